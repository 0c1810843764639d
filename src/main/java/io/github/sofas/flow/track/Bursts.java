package io.github.sofas.flow.track;

import io.github.sofas.event.SensorSize;
import java.util.Arrays;

/**
 * Finds the first event of each burst. A strong edge that crosses a pixel changes the pixel's brightness by several
 * contrast thresholds, and the pixel fires once for each of them, always with the same polarity.
 *
 * <p>Ours, because only the first event of a burst shows when the edge arrived. The others follow after delays that
 * differ from pixel to pixel. A measurement from all of them would blur the edge and count a strong edge several times.
 */
final class Bursts {
    /** Eighteen minutes. After this time all events are forgotten, and times start at 0 again. */
    private static final long LAST_US = 1 << 30;
    private static final int NEVER = -1 << 29;

    private final int columns;
    /** Start of the last burst of each pixel, OFF then ON, in µs since the first event. */
    private final int[] beganUs;
    private long firstUs;
    private boolean started;

    Bursts(SensorSize sensor) {
        columns = sensor.width();
        beganUs = new int[2 * sensor.width() * sensor.height()];
        reset();
    }

    /** Bytes that the array takes. */
    static long bytes(SensorSize sensor) {
        return 2L * Integer.BYTES * sensor.width() * sensor.height();
    }

    /**
     * Whether an event begins a burst. Events that continue beyond the duration of a burst begin another one.
     *
     * @param lastsUs duration of a burst
     */
    boolean begins(int x, int y, long timeUs, int polarity, long lastsUs) {
        if (!started || timeUs - firstUs > LAST_US) {
            reset();
            started = true;
            firstUs = timeUs;
        }
        int us = (int) (timeUs - firstUs);
        int i = 2 * (y * columns + x) + (polarity > 0 ? 1 : 0);
        // the past events of a new structure may be handed over after newer events
        boolean begins = us - beganUs[i] > lastsUs || us < beganUs[i];
        if (begins) {
            beganUs[i] = us;
        }
        return begins;
    }

    /** Forgets all events. */
    void reset() {
        Arrays.fill(beganUs, NEVER);
        started = false;
    }
}
