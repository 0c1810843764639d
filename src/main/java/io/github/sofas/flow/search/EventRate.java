package io.github.sofas.flow.search;

/**
 * Determines whether enough events per ms are explained to make a helper worthwhile, which searches while further
 * events are labelled. Events that no track plane explains do not count: before anything is tracked, there is nothing
 * to do but to search, and soon.
 */
public final class EventRate {
    /**
     * Time over which events are counted, and the number of events that makes it dense: labelling them takes longer
     * than waking a helper.
     */
    private static final long COUNTED_US = 1_000;
    private static final int DENSE = 256;

    private long fromUs = Long.MIN_VALUE / 2;
    private int count;
    private boolean dense;

    /** Advances to the time of an event; events come in order of time. */
    public void goOn(long timeUs) {
        if (timeUs - fromUs >= COUNTED_US) {
            dense = count >= DENSE && timeUs - fromUs < 2 * COUNTED_US;
            fromUs = timeUs;
            count = 0;
        }
    }

    /** Notes whether that event is explained. */
    public void note(boolean isExplained) {
        count += isExplained ? 1 : 0;
    }

    /** Whether many events of the previous ms were explained. */
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
