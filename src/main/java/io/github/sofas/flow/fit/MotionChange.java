package io.github.sofas.flow.fit;

import io.github.sofas.flow.SofasParameters;
import io.github.sofas.flow.motion.Motion;

/**
 * How the motion of a structure changes over the window that it is measured in: acceleration along and across the
 * axis that is known best, and rotation. Ours, because a velocity that is that of the middle of the window lags: by 25
 * of a pendulum's 380 px/s.
 */
public final class MotionChange {
    /** Shift of the end of the window by a newly measured change that is half taken over at once, in px. */
    private static final double NEWS_PX = 1;
    /** What is left of a change with each measurement that cannot be made. */
    private static final double HELD = 0.8;
    /** Distance of the projections that measure acceleration and rotation, at the end of the window. */
    private static final double CHANGE_PX = 1.5;
    /** Share of a newly measured change that is taken over: successive windows share most events. */
    private static final double CHANGE_GAIN = 0.5;
    /** Shift at the end of the window by a change that may be noise: most motion is steady. */
    private static final double BEND_PX = 0.07;
    /** Knowledge along an edge, as a share of that across, at which its acceleration counts half. */
    public static final double FLAT_CHANGE = 0.1;

    // as measured, before what may be noise is left out
    private double along;
    private double across;
    private double omega;
    /** The acceleration across as far as it is known. */
    private double shownAcross;
    private double turnLoss;

    /**
     * Measures the change, from the events that the velocity was fitted to, and gives it to the motion; the velocity at
     * the reference, the middle of the window, stays.
     *
     * @param half half the window in s
     * @param radius of the structure in px
     */
    public void measure(MetricFit fit, Motion motion, MotionLoss loss, double half, double radius,
                        SofasParameters.Track p) {
        if (p.acceleration()) {
            measureAcceleration(fit, motion, loss, half);
        } else {
            along = 0;
            across = 0;
            shownAcross = 0;
            motion.ax = 0;
            motion.ay = 0;
        }
        if (p.rotation() && radius > 1) {
            measureRotation(fit, motion, loss, half, radius);
        }
    }

    private void measureAcceleration(MetricFit fit, Motion motion, MotionLoss loss, double half) {
        double axisX = loss.axisX;
        double axisY = loss.axisY;
        double flatness = fit.flatness();
        double acceleration = 2 / (half * half); // shifts both ends of the window by one pixel
        double h = acceleration * CHANGE_PX;
        fit.fitAcceleration(axisX, axisY, h);
        double newAlong = motion.ax * axisX + motion.ay * axisY + fit.step();
        along += gain(newAlong - along, acceleration) * (newAlong - along);
        fit.fitAcceleration(-axisY, axisX, h);
        double newAcross = motion.ay * axisX - motion.ax * axisY + fit.step();
        across += CHANGE_GAIN * (newAcross - across);
        // along a straight edge nothing is known, of acceleration still less than of velocity
        double shown = shown(flatness);
        shownAcross = across * shown;
        double a = believe(along, acceleration);
        double b = believe(across, acceleration) * shown;
        motion.ax = a * axisX - b * axisY;
        motion.ay = a * axisY + b * axisX;
    }

    private void measureRotation(MetricFit fit, Motion motion, MotionLoss loss, double half, double radius) {
        double rotation = 1 / (half * radius); // shifts both ends by one pixel at the radius
        fit.fitRotation(rotation * CHANGE_PX);
        turnLoss = fit.loss();
        double newOmega = motion.omega + fit.step();
        omega += gain(newOmega - omega, rotation) * (newOmega - omega);
        double shownOmega = shown(shareOf(turnLoss, loss.best() * radius * radius));
        motion.omega = believe(omega, rotation) * shownOmega;
    }

    /** Holds the motion steady where it cannot be measured, because another structure crosses or no events come. */
    public void hold(Motion motion) {
        along *= HELD;
        across *= HELD;
        shownAcross *= HELD;
        omega *= HELD;
        motion.ax *= HELD;
        motion.ay *= HELD;
        motion.omega *= HELD;
    }

    /** Begins with a steady motion. */
    public void restart() {
        along = 0;
        across = 0;
        omega = 0;
        shownAcross = 0;
        turnLoss = 0;
    }

    /** Goes on from a rotation that is known from elsewhere, in rad/s. */
    public void setOmega(double known) {
        omega = known;
    }

    /** Shift at the end of the window by the acceleration, in px. */
    public double bendPx(double half) {
        return StrictMath.hypot(along, shownAcross) * half * half / 2;
    }

    /** Loss of metric per (rad/s)² by another rotation. */
    public double turnLoss() {
        return turnLoss;
    }

    /** The share of a measured change to take over: the more, the farther it is from what noise could be. */
    private static double gain(double news, double perPx) {
        double px = news / perPx;
        return CHANGE_GAIN + (1 - CHANGE_GAIN) * px * px / (px * px + NEWS_PX * NEWS_PX);
    }

    /** How far a change shows, 0 to 1, of which as much is known as a share of the best known. */
    private static double shown(double share) {
        double ratio = FLAT_CHANGE / share;
        return share > 0 ? 1 / (1 + ratio * ratio) : 0;
    }

    /** A change that shifts the ends of the window by no more than the noise is none. */
    private static double believe(double value, double perPx) {
        double px = value / perPx;
        return value * shareOf(px * px, px * px + BEND_PX * BEND_PX);
    }

    /** A share of what is known; where nothing is known, none. */
    private static double shareOf(double part, double whole) {
        return whole > 0 ? part / whole : 0;
    }
}
