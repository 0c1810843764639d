package io.github.sofas.flow.fit;

import static org.junit.Assert.assertEquals;

import io.github.sofas.flow.SofasParameters;
import io.github.sofas.flow.motion.Motion;
import java.util.Random;
import org.junit.Test;

/** Acceleration and rotation of a cloud of dots around (50, 40), each seen twenty times in a window of 0.2 s. */
public class MotionChangeTest {
    private static final double HALF_S = 0.1;
    private static final double RADIUS_PX = 20;
    private static final SofasParameters DEFAULTS = SofasParameters.defaults();

    /** Measures eight times, starting from the velocity (100, 0) px/s that is right in the middle of the window. */
    private static Motion measured(double ax, double omega) {
        Motion motion = new Motion();
        motion.set(0, 100, 0);
        motion.centreX = 50;
        motion.centreY = 40;
        MotionChange change = new MotionChange();
        change.restart();
        MotionLoss loss = new MotionLoss();
        MetricFit fit = new MetricFit(128, 96, MetricFit.CELL_PX, 4096, 1900);
        for (int repeat = 0; repeat < 8; repeat++) {
            Random random = new Random(5);
            fit.clear();
            for (int dot = 0; dot < 60; dot++) {
                double rx = 2 * RADIUS_PX * (random.nextDouble() - 0.5);
                double ry = 2 * RADIUS_PX * (random.nextDouble() - 0.5);
                for (int k = 0; k < 20; k++) {
                    double t = (k + random.nextDouble() - 10) / 10 * HALF_S;
                    double cos = Math.cos(omega * t);
                    double sin = Math.sin(omega * t);
                    motion.project((int) Math.rint(50 + 100 * t + ax / 2 * t * t + cos * rx - sin * ry),
                        (int) Math.rint(40 + sin * rx + cos * ry), Math.round(t * 1e6));
                    fit.add((float) motion.x, (float) motion.y, (float) t, (float) (motion.x - 50),
                        (float) (motion.y - 40), 1);
                }
            }
            fit.frame(1 / HALF_S);
            fit.fit(0, 0, MetricFit.FLAT_SIGMAS);
            loss.take(fit);
            change.measure(fit, motion, loss, HALF_S, RADIUS_PX, DEFAULTS.track());
        }
        return motion;
    }

    @Test
    public void accelerationAndRotationAreThoseOfTheEvents() {
        // 400 px/s² bend the ends of the window by 2 px, 0.5 rad/s turn them by 1 px at 20 px
        Motion motion = measured(400, 0.5);
        assertEquals(400, motion.ax, 20);
        assertEquals(0, motion.ay, 20);
        assertEquals(0.5, motion.omega, 0.05);
    }

    @Test
    public void steadyMotionHasNoChange() {
        Motion motion = measured(0, 0);
        assertEquals(0, motion.ax, 5);
        assertEquals(0, motion.ay, 5);
        assertEquals(0, motion.omega, 0.03);
    }

    @Test
    public void heldChangeFadesByAFifth() {
        Motion motion = new Motion();
        motion.ax = 100;
        motion.omega = -2;
        new MotionChange().hold(motion);
        assertEquals(80, motion.ax, 1e-9);
        assertEquals(-1.6, motion.omega, 1e-9);
    }
}
