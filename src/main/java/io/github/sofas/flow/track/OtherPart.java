package io.github.sofas.flow.track;

/**
 * The older structure that may be a part of the same body, and how clearly it is. There is one such structure at a
 * time, and it is asked about each few px of travel. After an answer of no, other structures go first.
 */
final class OtherPart {
    private static final double EVERY_PX = 4;
    /** Travel between two questions about a structure that lets others go first, in px. */
    private static final double LATER_PX = 6;
    /**
     * Standard deviations that one motion must gain each time to be more likely than two: noise gains and loses as
     * much.
     */
    private static final double NOISE_SIGMAS = 0.5;
    /** Sum of the gains beyond that from which on the two structures are one body. */
    private static final double SURE_SIGMAS = 2;
    private static final int NONE = 0;

    private int id = NONE;
    private double sigmas;
    private long askedUs;

    /** Begins alone. */
    void start(long nowUs) {
        id = NONE;
        sigmas = 0;
        askedUs = nowUs;
    }

    /**
     * Whether a structure is due to be asked about.
     *
     * @param speed of the faster of the two, in px/s
     */
    boolean isDue(int other, double speed, long nowUs) {
        boolean goesFirst = sigmas > 0 ? id == other : id != other;
        return (nowUs - askedUs) * 1e-6 * speed >= (goesFirst ? EVERY_PX : LATER_PX);
    }

    /** Notes what one motion with a structure gained, in standard deviations. Returns whether the two are one body. */
    boolean note(int other, double gained, long nowUs) {
        double before = id == other ? sigmas : 0;
        id = other;
        sigmas = Math.max(0, before + gained - NOISE_SIGMAS);
        askedUs = nowUs;
        return sigmas > SURE_SIGMAS;
    }
}
