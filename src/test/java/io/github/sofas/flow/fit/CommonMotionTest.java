package io.github.sofas.flow.fit;

import static org.junit.Assert.assertEquals;
import static org.junit.Assert.assertFalse;
import static org.junit.Assert.assertTrue;

import io.github.sofas.flow.motion.Motion;
import org.junit.Test;

/** The rigid motion that serves two structures best. */
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

    /** Of a metric of 1,000. */
    private static MotionLoss loss(double xx, double xy, double yy, double turn) {
        MotionLoss loss = new MotionLoss();
        loss.metric = 1000;
        loss.xx = xx;
        loss.xy = xy;
        loss.yy = yy;
        loss.turn = turn;
        return loss;
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
        // but no common velocity: each would lose 20² of 1,000
        assertTrue(common.fitVelocity(motion(60, 40, 0, 20, 2), all, motion(40, 40, 0, -20, 2), all, 0));
        assertEquals(0.4, common.lost(), TINY);
    }

    @Test
    public void twoThatPassEachOtherAreNotOneBodyWhereTheirRotationShows() {
        // the same velocities, but neither turns. With omega w each centre moves 10 w of its 20 px/s, and the sum of
        // both is 2 (10 w - 20)² + 2 * 900 w², least at w = 200 / 1000 = 0.2: each loses 18² + 900 * 0.2² = 360
        CommonMotion common = new CommonMotion();
        MotionLoss seen = loss(1, 0, 1, 900);
        assertTrue(common.fit(motion(60, 40, 0, 20, 0), seen, motion(40, 40, 0, -20, 0), seen, 0));
        assertEquals(0.2, common.motion().omega, TINY);
        assertEquals(0.36, common.lost(), TINY);
    }

    @Test
    public void twoStraightEdgesKnowTheCommonVelocityTogether() {
        // a vertical edge knows 30 px/s to the right, a horizontal one 10 px/s up; of the rest neither knows
        CommonMotion common = new CommonMotion();
        assertTrue(common.fitVelocity(motion(40, 30, 30, 0, 0), loss(1, 0, 0, 0), motion(50, 20, 0, -10, 0),
            loss(0, 0, 1, 0), 0));
        assertEquals(30, common.motion().vx, TINY);
        assertEquals(-10, common.motion().vy, TINY);
        assertEquals(0, common.lost(), TINY);
    }

    @Test
    public void betterKnownOfTwoVelocitiesCountsMore() {
        // (3 * 10 + 1 * 14) / 4 = 11: the first loses 3 * 1², the second 1 * 3²
        CommonMotion common = new CommonMotion();
        assertTrue(common.fitVelocity(motion(40, 30, 10, 0, 0), loss(3, 0, 3, 0), motion(40, 30, 14, 0, 0),
            loss(1, 0, 1, 0), 0));
        assertEquals(11, common.motion().vx, TINY);
        assertEquals(0.009, common.lost(), TINY);
    }

    @Test
    public void twoParallelEdgesDoNotKnowIt() {
        CommonMotion common = new CommonMotion();
        MotionLoss vertical = loss(1, 0, 0, 1);
        assertFalse(common.fit(motion(40, 30, 30, 5, 0), vertical, motion(50, 30, 30, -5, 0), vertical, 0));
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
}
