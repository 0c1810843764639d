package io.github.sofas.flow.track;

/**
 * The older structure that moves as this one does, and how far the two have moved alike. There is one companion at a
 * time. It is given up when the two have moved alike no farther than differently, or when either ends.
 */
final class Companion {
    /** Time without a look at it after which another may become the companion: several times that between looks. */
    private static final long LOST_US = 20_000;
    private static final int NONE = 0;

    private int id = NONE;
    private double togetherPx;
    private long lastUs;

    /** Starts without a companion. */
    void start() {
        id = NONE;
        togetherPx = 0;
    }

    /** Whether a structure is, or may become, the companion. */
    boolean mayBe(int other, long nowUs) {
        return id == other || id == NONE || nowUs - lastUs > LOST_US;
    }

    /**
     * Notes whether a structure that may be the companion moves as this one does.
     *
     * @param pxPerS rate at which their common travel grows, in px/s
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

    /** Travel over which the two moved alike, less the travel over which they did not; 0 without a companion. */
    double togetherPx() {
        return togetherPx;
    }
}
