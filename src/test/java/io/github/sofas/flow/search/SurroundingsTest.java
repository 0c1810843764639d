package io.github.sofas.flow.search;

import static org.junit.Assert.assertEquals;
import static org.junit.Assert.assertFalse;
import static org.junit.Assert.assertTrue;

import io.github.sofas.event.SensorSize;
import io.github.sofas.flow.fit.MetricFit;
import java.util.ArrayList;
import java.util.List;
import java.util.Random;
import org.junit.Test;

/** What a new structure takes over from around it. */
public class SurroundingsTest {
    private static final SensorSize SENSOR = new SensorSize(256, 96);
    private static final long NOW_US = 60_000;

    private final RecentEvents events = new RecentEvents(SENSOR);
    private final MetricFit fit = new MetricFit(256, 96, MetricFit.CELL_PX, 4096, 300);
    private final Surroundings surroundings = new Surroundings(SENSOR, events, fit);

    /** Two textures side by side: points left of column 128 move right at 100 px/s, the others by another velocity. */
    private void film(int rightVx, int rightVy) {
        Random random = new Random(1);
        int points = 3000;
        int[] x = random.ints(points, 8, 248).toArray();
        int[] y = random.ints(points, 8, 88).toArray();
        for (int step = 0; step < 6; step++) {
            for (int i = 0; i < points; i++) {
                boolean left = x[i] < 128;
                events.add(x[i] + step * (left ? 1 : rightVx / 100), y[i] + step * (left ? 0 : rightVy / 100),
                    step * 10_000L + i * 3, i % 2 == 0 ? 1 : -1);
            }
        }
    }

    private void spreadFrom(int x, int y) {
        surroundings.begin(100, 0, NOW_US);
        surroundings.addPlace(x, y, NOW_US);
        askAll();
    }

    /** Asks until all is asked; returns the greatest cost of a step. */
    private long askAll() {
        long most = 0;
        while (!surroundings.isAsked()) {
            most = Math.max(most, surroundings.ask(40));
        }
        return most;
    }

    private void handAll(Structures.Structure structure) {
        while (!surroundings.isHanded()) {
            surroundings.hand(structure);
        }
    }

    /** Takes events, and keeps their times. */
    private static final class Taker extends StructureThatMoves {
        private final List<Long> times = new ArrayList<>();
        private final List<Long> seen = new ArrayList<>();

        Taker() {
            super(100);
        }

        @Override
        public void addPast(int x, int y, long timeUs, int polarity) {
            times.add(timeUs);
        }

        @Override
        public boolean isAround(int x, int y, double marginPx, long nowUs) {
            // its box ends in the middle of the sensor
            return x - marginPx < 128;
        }

        @Override
        public void see(int x, int y, long timeUs, int polarity, long nowUs) {
            seen.add(timeUs);
        }
    }

    @Test
    public void allOfOneTextureMovesAlike() {
        film(100, 0);
        spreadFrom(40, 48);
        assertTrue(surroundings.isAny());
        for (int x = 48; x < 224; x += 32) {
            assertTrue("at " + x, surroundings.has(x, 48, NOW_US));
        }
    }

    @Test
    public void textureThatMovesOtherwiseDoesNot() {
        film(0, 100);
        spreadFrom(40, 48);
        assertTrue(surroundings.has(80, 48, NOW_US));
        for (int x = 176; x < 256; x += 32) {
            assertFalse("at " + x, surroundings.has(x, 48, NOW_US));
        }
    }

    /** Asks around the region of 64 px at the left border, above. */
    private void spreadFromRegion(double windowS) {
        surroundings.begin(100, 0, windowS, 0, 0, NOW_US);
        askAll();
    }

    @Test
    public void whatMovesAsARegionDoesIsAlikeAfterThreePixels() {
        film(100, 0);
        spreadFromRegion(0.03);
        for (int x = 16; x < 224; x += 32) {
            assertTrue("at " + x, surroundings.has(x, 48, NOW_US));
        }
        // those of the last 30 ms were asked, and of twice that are handed
        assertEquals(0, surroundings.seenFromUs());
    }

