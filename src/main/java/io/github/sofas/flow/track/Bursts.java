package io.github.sofas.flow.track;

import io.github.sofas.event.SensorSize;
import java.util.Arrays;

/**
 * Tells the first event of each burst: a strong edge that crosses a pixel changes its brightness by several thresholds,
 * and the pixel fires as often, with one polarity.
 *
 * <p>Ours, because the first event tells when the edge came, and the others come later by times that differ from pixel
 * to pixel: measured from all of them, an edge is blurred, and a strong one counts several times.
 */
final class Bursts {
    /** Eighteen minutes; then all is forgotten, and times begin at 0 again. */
    private static final long LAST_US = 1 << 30;
    private static final int NEVER = -1 << 29;

    private final int columns;
    /** When the last burst of each pixel began, OFF and ON, in µs since a first event. */
    private final int[] beganUs;
    private long firstUs;
    private boolean started;

    Bursts(SensorSize sensor) {
        columns = sensor.width();
        beganUs = new int[2 * sensor.width() * sensor.height()];
        reset();
    }

    /** Bytes of its array. */
    static long bytes(SensorSize sensor) {
        return 2L * Integer.BYTES * sensor.width() * sensor.height();
    }

    /**
     * Whether an event begins a burst. One that lasts for longer than a burst does is followed by another.
     *
     * @param lastsUs how long a burst lasts
     */
    boolean begins(int x, int y, long timeUs, int polarity, long lastsUs) {
        if (!started || timeUs - firstUs > LAST_US) {
            reset();
            started = true;
            firstUs = timeUs;
        }
        int us = (int) (timeUs - firstUs);
        int i = 2 * (y * columns + x) + (polarity > 0 ? 1 : 0);
        // those of the past of a structure may be handed over after others
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
