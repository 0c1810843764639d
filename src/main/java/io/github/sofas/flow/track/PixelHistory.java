package io.github.sofas.flow.track;

import io.github.sofas.event.SensorSize;
import io.github.sofas.flow.motion.Motion;
import java.util.Arrays;

/**
 * The times of the last events of each pixel, ON and OFF apart. From them {@link #traceBeyond} determines how far an
 * edge came along a motion.
 *
 * <p>Ours, because contours do not separate structures that overlap: each contour holds what its plane was given
 * before. The places of recent events are the same, whatever the events were taken for.
 *
 * <p>The last {@value #KEPT} events of a pixel and polarity are one {@code long}: the tick of the newest event, above
 * the gaps to the earlier ones. An event is therefore noted by one load and one store, and the history of a DAVIS346
 * takes 1.4 MB.
 */
final class PixelHistory {
    /** Travel, in px, that a trace goes back. */
    static final int TRACE_PX = 8;
    /** Count of a px of travel with an event on the very pixel where the edge was; an event beside it counts 1. */
    static final int ON_THE_PIXEL = 3;
    /** Events that are kept of each pixel and polarity. */
    private static final int KEPT = 4;
    /** Travel, in px, within which an edge from beyond the border has just come in. */
    private static final int ENTRY_PX = 5;
    /**
     * Least speed from which the time of a px of travel is computed, for edges that move more slowly or stand still.
     */
    static final double SLOWEST_PX_PER_S = 1;

    /** Ticks are 64 µs, a sixteenth of the time that a px of travel takes at 1,000 px/s. */
    private static final int TICK_BITS = 6;
    private static final double TICKS_PER_US = 1.0 / (1 << TICK_BITS);
    private static final int GAP_BITS = 13;
    /** Longest gap between two events of a pixel, half a second; after it the earlier events are forgotten. */
    private static final int LONGEST_GAP = (1 << GAP_BITS) - 1;
    private static final int GAPS_BITS = (KEPT - 1) * GAP_BITS;
    /** Gaps of a pixel that has no event before its newest. The tick of a pixel without any event is 0. */
    private static final long NO_EVENTS_BEFORE = (1L << GAPS_BITS) - 1;
    /** Tick of the first event: more than any trace goes back. */
    private static final int FIRST_TICK = 1 << 20;
    /** Ticks after which they are counted from a later origin: 18 minutes. */
    private static final int SPAN_TICKS = 1 << 24;

    private final int width;
    private final int height;
    /** Events of each pixel, OFF then ON. */
    private final long[] events;
    private long originUs;

    PixelHistory(SensorSize sensor) {
        width = sensor.width();
        height = sensor.height();
        events = new long[2 * width * height];
        clear();
    }

    /** Bytes of its array. */
    static long bytes(SensorSize sensor) {
        return 2L * Long.BYTES * sensor.width() * sensor.height();
    }

    /** Forgets all events. */
    void clear() {
        Arrays.fill(events, NO_EVENTS_BEFORE);
        originUs = Long.MIN_VALUE;
    }

    /** Notes an event. */
    void note(int x, int y, long timeUs, int polarity) {
        if (originUs == Long.MIN_VALUE) {
            begin(timeUs);
        }
        while (ticks(timeUs) >= FIRST_TICK + SPAN_TICKS) {
            moveOrigin(timeUs);
        }
        int i = index(x, y, polarity);
        long before = events[i];
        int tick = (int) ticks(timeUs);
        int gap = tick - newest(before);
        long gaps = gap >= LONGEST_GAP ? NO_EVENTS_BEFORE
            : (long) gap << GAPS_BITS - GAP_BITS | (before & NO_EVENTS_BEFORE) >>> GAP_BITS;
        events[i] = (long) tick << GAPS_BITS | gaps;
    }

    private void begin(long timeUs) {
        originUs = timeUs - ((long) FIRST_TICK << TICK_BITS);
    }

    private long ticks(long timeUs) {
        return timeUs - originUs >> TICK_BITS;
    }

    private static int newest(long events) {
        return (int) (events >>> GAPS_BITS);
    }

