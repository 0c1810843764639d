package io.github.sofas.flow.search;

import static org.junit.Assert.assertEquals;
import static org.junit.Assert.assertTrue;

import io.github.sofas.event.SensorSize;
import io.github.sofas.flow.PlainPlane.Event;
import io.github.sofas.flow.SofasParameters;
import io.github.sofas.flow.Streams;
import io.github.sofas.flow.fit.MetricFit;
import java.util.List;
import java.util.Random;
import org.junit.Test;

/** What is looked at, what it may cost, and what a new structure gets of the events that come in the meantime. */
public class StructureSearchTest {
    private static final SofasParameters P = SofasParameters.defaults();
    private static final int WALL_POINTS = 5000;
    private static final SensorSize SENSOR = new SensorSize(64, 48);
    private static final int ROWS = 30;

    /** Takes every structure, and counts them. */
    private static class AllStructures extends StructureThatMoves {
        int begun;

        AllStructures() {
            super(100);
        }

        @Override
        public void begin(long nowUs) {
            begun++;
        }

        @Override
        public boolean expects(int x, int y, long timeUs, int polarity) {
            return true;
        }
    }

    /**
     * Lets an edge of 100 px/s be found, which enters a ninth column while it is refined, and returns how many events
     * are left in the second slowest ring.
     *
     * @param column whether the ninth column has events
     * @param ofAnother events of that column that ring 0 is rid of, as another structure was given them
     */
    private static int left(boolean column, int ofAnother) {
        FlowPlane plane = new FlowPlane(SENSOR.width(), SENSOR.height(), P.search());
        AllStructures structures = new AllStructures();
        MetricFit fit = new MetricFit(SENSOR.width(), SENSOR.height(), MetricFit.CELL_PX, 4096, 300);
        StructureSearch search = new StructureSearch(plane, P.search(), fit, structures, 0);
        List<Event> edge = Streams.edge(4, 9, ROWS, 0, 10_000);
        for (int i = 0; i < 9 * ROWS; i++) {
            if (i == 8 * ROWS) {
                plane.settle(71_000);
                search.run(0, 0);
            }
            if (i < 8 * ROWS || column) {
                Event e = edge.get(i);
                plane.add(e.x(), e.y(), e.timeUs(), e.polarity());
            }
        }
        int[] events = new int[ofAnother];
        for (int i = 0; i < ofAnother; i++) {
            events[i] = 8 * ROWS + i;
        }
        plane.takeOut(0, events, 0, ofAnother);
        for (int i = 0; i < 2_000; i++) {
            search.run(0, 0);
        }
        assertEquals("structures", 1, structures.begun);
        // the ring takes in what is left after 1/16 of the time of 6 px at 6.9 px/s: 55 ms
        plane.settle(140_000);
        return plane.count(1);
    }

    @Test
    public void newStructureGetsWhatCameWhileItWasRefined() {
        assertEquals(left(false, 0), left(true, 0));
    }

    @Test
    public void newStructureGetsNoEventThatAnotherHas() {
        assertEquals(left(true, 0) + 10, left(true, 10));
    }

    /** A search in a flow plane that holds an edge which is to be found. */
    private static final class Budget {
        private final MetricFit fit = new MetricFit(SENSOR.width(), SENSOR.height(), MetricFit.CELL_PX, 4096, 300);
        private final AllStructures structures = new AllStructures();
        private final StructureSearch search;

        Budget() {
            FlowPlane plane = new FlowPlane(SENSOR.width(), SENSOR.height(), P.search());
            for (Event e : Streams.edge(4, 9, ROWS, 0, 10_000)) {
                plane.add(e.x(), e.y(), e.timeUs(), e.polarity());
            }
            plane.settle(81_000);
            search = new StructureSearch(plane, P.search(), fit, structures, 0);
        }

        private int eventsUntilFound(long measuringVotes) {
            return eventsUntilFound(0, measuringVotes);
        }

        /**
         * Events until the edge is found.
         *
         * @param before votes that measurements gave before
         * @param measuringVotes votes that they give for each event
         */
        private int eventsUntilFound(long before, long measuringVotes) {
            int events = 0;
            while (structures.begun == 0) {
                events++;
                search.run(before + events * measuringVotes, 0);
                assertTrue("never found", events < 10_000);
            }
            return events;
        }
    }

