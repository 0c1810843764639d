package io.github.sofas.flow.search;

import io.github.sofas.event.SensorSize;
import io.github.sofas.flow.SofasParameters;

/**
 * Detects events of pixels that fired so often that more events would overflow a cell of the flow plane, whose counts
 * have 16 bits. Such pixels are hot pixels side by side, and lights that flicker. Ours, because a count that wraps
 * around would spoil the metric for good.
 *
 * <p>At any time, a cell of 2 x 2 px sees four pixels. It sees two more each time that the travel crosses a pixel's
 * border along an axis: over t px of travel, at most 8 + 3 t pixels. The interval over which events are counted is
 * longer than a window of the flow plane, so that a window meets two intervals at most. Each pixel gives at most
 * (32,767 - r) / 2 / (8 + 3 t) events per interval, where r is the number of events that wait when the time jumps. No
 * cell therefore sees more than 32,767 events.
 */
public final class BusyPixels {
    /** Events that wait to be projected when the time jumps; all of them may fall on one cell. */
    private static final int WAITING = 2048;
    private static final int COUNT_BITS = 10;
    private static final int COUNT_MASK = (1 << COUNT_BITS) - 1;
    /** Most events of a pixel that are counted per interval. */
    static final int MOST = Math.min(COUNT_MASK,
        (int) ((Short.MAX_VALUE - WAITING) / 2 / (8 + 3 * Projections.TRAVEL_PX)));

    private final int columns;
    /**
     * For each pixel, the number of the interval in which it last fired and, in the low bits, how often it fired then.
     */
    private final int[] fired;
    private final long intervalUs;
    private long startUs;
    private int interval;
    private boolean started;

    /** Bytes of the array for a sensor. */
    public static long bytes(SensorSize sensor) {
        return (long) Integer.BYTES * sensor.width() * sensor.height();
    }

    /** Creates a detector for a sensor of the given size in px. */
    public BusyPixels(int sensorWidth, int sensorHeight, SofasParameters.Search p) {
        columns = sensorWidth;
        fired = new int[sensorWidth * sensorHeight];
        // events leave a little later than the travel asks for, by an eighth of the window at most
        double windowUs = Math.min(p.lifespanUs(), Projections.TRAVEL_PX / p.slowestPxPerS() * 1e6);
        intervalUs = (long) (1.125 * windowUs) + 10_000;
    }

    /** Whether the event's pixel has fired too often in this interval. Such an event is not counted. */
    public boolean isBusy(int x, int y, long timeUs) {
        if (!started || timeUs - startUs >= intervalUs) {
            started = true;
            startUs = timeUs;
            // wraps around after 2^22 intervals: at worst, a pixel that was silent for so long counts its last events
            // again
            interval += 1 << COUNT_BITS;
        }
        int i = y * columns + x;
        int count = fired[i];
        if ((count & ~COUNT_MASK) != interval) {
            count = interval;
        }
        if ((count & COUNT_MASK) == MOST) {
            return true;
        }
        fired[i] = count + 1;
        return false;
    }

    /** Forgets all events. */
    public void reset() {
        // the next event begins an interval in which no pixel has fired yet
        started = false;
    }
}
