package io.github.sofas.flow.fit;

import static org.junit.Assert.assertEquals;

import io.github.sofas.flow.SofasParameters;
import io.github.sofas.flow.motion.Motion;
import io.github.sofas.flow.motion.SteppedProjection;
import java.util.Random;
import org.junit.Test;

/**
 * Eighty dots in a square of 60 px, each of which is seen every 4 ms for 100 ms before and after the reference, at the
 * nearest pixel.
 */
public class CentredStepTest {
    private static final long SIDE_US = 100_000;
    private static final long EVERY_US = 4_000;
    private static final double RADIUS = 60 / Math.sqrt(6);

    private final MetricFit fit = new MetricFit(160, 120, MetricFit.CELL_PX, 8000, 1900);

    /** Steps from one motion towards the one of the dots. */
    private Motion steps(Motion from, Motion dots, SofasParameters.Track p) {
        CentredStep step = new CentredStep(p);
        step.begin();
        for (int round = 0; round < 2; round++) {
            fit.clear();
            Random random = new Random(5);
            SteppedProjection projection = new SteppedProjection();
            projection.begin(from, SIDE_US, 2 * RADIUS, 1.0 / 64);
            for (int dot = 0; dot < 80; dot++) {
                double rx = 60 * random.nextDouble() - 30;
                double ry = 60 * random.nextDouble() - 30;
                for (long us = -SIDE_US; us <= SIDE_US; us += EVERY_US) {
                    double s = us * 1e-6;
                    double turned = dots.omega * s + dots.alpha * s * s / 2;
                    double grown = Math.exp(dots.growth * s);
                    int x = (int) Math.rint(80 + (dots.vx + dots.ax * s / 2) * s
                        + grown * (Math.cos(turned) * rx - Math.sin(turned) * ry));
                    int y = (int) Math.rint(60 + (dots.vy + dots.ay * s / 2) * s
                        + grown * (Math.sin(turned) * rx + Math.cos(turned) * ry));
                    projection.goTo(us);
                    double atX = projection.x(x, y);
                    double atY = projection.y(x, y);
                    fit.add((float) atX, (float) atY, (float) s, (float) (atX - 80), (float) (atY - 60), 1);
                }
            }
            step.take(fit, from, SIDE_US * 1e-6, RADIUS);
        }
        return from;
    }

    private static Motion motion(double vx, double vy, double omega, double growth) {
        Motion motion = new Motion();
        motion.set(0, vx, vy);
        motion.omega = omega;
        motion.growth = growth;
        motion.centreX = 80;
        motion.centreY = 60;
        return motion;
    }

    @Test
    public void twoStepsLeadToTheMotionOfTheDots() {
        Motion found = steps(motion(45, -22, 0.8, 0.4), motion(50, -20, 1, 0.5), SofasParameters.defaults().track());
        assertEquals(50, found.vx, 0.5);
        assertEquals(-20, found.vy, 0.5);
        assertEquals(1, found.omega, 0.03);
        assertEquals(0.5, found.growth, 0.03);
    }

    @Test
    public void changesAreFoundBesideWhatChanges() {
        Motion dots = motion(50, -20, 1, 0);
        dots.ax = 150;
        dots.alpha = 4;
        Motion found = steps(motion(50, -20, 0.9, 0), dots, SofasParameters.defaults().track());
        assertEquals(50, found.vx, 1);
        assertEquals(150, found.ax, 40);
        assertEquals(1, found.omega, 0.03);
        assertEquals(4, found.alpha, 1);
    }

    @Test
    public void whatIsSwitchedOffStaysAsItIs() {
        SofasParameters.Track p = SofasParameters.defaults().with("rotation", false).with("growth", false)
            .with("acceleration", false).track();
        Motion found = steps(motion(48, -20, 0, 0), motion(50, -20, 0.3, 0.2), p);
        assertEquals(0, found.omega, 0);
        assertEquals(0, found.alpha, 0);
        assertEquals(0, found.growth, 0);
        assertEquals(0, found.ax, 0);
        assertEquals(50, found.vx, 1);
    }
}
