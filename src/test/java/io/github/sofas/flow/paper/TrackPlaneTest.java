package io.github.sofas.flow.paper;

import static org.junit.Assert.assertEquals;
import static org.junit.Assert.assertFalse;
import static org.junit.Assert.assertTrue;

import io.github.sofas.flow.PlainPlane.Event;
import io.github.sofas.flow.SofasParameters;
import java.util.ArrayList;
import java.util.List;
import org.junit.Test;

/**
 * The paper's track plane worked out by hand. One projection in three lies at angle 0, so that a structure of events
 * that stand still has velocity 0; velocityScale 100 px/s at 45 degrees.
 */
public class TrackPlaneTest {
    /** One cycle of 3 x 3 projections over 6 degrees: h starts at 2 degrees, 3.49 px/s. */
    private static final Numbers P = Changed.of(Numbers.of(SofasParameters.paper()), "flowProjections", 3,
        "rangeDeg", 6, "cycles", 1, "thresholdSd", 0, "hitShare", 1, "contourThreshold", 2);
    private static final long SECOND = 1_000_000;

    /** A plane of 40 x 30 whose structure is a row of still dots on (10..9+n, 5), the first of them twice. */
    private static TrackPlane stillRow(Numbers p, int n) {
        List<Event> events = new ArrayList<>();
        events.add(new Event(10, 5, 0, 1));
        for (int i = 0; i < n; i++) {
            events.add(new Event(10 + i, 5, 0, 1));
        }
        return started(p, events, 1, 1);
    }

    /** A plane of 40 x 30 of the events that projection (i, j) of the flow plane associates. */
    private static TrackPlane started(Numbers p, List<Event> events, int i, int j) {
        Refinement structure = new Refinement(p);
        int n = events.size();
        long[] time = new long[n];
        short[] x = new short[n];
        short[] y = new short[n];
        byte[] sign = new byte[n];
        for (int e = 0; e < n; e++) {
            time[e] = events.get(e).timeUs();
            x[e] = (short) events.get(e).x();
            y[e] = (short) events.get(e).y();
            sign[e] = (byte) events.get(e).polarity();
        }
        structure.load(time, x, y, sign, 0, n);
        structure.refine(i, j);
        TrackPlane plane = new TrackPlane(40, 30, p);
        plane.start(7, structure);
        return plane;
    }

    @Test
    public void occupiedCellsOfEveryProjectionAreCounted() {
        // all at the reference time: no projection moves them
        TrackPlane plane = stillRow(P, 8);
        assertEquals(9, plane.live());
        for (int k = 0; k < 9; k++) {
            assertEquals(8, plane.cells(k % 3, k / 3));
        }
        assertEquals(0, plane.vxPxPerS, 0);
        assertEquals(List.of(10, 5, 17, 5), List.of(plane.minX, plane.minY, plane.maxX, plane.maxY));
    }

    @Test
    public void oldestEventsGoEarlyWhereMoreComeThanACellCanCount() {
        TrackPlane plane = stillRow(P, 28);
        for (int i = 0; i < 36_000; i++) {
            assertTrue(plane.offer(11 + i % 27, 5, i));
        }
        assertEquals(32_767, plane.live());
        // the dot that did not fire again went first
        assertEquals(27, plane.cells(1, 1));
    }

    @Test
    public void planesThatMergeKeepTheNewestEvents() {
        TrackPlane plane = stillRow(P, 28);
        TrackPlane other = stillRow(P, 28);
        for (int i = 0; i < 20_000; i++) {
            plane.offer(10 + i % 28, 5, i);
            other.offer(11 + i % 27, 5, 20_000 + i);
        }
        plane.merge(other);
        assertEquals(32_767, plane.live());
        assertEquals(28, plane.cells(1, 1));
    }