    @Test
    public void eachEventEarnsAHundredAndTwentyVotes() {
        Budget budget = new Budget();
        // the dearest step: nine metrics of the edge's 270 events, each on two grids
        long mostAtOnce = 9 * 2 * 9 * ROWS;
        for (int i = 1; budget.structures.begun == 0; i++) {
            budget.search.run(0, 0);
            assertTrue("votes after " + i + " events: " + budget.fit.votes(),
                budget.fit.votes() <= 120L * i + mostAtOnce);
        }
    }

    @Test
    public void measurementsLeaveTwoThirdsToTheSearchAtLeast() {
        int alone = new Budget().eventsUntilFound(0);
        int beside = new Budget().eventsUntilFound(40);
        int starved = new Budget().eventsUntilFound(1_000_000);
        // 120 - 40 votes per event are left, and no fewer however many are owed
        assertEquals(1.5, (double) beside / alone, 0.1);
        assertEquals(beside, starved);
    }

    @Test
    public void debtsArePaidByTheEventsThatFollow() {
        Budget budget = new Budget();
        // of 2,000 votes owed, 40 are paid with each of 50 events; then all 120 are the search's
        budget.search.run(2_000, 0);
        int events = 1 + budget.eventsUntilFound(2_000, 0);
        int alone = new Budget().eventsUntilFound(0);
        assertTrue("more than 50 events: " + alone, alone > 50);
        assertEquals(alone + 2_000 / 120.0, events, 2);
    }

    /** A search over events that are added as the test wants them. */
    private static final class Looks {
        private final FlowPlane plane = new FlowPlane(SENSOR.width(), SENSOR.height(), P.search());
        private final MetricFit fit = new MetricFit(SENSOR.width(), SENSOR.height(), MetricFit.CELL_PX, 4096, 300);
        private final AllStructures structures = new AllStructures();
        private final StructureSearch search = new StructureSearch(plane, P.search(), fit, structures, 0);
        private final Random random = new Random(8);

        /** Events of either polarity at chance places and times of a tenth of a second. */
        private void addNoise(int count, long fromUs) {
            for (int i = 0; i < count; i++) {
                plane.add(random.nextInt(SENSOR.width()), random.nextInt(SENSOR.height()),
                    fromUs + 100_000L * i / count, random.nextBoolean() ? 1 : -1);
            }
        }

        /** Five by five pixels that fire again and again, and go nowhere. */
        private void addFlicker(int count, long fromUs) {
            for (int i = 0; i < count; i++) {
                plane.add(50 + i % 5, 40 + i / 5 % 5, fromUs + 80_000L * i / count, 1);
            }
        }

        /** Settles what was added, looks as often as is wanted, and returns the votes that it gave. */
        private long look(long nowUs) {
            long before = fit.votes();
            plane.settle(nowUs);
            for (int i = 0; i < 5_000; i++) {
                search.run(0, 0);
            }
            return fit.votes() - before;
        }
    }

    @Test
    public void noiseIsNotLookedAt() {
        Looks looks = new Looks();
        looks.addNoise(600, 0);
        assertEquals(0, looks.look(100_000));
    }

    @Test
    public void noiseThatFillsARegionVotesOnce() {
        Looks looks = new Looks();
        looks.addNoise(2_000, 0);
        assertEquals(2_000, looks.look(100_000));
    }

    @Test
    public void pieceThatWasLookedAtInVainIsNotLookedAtAgain() {
        Looks looks = new Looks();
        looks.addFlicker(400, 0);
        assertTrue(looks.look(80_000) > 0);
        // enough events for a look each time, but few of the piece: it is looked at once more in each ring at most
        long nowUs = 80_000;
        long last = 1;
        for (int i = 0; i < 20 && last > 0; i++) {
            looks.addNoise(150, nowUs);
            nowUs += 100_000;
            last = looks.look(nowUs);
        }
        assertEquals(0, last);
        // as many again as it had
        looks.addFlicker(400, nowUs);
        assertTrue(looks.look(nowUs + 80_000) > 0);
        assertEquals(0, looks.structures.begun);
    }

    /** Knows structure 7, which is everywhere and moves right at 100 px/s, and counts the events that it is shown. */
    private static final class OneKnown extends AllStructures {
        private int seen;

        @Override
        public void report(Recognition to, long nowUs) {
            Recognition.Known known = to.know(7, 10_000);
            known.motion().set(nowUs, 100, 0);
            known.box().include(0, 0);
            known.box().include(SENSOR.width(), SENSOR.height());
        }

        @Override
        public void see(int id, int x, int y, long timeUs, int polarity, long nowUs) {
            assertEquals(7, id);
            seen++;
        }
    }

