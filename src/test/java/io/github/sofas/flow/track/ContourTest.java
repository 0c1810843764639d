package io.github.sofas.flow.track;

import static org.junit.Assert.assertEquals;
import static org.junit.Assert.assertFalse;
import static org.junit.Assert.assertTrue;

import io.github.sofas.event.SensorSize;
import io.github.sofas.flow.motion.Bounds;
import io.github.sofas.flow.motion.Motion;
import java.util.ArrayList;
import java.util.List;
import org.junit.Test;

/** A contour by hand: each sixteenth of the lifetime in which events of its polarity fell supports an event by two. */
public class ContourTest {
    private static final SensorSize SENSOR = new SensorSize(128, 96);
    /** A sixteenth has 10 ms. */
    private static final long LIFETIME_US = 160_000;

    private final Contour.Spare spare = new Contour.Spare(SENSOR);
    private final Contour contour = new Contour(SENSOR, spare);
    private final Motion motion = new Motion();

    /** Starts at time 0 along a velocity; the centre is (60, 40). */
    private void start(double vx, double vy) {
        motion.set(0, vx, vy);
        motion.centreX = 60;
        motion.centreY = 40;
        contour.start(motion);
    }

    private void startAtRest() {
        start(0, 0);
    }

    private void followTo(long timeUs) {
        motion.moveReference(timeUs);
        contour.follow(motion);
    }

    /** A block of single ON events at time 0. */
    private void addBlock(int fromX, int fromY, int side) {
        for (int y = fromY; y < fromY + side; y++) {
            for (int x = fromX; x < fromX + side; x++) {
                contour.add(x, y, 0, 1, 0, 1);
            }
        }
    }

    private static LiveEvents live(int[]... places) {
        LiveEvents live = new LiveEvents();
        for (int[] place : places) {
            live.add(place[0], place[1], place[2], 1, Claim.OWN, 0);
        }
        return live;
    }

    @Test
    public void contourIsInSightWithFourFifthsOfItsBoxAndHasLeftBeyondTheBorder() {
        start(-100, 0);
        assertFalse("nothing is anywhere", contour.isInSight(0));
        assertFalse(contour.hasLeft(0));
        // columns 3 to 7
        addBlock(3, 40, 5);
        assertTrue(contour.isInSight(0));
        assertTrue("from column -0.9 on", contour.isInSight(39_000));
        assertFalse("from column -1.1 on", contour.isInSight(41_000));
        assertFalse("up to column 0", contour.hasLeft(70_000));
        assertTrue(contour.hasLeft(80_000));
    }

    @Test
    public void boxIsAroundTheContourAndNowhereWhereItIsEmpty() {
        start(100, 0);
        assertFalse(contour.isAround(60, 40, 5, 0));
        Bounds box = new Bounds();
        contour.includeIn(box, 0);
        assertFalse("nothing to include", box.isAround(60, 40, 100));
        addBlock(59, 39, 3);
        assertTrue(contour.isAround(63, 43, 2, 0));
        assertFalse(contour.isAround(64, 43, 2, 0));
        assertTrue("10 px on after 0.1 s", contour.isAround(73, 43, 2, 100_000));
        contour.includeIn(box, 100_000);
        assertEquals(69, box.left(), 1e-9);
        assertEquals(71, box.right(), 1e-9);
        assertEquals(39, box.top(), 0);
        assertEquals(41, box.bottom(), 0);
    }

    @Test
    public void eventsOfTheOtherPolarityAreSupportedWhereEitherIsExpected() {
        startAtRest();
        contour.add(30, 20, 0, 1, 0, 1);
        assertEquals(-1, contour.support(30, 20, 0, -1));
        contour.expectEither(true);
        assertEquals(2, contour.support(30, 20, 0, -1));
        assertEquals(2, contour.closeSupport(-1));
        contour.start(motion);
        contour.add(30, 20, 0, 1, 0, 1);
        assertEquals("begun anew", -1, contour.support(30, 20, 0, -1));
    }

