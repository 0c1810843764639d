package io.github.sofas.flow.track;

import static org.junit.Assert.assertEquals;
import static org.junit.Assert.assertFalse;
import static org.junit.Assert.assertTrue;

import io.github.sofas.event.SensorSize;
import io.github.sofas.flow.motion.Motion;
import org.junit.Test;

/** Traces of an event at (40, 20) at 1 s. A px of travel takes 10 ms at 100 px/s. */
public class PixelHistoryTest {
    private static final long NOW_US = 1_000_000;
    private static final int X = 40;
    private static final int Y = 20;

    private final PixelHistory history = new PixelHistory(new SensorSize(64, 48));

    private static Motion motion(double vx, double vy) {
        Motion motion = new Motion();
        motion.set(NOW_US, vx, vy);
        return motion;
    }

    private int trace(double vx, double vy) {
        return trace(X, Y, NOW_US, 1, motion(vx, vy));
    }

    private int trace(int x, int y, long timeUs, int polarity, Motion motion) {
        return history.traceBeyond(-1, x, y, timeUs, polarity, motion);
    }

    /** An edge that entered each of so many columns before the event's, 10 ms apart. */
    private void edge(int columns, int row, int polarity) {
        for (int c = columns; c >= 1; c--) {
            history.note(X - c, row, NOW_US - c * 10_000, polarity);
        }
    }

    @Test
    public void eachPxOfTravelOnItsPixelCountsThree() {
        assertEquals(0, trace(100, 0));
        edge(5, Y, 1);
        assertEquals(5 * 3, trace(100, 0));
        edge(20, Y, 1);
        assertEquals("eight px at most", 8 * 3, trace(100, 0));
    }

    @Test
    public void pxOfTravelBesideItsPixelCountsOne() {
        // a row below, where the edge was at 20.1 to 20.8; from the sixth on row 21 is its own
        edge(8, Y + 1, 1);
        assertEquals(5 + 3 * 3, trace(100, -10));
        // where it was above row 20, row 21 is not beside it
        assertEquals(0, trace(100, 10));
    }

    @Test
    public void eventsAtOtherTimesDoNotCount() {
        edge(8, Y, 1);
        // at twice the speed the edge was a px back 5 ms ago, when nothing fired
        assertEquals(0, trace(200, 0));
        assertEquals(0, trace(-100, 0));
    }

    @Test
    public void eventOfATimeWithinHalfAPxOfTravelCounts() {
        history.note(X - 2, Y, NOW_US - 25_000, 1);
        assertEquals("25 of 15 to 25 ms", 3, trace(100, 0));
        // times are told apart by 64 µs
        history.note(X - 3, Y, NOW_US - 35_100, 1);
        assertEquals("35.1 of 25 to 35 ms", 3, trace(100, 0));
    }

    @Test
    public void edgeThatWasBeyondTheBorderFivePxBeforeHasComeIn() {
        assertTrue("at column -1", history.cameIn(4, Y, NOW_US, motion(100, 0)));
        assertFalse("at column 0", history.cameIn(5, Y, NOW_US, motion(100, 0)));
        assertFalse("from the other side", history.cameIn(4, Y, NOW_US, motion(-100, 0)));
        assertTrue("at column 64", history.cameIn(59, Y, NOW_US, motion(-100, 0)));
        assertFalse("at column 63", history.cameIn(58, Y, NOW_US, motion(-100, 0)));
        assertTrue("three px to the left and four up", history.cameIn(X, 3, NOW_US, motion(60, 80)));
        assertFalse(history.cameIn(X, 4, NOW_US, motion(60, 80)));
        assertTrue("at row 48", history.cameIn(X, 43, NOW_US, motion(0, -100)));
    }

    @Test
    public void edgesComeInNearTheBorderOnly() {
        for (int x = 0; x < 64; x++) {
            for (int y = 0; y < 48; y++) {
                assertEquals(x < 5 || y < 5 || x > 58 || y > 42, history.isNearBorder(x, y));
            }
        }
    }

    @Test
    public void otherPolarityDoesNotCount() {
        edge(8, Y, -1);
        assertEquals(0, trace(100, 0));
        assertEquals(24, trace(X, Y, NOW_US, -1, motion(100, 0)));
    }

    @Test
    public void pixelFindsItsEventsBehindLaterOnes() {
        edge(8, Y, 1);
        // three more on each pixel since
        for (int c = 8; c >= 1; c--) {
            for (int later = 1; later <= 3; later++) {
                history.note(X - c, Y, NOW_US - 1000 + 200 * later, 1);
            }
        }
        assertEquals(24, trace(100, 0));
        for (int c = 8; c >= 1; c--) {
            history.note(X - c, Y, NOW_US, 1);
        }
        assertEquals("four are kept", 0, trace(100, 0));
    }

    @Test
    public void pixelForgetsItsEventsOfMoreThanHalfASecondBeforeALaterOne() {
        history.note(X - 1, Y, NOW_US - 600_000, 1);
        history.note(X - 1, Y, NOW_US - 90_000, 1);
        assertEquals("510 ms before", 3, trace(1 / 0.6, 0));
        history.note(X - 2, Y, NOW_US - 1_200_000, 1);
        history.note(X - 2, Y, NOW_US - 600_000, 1);
        assertEquals("600 ms before", 3, trace(1 / 0.6, 0));
    }

    @Test
    public void traceIsFollowedNoFartherThanItMayPassAKnownOne() {
        edge(5, Y, 1);
        for (int known = 0; known < 15; known++) {
            assertEquals(15, history.traceBeyond(known, X, Y, NOW_US, 1, motion(100, 0)));
        }
        for (int known = 15; known <= 24; known++) {
            assertTrue(history.traceBeyond(known, X, Y, NOW_US, 1, motion(100, 0)) <= known);
        }
    }

    @Test
    public void traceOfWhatTurnsFollowsTheVelocityAtTheEvent() {
        edge(8, Y, 1);
        Motion motion = motion(0, 0);
        motion.centreX = X;
        motion.centreY = Y + 50;
        motion.omega = 2;
        // 50 px above the centre, 2 rad/s: 100 px/s to the right
        assertEquals(24, trace(X, Y, NOW_US, 1, motion));
    }

    @Test
    public void edgesAtTheBorderComeFromWhereThereIsNone() {
        history.note(0, Y, NOW_US - 10_000, 1);
        assertEquals(3, trace(1, Y, NOW_US, 1, motion(100, 0)));
        assertEquals(0, trace(63, 47, NOW_US, 1, motion(-100, -100)));
    }

    @Test
    public void whatStandsHasNoTrace() {
        edge(8, Y, 1);
        assertEquals(0, trace(0, 0));
    }

    @Test
    public void longTimesAndPausesChangeNothing() {
        // the origin moves each 2^30 µs, about 18 minutes
        long startUs = NOW_US - 8 * 10_000;
        history.note(0, 0, startUs - (1L << 30) + 50_000, 1);
        edge(8, Y, 1);
        history.note(0, 0, startUs + 50_000, 1);
        assertEquals(24, trace(100, 0));
        long nextUs = NOW_US + (1L << 40);
        history.note(0, 0, nextUs, 1);
        assertEquals(0, trace(X, Y, nextUs, 1, motion(100, 0)));
        history.note(X - 1, Y, nextUs + 10_000, 1);
        assertEquals(3, trace(X, Y, nextUs + 20_000, 1, motion(100, 0)));
    }

    @Test
    public void nothingIsLeftOnceItIsCleared() {
        edge(8, Y, 1);
        history.clear();
        assertEquals(0, trace(100, 0));
    }
}