    @Test
    public void eventOnTheContourBelongsAndOneBesideItDoesNot() {
        TrackPlane plane = stillRow(P, 8);
        assertTrue(plane.offer(17, 5, 10));
        assertFalse(plane.offer(18, 5, 20));
        assertFalse(plane.offer(17, 6, 30));
        assertEquals(1, plane.events);
        assertEquals(10, plane.lastUs);
    }

    @Test
    public void contourEvolvesPastTheThreshold() {
        // threshold 2: the third event that misses at one cell makes it contour, and the fourth falls on contour
        TrackPlane plane = stillRow(P, 8);
        assertFalse(plane.offer(30, 20, 10));
        assertFalse(plane.offer(30, 20, 20));
        assertEquals(8, plane.cells(1, 1));
        assertTrue(plane.offer(30, 20, 30));
        assertEquals(9, plane.cells(1, 1));
        assertTrue(plane.offer(30, 20, 40));
        assertEquals(9, plane.cells(1, 1));
    }

    @Test
    public void centreThatIsBestHalvesTheDistance() {
        // Share 0.5 of 8 cells is passed by the fifth hit. At time 0 all projections are hit alike: the centre is best.
        // h goes from 2 to 1 degree: one second later the neighbour has moved round(100 tan 1 * 1) = 2 px, not 3.
        TrackPlane plane = stillRow(Changed.of(P, "hitShare", 0.5, "minPerturbationDeg", 0.3), 8);
        for (int i = 0; i < 5; i++) {
            assertEquals("before hit " + i, 2, distance(plane), 0);
            assertTrue(plane.offer(10 + i, 5, 0));
        }
        assertEquals(1, distance(plane), 0);
        for (int i = 0; i < 7; i++) {
            assertTrue(plane.offer(10, 5, 0));
        }
        // five more hits halve again; the next halving meets the least distance
        assertEquals(0.5, distance(plane), 0);
        for (int i = 0; i < 5; i++) {
            assertTrue(plane.offer(10, 5, 0));
        }
        assertEquals(0.3, distance(plane), 0);
        assertEquals(0, plane.vxPxPerS, 0);
    }

    private static double distance(TrackPlane plane) {
        return plane.perturbationDeg();
    }

    /** Ten dots two columns apart, of two events each, and a lone one below the first: a plane that stands still. */
    private static TrackPlane spacedDots(Numbers p) {
        // threshold: the mean of ten cells of 2 and one of 1, so that each dot is associated though none are connected
        List<Event> events = new ArrayList<>();
        for (int i = 0; i < 10; i++) {
            events.add(new Event(10 + 2 * i, 5, 0, 1));
            events.add(new Event(10 + 2 * i, 5, 0, 1));
        }
        events.add(new Event(10, 6, 0, 1));
        return started(p, events, 1, 1);
    }

    @Test
    public void neighbourThatIsBestBecomesTheCentreAndDoublesTheDistance() {
        // 11 cells: (10 + 2i, 5) and (10, 6). After 0.4 s the neighbours stand 100 tan 2 * 0.4 = 1.40 px off: 1 px.
        // Dots that moved 1 px right are hit by the right-hand projection of the middle row only: (11 + 2i) - 1.
        // The one to the left sees (11 + 2i) + 1 = 12 + 2i, a dot for all but the last: so it is hit as well, one dot
        // less. Share 0.8 of 11 cells = 8.8 is passed by the ninth hit. With the last dot first, right is ahead.
        TrackPlane plane = spacedDots(Changed.of(P, "hitShare", 0.8));
        assertEquals(11, plane.cells(1, 1));
        for (int i = 9; i > 1; i--) {
            assertFalse(plane.offer(11 + 2 * i, 5, 400_000));
            assertEquals(0, plane.vxPxPerS, 0);
        }
        assertFalse(plane.offer(11 + 2, 5, 400_000));
        assertEquals(100 * Math.tan(Math.toRadians(2)), plane.vxPxPerS, 1e-5);
        assertEquals(0, plane.vyPxPerS, 0);
        assertEquals(4, plane.perturbationDeg(), 0);
    }

