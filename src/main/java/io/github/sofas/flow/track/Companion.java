package io.github.sofas.flow.track;

/**
 * The older structure that moves as another one does, and how far: one at a time, until the two have moved alike no
 * farther than otherwise, or either ends.
 */
final class Companion {
    /** Time without a look at it after which there may be another: several times that between two looks. */
    private static final long LOST_US = 20_000;
    private static final int NONE = 0;

    private int id = NONE;
    private double togetherPx;
    private long lastUs;

    /** Begins alone. */
    void start() {
        id = NONE;
        togetherPx = 0;
    }

    /** Whether a structure is the companion, or may become it. */
    boolean mayBe(int other, long nowUs) {
        return id == other || id == NONE || nowUs - lastUs > LOST_US;
    }

    /**
     * Notes whether a structure that may be the companion moves as this does.
     *
     * @param pxPerS that their way grows by, in px/s
     */
    void note(int other, boolean isAlike, double pxPerS, long nowUs) {
        if (id != other || nowUs - lastUs > LOST_US) {
            id = other;
            togetherPx = 0;
        } else {
            double px = (nowUs - lastUs) * 1e-6 * pxPerS;
            togetherPx += isAlike ? px : -px;
        }
        lastUs = nowUs;
        if (!isAlike && togetherPx <= 0) {
            start();
        }
    }

    /** How far the two have moved alike, less how far they have moved otherwise; 0 without a companion. */
    double togetherPx() {
        return togetherPx;
    }
}
