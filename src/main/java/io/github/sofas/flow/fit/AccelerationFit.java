package io.github.sofas.flow.fit;

import io.github.sofas.flow.motion.Motion;

/**
 * The acceleration of a structure, estimated from one window after another. It is believed as far as it exceeds what
 * noise could be, separately along the best known axis and across it.
 *
 * <p>A plane is large and has many events. Both of its axes are known alike, unless it is a straight edge, and the best
 * known axis changes from window to window. Its acceleration is therefore believed as one vector. So many events also
 * show the change of the acceleration, the jerk. Without the jerk, the acceleration is that of the middle of the
 * window, and a camera moved by hand reverses within two or three windows.
 */
final class AccelerationFit {
    /** Share of a newly measured acceleration that is adopted: successive windows share most of their events. */
    private static final double GAIN = 0.5;
    /** The same for a plane, whose successive windows are measured from different events. */
    private static final double PLANE_GAIN = 0.8;
    /**
     * Shift of the end of the window, in px, by a new acceleration at which half of what {@link #GAIN} leaves is
     * adopted at once, too ({@link Belief#taken}): for many events, and the addition for few events, which is divided
     * by their number.
     */
    private static final double NEWS_PX = 0.16;
    private static final double EVENT_NEWS_PX = 300;
    /**
     * Shift at the end of the window, in px, that may be noise: most motion is steady. Steady structures of 2,000
     * events or more show 0.02 px; the path of a camera moved by hand bends by 0.13 px in a window.
     */
    private static final double NOISE_PX = 0.04;
    /** The same while a new structure settles. */
    private static final double SETTLING_PX = 0.07;
    /**
     * What a single event would add to that noise, in px. Several events add that part divided by their number n,
     * because their meetings grow with n². Found with a ball before a DVS128, whose 150 events showed accelerations of
     * 4,000 px/s² back and forth.
     */
    private static final double EVENT_PX = 45;
    /** Knowledge of the second axis, as a share of that of the best known one, from which both count as known alike. */
    private static final double ALIKE = 0.2;
    /** Shift at the end of the window, in px, that may be noise in the acceleration of a plane. */
    private static final double PLANE_PX = 0.06;
    /** The same for its jerk, in addition to the scatter of its accelerations: those of real edges oscillate. */
    private static final double JERK_PX = 0.02;
    /**
     * Share of the jerk that is carried on from the middle of the window. A velocity fitted to the whole window already
     * includes a fifth of what the jerk adds until its end.
     */
    private static final double JERK_SHARE = 0.8;
    /**
     * Knowledge across the best known axis, as a share of that along it, at which an acceleration across counts half.
     */
    private static final double FLAT = 0.1;

    // as measured, before possible noise is removed
    private double along;
    private double across;
    /** The acceleration across, weighted by how well it is known. */
    private double shownAcross;
    // the best known axis of the last measurement
    private double axisX;
    private double axisY;
    /** How clearly the acceleration along that axis shows, in standard deviations of the metric. */
    private double sigmas;
    /** Whether the acceleration is that of a plane whose axes are both known alike. */
    private boolean isVector;
    private final SeriesSlope jerkX = new SeriesSlope();
    private final SeriesSlope jerkY = new SeriesSlope();

    /** Begins with no acceleration. */
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
     * Measures the acceleration, and sets it in the motion.
     *
     * @param half half the window in s
     * @param perSpeed acceleration per unit of velocity that is assumed without evidence, in 1/s
     * @param settles whether the structure is new: corrections of its first velocity look like accelerations
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
        // along a straight edge, nothing is known of the velocity, and still less of the acceleration
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

    /** Expresses the measured acceleration along and across other axes from now on. */
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

    /** Treats the motion as one of constant velocity. */
    void leaveOut(Motion motion) {
        restart();
        motion.ax = 0;
        motion.ay = 0;
        motion.jerkX = 0;
        motion.jerkY = 0;
    }

    /** Keeps a share of the acceleration where nothing can be measured. */
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

    /** Whether the acceleration is that of a plane whose axes are both known alike. */
    boolean isVector() {
        return isVector;
    }

    /** The measured acceleration to the right, before possible noise is removed, in px/s². */
    double measuredX() {
        return along * axisX - across * axisY;
    }

    /** The same, downwards. */
    double measuredY() {
        return along * axisY + across * axisX;
    }

    /** Magnitude of the measured acceleration, with the part across weighted by how well it is known, in px/s². */
    double measured() {
        return Math.hypot(along, shownAcross);
    }

    /**
     * How clearly the acceleration shows along the best known axis: the fall of the metric towards no acceleration,
     * over the distance of the projections that measure it, in standard deviations of the metric. Noise has 0.4.
     */
    double sigmas() {
        return sigmas;
    }
}
