package io.github.sofas.flow.fit;

import static org.junit.Assert.assertEquals;
import static org.junit.Assert.assertFalse;
import static org.junit.Assert.assertTrue;

import io.github.sofas.flow.motion.Motion;
import org.junit.Test;

/** The motion of one body that serves two structures best. */
public class CommonMotionTest {
    private static final double TINY = 1e-9;

    /** At time 0, with its centre at (x, y) px. */
    private static Motion motion(double x, double y, double vx, double vy, double omega) {
        Motion motion = new Motion();
        motion.set(0, vx, vy);
        motion.centreX = x;
        motion.centreY = y;
        motion.omega = omega;
        return motion;
    }

    /** The same, growing. */
    private static Motion motion(double x, double y, double vx, double vy, double omega, double growth) {
        Motion motion = motion(x, y, vx, vy, omega);
        motion.growth = growth;
        return motion;
    }

    /** Of a metric of 1,000; nothing is known of growth. */
    private static MotionLoss loss(double xx, double xy, double yy, double turn) {
        MotionLoss loss = new MotionLoss();
        loss.metric = 1000;
        loss.xx = xx;
        loss.xy = xy;
        loss.yy = yy;
        loss.turn = turn;
        return loss;
    }

    /** The same with knowledge of growth. */
    private static MotionLoss loss(double xx, double xy, double yy, double turn, double grow) {
        MotionLoss loss = loss(xx, xy, yy, turn);
        loss.grow = grow;
        return loss;
    }

    @Test
    public void pieceOfAPlaneMovesAsThePlaneDoesThere() {
        // a camera that turns by 0.4 rad/s with a focal length of 200 px: 80 (1 + x²/f²) and 80 x y / f² px/s; at
        // (100, 50) from the middle 100 and 10 px/s, growing by 1.5 times 0.2, turning by half of 0.1
        Motion plane = motion(120, 90, 80, 0, 0);
        plane.deformation.perspectiveX = 80 / 40_000.0;
        Motion piece = motion(220, 140, 100, 10, 0.05, 0.3);
        CommonMotion common = new CommonMotion();
        assertTrue(common.fit(piece, loss(1, 0, 1, 10, 10), plane, loss(1, 0, 1, 1000, 1000), 0));
        assertEquals(0, common.lost(), TINY);
        // in the middle between the two, 80 (1 + 50²/f²) and 80 50 25 / f²
        assertEquals(85, common.motion().vx, TINY);
        assertEquals(2.5, common.motion().vy, TINY);
        assertEquals(plane.vxAt(30, 20, 0), common.motion().vxAt(30, 20, 0), 1e-4);
        assertEquals(plane.vyAt(30, 20, 0), common.motion().vyAt(30, 20, 0), 1e-4);
        // which differ by a quarter of the speed
        assertTrue(common.turnsOrGrows(0.2));
    }

    @Test
    public void twoHalvesOfARotatingBarAreOneBody() {
        // 2 rad/s about (50, 40): 10 px to the right of it 20 px/s down, 10 px to the left as much up
        CommonMotion common = new CommonMotion();
        MotionLoss all = loss(1, 0, 1, 1);
        assertTrue(common.fit(motion(60, 40, 0, 20, 2), all, motion(40, 40, 0, -20, 2), all, 0));
        assertEquals(0, common.motion().vx, TINY);
        assertEquals(0, common.motion().vy, TINY);
        assertEquals(2, common.motion().omega, TINY);
        assertEquals(50, common.motion().centreX, TINY);
        assertEquals(40, common.motion().centreY, TINY);
        assertEquals(0, common.lost(), TINY);
    }

    @Test
    public void twoHalvesThatAreNotSeenToTurnHaveNoCommonVelocity() {
        // each would lose 20² of 1,000
        CommonMotion common = new CommonMotion();
        MotionLoss all = loss(1, 0, 1, 1);
        assertTrue(common.fit(motion(60, 40, 0, 20, 0), all, motion(40, 40, 0, -20, 0), all, 0));
        assertEquals(0, common.motion().vy, TINY);
        assertEquals(0.4, common.lost(), TINY);
    }