    @Test
    public void eventIsSupportedByTheNineCellsAroundIt() {
        startAtRest();
        contour.add(30, 20, 0, 1, 0, 1);
        for (int dy = -2; dy <= 2; dy++) {
            for (int dx = -2; dx <= 2; dx++) {
                boolean near = Math.max(Math.abs(dx), Math.abs(dy)) <= 1;
                assertEquals(near ? 2 : 0, contour.support(30 + dx, 20 + dy, 5, 1));
            }
        }
    }

    @Test
    public void goesOnFromPlacesFourOrEightPxBehindIt() {
        start(100, 0);
        addBlock(24, 39, 3);
        // in a second sixteenth, for one is too little; the block is a px farther by then
        contour.fade(10_000, LIFETIME_US);
        for (int y = 39; y < 42; y++) {
            for (int x = 25; x < 28; x++) {
                contour.add(x, y, 10_000, 1, 0, 1);
            }
        }
        assertTrue(contour.goesOnFrom(22, 40, 10_000));
        assertTrue(contour.goesOnFrom(18, 40, 10_000));
        assertFalse("it has 24 to 28, not 18 and 22", contour.goesOnFrom(14, 40, 10_000));
        assertFalse("it comes from there", contour.goesOnFrom(30, 40, 10_000));
    }

    @Test
    public void sixteenthsCountAndNotEvents() {
        startAtRest();
        addBlock(29, 19, 3);
        assertEquals(2, contour.support(30, 20, 5, 1));
        contour.fade(10_000, LIFETIME_US);
        contour.add(31, 21, 10_000, 1, 0, 1);
        assertEquals(4, contour.support(30, 20, 10_005, 1));
        assertEquals(2, contour.support(29, 20, 10_005, 1));
    }

    @Test
    public void whatCrossesACellSupportsLessThanWhatStaysOnIt() {
        // an edge of one pixel at rest in the frame, one event each 10 ms; another crosses at 1 px each 10 ms, ten
        // events at a time
        startAtRest();
        for (int k = 0; k < 16; k++) {
            contour.fade(k * 10_000, LIFETIME_US);
            contour.add(30, 20, k * 10_000, 1, 0, 1);
            for (int i = 0; i < 10; i++) {
                contour.add(50 + k, 20, k * 10_000, 1, 0, 1);
            }
        }
        assertEquals(2 * 16, contour.support(30, 20, 155_000, 1));
        assertEquals(2 * 2, contour.support(65, 20, 155_000, 1));
    }

    @Test
    public void otherPolarityCountsAgainstByHalf() {
        startAtRest();
        for (int k = 0; k < 3; k++) {
            contour.fade(k * 10_000, LIFETIME_US);
            contour.add(30, 20, k * 10_000, 1, 0, 1);
        }
        assertEquals(6, contour.support(30, 20, 20_005, 1));
        assertEquals(-3, contour.support(30, 20, 20_005, -1));
        // what flickers: as many of each
        for (int k = 3; k < 6; k++) {
            contour.fade(k * 10_000, LIFETIME_US);
            contour.add(30, 20, k * 10_000, -1, 0, 1);
        }
        assertEquals(6 - 3, contour.support(30, 20, 50_005, 1));
        assertEquals(6 - 3, contour.support(30, 20, 50_005, -1));
    }

    @Test
    public void eventsOfTwoSixteenthsPutAnotherOnTheContour() {
        startAtRest();
        contour.add(30, 20, 0, 1, 0, 1);
        contour.add(30, 20, 5_000, 1, 0, 1);
        assertFalse(contour.support(31, 20, 5_000, 1) >= contour.threshold());
        contour.fade(10_000, LIFETIME_US);
        contour.add(30, 20, 10_000, 1, 0, 1);
        assertTrue(contour.support(31, 20, 10_000, 1) >= contour.threshold());
    }

