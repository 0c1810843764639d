package io.github.sofas.flow.track;

/**
 * When a structure is asked whether a part of it is a body of its own, each few px of its travel, and when whether it
 * is two that seem to turn, too: what clearly turned as one body, or grew, half as often from then on. The answer stays
 * the same, and takes as long as several measurements.
 */
final class PartingSchedule {
    private static final double EVERY_PX = 4;
    /** Of those times, the most to the next one at which it is asked whether it is two. */
    private static final int MOST_TO_TWO = 8;

    private long askedUs;
    /** Times until it is asked whether it is two, and from one such time to the next. */
    private int untilTwo;
    private int betweenTwo;

    /** Begins with a new structure. */
    void start(long nowUs) {
        askedUs = nowUs;
        askSoonForTwo();
    }

    /** Asks whether it is two the next time. */
    void askSoonForTwo() {
        betweenTwo = 1;
        untilTwo = 1;
    }

    /** Whether a structure of some speed is due. */
    boolean isDue(double speed, long nowUs) {
        return (nowUs - askedUs) * 1e-6 * speed >= EVERY_PX;
    }

    /** Begins to ask. */
    void begin(long nowUs) {
        askedUs = nowUs;
        untilTwo--;
    }

    /** Whether it is to be asked whether it is two, too. */
    boolean isForTwo() {
        return untilTwo <= 0;
    }

    /** Notes the answer where it was asked whether it is two. */
    void note(boolean isClearlyOne) {
        betweenTwo = isClearlyOne ? Math.min(MOST_TO_TWO, 2 * betweenTwo) : 1;
        untilTwo = betweenTwo;
    }
}
