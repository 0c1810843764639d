package io.github.sofas.flow.fit;

import io.github.sofas.flow.motion.Motion;

/**
 * The acceleration of a structure, of which each window tells something, believed as far as it passes what noise could
 * be: along the axis that is known best and across it, each by itself.
 *
 * <p>Of a plane, which is large and has many events, both axes are known alike unless it is a straight edge, and the
 * better one is now this, now that: its acceleration is one vector. So many events tell its change, too, the jerk.
 * Without it the acceleration is that of the middle of the window, and a camera moved by hand turns round within two or
 * three of these.
 */
final class AccelerationFit {
    /** Share of a newly measured acceleration that is taken over: successive windows share most events. */
    private static final double GAIN = 0.5;
    /** The same of a plane, of which two windows are told by different events. */
    private static final double PLANE_GAIN = 0.8;
    /**
     * Shift of the end of the window by a new acceleration that is half taken over at once, in px: of many events, and
     * what the fewness of events adds, by their number.
     */
    private static final double NEWS_PX = 0.16;
    private static final double EVENT_NEWS_PX = 300;
    /**
     * Shift at the end of the window that may be noise: most motion is steady. Steady structures of 2,000 events and
     * more show 0.02 px; a camera that moves by hand bends by 0.13 px in a window.
     */
    private static final double NOISE_PX = 0.04;
    /** The same while a structure that was just found settles. */
    private static final double SETTLING_PX = 0.07;
    /**
     * What a single event would add to that, in px; many add less, by their number, because they meet by its square.
     * Found by a ball before a DVS128, of which 150 events showed accelerations of 4,000 px/s² to and fro.
     */
    private static final double EVENT_PX = 45;
    /** Knowledge of the other axis, as a share of the best known, from which on both are known alike. */
    private static final double ALIKE = 0.2;
    /** Shift at the end of the window that may be noise of the acceleration of a plane, in px. */
    private static final double PLANE_PX = 0.06;
    /** The same of its jerk, beside what its accelerations scatter by: those of real edges swing to and fro. */
    private static final double JERK_PX = 0.02;
    /**
     * Share of the jerk that is taken on from the middle of the window. A velocity that fits all of the window has a
     * fifth of what the jerk adds until its end already.
     */
    private static final double JERK_SHARE = 0.8;
    /** Knowledge of a change, as a share of the best known, at which it counts half. */
    private static final double FLAT = 0.1;

    // as measured, before what may be noise is left out
    private double along;
    private double across;
    /** The acceleration across as far as it is known. */
    private double shownAcross;
    // the axis that was known best last
    private double axisX;
    private double axisY;
    /** How clearly the acceleration along shows, in standard deviations of the metric. */
    private double sigmas;
    /** Whether it is that of a plane, of which both axes are known alike. */
    private boolean isVector;
    private final SeriesSlope jerkX = new SeriesSlope();
    private final SeriesSlope jerkY = new SeriesSlope();

    /** Begins with none. */
    void restart() {
        along = 0;
        across = 0;
        shownAcross = 0;
        axisX = 0;
        axisY = 0;
        sigmas = 0;
        isVector = false;
        jerkX.restart();
        jerkY.restart();
    }

