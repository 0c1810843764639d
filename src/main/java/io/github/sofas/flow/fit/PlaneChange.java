package io.github.sofas.flow.fit;

import io.github.sofas.flow.motion.Deformation;
import io.github.sofas.flow.motion.Motion;
import java.util.Arrays;

/**
 * The deformation of a large structure, with its rotation and growth. All of them are measured at once by the slopes of
 * the metric, because each by itself is mistaken for another. They are believed as far as the events meet more often by
 * the deformation. Ours: before a camera that turns, or where a plane is seen at a slant, velocity, rotation and growth
 * leave a tenth of error, and one plane is several structures.
 */
final class PlaneChange {
    /**
     * Smallest radius, in px. A smaller structure is deformed by a part of a pixel over the window, less than its
     * outline or a neighbour makes it seem.
     */
    private static final double LEAST_RADIUS_PX = 35;
    /** Fewest events: two bodies that are mistaken for one would be so all the more if taken for a plane. */
    private static final int LEAST_EVENTS = 2000;
    /** Number of first measurements that leave the structure to settle. */
    private static final int SETTLING = 8;
    /** Twice the share of the metric that a parameter must lose by a shift of one pixel for half of its step. */
    private static final double STIFFNESS = 0.004;
    /** Greatest shift of the ends of the window by a step, at the radius, in px: slopes hold no farther. */
    private static final double MOST_PX = 0.5;
    /** Part of a step that is taken: successive windows share most of their events. */
    private static final double GAIN = 0.5;
    /** Gain of the metric by a deformation, in standard deviations, at which half of the deformation is believed. */
    private static final double GAIN_SIGMAS = 0.3;

    private static final int FIRST = PlaneSlopes.STRETCH;
    private static final int DEFORMING = PlaneSlopes.COUNT - FIRST;

    private final LinearSystem system = new LinearSystem(PlaneSlopes.COUNT);
    private final double[] now = new double[PlaneSlopes.COUNT];
    private final double[] step = new double[PlaneSlopes.COUNT];
    /** The measured deformation, before possible noise is removed, in px/s at the radius. */
    private final double[] measured = new double[DEFORMING];
    private double half;
    private double radius;

    /** Begins with no deformation. */
    void restart() {
        Arrays.fill(measured, 0);
    }

    /** Keeps the share {@code left} of the deformation where it cannot be measured. */
    void hold(Motion motion, double left) {
        for (int k = 0; k < DEFORMING; k++) {
            measured[k] *= left;
        }
        motion.deformation.multiply(left);
    }

    /** Whether a structure may be a plane whose deformation shows, after so many measurements of it. */
    static boolean mayBe(int events, double radius, int measurements) {
        return events >= LEAST_EVENTS && radius > LEAST_RADIUS_PX && measurements > SETTLING;
    }

    /**
     * Takes a step of rotation, growth and deformation, and moves the velocity as they require.
     *
     * @param motion has the rotation and the growth that were each measured separately
     * @param metric of the events along the motion that they were projected along
     * @param turned rotation that the events were projected along, in rad/s, and grown the growth in 1/s
     * @param halfS half the window in s
     * @param structureRadius of the structure in px
     */
    void measure(MetricFit fit, double metric, Motion motion, double turned, double grown, double halfS,
                 double structureRadius) {
        half = halfS;
        radius = structureRadius;
        PlaneSlopes slopes = fit.planeSlopes(radius);
        double stiffness = STIFFNESS * Math.max(0, metric) * half * half;
        take(motion.deformation, turned, grown);
        fill(slopes, stiffness);
        if (!system.factor()) {
            // the top is more than a cell away: velocity, rotation and growth come first
            return;
        }
        system.solve(step);
        double most = 0;
        for (int i = PlaneSlopes.TURN; i < PlaneSlopes.COUNT; i++) {
            most = Math.max(most, Math.abs(step[i]) * half);
        }
        double taken = GAIN * Math.min(1, MOST_PX / Math.max(most, Double.MIN_NORMAL));
        for (int k = 0; k < DEFORMING; k++) {
            measured[k] += GAIN * (now[FIRST + k] - measured[k]) + taken * step[FIRST + k];
        }
        // what the metric loses without the deformation, with the best velocity, rotation and growth
        double gained = system.squareOfLast(measured) / 2 / MetricFit.sd(metric);
        double believed = MetricFit.shown(gained, GAIN_SIGMAS);
        double omega = motion.omega + believed * (turned + taken * step[PlaneSlopes.TURN] / radius - motion.omega);
        double growth = motion.growth + believed * (grown + taken * step[PlaneSlopes.GROW] / radius - motion.growth);
        step[PlaneSlopes.TURN] = (omega - turned) * radius;
        step[PlaneSlopes.GROW] = (growth - grown) * radius;
        for (int k = 0; k < DEFORMING; k++) {
            step[FIRST + k] = believed * measured[k] - now[FIRST + k];
        }
        followVelocity(slopes, stiffness, believed, motion);
        motion.omega = omega;
        motion.growth = growth;
        give(motion.deformation, believed);
    }

    private void take(Deformation deformation, double turned, double grown) {
        now[PlaneSlopes.TURN] = turned * radius;
        now[PlaneSlopes.GROW] = grown * radius;
        now[PlaneSlopes.STRETCH] = deformation.stretch * radius;
        now[PlaneSlopes.SHEAR] = deformation.shear * radius;
        now[PlaneSlopes.PERSPECTIVE_X] = deformation.perspectiveX * radius * radius;
        now[PlaneSlopes.PERSPECTIVE_Y] = deformation.perspectiveY * radius * radius;
    }

    private void give(Deformation deformation, double believed) {
        deformation.stretch = believed * measured[0] / radius;
        deformation.shear = believed * measured[1] / radius;
        deformation.perspectiveX = believed * measured[2] / radius / radius;
        deformation.perspectiveY = believed * measured[3] / radius / radius;
    }

    /**
     * Sets up the equations of the step to the top: twice the loss times the step is the rise. The stiffness draws a
     * deformation towards none.
     */
    private void fill(PlaneSlopes slopes, double stiffness) {
        for (int i = 0; i < PlaneSlopes.COUNT; i++) {
            for (int j = 0; j <= i; j++) {
                system.set(i, j, 2 * slopes.loss(i, j) + (i == j ? stiffness : 0));
            }
            step[i] = slopes.rise(i) - (i < FIRST ? 0 : stiffness * now[i]);
        }
    }

    /** Moves the velocity, which was fitted without the step, to where it is best with the step. */
    private void followVelocity(PlaneSlopes slopes, double stiffness, double believed, Motion motion) {
        double xx = 2 * slopes.loss(0, 0) + stiffness;
        double xy = 2 * slopes.loss(0, 1);
        double yy = 2 * slopes.loss(1, 1) + stiffness;
        double x = 0;
        double y = 0;
        for (int i = PlaneSlopes.TURN; i < PlaneSlopes.COUNT; i++) {
            x -= 2 * slopes.loss(0, i) * step[i];
            y -= 2 * slopes.loss(1, i) * step[i];
        }
        double det = xx * yy - xy * xy;
        motion.vx += believed * (yy * x - xy * y) / det;
        motion.vy += believed * (xx * y - xy * x) / det;
    }
}
