package io.github.sofas.flow.search;

import static org.junit.Assert.assertEquals;
import static org.junit.Assert.assertFalse;
import static org.junit.Assert.assertTrue;

import io.github.sofas.event.SensorSize;
import io.github.sofas.flow.SofasParameters;
import io.github.sofas.flow.fit.MetricFit;
import java.util.Random;
import org.junit.Before;
import org.junit.Test;

/** Who gets what surrounds a structure, and when. */
public class TakingOverTest {
    private static final SensorSize SENSOR = new SensorSize(256, 96);
    private static final int POINTS = 3000;

    private final FlowPlane plane =
        new FlowPlane(SENSOR.width(), SENSOR.height(), SofasParameters.defaults().search());
    private final MetricFit fit = new MetricFit(SENSOR.width(), SENSOR.height(), MetricFit.CELL_PX, 4096, 300);
    private final OneStructure structure = new OneStructure();
    private final TakenEvents taken = new TakenEvents(plane);
    private final TakingOver takingOver = new TakingOver(plane, fit, structure, taken, new VoteBudget(0));

    /** A structure of 100 px/s that counts what it gets, and who tracks it. */
    private static final class OneStructure extends StructureThatMoves {
        private int handed;
        private int seen;
        private boolean begun;
        private boolean full;
        private boolean lost;

        OneStructure() {
            super(100);
        }

        @Override
        public boolean isFull() {
            return full;
        }

        @Override
        public boolean isTracked() {
            return begun && !lost;
        }

        @Override
        public void addPast(int x, int y, long timeUs, int polarity) {
            handed++;
        }

        @Override
        public void begin(long nowUs) {
            begun = true;
        }

        @Override
        public void see(int x, int y, long timeUs, int polarity, long nowUs) {
            seen++;
        }
    }

    /** A wall that moves right at 100 px/s for 60 ms. */
    @Before
    public void film() {
        addSteps(0, 6);
    }

    private void addSteps(int from, int to) {
        Random random = new Random(1);
        int[] x = random.ints(POINTS, 8, 230).toArray();
        int[] y = random.ints(POINTS, 8, 88).toArray();
        for (int step = from; step < to; step++) {
            for (int i = 0; i < POINTS; i++) {
                plane.add(x[i] + step, y[i], step * 10_000L + i * 3, i % 2 == 0 ? 1 : -1);
            }
        }
    }

    private void begin() {
        takingOver.begin(100, 0);
        takingOver.addPlace(plane.events().oldest());
    }

    private void goOnToTheEnd() {
        while (!takingOver.isOver()) {
            assertTrue(!takingOver.waits() || structure.begun);
            takingOver.goOn(40);
        }
    }

    @Test
    public void newStructureBeginsWithAllThatMovesAlikeAroundIt() {
        begin();
        goOnToTheEnd();
        assertTrue(structure.begun);
        assertTrue(takingOver.hasHanded());
        // of the last 40 ms
        assertTrue("handed " + structure.handed, structure.handed > 3 * POINTS);
        assertTrue("taken " + taken.size(), taken.size() > structure.handed);
    }

    /** Begins with the first region that shows a structure. */
    private void beginWithRegion() {
        RegionRefinement region = new RegionRefinement(plane.regions(), plane.recent(), fit);
        do {
            region.begin();
            while (!region.isOver()) {
                region.step();
            }
        } while (!region.isStructure());
        takingOver.begin(region);
    }

    @Test
    public void structureOfARegionBeginsWithAllThatMovesAlikeAroundIt() {
        plane.reset();
        addSteps(0, 5);
        beginWithRegion();
        assertFalse(takingOver.isOfPiece());
        goOnToTheEnd();
        assertTrue(structure.begun);
        assertTrue(takingOver.hasHanded());
        assertTrue("handed " + structure.handed, structure.handed > 3 * POINTS);
    }

    @Test
    public void structureIsNotOfAPieceOnceItIsTracked() {
        begin();
        assertTrue(takingOver.isOfPiece());
        goOnToTheEnd();
        addSteps(6, 12);
        assertTrue(takingOver.beginWithDue());
        assertFalse(takingOver.isOfPiece());
    }

    @Test
    public void nothingIsHandedWhereNoMoreStructuresAreTracked() {
        structure.full = true;
        begin();
        goOnToTheEnd();
        assertEquals(0, structure.handed);
        assertFalse(takingOver.hasHanded());
    }

    @Test
    public void structureBeginsOnlyIfItMayYetBeTrackedWhenAllIsHanded() {
        begin();
        while (structure.handed == 0) {
            takingOver.goOn(40);
        }
        structure.full = true;
        goOnToTheEnd();
        assertFalse(structure.begun);
        assertFalse(takingOver.hasHanded());
    }

    private void goOnUntilWhatIsTrackedMayGetMore() {
        begin();
        goOnToTheEnd();
        addSteps(6, 12);
        assertTrue(takingOver.beginWithDue());
        while (!takingOver.waits()) {
            takingOver.goOn(40);
        }
    }

    @Test
    public void structureThatIsTrackedSeesWhatEntersWhileNobodyElseWorksWithIt() {
        goOnUntilWhatIsTrackedMayGetMore();
        assertEquals(0, structure.seen);
        takingOver.handToTracked();
        int atOnce = structure.seen;
        assertTrue("seen " + atOnce, atOnce > 0 && atOnce <= 4096);
        goOnToTheEnd();
        assertTrue(takingOver.hasHanded());
    }

    @Test
    public void structureThatIsLostInTheMeantimeGetsNothing() {
        goOnUntilWhatIsTrackedMayGetMore();
        structure.lost = true;
        takingOver.handToTracked();
        assertTrue(takingOver.isOver());
        assertFalse(takingOver.hasHanded());
        assertEquals(0, structure.seen);
    }

    @Test
    public void eachEventEarnsFourHundredAndEightyVotesMore() {
        VoteBudget budget = new VoteBudget(0);
        TakingOver other = new TakingOver(plane, fit, structure, taken, budget);
        other.begin(100, 0);
        other.earn();
        budget.spend(480 - 1);
        assertTrue(budget.isLeft());
        budget.spend(1);
        assertFalse(budget.isLeft());
    }
}