    /**
     * Measures it, and gives it to the motion.
     *
     * @param half half the window in s
     * @param perSpeed acceleration of each velocity that needs no showing, in 1/s
     * @param settles whether the structure was just found: corrections of its first velocity look like accelerations
     */
    void measure(MetricFit fit, Motion motion, MotionLoss loss, double half, double perSpeed, boolean settles,
                 boolean isPlane) {
        isVector = isPlane && loss.flatness() > ALIKE;
        if (isVector) {
            turnTo(loss.axisX, loss.axisY);
        }
        axisX = loss.axisX;
        axisY = loss.axisY;
        double wasX = motion.ax;
        double wasY = motion.ay;
        double gain = isVector ? PLANE_GAIN : GAIN;
        double perPx = 2 / (half * half); // shifts both ends of the window by one pixel
        double h = perPx * ChangeFit.APART_PX;
        Parabola fitted = fit.changes().acceleration(axisX, axisY, h);
        along = Belief.taken(along, wasX * axisX + wasY * axisY + fitted.step(), gain, perPx,
            Belief.noisePx(NEWS_PX, EVENT_NEWS_PX, fit.size()));
        sigmas = Math.max(Math.abs(fitted.slope()), 2 * fitted.loss() * h * Math.abs(along))
            / MetricFit.sd(loss.metric);
        double stepAcross = fit.changes().acceleration(-axisY, axisX, h).step();
        across += gain * (wasY * axisX - wasX * axisY + stepAcross - across);
        // along a straight edge nothing is known, of acceleration still less than of velocity
        double shown = MetricFit.shown(loss.flatness(), FLAT);
        shownAcross = across * shown;
        double inDepthAlong = perSpeed * (motion.vx * axisX + motion.vy * axisY);
        double inDepthAcross = perSpeed * (motion.vy * axisX - motion.vx * axisY);
        double freeAlong = along - inDepthAlong;
        double freeAcross = across - inDepthAcross;
        double noisePx = isVector ? PLANE_PX
            : Belief.noisePx(settles ? SETTLING_PX : NOISE_PX, EVENT_PX, fit.size());
        double whole = Math.hypot(freeAlong, freeAcross);
        double a = inDepthAlong + freeAlong * Belief.share(isVector ? whole : freeAlong, perPx, noisePx);
        double b = inDepthAcross + freeAcross * Belief.share(isVector ? whole : freeAcross, perPx, noisePx) * shown;
        motion.ax = a * axisX - b * axisY;
        motion.ay = a * axisY + b * axisX;
        if (isVector) {
            measureJerk(motion, wasX, wasY, perPx, half);
        } else {
            motion.jerkX = 0;
            motion.jerkY = 0;
        }
    }

    /** Tells what was measured along and across other axes from now on. */
    private void turnTo(double nextX, double nextY) {
        double x = measuredX();
        double y = measuredY();
        along = x * nextX + y * nextY;
        across = y * nextX - x * nextY;
    }

    private void measureJerk(Motion motion, double wasX, double wasY, double perPx, double half) {
        jerkX.measured(motion.ax, motion.referenceUs, motion.ax - wasX, perPx, half);
        jerkY.measured(motion.ay, motion.referenceUs, motion.ay - wasY, perPx, half);
        double x = jerkX.perS();
        double y = jerkY.perS();
        double perPxOfJerk = 3 * perPx / half;
        double noisePx = Math.hypot(JERK_PX, Math.hypot(jerkX.noisePerS(), jerkY.noisePerS()) / perPxOfJerk);
        double share = JERK_SHARE * Belief.share(Math.hypot(x, y), perPxOfJerk, noisePx);
        motion.jerkX = x * share;
        motion.jerkY = y * share;
    }

    /** Takes the motion for one of a steady velocity. */
    void leaveOut(Motion motion) {
        restart();
        motion.ax = 0;
        motion.ay = 0;
        motion.jerkX = 0;
        motion.jerkY = 0;
    }

    /** Keeps a share of it where nothing can be measured. */
    void hold(Motion motion, double share) {
        along *= share;
        across *= share;
        shownAcross *= share;
        motion.ax *= share;
        motion.ay *= share;
        motion.jerkX *= share;
        motion.jerkY *= share;
        jerkX.hold(share);
        jerkY.hold(share);
    }

    /** Whether it is that of a plane, of which both axes are known alike. */
    boolean isVector() {
        return isVector;
    }

    /** As it was measured, before what may be noise is left out, to the right in px/s². */
    double measuredX() {
        return along * axisX - across * axisY;
    }

    /** The same, downwards. */
    double measuredY() {
        return along * axisY + across * axisX;
    }

    /** As it was measured, as far as it is known, in px/s². */
    double measured() {
        return Math.hypot(along, shownAcross);
    }

    /**
     * How clearly it shows along the best known axis: what the metric falls by towards none, at the distance of the
     * projections that measure it, in standard deviations of the metric. Noise has 0.4.
     */
    double sigmas() {
        return sigmas;
    }
}
