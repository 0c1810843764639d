package io.github.sofas.flow.smooth;

/**
 * Determines which event begins a new slice: one at or after the next multiple of a slice's duration, or after
 * {@link Smoother#MOST_EVENTS} events. This depends on the events alone, so that the step before the smoother knows it
 * without asking.
 */
public final class SliceClock {
    private final long sliceUs;
    private long untilUs = Long.MIN_VALUE;
    private long newestUs;
    private int events;

    /** Makes one for a look-ahead in µs. */
    public SliceClock(long lookAheadUs) {
        sliceUs = sliceUs(lookAheadUs);
    }

    /** Duration of a slice in µs. */
    static long sliceUs(long lookAheadUs) {
        return Math.max(1, lookAheadUs / Smoother.AHEAD);
    }

    /** Latest end, in µs, of a slice that begins or continues at a time. */
    static long untilUs(long us, long sliceUs) {
        return Math.floorDiv(us, sliceUs) * sliceUs + sliceUs;
    }

    /**
     * Takes the next event.
     *
     * @param timeUs never less than before
     * @return whether the event begins a slice, other than the first one
     */
    public boolean begins(long timeUs) {
        boolean isFirst = untilUs == Long.MIN_VALUE;
        boolean isFull = events == Smoother.MOST_EVENTS;
        boolean begins = !isFirst && (isFull || timeUs >= untilUs);
        if (isFull) {
            untilUs = untilUs(Math.min(untilUs, newestUs + 1), sliceUs);
        }
        if (isFirst || timeUs >= untilUs) {
            untilUs = untilUs(timeUs, sliceUs);
        }
        newestUs = timeUs;
        events = begins ? 1 : events + 1;
        return begins;
    }
}
