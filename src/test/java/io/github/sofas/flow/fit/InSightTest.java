package io.github.sofas.flow.fit;

import static org.junit.Assert.assertEquals;
import static org.junit.Assert.assertFalse;
import static org.junit.Assert.assertTrue;

import org.junit.Test;

/** A sensor of 40 x 30 px, and a window of 100 ms. */
public class InSightTest {
    private static final double HALF_S = 0.05;

    private final InSight inSight = new InSight(40, 30, 4, 4);

    /** What a meeting counts of two events in the middle of a cell of 1 px in the first row and column of a grid. */
    private double counts(double x, double y, double vx, double vy) {
        inSight.weigh(4, 4, x - 0.5, y - 0.5, 1, vx, vy);
        return (double) inSight.vote(new int[2], 2, new int[16], 4) / (256 * 256);
    }

    @Test
    public void whatIsInSightForAPartOfTheWindowCountsByAsMuchMore() {
        inSight.cutOff(100, 0, HALF_S);
        assertEquals("all the time", 1, counts(20, 10, 0, 0), 0);
        assertEquals("from 2.5 px before the border on", 1 / 0.75, counts(2.5, 10, 0, 0), 0.03);
        assertEquals("in the second half", 2, counts(0, 10, 0, 0), 0);
        assertEquals("until it leaves", 1 / 0.6, counts(39, 10, 0, 0), 0.03);
    }

    @Test
    public void nothingCountsMoreThanFourTimes() {
        inSight.cutOff(100, 0, HALF_S);
        assertEquals(4, counts(-4.5, 10, 0, 0), 0);
        assertEquals(4, counts(-20, 10, 0, 0), 0);
    }

    @Test
    public void placesLeaveTheSightByEitherAxisAndComeBackByNone() {
        inSight.cutOff(100, -100, HALF_S);
        // in sight from -25 ms on, and until 30 ms
        assertEquals(1 / 0.55, counts(2.5, 3, 0, 0), 0.03);
    }

    @Test
    public void velocityBesideCounts() {
        inSight.cutOff(0, 0, HALF_S);
        assertEquals(1, counts(0, 10, 0, 0), 0);
        assertEquals(2, counts(0, 10, 100, 0), 0);
    }

    @Test
    public void nothingIsCutOffUntilItIsTold() {
        assertFalse(inSight.isCutOff());
        inSight.cutOff(100, 0, HALF_S);
        assertTrue(inSight.isCutOff());
        inSight.clear();
        assertFalse(inSight.isCutOff());
    }
}
