package io.github.sofas.flow.track;

/** The life of a structure: its first and last time, its events that got flow, and its {@link State}. */
final class Life {
    /** Fewest events with flow of a structure that is worth waiting for while it is hidden. */
    private static final int LEAST_HIDDEN = 200;

    /** How a structure is treated. */
    enum State {
        /** It gets the events that it is expected to give. */
        TRACKED,
        /** It gets too few events: it is hidden, stands still, or is gone. It is waited for where it would be. */
        WAITED_FOR,
        /** It is no longer tracked. */
        ENDED
    }

    private long firstUs;
    private long lastUs;
    private long events;
    private State state = State.ENDED;
    private long waitingSinceUs;

    /** Starts with a structure that was just found. */
    void start(long nowUs) {
        firstUs = nowUs;
        lastUs = nowUs;
        events = 0;
        state = State.TRACKED;
    }

    /** Counts an event that got flow. */
    void note(long timeUs) {
        events++;
        lastUs = timeUs;
    }

    /** Adds the events of another structure that this one has taken over. */
    void takeOver(Life other) {
        events += other.events;
    }

    /**
     * Updates the state: the only place where a running life changes it.
     *
     * @param isStarved whether the structure gets too few events
     * @param isGone whether there is no structure any more, or none that moves along the assumed motion
     * @param mayComeBack whether the structure may be in sight
     * @param patienceUs longest time for which the structure is waited for
     */
    State goOn(boolean isStarved, boolean isGone, boolean mayComeBack, long patienceUs, long nowUs) {
        if (!isStarved) {
            state = State.TRACKED;
        } else if (state == State.TRACKED) {
            state = events < LEAST_HIDDEN ? State.ENDED : State.WAITED_FOR;
            waitingSinceUs = nowUs;
        }
        if (isGone || state == State.WAITED_FOR && (nowUs - waitingSinceUs >= patienceUs || !mayComeBack)) {
            state = State.ENDED;
        }
        return state;
    }

    /** Whether the structure is tracked. */
    boolean isTracked() {
        return state == State.TRACKED;
    }

    /** Whether the structure has been waited for at least so long. */
    boolean isWaitedFor(long atLeastUs, long nowUs) {
        return state == State.WAITED_FOR && nowUs - waitingSinceUs >= atLeastUs;
    }

    /** Returns the time at which the structure was found. */
    long firstUs() {
        return firstUs;
    }

    /** Returns the time of its last event that got flow, or the time at which it was found. */
    long lastUs() {
        return lastUs;
    }

    /** Returns the number of its events that got flow. */
    long events() {
        return events;
    }
}