    @Test
    public void sixteenthsPassWithTheTime() {
        startAtRest();
        for (int k = 0; k < 20; k++) {
            contour.fade(k * 10_000, LIFETIME_US);
            contour.add(30, 20, k * 10_000, 1, 0, 1);
        }
        // four of twenty are older than the lifetime
        assertEquals(32, contour.support(30, 20, 190_005, 1));
        contour.fade(199_999, LIFETIME_US);
        assertEquals(32, contour.support(30, 20, 190_005, 1));
        contour.fade(200_000, LIFETIME_US);
        assertEquals(30, contour.support(30, 20, 190_005, 1));
        // three that are due at once
        contour.fade(230_000, LIFETIME_US);
        assertEquals(24, contour.support(30, 20, 190_005, 1));
    }

    @Test
    public void loneEventIsGoneAfterALifetime() {
        startAtRest();
        contour.add(30, 20, 0, 1, 0, 1);
        contour.fade(150_000, LIFETIME_US);
        assertFalse(contour.isEmpty());
        contour.fade(160_000, LIFETIME_US);
        assertTrue(contour.isEmpty());
        assertEquals(0, contour.support(30, 20, 5, 1));
    }

    @Test
    public void boxIsThatOfTheOccupiedCells() {
        startAtRest();
        assertTrue(contour.isEmpty());
        contour.add(30, 20, 0, 1, 0, 1);
        assertEquals(0, contour.extent());
        contour.add(45, 27, 0, -1, 0, 1);
        assertEquals(30, contour.box(0).left(), 0);
        assertEquals(45, contour.box(0).right(), 0);
        assertEquals(20, contour.box(0).top(), 0);
        assertEquals(27, contour.box(0).bottom(), 0);
        assertEquals(15, contour.extent());
    }

    @Test
    public void boxShrinksToWhatHasNotFaded() {
        startAtRest();
        contour.add(30, 20, 0, 1, 0, 1);
        contour.fade(10_000, LIFETIME_US);
        contour.add(45, 27, 10_000, 1, 0, 1);
        contour.fade(160_000, LIFETIME_US);
        assertEquals(45, contour.box(160_000).left(), 0);
        assertEquals(45, contour.box(160_000).right(), 0);
        assertEquals(27, contour.box(160_000).top(), 0);
        assertTrue(contour.support(45, 27, 160_000, 1) > 0);
    }

    @Test
    public void boxTravelsWithTheStructure() {
        // 100 px/s to the right, 50 up
        start(100, -50);
        contour.add(30, 60, 0, 1, 0, 1);
        assertEquals(50, contour.box(200_000).left(), 1e-9);
        assertEquals(50, contour.box(200_000).bottom(), 1e-9);
    }

    @Test
    public void contourTravelsWithTheStructure() {
        start(100, 0);
        addBlock(30, 20, 3);
        // 5 px on
        assertEquals(2, contour.support(36, 21, 50_000, 1));
        assertEquals(0, contour.support(31, 21, 50_000, 1));
    }

    @Test
    public void cellsAreKeptWhenTheFrameIsAnchoredAfterTwelvePixels() {
        start(100, 0);
        addBlock(30, 20, 3);
        contour.add(31, 21, 0, -1, 0, 1);
        int before = contour.support(31, 21, 0, 1);
        int beside = contour.support(33, 22, 0, 1);
        for (long timeUs = 10_000; timeUs <= 400_000; timeUs += 10_000) {
            followTo(timeUs);
            int travelled = (int) (timeUs / 10_000);
            assertEquals(before, contour.support(31 + travelled, 21, timeUs, 1));
            assertEquals(beside, contour.support(33 + travelled, 22, timeUs, 1));
            assertEquals(30 + travelled, contour.box(timeUs).left(), 1e-9);
            assertEquals(32 + travelled, contour.box(timeUs).right(), 1e-9);
            assertEquals(22, contour.box(timeUs).bottom(), 1e-9);
        }
        assertEquals(2 - 1, before);
        assertEquals(2, beside);
    }

