package io.github.sofas.flow.search;

/**
 * Whether so many events are explained in a time that it is worth having a helper search beside labelling. Those that
 * are not do not count: before anything is tracked, there is nothing to do but to search, and soon.
 */
public final class EventRate {
    /** Time that events are counted for, and events that make it dense: labelling takes longer than waking a helper. */
    private static final long COUNTED_US = 1_000;
    private static final int DENSE = 256;

    private long fromUs = Long.MIN_VALUE / 2;
    private int count;
    private boolean dense;

    /** Goes on to an event, in order of time. */
    public void goOn(long timeUs) {
        if (timeUs - fromUs >= COUNTED_US) {
            dense = count >= DENSE && timeUs - fromUs < 2 * COUNTED_US;
            fromUs = timeUs;
            count = 0;
        }
    }

    /** Notes whether it is explained. */
    public void note(boolean isExplained) {
        count += isExplained ? 1 : 0;
    }

    /** Whether many events of the ms before were explained. */
    public boolean isDense() {
        return dense;
    }

    /** Forgets all events. */
    public void reset() {
        fromUs = Long.MIN_VALUE / 2;
        count = 0;
        dense = false;
    }
}