    @Test
    public void distanceStopsDoublingAtItsGreatest() {
        TrackPlane plane = spacedDots(Changed.of(P, "hitShare", 0.8, "maxPerturbationDeg", 3));
        for (int i = 9; i >= 1; i--) {
            assertFalse(plane.offer(11 + 2 * i, 5, 400_000));
        }
        assertEquals(3, plane.perturbationDeg(), 0);
    }

    @Test
    public void eventLeavesAfterTheTimeToCrossTheLifetimesPixels() {
        // at 2 degrees the plane moves 3.492077 px/s: 3 px take 859,087.6 us
        TrackPlane plane = stillDots(Changed.of(P, "minShare", 0), 5, 5, 1);
        assertEquals(100 * Math.tan(Math.toRadians(2)), plane.vxPxPerS, 1e-5);
        assertFalse(plane.isStarved(859_087));
        assertEquals(11, plane.live());
        assertTrue(plane.isStarved(859_088));
        assertEquals(0, plane.live());
    }

    @Test
    public void lifetimeOfAPlaneThatStandsStillIsTheLongest() {
        TrackPlane plane = stillRow(Changed.of(P, "maxLifetimeUs", 2 * SECOND), 8);
        plane.isStarved(2 * SECOND);
        assertEquals(9, plane.live());
        plane.isStarved(2 * SECOND + 1);
        assertEquals(0, plane.live());
    }

    @Test
    public void planeWithFewerEventsThanItsShareOfCellsALifetimeIsStarved() {
        // 8 cells, share 0.25: 2 events in a lifetime of 1 s do, 1 is not; and nobody asks before a lifetime is over
        Numbers p = Changed.of(P, "minShare", 0.25, "maxLifetimeUs", SECOND);
        TrackPlane fed = stillRow(p, 8);
        fed.offer(10, 5, 100);
        fed.offer(11, 5, 200);
        assertFalse(fed.isStarved(SECOND));
        TrackPlane hungry = stillRow(p, 8);
        hungry.offer(10, 5, 100);
        assertFalse(hungry.isStarved(SECOND - 1));
        assertTrue(hungry.isStarved(SECOND));
    }

    @Test
    public void planeWithoutLiveEventsIsStarvedAtOnce() {
        assertTrue(stillRow(Changed.of(P, "minShare", 0), 8).isStarved(SECOND + 1));
    }

    @Test
    public void planesOfSimilarVelocityWhoseBoxesTouchDescribeTheSame() {
        TrackPlane a = stillRow(P, 8); // columns 10 to 17, row 5
        assertTrue(a.describesSameAs(stillDots(P, 18, 5, 0)));
        assertTrue(a.describesSameAs(stillDots(P, 18, 6, 0)));
        assertFalse(a.describesSameAs(stillDots(P, 19, 5, 0)));
        assertFalse(a.describesSameAs(stillDots(P, 12, 7, 0)));
        // 3.5 px/s apart is more than 15 % of 3.5 px/s
        assertFalse(a.describesSameAs(stillDots(P, 18, 5, 1)));
    }

    /** Ten dots from (x, y) to the right, at time 0, taken to move right at 2 degrees times the last argument. */
    private static TrackPlane stillDots(Numbers p, int x, int y, int right) {
        List<Event> events = new ArrayList<>();
        for (int i = 0; i < 10; i++) {
            events.add(new Event(x + i, y, 0, 1));
        }
        events.add(new Event(x, y, 0, 1));
        return started(p, events, 1 + right, 1);
    }