    @Test
    public void partsOfPixelsAreKeptWhenTheFrameIsAnchored() {
        // anchored each 12.4 px, by 12 or 13: what is left counts the next time
        start(100, 0);
        addBlock(10, 20, 3);
        for (int i = 1; i <= 16; i++) {
            followTo(i * 62_000);
        }
        // from column 11 to 110.2
        assertEquals(2, contour.support(110, 21, 992_000, 1));
    }

    @Test
    public void whatLeavesTheSensorComesBackFromTheMargin() {
        // 20 px beyond the border, then as far back
        start(-200, 0);
        addBlock(2, 20, 3);
        followTo(100_000);
        motion.vx = 200;
        contour.follow(motion);
        assertEquals(2, contour.support(3, 21, 200_000, 1));
    }

    /** Two blocks of 9 px, 20 px left and right of the centre, whose radius and breadth are measured. */
    private void addDumbbell() {
        LiveEvents live = new LiveEvents();
        for (int middle = 40; middle <= 80; middle += 40) {
            addBlock(middle - 4, 36, 9);
            for (int i = 0; i < 81; i++) {
                live.add(middle - 4 + i % 9, 36 + i / 9, 0, 1, Claim.OWN, 0);
            }
        }
        contour.measure(live, motion, 0);
        // 20² between the middles and the centre, and (9² - 1) / 12 along each axis of a block
        assertEquals(Math.sqrt(400 + 2 * 80 / 12.0), contour.radius(), 0.01);
        assertEquals(Math.sqrt(80 / 12.0), contour.breadth(), 0.01);
    }

    @Test
    public void innerCellsOfWhatTurnsAreKept() {
        // 0.8 rad about (60, 40): from (80, 40) to (60 + 20 * 0.69671, 40 + 20 * 0.71736) = (73.9, 54.3), 15.6 px off
        startAtRest();
        addDumbbell();
        motion.omega = 8;
        for (long timeUs = 0; timeUs <= 100_000; timeUs += 10_000) {
            followTo(timeUs);
        }
        assertEquals(2, contour.support(74, 54, 100_000, 1));
        assertEquals(2, contour.support(46, 26, 100_000, 1));
        assertEquals(0, contour.support(84, 40, 100_000, 1));
    }

    @Test
    public void innerCellsOfWhatGrowsAreKept() {
        // exp(0.5) = 1.6487: from (80, 40) to (92.97, 40), 13 px off
        startAtRest();
        addDumbbell();
        motion.growth = 5;
        for (long timeUs = 0; timeUs <= 100_000; timeUs += 10_000) {
            followTo(timeUs);
        }
        assertEquals(2, contour.support(93, 40, 100_000, 1));
        assertEquals(60 - 24 * 1.6487, contour.box(100_000).left(), 1);
        assertEquals(60 + 24 * 1.6487, contour.box(100_000).right(), 1);
    }

    @Test
    public void absorbedContourIsAddedWhereBothAreNow() {
        start(100, 0);
        addBlock(30, 20, 3);
        Contour other = new Contour(SENSOR, spare);
        Motion its = new Motion();
        its.set(0, 0, 100);
        other.start(its);
        other.add(41, 11, 0, 1, 0, 1);
        other.add(50, 11, 0, -1, 0, 1);
        contour.fade(10_000, LIFETIME_US);
        other.fade(10_000, LIFETIME_US);
        other.add(42, 12, 10_000, 1, 0, 1);
        // both along their own for 0.1 s: (41, 11) is at (41, 21), as the middle of the block is
        motion.moveReference(100_000);
        contour.absorb(other, motion);
        assertEquals(2 + 2, contour.support(41, 21, 100_000, 1));
        assertEquals(2, contour.support(50, 21, 100_000, -1));
        assertEquals(40, contour.box(100_000).left(), 1);
        assertEquals(50, contour.box(100_000).right(), 1);
        // from now on along the common one
        assertEquals(2 + 2, contour.support(46, 21, 150_000, 1));
    }