    /** Counts ticks from a later origin. Events before the new origin are long past, and are forgotten. */
    private void moveOrigin(long nowUs) {
        if (ticks(nowUs) >= FIRST_TICK + 2L * SPAN_TICKS) {
            clear();
            begin(nowUs);
            return;
        }
        for (int i = 0; i < events.length; i++) {
            int tick = newest(events[i]) - SPAN_TICKS;
            events[i] = tick <= 0 ? NO_EVENTS_BEFORE
                : (long) tick << GAPS_BITS | events[i] & NO_EVENTS_BEFORE;
        }
        originUs += (long) SPAN_TICKS << TICK_BITS;
    }

    private int index(int x, int y, int polarity) {
        return (y * width + x) * 2 + (polarity > 0 ? 1 : 0);
    }

    /**
     * How far an edge that fires now came along a motion, as a count from 0 to 24. A px of travel counts
     * {@value #ON_THE_PIXEL} where an event of the edge's polarity was on the very pixel when the edge must have been
     * there. It counts 1 where such an event was on a pixel beside it.
     *
     * @param known trace that the result is to exceed, -1 for any; a trace that does not exceed it may be returned as
     *     any value that does not
     */
    int traceBeyond(int known, int x, int y, long timeUs, int polarity, Motion motion) {
        double vx = motion.vxAt(x, y, timeUs);
        double vy = motion.vyAt(x, y, timeUs);
        double pxUs = 1e6 / Math.max(SLOWEST_PX_PER_S, Math.sqrt(vx * vx + vy * vy));
        double stepX = vx * pxUs * 1e-6;
        double stepY = vy * pxUs * 1e-6;
        double nowTicks = (timeUs - originUs) * TICKS_PER_US;
        double pxTicks = pxUs * TICKS_PER_US;
        int trace = 0;
        for (int px = 1; px <= TRACE_PX && trace + ON_THE_PIXEL * (TRACE_PX + 1 - px) > known; px++) {
            trace += met(x - px * stepX, y - px * stepY, polarity, (int) (nowTicks - (px + 0.5) * pxTicks),
                (int) (nowTicks - (px - 0.5) * pxTicks));
        }
        return trace;
    }

    /** Whether an edge that fires now may just have come from beyond the border of the sensor. */
    boolean isNearBorder(int x, int y) {
        return x < ENTRY_PX || y < ENTRY_PX || x >= width - ENTRY_PX || y >= height - ENTRY_PX;
    }

    /** Whether an edge that fires now has just come from beyond the border along a motion. */
    boolean cameIn(int x, int y, long timeUs, Motion motion) {
        double vx = motion.vxAt(x, y, timeUs);
        double vy = motion.vyAt(x, y, timeUs);
        double entryS = travelS(ENTRY_PX, vx, vy);
        return !isOnSensor((int) Math.rint(x - entryS * vx), (int) Math.rint(y - entryS * vy));
    }

    /** Time to travel some px at a velocity, in s; an edge at rest is taken to move at {@link #SLOWEST_PX_PER_S}. */
    static double travelS(double px, double vx, double vy) {
        return px / Math.max(SLOWEST_PX_PER_S, Math.sqrt(vx * vx + vy * vy));
    }

    private boolean isOnSensor(int x, int y) {
        return x >= 0 && y >= 0 && x < width && y < height;
    }

    /** Count of a px of travel, by the events at a place within a span of time. */
    private int met(double atX, double atY, int polarity, int fromTick, int untilTick) {
        int x = (int) Math.rint(atX);
        int y = (int) Math.rint(atY);
        if (fired(x, y, polarity, fromTick, untilTick)) {
            return ON_THE_PIXEL;
        }
        int besideX = atX > x ? x + 1 : x - 1;
        int besideY = atY > y ? y + 1 : y - 1;
        return fired(besideX, y, polarity, fromTick, untilTick) || fired(x, besideY, polarity, fromTick, untilTick)
            || fired(besideX, besideY, polarity, fromTick, untilTick) ? 1 : 0;
    }

    private boolean fired(int x, int y, int polarity, int fromTick, int untilTick) {
        if (!isOnSensor(x, y)) {
            return false;
        }
        long its = events[index(x, y, polarity)];
        int tick = newest(its);
        for (int bit = GAPS_BITS - GAP_BITS; tick >= untilTick && bit >= 0; bit -= GAP_BITS) {
            int gap = (int) (its >>> bit) & LONGEST_GAP;
            tick = gap == LONGEST_GAP ? 0 : tick - gap;
        }
        return tick >= fromTick && tick < untilTick;
    }
}
