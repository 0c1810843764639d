package io.github.sofas.flow.paper;

import static org.junit.Assert.assertEquals;
import static org.junit.Assert.assertFalse;
import static org.junit.Assert.assertTrue;

import io.github.sofas.flow.PlainPlane.Event;
import io.github.sofas.flow.SofasParameters;
import io.github.sofas.flow.Streams;
import java.util.List;
import org.junit.Test;

/**
 * The paper's flow plane worked out by hand: 9 x 9 projections, 20 degrees apart, velocity 100 tan(angle) px/s. Index 4
 * stands still, 5 is 36.4 px/s to the right or down, 6 is 83.9 px/s, 7 is 173.2 px/s, 8 is 567.1 px/s.
 */
public class FlowPlaneTest {
    private static final Numbers P = Numbers.of(SofasParameters.paper());

    @Test
    public void voteRaisesTheMetricByTwiceTheCellAndOne() {
        // f = 0, 1, 2, 3 before each vote w = 1 on one cell: + 2 w f + w^2 = 1, 3, 5, 7; then an OFF event, w = -1 on
        // f = 4: - 8 + 1; then a cell of its own: + 1
        FlowPlane plane = new FlowPlane(40, 30, P);
        long[] metric = {1, 4, 9, 16};
        for (int i = 0; i < 4; i++) {
            plane.add(7, 7, 0, 1);
            assertEquals(metric[i], plane.metric(4, 4));
            assertEquals(metric[i], plane.metric(8, 0));
        }
        plane.add(7, 7, 0, -1);
        assertEquals(9, plane.metric(4, 4));
        plane.add(20, 3, 0, -1);
        assertEquals(10, plane.metric(4, 4));
    }

    @Test
    public void eventsOlderThanTheLifespanAreFlushedAndTheMetricFallsBack() {
        // three events on one cell, 9; at 100,000 us another cell, 10; at 200,000 all live; at 200,001 the three leave
        FlowPlane plane = new FlowPlane(40, 30, Changed.of(P, "lifespanUs", 200_000));
        for (int i = 0; i < 3; i++) {
            plane.add(7, 7, 0, 1);
        }
        plane.add(20, 20, 100_000, 1);
        plane.add(30, 20, 200_000, 1);
        assertEquals(5, plane.size());
        assertEquals(11, plane.metric(4, 4));
        plane.add(35, 20, 200_001, 1);
        assertEquals(3, plane.size());
        assertEquals(3, plane.metric(4, 4));
    }

    @Test
    public void oldestEventsGoEarlyWhereMoreComeThanACellCanCount() {
        // 40,000 events on one cell in 40 ms: the newest 32,767 are held, and their metric is their square
        FlowPlane plane = new FlowPlane(40, 30, Changed.of(P, "flowProjections", 3, "constantEvents", 100_000));
        for (int i = 0; i < 40_000; i++) {
            plane.add(7, 7, i, 1);
        }
        assertEquals(32_767, plane.size());
        assertEquals(32_767L * 32_767, plane.metric(1, 1));
        plane.add(20, 20, 300_000, 1);
        assertEquals(1, plane.size());
        assertEquals(1, plane.metric(1, 1));
    }

    @Test
    public void eventFallsWhereItsProjectionPutsIt() {
        // at 36.397 px/s two events 27,475 us and 1 px apart meet (1.00000 px), in x with (5, 4), in y with (4, 5)
        FlowPlane plane = new FlowPlane(40, 30, P);
        plane.add(10, 10, 0, 1);
        plane.add(11, 10, 27_475, 1);
        assertEquals(4, plane.metric(5, 4));
        assertEquals(2, plane.metric(4, 4));
        assertEquals(2, plane.metric(4, 5));
        assertEquals(2, plane.metric(3, 4));
        FlowPlane down = new FlowPlane(40, 30, P);
        down.add(10, 10, 0, 1);
        down.add(10, 11, 27_475, 1);
        assertEquals(4, down.metric(4, 5));
        assertEquals(2, down.metric(5, 4));
    }

    @Test
    public void edgeThatMovedAKnownDistanceGivesTheKnownProjection() {
        // 12 columns at 83.9 px/s, 40 degrees: a column in 11,918 us; in y nothing moves, the slowest is 0 degrees
        assertAngles(40, 0, Streams.edge(3, 12, 20, 0, 11_918));
        assertAngles(-40, 0, Streams.edge(36, 12, 20, 0, -11_918));
    }

