package io.github.sofas.flow.track;

/** When a structure lived, how many of its events got flow, and whether it is tracked, waited for or ended. */
final class Life {
    /** Events that a structure must have had to be waited for while it is hidden. */
    private static final int LEAST_HIDDEN = 200;

    /** What is to be done with a structure. */
    enum State {
        /** It gets its events. */
        TRACKED,
        /** It gets too few: it is hidden, or stands, or is gone; it is waited for where it would be. */
        WAITED_FOR,
        /** It is not to be tracked any more. */
        ENDED
    }

    private long firstUs;
    private long lastUs;
    private long events;
    private State state = State.ENDED;
    private long waitingSinceUs;

    /** Begins with a structure that was found. */
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

    /** Counts the events of another structure, which this one has taken over, too. */
    void takeOver(Life other) {
        events += other.events;
    }

    /**
     * Goes to the state that it is in by now: the only place where it changes.
     *
     * @param isStarved whether it gets too few events
     * @param isGone whether there is no structure any more, or none that moves as this one was taken to
     * @param mayComeBack whether it may be in sight
     * @param patienceUs how long it is waited for
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

    /** Whether it gets its events. */
    boolean isTracked() {
        return state == State.TRACKED;
    }

    /** Whether it has been waited for that long. */
    boolean isWaitedFor(long atLeastUs, long nowUs) {
        return state == State.WAITED_FOR && nowUs - waitingSinceUs >= atLeastUs;
    }

    /** When it was found. */
    long firstUs() {
        return firstUs;
    }

    /** When it gave the last event that got flow, or was found. */
    long lastUs() {
        return lastUs;
    }

    /** How many of its events got flow. */
    long events() {
        return events;
    }
}
