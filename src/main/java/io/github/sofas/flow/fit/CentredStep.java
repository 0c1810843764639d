package io.github.sofas.flow.fit;

import io.github.sofas.flow.SofasParameters;
import io.github.sofas.flow.motion.Motion;

/**
 * Steps of a motion, in all of its parameters at once, towards the top of the metric over events on both sides of its
 * reference. Such a window separates what a window on one side confuses: velocity and acceleration, or rotation and its
 * change. Less therefore counts as noise than in {@link MotionChange}: a stiffness holds a step back; so does noise for
 * an acceleration, and what is known already for rotation and growth. Across the best known direction, velocity and
 * acceleration follow only as far as they are known.
 */
public final class CentredStep {
    /** Share of the metric that a parameter must lose by a shift of one pixel for half of its step to be taken. */
    private static final double STIFFNESS = 0.005;
    /** Distance of the projections that measure a change, at the ends of the window, in px. */
    private static final double CHANGE_PX = 1.5;
    /** Shift at the ends of the window, in px, by an acceleration that may be noise. */
    private static final double BEND_PX = 0.07;
    /**
     * Knowledge of the velocity across the best known direction, as a share of that along it, at which it counts half.
     */
    private static final double FLAT = 0.2;
    /** The same for the acceleration. */
    private static final double FLAT_CHANGE = 0.1;
    /**
     * Shift at the ends of the window, in px, by the rotation and growth known before, at which these are half sure.
     */
    private static final double KNOWN_PX = 0.1;
    /** Evidence that makes rotation and growth sure, in standard deviations of the metric. */
    private static final double SURE_SIGMAS = 0.2;
    /** Smallest radius of a structure, in px, for which rotation and growth are measured. */
    private static final double LEAST_RADIUS_PX = 1;

    private final SofasParameters.Track p;
    private final PathPull pull = new PathPull();
    private VelocityTop top;

    /** Makes steps in the parameters that a motion may have. */
    public CentredStep(SofasParameters.Track p) {
        this.p = p;
    }

    /** Begins with another motion, for which no step was taken yet. */
    public void begin() {
        top = null;
    }

    /**
     * Takes a step.
     *
     * @param fit has the events, projected along the motion
     * @param half half the window in s
     * @param radius of the structure in px
     */
    public void take(MetricFit fit, Motion motion, double half, double radius) {
        double px = 1 / half; // velocity that shifts both ends of the window by one pixel
        if (top == null) {
            fit.frame(px);
        } else {
            fit.frame(top, MetricFit.neighbourLoss(top.metric()), px);
        }
        top = fit.fit(0, 0, MetricFit.FLAT_SIGMAS);
        double best = top.bestLoss();
        // knowledge across the best known direction, as a share of that along it
        double flatness = (top.lossXx() + top.lossYy() - best) / Math.max(best, Double.MIN_NORMAL);
        double stiffness = STIFFNESS * top.metric() / (px * px);
        if (p.acceleration()) {
            stepAcceleration(fit, motion, half, flatness);
        }
        if (radius > LEAST_RADIUS_PX && best > 0) {
            stepTurnAndGrowth(fit, motion, half, radius, stiffness * radius * radius);
        }
        double axisX = top.axisX();
        double axisY = top.axisY();
        double along = (top.stepX() * axisX + top.stepY() * axisY) * followed(best, stiffness);
        double across = (top.stepY() * axisX - top.stepX() * axisY) * MetricFit.shown(flatness, FLAT);
        motion.vx += along * axisX - across * axisY;
        motion.vy += along * axisY + across * axisX;
    }

    private void stepAcceleration(MetricFit fit, Motion motion, double half, double flatness) {
        double axisX = top.axisX();
        double axisY = top.axisY();
        double perPx = 2 / (half * half);
        double h = perPx * CHANGE_PX;
        double along = motion.ax * axisX + motion.ay * axisY + fit.changes().acceleration(axisX, axisY, h).step();
        double across = motion.ay * axisX - motion.ax * axisY + fit.changes().acceleration(-axisY, axisX, h).step();
        double a = along * MetricFit.shown(Math.abs(along) / perPx, BEND_PX);
        double b = across * MetricFit.shown(Math.abs(across) / perPx, BEND_PX) * MetricFit.shown(flatness, FLAT_CHANGE);
        motion.ax = a * axisX - b * axisY;
        motion.ay = a * axisY + b * axisX;
    }

    private void stepTurnAndGrowth(MetricFit fit, Motion motion, double half, double radius, double stiffness) {
        double perPx = 1 / (half * radius);
        double h = perPx * CHANGE_PX;
        double turn = 0;
        double grow = 0;
        if (p.rotation()) {
            Parabola rotation = fit.changes().rotation(h);
            pull.take(rotation, top.metric(), motion, half, radius);
            turn = (pull.freed() - motion.omega) * followed(rotation.loss(), stiffness);
        }
        if (p.growth()) {
            Parabola growth = fit.changes().growth(h);
            grow = growth.step() * followed(growth.loss(), stiffness);
        }
        double known = Math.sqrt(motion.omega * motion.omega + motion.growth * motion.growth) / perPx;
        double evidence = fit.localEvidence(motion.omega + turn, motion.growth + grow, turn, grow);
        double sure = evidence > SURE_SIGMAS ? 1 : MetricFit.shown(known, KNOWN_PX);
        motion.omega += sure * turn;
        motion.growth += sure * grow;
        if (p.rotation() && p.acceleration()) {
            Parabola spin = fit.changes().spin(2 * perPx / half * CHANGE_PX);
            motion.alpha += sure * spin.step() * followed(spin.loss(), stiffness * half * half / 4);
        }
    }

    /** Share of a step that is taken in a parameter with this loss. */
    private static double followed(double loss, double stiffness) {
        return loss > 0 ? loss / (loss + stiffness) : 0;
    }
}