    private static void assertAngles(double angleX, double angleY, List<Event> edge) {
        Numbers p = Changed.of(P, "cycles", 1, "constantEvents", edge.size() / 3, "minEvents", 8);
        FlowPlane plane = new FlowPlane(40, 30, p);
        // one event more on one cell, so that there is a cell above the mean
        boolean found = plane.add(edge.get(0).x(), edge.get(0).y(), edge.get(0).timeUs(), edge.get(0).polarity());
        for (int e = 0; e < edge.size() && !found; e++) {
            found = plane.add(edge.get(e).x(), edge.get(e).y(), edge.get(e).timeUs(), edge.get(e).polarity());
        }
        assertTrue("found", found);
        assertEquals(angleX, plane.structure().angleX(), 0);
        assertEquals(angleY, plane.structure().angleY(), 0);
    }

    @Test
    public void tiesGoToTheSlowest() {
        // events of one moment look alike from everywhere; then two events that meet at (5, 4) and nowhere slower, but
        // also at faster ones
        Numbers p = Changed.of(P, "cycles", 1, "constantEvents", 1, "minEvents", 100_000);
        FlowPlane plane = new FlowPlane(40, 30, p);
        for (int k = 0; k < 5; k++) {
            plane.add(5 + k, 9, 0, 1);
            assertEquals(0, plane.structure().angleX(), 0);
            assertEquals(0, plane.structure().angleY(), 0);
        }
        // 5 px above the row after 0.06 s: (4, 3) went 2.2 px, (4, 2) 5.04 px, to the nearest 5; (3, 2), (2, 2) and
        // others as well
        plane.add(7, 4, 60_000, 1);
        assertEquals(8, plane.metric(4, 2));
        assertEquals(8, plane.metric(5, 2));
        assertEquals(6, plane.metric(4, 4));
        assertEquals(0, plane.structure().angleX(), 0);
        assertEquals(-40, plane.structure().angleY(), 0);
    }

    @Test
    public void structureIsFoundWhenTheGreatestStaysForTheGivenEvents() {
        // nine events on one cell and eleven beside it; the greatest is (4, 4) from the first: the twentieth event ends
        // the wait
        Numbers p = Changed.of(P, "cycles", 1, "constantEvents", 20, "minEvents", 8, "thresholdSd", 0);
        FlowPlane plane = new FlowPlane(40, 30, p);
        for (int k = 0; k < 9; k++) {
            assertFalse(plane.add(5, 9, 0, 1));
        }
        for (int k = 0; k < 10; k++) {
            assertFalse(plane.add(6, 9, 0, 1));
        }
        assertTrue(plane.add(6, 9, 0, 1));
        assertEquals(20, plane.structure().size());
    }

    @Test
    public void structureOfTooFewEventsIsLeftInThePlane() {
        Numbers p = Changed.of(P, "cycles", 1, "constantEvents", 20, "minEvents", 21, "thresholdSd", 0);
        FlowPlane plane = new FlowPlane(40, 30, p);
        for (int k = 0; k < 20; k++) {
            assertFalse(plane.add(k < 9 ? 5 : 6, 9, 0, 1));
        }
        assertEquals(20, plane.size());
        // and the wait starts anew: 20 more events
        for (int k = 0; k < 19; k++) {
            assertFalse(plane.add(6, 9, 0, 1));
        }
        assertTrue(plane.add(6, 9, 0, 1));
    }

    @Test
    public void restIsProjectedAgainAfterTheRelease() {
        // a lone event far off stays; the plane is seen from its time on
        Numbers p = Changed.of(P, "cycles", 1, "constantEvents", 21, "minEvents", 8, "thresholdSd", 0);
        FlowPlane plane = new FlowPlane(40, 30, p);
        plane.add(30, 20, 0, 1);
        for (int k = 0; k < 20; k++) {
            boolean found = plane.add(k < 9 ? 5 : 6, 9, 0, 1);
            assertEquals(k == 19, found);
        }
        assertEquals(1 + 9 * 9 + 11 * 11, plane.metric(4, 4));
        plane.release();
        assertEquals(1, plane.size());
        for (int k = 0; k < 81; k++) {
            assertEquals(1, plane.metric(k % 9, k / 9));
        }
        // the rest meets what comes: 27,475 us later 1 px to the right
        plane.add(31, 20, 27_475, 1);
        assertEquals(4, plane.metric(5, 4));
    }

    @Test
    public void resetEmptiesEveryProjection() {
        FlowPlane plane = new FlowPlane(40, 30, P);
        for (Event e : Streams.edge(3, 5, 20, -100, 5_000)) {
            plane.add(e.x(), e.y(), e.timeUs(), e.polarity());
        }
        plane.reset();
        assertEquals(0, plane.size());
        for (int k = 0; k < 81; k++) {
            assertEquals(0, plane.metric(k % 9, k / 9));
        }
    }
}