    @Test
    public void cellsOfOneContourDoNotShowInAnother() {
        // both use the same spare cells in turn
        start(100, 0);
        addBlock(30, 20, 3);
        Contour other = new Contour(SENSOR, spare);
        other.start(motion);
        other.add(30, 60, 0, 1, 0, 1);
        followTo(130_000);
        other.follow(motion);
        motion.moveReference(260_000);
        contour.follow(motion);
        other.follow(motion);
        contour.add(56, 60, 260_000, -1, 0, 1);
        other.add(56, 20, 260_000, -1, 0, 1);
        assertEquals(-1, contour.support(56, 61, 260_000, 1));
        assertEquals(2, contour.support(57, 21, 260_000, 1));
        assertEquals(2, other.support(56, 60, 260_000, 1));
        assertEquals(-1, other.support(56, 21, 260_000, 1));
    }

    @Test
    public void redrawnContourHasTheLiveEventsOfTheLifetime() {
        // 100 px/s: events of a lifetime ago, of the eighth sixteenth, and of now
        start(100, 0);
        addBlock(90, 60, 3);
        motion.moveReference(160_000);
        LiveEvents live = live(new int[] {20, 20, 0}, new int[] {40, 40, 85_000}, new int[] {60, 60, 160_000});
        contour.draw(live, motion, LIFETIME_US);
        assertEquals("too old", 0, contour.support(36, 20, 160_000, 1));
        assertEquals(2, contour.support(48, 40, 160_000, 1));
        assertEquals(2, contour.support(60, 60, 160_000, 1));
        assertEquals("what was there", 0, contour.support(107, 61, 160_000, 1));
        // nine sixteenths later the one of the eighth has passed
        contour.fade(250_000, LIFETIME_US);
        assertEquals(0, contour.support(48, 40, 160_000, 1));
        assertEquals(2, contour.support(60, 60, 160_000, 1));
    }

    @Test
    public void centreAndRadiusAreThoseOfTheLiveEventsByNow() {
        // a square of 10 px around (25, 25) at 100 px/s, its corners seen one after the other, each 10 ms
        start(100, 0);
        int[][] places = {{20, 20, 0}, {31, 20, 10_000}, {22, 30, 20_000}, {33, 30, 30_000}};
        for (int[] place : places) {
            contour.add(place[0], place[1], place[2], 1, 0, 1);
        }
        followTo(30_000);
        contour.measure(live(places), motion, 0);
        // 3 px on; each corner is 5 px off along both axes
        assertEquals(28, contour.centreX(), 0.1);
        assertEquals(25, contour.centreY(), 0.1);
        assertEquals(Math.sqrt(50), contour.radius(), 0.1);
    }

    @Test
    public void thresholdsAreSharesOfTheMeanSupport() {
        // a cell seen in ten sixteenths: a support of 20, of which 0.25 are 5 and 0.6 are 12
        startAtRest();
        LiveEvents live = new LiveEvents();
        for (int k = 0; k < 10; k++) {
            contour.fade(k * 10_000, LIFETIME_US);
            contour.add(30, 20, k * 10_000, 1, 0, 1);
            live.add(30, 20, k * 10_000, 1, Claim.OWN, 0);
        }
        assertEquals(4, contour.threshold());
        assertTrue("nothing is sure before it was measured", contour.sureSupport() > 32);
        contour.measure(live, motion, 0);
        assertEquals(5, contour.threshold());
        assertEquals(12, contour.sureSupport(), 1e-9);
        // never less than two sixteenths
        contour.draw(live(new int[] {30, 20, 0}), motion, LIFETIME_US);
        contour.measure(live(new int[] {30, 20, 0}), motion, 0);
        assertEquals(4, contour.threshold());
    }

