package io.github.sofas.flow.search;

import static org.junit.Assert.assertEquals;
import static org.junit.Assert.assertFalse;
import static org.junit.Assert.assertTrue;

import io.github.sofas.flow.PlainPlane.Event;
import io.github.sofas.flow.SofasParameters;
import io.github.sofas.flow.Streams;
import io.github.sofas.flow.fit.MetricFit;
import java.util.ArrayList;
import java.util.Comparator;
import java.util.List;
import org.junit.Test;

/** From a piece of the flow plane to a structure with a velocity, or to nothing. */
public class PieceRefinementTest {
    private static final int WIDTH = 64;
    private static final int HEIGHT = 48;
    private static final int CAPACITY = 4096;
    private static final SofasParameters P = SofasParameters.defaults();

    private final MetricFit fit = new MetricFit(WIDTH, HEIGHT, MetricFit.CELL_PX, CAPACITY, 300);

    /** Refines all events from a velocity. */
    private PieceRefinement refined(SofasParameters p, List<Event> events, double fromVx, double fromVy) {
        FlowPlane plane = new FlowPlane(WIDTH, HEIGHT, p.search());
        int[] numbers = new int[events.size()];
        for (int i = 0; i < numbers.length; i++) {
            Event e = events.get(i);
            plane.add(e.x(), e.y(), e.timeUs(), e.polarity());
            numbers[i] = i;
        }
        PieceRefinement refinement = new PieceRefinement(fit, p.search());
        refinement.begin(plane.events(), numbers, 0, numbers.length, fromVx, fromVy);
        while (!refinement.isOver()) {
            refinement.step();
        }
        return refinement;
    }

    /** An upright edge of 30 rows that moves right by a column each 10 ms, at 100 px/s. */
    private static List<Event> edge(int columns) {
        return Streams.edge(10, columns, 30, 0, 10_000);
    }

    /** A right angle of two edges of 20 px, which moves by (1, 1) px each 10 ms, at (100, 100) px/s. */
    private static List<Event> corner(int steps) {
        List<Event> events = new ArrayList<>();
        for (int step = 0; step < steps; step++) {
            for (int i = 0; i < 20; i++) {
                long timeUs = step * 10_000L + i * 200;
                events.add(new Event(5 + step + i, 5 + step, timeUs, 1));
                events.add(new Event(5 + step, 6 + step + i, timeUs, 1));
            }
        }
        return events;
    }

    @Test
    public void cornerIsFoundWithItsVelocity() {
        PieceRefinement found = refined(P, corner(12), 80, 120);
        assertTrue(found.isStructure());
        // right to a few percent, which the track plane's measurements improve
        assertEquals(100, found.vx(), 5);
        assertEquals(100, found.vy(), 5);
    }

    @Test
    public void straightEdgeGetsTheSlowestOfVelocitiesThatAreAboutAsGood() {
        // along itself nothing tells its velocity: it would keep the 60 px/s that its projection has
        PieceRefinement found = refined(P, edge(10), 90, 60);
        assertTrue(found.isStructure());
        assertEquals(100, found.vx(), 3);
        assertEquals(0, found.vy(), 6);
    }

    @Test
    public void edgesThatAreAllButParallelAreNotOneThatSlidesAlongBoth() {
        // 4 degrees apart, 60 and 30 px/s: one velocity that agrees with both, 430 px/s along them, and sharper by 7 %
        List<Event> edges = new ArrayList<>();
        addEdge(edges, 20, 12, 18, 60);
        addEdge(edges, 34, 34, 22, 30);
        edges.sort(Comparator.comparingLong(Event::timeUs));
        PieceRefinement found = refined(P, edges, 189, -388);
        assertTrue(found.isStructure());
        assertTrue(Math.hypot(found.vx(), found.vy()) < 65);
    }

    /** Adds 0.1 s of a straight edge of 28 px about a place, which moves across itself, in a direction in degrees. */
    private static void addEdge(List<Event> events, int centreX, int centreY, double degrees, double pxPerS) {
        double nx = Math.cos(Math.toRadians(degrees));
        double ny = Math.sin(Math.toRadians(degrees));
        for (int y = 0; y < HEIGHT; y++) {
            for (int x = 0; x < WIDTH; x++) {
                double across = (x - centreX) * nx + (y - centreY) * ny;
                double along = (y - centreY) * nx - (x - centreX) * ny;
                if (Math.abs(along) < 14 && across >= 0 && across < pxPerS * 0.1) {
                    events.add(new Event(x, y, (long) (across / pxPerS * 1e6), 1));
                }
            }
        }
    }

