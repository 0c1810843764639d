package io.github.sofas.flow.track;

/**
 * When a structure is asked whether a part of it is a body of its own: each few px of its travel. At some of these
 * times it is asked, too, whether it is two bodies that seem to turn. Each time that it clearly turned or grew as one
 * body, this second question is asked half as often from then on, down to one time in {@value #MOST_TO_TWO}: its answer
 * stays the same, and takes as long as several measurements.
 */
final class PartingSchedule {
    private static final double EVERY_PX = 4;
    /** The second question is asked at least once in so many times. */
    private static final int MOST_TO_TWO = 8;

    private long askedUs;
    /** Times until the second question is asked, and from one such question to the next. */
    private int untilTwo;
    private int betweenTwo;

    /** Begins with a new structure. */
    void start(long nowUs) {
        askedUs = nowUs;
        askSoonForTwo();
    }

    /** Has the second question asked the next time. */
    void askSoonForTwo() {
        betweenTwo = 1;
        untilTwo = 1;
    }

    /** Whether a structure of some speed, in px/s, is due to be asked. */
    boolean isDue(double speed, long nowUs) {
        return (nowUs - askedUs) * 1e-6 * speed >= EVERY_PX;
    }

    /** Notes that the structure is asked now. */
    void begin(long nowUs) {
        askedUs = nowUs;
        untilTwo--;
    }

    /** Whether the second question is to be asked now, too. */
    boolean isForTwo() {
        return untilTwo <= 0;
    }

    /** Notes the answer to the second question. */
    void note(boolean isClearlyOne) {
        betweenTwo = isClearlyOne ? Math.min(MOST_TO_TWO, 2 * betweenTwo) : 1;
        untilTwo = betweenTwo;
    }
}
