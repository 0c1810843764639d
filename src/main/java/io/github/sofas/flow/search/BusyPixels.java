package io.github.sofas.flow.search;

import io.github.sofas.event.SensorSize;
import io.github.sofas.flow.SofasParameters;

/**
 * Tells events of pixels that fired so often that more of them would overflow a cell of the flow plane, whose counts
 * have 16 bits: hot pixels side by side, and lights that flicker. Ours, because a count that wraps round would spoil
 * the metric for good.
 *
 * <p>A cell of 2 x 2 px sees at any time four pixels, and two more each time that the travel crosses a pixel's border
 * along an axis: over t px of travel at most 8 + 3 t. A window of the flow plane meets two of the intervals that events
 * are counted in, since each of those is longer than it. So no cell sees more than 32,767 events when each pixel gives
 * at most (32,767 - r) / 2 / (8 + 3 t) in an interval, with r for those that wait when time jumps.
 */
public final class BusyPixels {
    /** Events that wait to be projected when the time jumps; they may fall on one cell. */
    private static final int WAITING = 2048;
    private static final int COUNT_BITS = 10;
    private static final int COUNT_MASK = (1 << COUNT_BITS) - 1;
    /** The most events of a pixel in an interval. */
    static final int MOST = Math.min(COUNT_MASK,
        (int) ((Short.MAX_VALUE - WAITING) / 2 / (8 + 3 * Projections.TRAVEL_PX)));

    private final int columns;
    /** For each pixel the number of the interval that it fired in last, and how often it did, in the low bits. */
    private final int[] fired;
    private final long intervalUs;
    private long startUs;
    private int interval;
    private boolean started;

    /** Bytes of its array. */
    public static long bytes(SensorSize sensor) {
        return (long) Integer.BYTES * sensor.width() * sensor.height();
    }

    /** Makes it for a sensor of so many px. */
    public BusyPixels(int sensorWidth, int sensorHeight, SofasParameters.Search p) {
        columns = sensorWidth;
        fired = new int[sensorWidth * sensorHeight];
        // events are let go a little later than the travel says, at most an eighth
        double windowUs = Math.min(p.lifespanUs(), Projections.TRAVEL_PX / p.slowestPxPerS() * 1e6);
        intervalUs = (long) (1.125 * windowUs) + 10_000;
    }

    /** Whether the event's pixel has fired too often; such an event is not counted. */
    public boolean isBusy(int x, int y, long timeUs) {
        if (!started || timeUs - startUs >= intervalUs) {
            started = true;
            startUs = timeUs;
            // wraps round after 2^22 intervals, when a pixel silent for so long at worst counts its last events again
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
        // no pixel has fired in the next interval
        started = false;
    }
}