    @Test
    public void whatIsSharperAtRestIsNone() {
        List<Event> flicker = new ArrayList<>();
        for (int i = 0; i < 400; i++) {
            flicker.add(new Event(20 + i % 5, 20 + i / 5 % 5, i * 250L, 1));
        }
        long before = fit.votes();
        assertFalse(refined(P, flicker, 100, 0).isStructure());
        // it is given up before a fit: two metrics of 400 events, which all vote on one grid
        assertEquals(2 * 400, fit.votes() - before);
    }

    @Test
    public void whatHasNotTravelledEnoughIsNone() {
        // 0.6 of the 6 px that a projection's window spans: two columns are 1 px, eight are 7
        assertFalse(refined(P, edge(2), 100, 0).isStructure());
        assertTrue(refined(P, edge(8), 100, 0).isStructure());
    }

    @Test
    public void travelCountsHoweverOftenAPieceMeetsItself() {
        // four columns are 3 px, less than 3.6; six are 5
        SofasParameters anyDensity = P.with("evidence", 0);
        assertFalse(refined(anyDensity, edge(4), 100, 0).isStructure());
        assertTrue(refined(anyDensity, edge(6), 100, 0).isStructure());
    }

    @Test
    public void whatPassesRestByFewStandardDeviationsIsNone() {
        // n rows of six events, each of which meets the five others of its row, n * 30 in all, and none at rest: n = 1
        // passes that by sqrt(30) = 5.5, n = 3 by 9.5
        SofasParameters anyDensity = P.with("evidence", 0);
        assertFalse(refined(anyDensity, Streams.edge(10, 6, 1, 0, 10_000), 100, 0).isStructure());
        assertTrue(refined(anyDensity, Streams.edge(10, 6, 3, 0, 10_000), 100, 0).isStructure());
    }

    @Test
    public void hopelessPieceIsGivenUpAfterTheFirstFit() {
        // four px apart no event meets another, at rest or along any velocity near
        List<Event> apart = new ArrayList<>();
        for (int i = 0; i < 100; i++) {
            apart.add(new Event(i % 10 * 4, i / 10 * 4, i * 1000L, 1));
        }
        long before = fit.votes();
        assertFalse(refined(P, apart, 2, 0).isStructure());
        // two metrics to tell it from rest and eight more of the fit, of 100 events on two grids
        assertEquals(10 * 2 * 100, fit.votes() - before);
    }

    @Test
    public void edgeThatMeetsItselfTooSeldomIsNone() {
        assertTrue(refined(P, edge(8), 100, 0).isStructure());
        assertFalse(refined(P.with("evidence", 1000), edge(8), 100, 0).isStructure());
    }

    @Test
    public void textureIsFoundAfterLessTravelThanAnEdge() {
        // 100 dots that fire once per px, over 3 px: each event meets the three others of its dot, 3 * 400 in all, some
        // 30 standard deviations more than at rest, where none meets another
        assertTrue(refined(P, dots(4, 100, 0), 100, 0).isStructure());
        assertFalse(refined(P, edge(4), 100, 0).isStructure());
    }

    @Test
    public void textureThatStandsStillIsNone() {
        assertFalse(refined(P, dots(4, 0, 0), 100, 0).isStructure());
    }

    /** 100 dots far from each other that fire every 10 ms and move at (vx, vy) px/s. */
    private static List<Event> dots(int times, int vx, int vy) {
        List<Event> events = new ArrayList<>();
        for (int time = 0; time < times; time++) {
            for (int i = 0; i < 100; i++) {
                int x = 3 + i % 10 * 6 + i / 10 % 2 * 3;
                int y = 2 + i / 10 * 4;
                events.add(new Event(x + vx * time / 100, y + vy * time / 100, time * 10_000L + i, 1));
            }
        }
        return events;
    }

    @Test
    public void eventsOfOneMomentAreNone() {
        List<Event> moment = new ArrayList<>();
        for (int i = 0; i < 100; i++) {
            moment.add(new Event(i % 10, i / 10, 5, 1));
        }
        PieceRefinement refinement = refined(P, moment, 100, 0);
        assertTrue(refinement.isOver());
        assertFalse(refinement.isStructure());
    }

    @Test
    public void noMoreThanAThousandEventsAreFitted() {
        List<Event> dense = new ArrayList<>();
        for (Event e : corner(12)) {
            for (int k = 0; k < 4; k++) {
                dense.add(new Event(e.x(), e.y(), e.timeUs() + k, 1));
            }
        }
        assertEquals(1920, dense.size());
        assertTrue(refined(P, dense, 80, 120).isStructure());
        assertEquals(1000, fit.size());
    }
}
