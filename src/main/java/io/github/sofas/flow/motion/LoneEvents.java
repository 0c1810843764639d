package io.github.sofas.flow.motion;

import io.github.sofas.event.SensorSize;
import java.util.Arrays;

/**
 * Recognises events that are alone: none of the eight pixels around has fired within the time in which even the slowest
 * structure considered crosses one pixel. They belong to no such structure. Ours, because where little moves, most of
 * the work is to project noise n² times.
 */
public final class LoneEvents {
    private static final int TICK_BITS = 10;
    /** Twelve days. After that, all events are forgotten and ticks restart at 0. */
    private static final long LAST_TICK = 1 << 30;
    private static final int NEVER = Integer.MIN_VALUE / 2;

    private final int columns;
    /** Time at which each pixel last fired, in ticks of 1,024 µs since the first event; with a border of one pixel. */
    private final int[] lastTick;
    private final int companyTicks;
    private long firstUs;
    private boolean started;

    /** Bytes that the array takes. */
    public static long bytes(SensorSize sensor) {
        return Integer.BYTES * (sensor.width() + 2L) * (sensor.height() + 2L);
    }

    /** Makes an instance for a sensor of so many px and the speed of the slowest structure considered. */
    public LoneEvents(int sensorWidth, int sensorHeight, double slowestPxPerS) {
        columns = sensorWidth + 2;
        lastTick = new int[columns * (sensorHeight + 2)];
        companyTicks = (int) (1e6 / slowestPxPerS) >> TICK_BITS;
        reset();
    }

    /** Whether the event is alone. It is noted, so that events around it that follow soon are not. */
    public boolean isAlone(int x, int y, long timeUs) {
        if (!started || (timeUs - firstUs) >> TICK_BITS > LAST_TICK) {
            reset();
            started = true;
            firstUs = timeUs;
        }
        int tick = (int) ((timeUs - firstUs) >> TICK_BITS);
        int since = tick - companyTicks;
        int[] last = lastTick;
        int c = (y + 1) * columns + x + 1;
        int up = c - columns;
        int down = c + columns;
        last[c] = tick;
        return last[up - 1] < since && last[up] < since && last[up + 1] < since && last[c - 1] < since
            && last[c + 1] < since && last[down - 1] < since && last[down] < since && last[down + 1] < since;
    }

    /** Forgets all events. */
    public void reset() {
        Arrays.fill(lastTick, NEVER);
        started = false;
    }
}
