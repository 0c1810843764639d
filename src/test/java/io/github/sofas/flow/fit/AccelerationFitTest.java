package io.github.sofas.flow.fit;

import static org.junit.Assert.assertEquals;
import static org.junit.Assert.assertFalse;
import static org.junit.Assert.assertTrue;

import io.github.sofas.flow.motion.Motion;
import java.util.Random;
import org.junit.Test;

/** Dots all over 240 x 180 px that move to the right and gain speed faster and faster, in windows of 0.1 s. */
public class AccelerationFitTest {
    private static final double HALF_S = 0.05;
    /** In px/s³. */
    private static final double JERK = 9000;

    private final AccelerationFit acceleration = new AccelerationFit();
    private final MotionLoss loss = new MotionLoss();
    private final Motion motion = new Motion();
    /** Whether all dots lie above each other. */
    private boolean isEdge;

    /** Velocity in px/s at a time in s: 100 at first, and after 0.1 s 145. */
    private static double velocity(double s) {
        return 100 + JERK * s * s / 2;
    }

    private static double way(double s) {
        return 100 * s + JERK * s * s * s / 6;
    }

    /** Measures window after window, 10 ms apart, until that whose middle is at a time in s. */
    private void measureUntil(double lastS, boolean isPlane) {
        acceleration.restart();
        loss.clear();
        motion.set(-50_000, velocity(-0.05), 0);
        for (double middle = -0.05; middle < lastS + 0.005; middle += 0.01) {
            motion.moveReference(Math.round(middle * 1e6));
            measure(middle, isPlane);
            motion.moveReference(Math.round((middle + HALF_S) * 1e6));
        }
    }

    private void measure(double middle, boolean isPlane) {
        MetricFit fit = new MetricFit(240, 180, MetricFit.CELL_PX, 1 << 14, 1900);
        Random random = new Random(Math.round(middle * 100));
        for (int dot = 0; dot < 500; dot++) {
            double x = 240 * random.nextDouble();
            double y = 180 * random.nextDouble();
            if (isEdge) {
                x = 100;
            }
            for (int k = 0; k < 12; k++) {
                double s = (k + random.nextDouble() - 6) / 6 * HALF_S;
                double seen = Math.rint(x + way(middle + s) - way(middle));
                fit.add((float) (seen - (motion.vx + motion.ax * s / 2) * s), (float) (Math.rint(y)
                    - (motion.vy + motion.ay * s / 2) * s), (float) s, 0, 0, 1);
            }
        }
        fit.frame(1 / HALF_S);
        VelocityTop top = fit.fit(0, 0, MetricFit.FLAT_SIGMAS);
        loss.take(top);
        motion.vx += top.stepX();
        motion.vy += top.stepY();
        acceleration.measure(fit, motion, loss, HALF_S, 0, false, isPlane);
    }

    @Test
    public void velocityOfAPlaneIsThatOfTheEndOfTheWindowThoughItsAccelerationChanges() {
        // the last window ends at 0.2 s, with 280 px/s: 9000 * 0.05² * 0.4 more than the acceleration of its middle has
        measureUntil(0.15, true);
        assertEquals(280, motion.vx, 4);
        assertEquals(0, motion.vy, 2);
    }

    @Test
    public void jerkIsThatFromWindowToWindowButForAFifthThatTheVelocityHasAlready() {
        measureUntil(0.15, true);
        // nearly all of it is believed: it shifts the end of the window by 0.19 px, and 0.02 and some may be noise
        assertEquals(0.8 * JERK, motion.jerkX, 0.1 * JERK);
        assertEquals(0, motion.jerkY, 0.1 * JERK);
    }

    @Test
    public void otherStructuresHaveNoJerk() {
        measureUntil(0.15, false);
        assertEquals(0, motion.jerkX, 0);
        assertEquals(0, motion.jerkY, 0);
    }

    @Test
    public void straightEdgeIsNoVector() {
        measureUntil(0.15, true);
        assertTrue(acceleration.isVector());
        // of which nothing is known along itself
        isEdge = true;
        measureUntil(0.15, true);
        assertFalse(acceleration.isVector());
        assertEquals(0, motion.jerkX, 0);
        assertEquals(0, motion.jerkY, 0);
    }

    @Test
    public void heldAccelerationAndJerkFadeTogether() {
        measureUntil(0.15, true);
        double ax = motion.ax;
        double jerk = motion.jerkX;
        acceleration.hold(motion, 0.8);
        assertEquals(0.8 * ax, motion.ax, 1e-9);
        assertEquals(0.8 * jerk, motion.jerkX, 1e-9);
    }

    @Test
    public void whatIsLeftOutHasNeitherAccelerationNorJerk() {
        measureUntil(0.15, true);
        acceleration.leaveOut(motion);
        assertEquals(0, motion.ax, 0);
        assertEquals(0, motion.jerkX, 0);
        assertEquals(0, acceleration.measured(), 0);
        assertFalse(acceleration.isVector());
        double vx = motion.vx;
        motion.moveReference(1_000_000);
        assertEquals("steady from then on", vx, motion.vx, 0);
    }
}