    @Test
    public void twoPartsOfWhatComesNearerAreOneBody() {
        // growth of 2 1/s about (50, 40): 10 px to the right of it 20 px/s to the right, 5 px above it 10 px/s up
        CommonMotion common = new CommonMotion();
        MotionLoss all = loss(1, 0, 1, 1, 3);
        assertTrue(common.fit(motion(60, 40, 20, 0, 0, 2), all, motion(50, 35, 0, -10, 0, 2), all, 0));
        assertEquals(0, common.motion().omega, TINY);
        assertEquals(2, common.motion().growth, TINY);
        // between the two, at (55, 37.5): 5 px to the right of the middle and 2.5 above it
        assertEquals(10, common.motion().vx, TINY);
        assertEquals(-5, common.motion().vy, TINY);
        assertEquals(0, common.lost(), TINY);
    }

    @Test
    public void turnsOrGrowsWhereThatMakesTheCentresDifferByAShareOfTheSpeed() {
        // 20 px apart, at 0.06 rad/s and 0.08 1/s: by 2 of 30 px/s
        CommonMotion common = new CommonMotion();
        MotionLoss all = loss(1, 0, 1, 1, 1);
        common.fit(motion(60, 40, 30, 0, 0.06, 0.08), all, motion(40, 40, 30, 0, 0.06, 0.08), all, 0);
        assertTrue(common.turnsOrGrows(0.06));
        assertFalse(common.turnsOrGrows(0.07));
        common.fit(motion(60, 40, 30, 0, 0), all, motion(40, 40, 30, 0, 0), all, 0);
        assertFalse(common.turnsOrGrows(0));
    }

    @Test
    public void velocityOfTheMiddleIsFoundBesideRotationAndGrowth() {
        // (3, -1) px/s, 2 rad/s, 0.5 1/s about (50, 40): 10 px to the right (5, 20) px/s on top, to
        // the left as much less
        CommonMotion common = new CommonMotion();
        MotionLoss all = loss(1, 0.5, 2, 1, 1);
        assertTrue(common.fit(motion(60, 40, 8, 19, 2, 0.5), all, motion(40, 40, -2, -21, 2, 0.5), all, 0));
        assertEquals(3, common.motion().vx, TINY);
        assertEquals(-1, common.motion().vy, TINY);
        assertEquals(2, common.motion().omega, TINY);
        assertEquals(0.5, common.motion().growth, TINY);
        assertEquals(0, common.lost(), TINY);
    }

    @Test
    public void commonVelocityIsSoughtWithTheBetterKnownRotationAndGrowth() {
        // the second knows its 2 rad/s better, the first its growth of 0.5. Between them, at (50, 40), both are then
        // right: the first moves by (5, 20) px/s beside the common (0, 0), the second as much the other way
        CommonMotion common = new CommonMotion();
        MotionLoss grows = loss(1, 0, 1, 1, 8);
        MotionLoss turns = loss(1, 0, 1, 9, 2);
        assertTrue(common.fit(motion(60, 40, 5, 20, -3, 0.5), grows, motion(40, 40, -5, -20, 2, -7), turns, 0));
        assertEquals(2, common.motion().omega, TINY);
        assertEquals(0.5, common.motion().growth, TINY);
        assertEquals(0, common.motion().vx, TINY);
        assertEquals(0, common.motion().vy, TINY);
        // what differs: 1 * 5² of the first, 2 * 7.5² of the second
        assertEquals(0.1125, common.lost(), TINY);
    }

    @Test
    public void twoStraightEdgesKnowTheCommonVelocityTogether() {
        // a vertical edge knows 30 px/s to the right, a horizontal one 10 px/s up; of the rest neither knows, and is
        // held at none by a hundredth of what it knows
        CommonMotion common = new CommonMotion();
        assertTrue(common.fit(motion(40, 30, 30, 0, 0), loss(1, 0, 0, 0), motion(50, 20, 0, -10, 0),
            loss(0, 0, 1, 0), 0));
        assertEquals(30 * 1.01 / 1.02, common.motion().vx, TINY);
        assertEquals(-10 * 1.01 / 1.02, common.motion().vy, TINY);
        assertEquals(0, common.lost(), 1e-4);
    }

    @Test
    public void betterKnownOfTwoVelocitiesCountsMore() {
        // (3 * 10 + 1 * 14) / 4 = 11: the first loses 3 * 1², the second 1 * 3²
        CommonMotion common = new CommonMotion();
        assertTrue(common.fit(motion(40, 30, 10, 0, 0), loss(3, 0, 3, 0), motion(40, 30, 14, 0, 0),
            loss(1, 0, 1, 0), 0));
        assertEquals(11, common.motion().vx, TINY);
        assertEquals(0.009, common.lost(), TINY);
    }