    /** A search for an edge that moves as structure 7 does. */
    private static StructureSearch searchForPart(OneKnown structures) {
        FlowPlane plane = new FlowPlane(SENSOR.width(), SENSOR.height(), P.search());
        MetricFit fit = new MetricFit(SENSOR.width(), SENSOR.height(), MetricFit.CELL_PX, 4096, 300);
        for (Event e : Streams.edge(4, 9, ROWS, 0, 10_000)) {
            plane.add(e.x(), e.y(), e.timeUs(), e.polarity());
        }
        plane.settle(81_000);
        return new StructureSearch(plane, P.search(), fit, structures, 0);
    }

    private static void look(StructureSearch search, boolean nobodyTracks) {
        for (int i = 0; i < 2_000; i++) {
            search.run(0, 0, nobodyTracks);
        }
    }

    @Test
    public void partOfAStructureThatIsTrackedIsShownToItOnce() {
        OneKnown structures = new OneKnown();
        StructureSearch search = searchForPart(structures);
        look(search, true);
        int seen = structures.seen;
        // its own 6 px of travel, at least
        assertTrue("seen " + seen, seen >= 6 * ROWS);
        look(search, true);
        assertEquals(seen, structures.seen);
        assertEquals(0, structures.begun);
    }

    @Test
    public void whileOthersTrackAStructureItsPartsWait() {
        OneKnown structures = new OneKnown();
        StructureSearch search = searchForPart(structures);
        search.spread();
        look(search, false);
        assertEquals(0, structures.seen);
        search.spread();
        assertTrue(structures.seen >= 6 * ROWS);
        assertEquals(0, structures.begun);
        // or until others do no longer
        structures = new OneKnown();
        search = searchForPart(structures);
        search.spread();
        look(search, false);
        look(search, true);
        assertTrue(structures.seen >= 6 * ROWS);
    }

    /** Counts the events that a structure is handed. */
    private static final class Counting extends AllStructures {
        private int handed;
        private int handedInSmallSteps;
        private int mostAtOnce;

        @Override
        public void addPast(int x, int y, long timeUs, int polarity) {
            handed++;
        }

        @Override
        public boolean expects(int x, int y, long timeUs, int polarity) {
            // what comes while a piece is refined counts as little as what comes later
            return false;
        }
    }

    @Test
    public void wallIsHandedToAStructureInSmallSteps() {
        int handed = 0;
        int inSmallSteps = 0;
        for (int seed = 1; seed <= 4; seed++) {
            Counting structures = searchWall(seed);
            assertTrue("begun", structures.begun > 0);
            handed += structures.handed;
            inSmallSteps += structures.handedInSmallSteps;
            // no more than a part of 48 px, an eighth of the wall, whose points gave 4 or 5 events each
            assertTrue("handed at once " + structures.mostAtOnce, structures.mostAtOnce <= 5 * WALL_POINTS / 8);
        }
        assertTrue("handed " + handed, handed > 4 * 3 * WALL_POINTS);
        // what is not are the pieces that the wall is found by, each of which is handed over at once
        assertTrue("in small steps " + inSmallSteps + " of " + handed, inSmallSteps > handed / 2);
    }

    private static Counting searchWall(int seed) {
        SensorSize sensor = new SensorSize(256, 96);
        FlowPlane plane = new FlowPlane(sensor.width(), sensor.height(), P.search());
        MetricFit fit = new MetricFit(sensor.width(), sensor.height(), MetricFit.CELL_PX, 4096, 300);
        Counting structures = new Counting();
        StructureSearch search = new StructureSearch(plane, P.search(), fit, structures, 0);
        Random random = new Random(seed);
        int[] x = random.ints(WALL_POINTS, 8, 240).toArray();
        int[] y = random.ints(WALL_POINTS, 8, 88).toArray();
        for (int i = 0; i < 10 * WALL_POINTS; i++) {
            // each point moves right at 100 px/s
            long timeUs = 10_000L * i / WALL_POINTS;
            plane.add(x[i % WALL_POINTS] + i / WALL_POINTS, y[i % WALL_POINTS], timeUs, i % 2 == 0 ? 1 : -1);
            if (plane.mustSettle(timeUs)) {
                plane.settle(timeUs);
            }
            int before = structures.handed;
            search.run(0, 0);
            int step = structures.handed - before;
            structures.handedInSmallSteps += step <= Surroundings.AT_ONCE ? step : 0;
            structures.mostAtOnce = Math.max(structures.mostAtOnce, step);
        }
        return structures;
    }
}