    @Test
    public void cellsOnTheContourAreShownWhereTheyAreByThen() {
        start(100, 0);
        contour.add(30, 20, 0, 1, 0, 1);
        contour.add(31, 20, 0, 1, 0, 1);
        // on a cell with too little around it, and beyond the border by then
        contour.add(60, 60, 0, 1, 0, 1);
        contour.add(125, 80, 0, 1, 0, 1);
        contour.fade(10_000, LIFETIME_US);
        contour.add(31, 20, 10_000, 1, 0, 1);
        contour.add(32, 20, 10_000, 1, 0, 1);
        contour.add(126, 80, 10_000, 1, 0, 1);
        List<String> shown = new ArrayList<>();
        contour.show(50_000, (x, y) -> shown.add(x + "," + y));
        assertEquals(List.of("35,20", "36,20"), shown);
    }

    @Test
    public void wipedContourIsEmpty() {
        startAtRest();
        addBlock(30, 20, 3);
        contour.wipe();
        assertTrue(contour.isEmpty());
        contour.add(30, 20, 0, 1, 0, 1);
        assertEquals(2, contour.support(31, 21, 0, 1));
    }

    @Test
    public void eventWithSupportLiesWithinTheReachUntilItsTimeIsOver() {
        for (double turn : new double[] {0, 3, -8}) {
            start(150, -90);
            motion.omega = turn;
            motion.growth = 0.8;
            motion.ax = -500;
            contour.start(motion);
            addBlock(50, 30, 9);
            contour.add(75, 52, 0, 1, 0, 1);
            followTo(30_000);
            long box = contour.reach(31_000, 36_000);
            assertFalse(contour.hasChangedReach());
            int supported = 0;
            for (long timeUs = 31_000; timeUs <= 36_000; timeUs += 250) {
                for (int y = 0; y < SENSOR.height(); y++) {
                    for (int x = 0; x < SENSOR.width(); x++) {
                        if (contour.support(x, y, timeUs, 1) != 0) {
                            supported++;
                            assertTrue(Reaches.holds(box, Reaches.event(x, y)));
                        }
                    }
                }
            }
            assertTrue(supported > 21 * 100);
            // 30 x 26 px and some room, of 128 x 96
            assertFalse(Reaches.holds(box, Reaches.event(20, 40)));
            assertFalse(Reaches.holds(box, Reaches.event(60, 70)));
        }
    }

    @Test
    public void reachChangesAsTheContourGrowsOrFollowsAnotherMotion() {
        startAtRest();
        addBlock(50, 30, 9);
        contour.reach(0, 1);
        contour.add(54, 34, 0, 1, 0, 1);
        assertFalse("inside", contour.hasChangedReach());
        contour.support(58, 34, 0, 1);
        contour.addLast(1);
        assertFalse("at its side, beside which it has support", contour.hasChangedReach());
        contour.support(59, 34, 0, 1);
        contour.addLast(1);
        assertTrue("beside it", contour.hasChangedReach());
        contour.reach(0, 1);
        assertFalse(contour.hasChangedReach());
        followTo(5_000);
        assertTrue(contour.hasChangedReach());
    }

    @Test
    public void emptyContourReachesNowhere() {
        startAtRest();
        long box = contour.reach(0, 1);
        assertFalse(Reaches.holds(box, Reaches.event(0, 0)));
        assertFalse(Reaches.holds(box, Reaches.event(60, 40)));
    }

    @Test
    public void placeIsInSightSinceItsMotionTookItOverTheBorder() {
        start(100, -50);
        // the middle of column 9 lies 9.5 px from the left border, that of row 76 of 96 19.5 px from the bottom
        assertEquals(95_000, contour.inSightUs(9, 40, 0), 1);
        assertEquals(390_000, contour.inSightUs(60, 76, 0), 1);
        startAtRest();
        assertEquals(Double.POSITIVE_INFINITY, contour.inSightUs(9, 40, 0), 0);
    }
}