    @Test
    public void mergedPlaneTakesOverEventsCellsAndBox() {
        TrackPlane a = stillRow(P, 8); // 9 events on 8 cells
        TrackPlane b = stillDots(P, 18, 6, 0); // 11 events on 10 cells
        assertTrue(a.offer(10, 5, 100));
        assertTrue(b.offer(18, 6, 50));
        assertTrue(b.offer(19, 6, 150));
        a.merge(b);
        assertEquals(10 + 13, a.live());
        assertEquals(18, a.cells(1, 1));
        assertEquals(3, a.events);
        assertEquals(150, a.lastUs);
        assertEquals(List.of(10, 5, 27, 6), List.of(a.minX, a.minY, a.maxX, a.maxY));
        assertTrue(a.offer(27, 6, 200));
    }

    @Test
    public void planeWhoseEventsHaveAllLeftKeepsItsVelocityAndBox() {
        // a hit, then an event after the end of all live ones: there are no cells of which a share could be hit
        TrackPlane plane = stillRow(Changed.of(P, "maxLifetimeUs", SECOND), 8);
        assertTrue(plane.offer(17, 5, 10));
        assertFalse(plane.offer(30, 5, 3 * SECOND));
        assertEquals(0, plane.live());
        assertEquals(2, plane.perturbationDeg(), 0);
        assertEquals(List.of(10, 5, 17, 5), List.of(plane.minX, plane.minY, plane.maxX, plane.maxY));
    }

    @Test
    public void neighbourOfASteepProjectionStaysShortOfTheRightAngle() {
        // 31 projections over 180 degrees: the last at 87.097 degrees, 1,972 px/s, h = 5.806. The neighbour to the
        // right is kept at 89 degrees, 5,729 px/s; at 92.9 it would move left. Ten dots at 1,000 us, and the same 800
        // us earlier, 1.58 px to the left: the centre sees ten cells, the neighbour the earlier ones 4.58 px to the
        // left of where it expects them, 5 - 2 = 3 cells beyond: 13.
        List<Event> events = new ArrayList<>();
        for (long t = 200; t <= 1000; t += 800) {
            for (int i = 0; i < 10; i++) {
                events.add(new Event((t == 200 ? 18 : 20) + i, 5, t, 1));
            }
        }
        events.add(new Event(20, 5, 1000, 1));
        TrackPlane plane = started(Changed.of(P, "flowProjections", 31, "rangeDeg", 180), events, 30, 15);
        assertEquals(21, plane.live());
        assertEquals(10, plane.cells(1, 1));
        assertEquals(13, plane.cells(2, 1));
    }

    @Test
    public void eventFarFromTheContourMissesHoweverLongTheLifetime() {
        // a lifetime of 100 px on a sensor of 40; at 3.492 px/s the plane has moved round(64.01) = 64 px after 18.33 s:
        // dots at 5 to 14 are expected at 69 to 78, and the pixel where they were is not on the contour
        TrackPlane plane = stillDots(Changed.of(P, "lifetimePx", 100, "maxLifetimeUs", 60 * SECOND),
            5, 5, 1);
        assertFalse(plane.offer(5, 5, 18_330_000));
        assertEquals(11, plane.live());
        assertEquals(0, plane.events);
    }

    @Test
    public void missesOfOnePixelAtDifferentTimesRaiseDifferentCells() {
        // two misses at time 0, and a third when the plane has moved on by round(64.01) = 64 px: another cell
        TrackPlane plane = stillDots(P, 5, 5, 1);
        assertFalse(plane.offer(30, 20, 0));
        assertFalse(plane.offer(30, 20, 0));
        assertFalse(plane.offer(30, 20, 18_330_000));
    }

    @Test
    public void distanceStartsWithinItsBounds() {
        // the spacing of the last cycle is 6 / 3 = 2 degrees
        assertEquals(2, stillRow(P, 8).perturbationDeg(), 0);
        assertEquals(1, stillRow(Changed.of(P, "maxPerturbationDeg", 1), 8).perturbationDeg(), 0);
        assertEquals(3, stillRow(Changed.of(P, "minPerturbationDeg", 3), 8).perturbationDeg(), 0);
    }
}