    @Test
    public void whatMovesOtherwiseThanARegionIsNotAlikeAfterThreePixels() {
        film(0, 100);
        spreadFromRegion(0.03);
        assertTrue(surroundings.has(48, 48, NOW_US));
        for (int x = 176; x < 256; x += 32) {
            assertFalse("at " + x, surroundings.has(x, 48, NOW_US));
        }
    }

    @Test
    public void nothingMovesAlikeWhereTheVelocityIsAnother() {
        film(100, 0);
        surroundings.begin(-100, 0, NOW_US);
        surroundings.addPlace(80, 48, NOW_US);
        askAll();
        assertFalse(surroundings.isAny());
    }

    @Test
    public void tileOfAnEventIsTheOneThatItsPlaceIsOnNow() {
        film(0, 100);
        spreadFrom(40, 48);
        // columns 128 to 159 stand; what was at 124 travels to 128 in 40 ms
        assertEquals(surroundings.has(128, 48, NOW_US), surroundings.has(124, 48, NOW_US - 40_000));
        assertEquals(surroundings.has(127, 48, NOW_US), surroundings.has(123, 48, NOW_US - 40_000));
    }

    @Test
    public void eventsAreHandedOnceAndInOrder() {
        film(100, 0);
        spreadFrom(40, 48);
        Taker first = new Taker();
        handAll(first);
        // of the last 40 ms, on tiles with events enough
        assertTrue("handed " + first.times.size(), first.times.size() > 3000);
        for (int i = 1; i < first.times.size(); i++) {
            assertTrue(first.times.get(i) >= first.times.get(i - 1));
        }
        assertTrue(first.times.get(0) >= NOW_US - 40_000);
        Taker second = new Taker();
        handAll(second);
        assertEquals(0, second.times.size());
        spreadFrom(40, 48);
        assertFalse(surroundings.isAny());
    }

    @Test
    public void structureThatIsTrackedTakesOverWhatMovesAlikeInItsBoxAndBeside() {
        film(100, 0);
        Taker tracked = new Taker();
        surroundings.begin(tracked, NOW_US);
        askAll();
        assertTrue(surroundings.has(48, 48, NOW_US));
        // tiles beside its box, and what moves alike beside those
        assertTrue(surroundings.has(144, 48, NOW_US));
        assertTrue(surroundings.has(208, 48, NOW_US));
        handAll(tracked);
        assertEquals(0, tracked.times.size());
        assertTrue("seen " + tracked.seen.size(), tracked.seen.size() > 3000);
    }

    @Test
    public void noStepCostsMoreThanAskingATile() {
        film(100, 0);
        surroundings.begin(100, 0, NOW_US);
        surroundings.addPlace(40, 48, NOW_US);
        // where they are, along the velocity, and there again with four neighbours: 300 events of a tile on two grids
        long most = askAll();
        assertTrue("cost " + most, most <= 1 + 7 * 2 * 300);
        Taker taker = new Taker();
        surroundings.hand(taker);
        assertTrue("handed at once " + taker.times.size(), taker.times.size() <= 256);
    }

    @Test
    public void whatComesInTheMeantimeIsHandedToo() {
        film(100, 0);
        spreadFrom(40, 48);
        Taker taker = new Taker();
        surroundings.hand(taker);
        events.add(80, 48, NOW_US + 1_000, 1);
        handAll(taker);
        assertEquals(NOW_US + 1_000, (long) taker.times.get(taker.times.size() - 1));
    }

    @Test
    public void structureThatIsTrackedTakesNothingOverThatMovesOtherwise() {
        film(0, 100);
        surroundings.begin(new Taker(), NOW_US);
        askAll();
        assertTrue(surroundings.has(80, 48, NOW_US));
        assertFalse(surroundings.has(144, 48, NOW_US));
    }

    @Test
    public void eventsOfTwiceTheTravelThatIsAskedOverMayHaveBeenThoseOfTheTiles() {
        film(100, 0);
        spreadFrom(40, 48);
        // 4 px at 100 px/s
        assertEquals(NOW_US - 80_000, surroundings.seenFromUs());
    }
}