    @Test
    public void twoParallelEdgesThatMoveAlikeAreOneBody() {
        // along themselves, where neither shows anything, they move by the mean of what they were taken to
        CommonMotion common = new CommonMotion();
        MotionLoss vertical = loss(1, 0, 0, 1);
        assertTrue(common.fit(motion(40, 30, 30, 5, 0), vertical, motion(50, 30, 30, -5, 0), vertical, 0));
        assertEquals(30, common.motion().vx, TINY);
        assertEquals(0, common.motion().vy, TINY);
        assertEquals(0, common.lost(), TINY);
    }

    @Test
    public void twoEdgesOfDifferentSpeedsThatAreAllButParallelAreNot() {
        // one shows vx = 30, the other vx + 0.1 vy = 20: both are right at (30, -100) px/s, along edges that show
        // neither. Held, vy = -0.1 (vx - 20) / (0.01 + 0.01 + 0.0101), and so vx = 25.98
        CommonMotion common = new CommonMotion();
        assertTrue(common.fit(motion(40, 30, 30, 0, 0), loss(1, 0, 0, 0), motion(50, 30, 20, 0, 0),
            loss(1, 0.1, 0.01, 0), 0));
        assertEquals(25.98, common.motion().vx, 0.01);
        assertEquals(-19.9, common.motion().vy, 0.1);
        // of 1,000 the first loses 4.02²
        assertEquals(0.0162, common.lost(), 1e-4);
    }

    @Test
    public void structuresOfWhichNothingIsKnownHaveNothingInCommon() {
        CommonMotion common = new CommonMotion();
        MotionLoss nothing = loss(0, 0, 0, 0);
        assertFalse(common.fit(motion(40, 30, 30, 5, 0), nothing, motion(50, 30, 30, -5, 0), nothing, 0));
        assertEquals(5, common.motion().vy, TINY);
        assertTrue(common.lost() > 1);
    }

    @Test
    public void motionsAreComparedAtTheSameTime() {
        // 20 px/s now and 100 px/s² faster every second are 30 px/s after 0.1 s, 2.5 px on
        Motion speedsUp = motion(40, 30, 20, 0, 0);
        speedsUp.ax = 100;
        MotionLoss all = loss(1, 0, 1, 1);
        CommonMotion common = new CommonMotion();
        assertTrue(common.fit(speedsUp, all, motion(40, 30, 30, 0, 0), all, 100_000));
        assertEquals(30, common.motion().vx, TINY);
        assertEquals(0, common.lost(), TINY);
        assertEquals((42.5 + 43) / 2, common.motion().centreX, TINY);
        assertEquals(100_000, common.motion().referenceUs);
    }

    @Test
    public void edgesOfABodyTurnAsTheirVelocitiesAskThoughNeitherShowsIt() {
        // 20 px apart and 40 px/s across that: 2 rad/s about (50, 40), which goes on to the right
        CommonMotion common = new CommonMotion();
        MotionLoss noTurning = loss(1, 0, 1, 0);
        Motion right = motion(60, 40, 50, 20, 0);
        Motion left = motion(40, 40, 50, -20, 0);
        assertTrue(common.fitEdges(right, noTurning, left, noTurning, 0));
        assertEquals(50, common.motion().vx, TINY);
        assertEquals(0, common.motion().vy, TINY);
        assertEquals(2, common.motion().omega, TINY);
        assertEquals(0, common.lost(), TINY);
        // each loses by the 20 px/s that it differs from the mean by
        assertTrue(common.fit(right, noTurning, left, noTurning, 0));
        assertEquals(20 * 20 / 1000.0, common.lost(), TINY);
    }

    @Test
    public void edgesThatComeApartAreNoBody() {
        CommonMotion common = new CommonMotion();
        MotionLoss noTurning = loss(1, 0, 1, 0);
        assertTrue(common.fitEdges(motion(60, 40, 70, 0, 0), noTurning, motion(40, 40, 50, 0, 0), noTurning, 0));
        assertEquals(0, common.motion().omega, TINY);
        assertEquals(10 * 10 / 1000.0, common.lost(), TINY);
    }

    @Test
    public void edgesAtOnePlaceHaveTheRotationOfTheOneThatKnowsItBetter() {
        CommonMotion common = new CommonMotion();
        assertTrue(common.fitEdges(motion(50, 40, 50, 0, 1), loss(1, 0, 1, 2), motion(50, 40, 50, 0, 3),
            loss(1, 0, 1, 1), 0));
        assertEquals(1, common.motion().omega, TINY);
    }
}
