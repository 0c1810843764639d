package io.github.sofas.recording;

import static io.github.sofas.recording.Aedat2Format.APS_SAMPLE_MASK;
import static io.github.sofas.recording.Aedat2Format.APS_SIGNAL_READ;
import static io.github.sofas.recording.Aedat2Format.DAVIS_SPECIAL;
import static io.github.sofas.recording.Aedat2Format.DAVIS_X_MASK;
import static io.github.sofas.recording.Aedat2Format.DAVIS_X_SHIFT;
import static io.github.sofas.recording.Aedat2Format.DAVIS_Y_MASK;
import static io.github.sofas.recording.Aedat2Format.DAVIS_Y_SHIFT;

import io.github.sofas.event.GreyFrame;
import io.github.sofas.event.SensorSize;
import java.util.Arrays;
import java.util.function.Consumer;

/**
 * Assembles the frames of a DAVIS from samples of single pixels. Each pixel is read after its reset and again after its
 * exposure; the difference is its brightness. A frame is complete when every pixel was read after its exposure. A frame
 * with missing samples ends where the next one begins.
 */
final class ApsFrames {
    /** Shift from the 10 bits of a sample to the 8 bits of a level. */
    private static final int SHIFT = 2;

    private final SensorSize sensor;
    private final Consumer<GreyFrame> receiver;
    private final short[] reset;
    private final byte[] levels;
    private final boolean[] isRead;
    private int read;
    private long timeUs;

    ApsFrames(SensorSize sensor, Consumer<GreyFrame> receiver) {
        this.sensor = sensor;
        this.receiver = receiver;
        int pixels = sensor.width() * sensor.height();
        reset = new short[pixels];
        levels = new byte[pixels];
        isRead = new boolean[pixels];
    }

    /** Takes a sample; a sample outside the sensor is skipped. */
    void take(int address, long sampleTimeUs) {
        // unlike that of events, raw x runs from left to right
        int x = address >>> DAVIS_X_SHIFT & DAVIS_X_MASK;
        int y = sensor.height() - 1 - (address >>> DAVIS_Y_SHIFT & DAVIS_Y_MASK);
        if (!sensor.contains(x, y)) {
            return;
        }
        int at = y * sensor.width() + x;
        int sample = address & APS_SAMPLE_MASK;
        if ((address & DAVIS_SPECIAL) != APS_SIGNAL_READ) {
            reset[at] = (short) sample;
            return;
        }
        if (isRead[at]) {
            finish();
        }
        if (read == 0) {
            timeUs = sampleTimeUs;
        }
        isRead[at] = true;
        read++;
        levels[at] = (byte) (Math.max(0, reset[at] - sample) >> SHIFT);
        if (read == levels.length) {
            finish();
        }
    }

    private void finish() {
        receiver.accept(new GreyFrame(timeUs, sensor.width(), sensor.height(), levels.clone()));
        Arrays.fill(isRead, false);
        read = 0;
    }
}
