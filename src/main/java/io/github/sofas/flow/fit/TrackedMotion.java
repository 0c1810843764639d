package io.github.sofas.flow.fit;

import io.github.sofas.flow.motion.Motion;

/**
 * A motion that follows the measurements under one assumption of how restless it is. Velocity along both axes and
 * rotation have a filter each ({@link KalmanFilter}).
 */
final class TrackedMotion {
    private final Motion motion = new Motion();
    private final boolean isSteady;
    private final KalmanFilter x;
    private final KalmanFilter y;
    private final KalmanFilter turn;
    private double logLikelihood;

    /**
     * Makes a motion that was not measured yet.
     *
     * @param unrestPx as of {@link KalmanFilter#KalmanFilter}
     */
    TrackedMotion(double unrestPx) {
        isSteady = unrestPx == 0;
        x = new KalmanFilter(unrestPx);
        y = new KalmanFilter(unrestPx);
        turn = new KalmanFilter(unrestPx);
    }

    /** Begins with a measured motion. */
    void start(Motion measured, double half) {
        motion.copyFrom(measured);
        if (isSteady) {
            motion.hold();
        }
        x.start(half);
        y.start(half);
        turn.start(half);
        logLikelihood = 0;
    }

    /**
     * Takes a measurement.
     *
     * @param measured motion about the same reference and centre
     * @param loss what the window knows of the motion
     * @param dt time since the reference of the measurement before, in s
     * @param half half the window in s
     * @param radius of the structure in px
     * @param kept share of the log-likelihood of earlier measurements that is kept
     */
    void correct(Motion measured, MotionLoss loss, double dt, double half, double radius, double kept) {
        double travel = 2 * half;
        x.correct(dt, half, measured.vx - motion.vx, measured.ax - motion.ax, motion.jerkX, travel * motion.vx,
            loss.noisePx(loss.xx, half));
        y.correct(dt, half, measured.vy - motion.vy, measured.ay - motion.ay, motion.jerkY, travel * motion.vy,
            loss.noisePx(loss.yy, half));
        turn.correct(dt, half, radius * (measured.omega - motion.omega), radius * (measured.alpha - motion.alpha),
            radius * motion.alphaChange, Double.POSITIVE_INFINITY, loss.noisePx(loss.turn, half * radius));
        motion.vx += x.velocity();
        motion.ax += x.acceleration();
        motion.jerkX += x.jerk();
        motion.vy += y.velocity();
        motion.ay += y.acceleration();
        motion.jerkY += y.jerk();
        motion.omega += turn.velocity() / radius;
        motion.alpha += turn.acceleration() / radius;
        motion.alphaChange += turn.jerk() / radius;
        motion.growth = measured.growth;
        motion.growthChange = measured.growthChange;
        motion.deformation.copyFrom(measured.deformation);
        logLikelihood = kept * logLikelihood + x.logLikelihood() + y.logLikelihood() + turn.logLikelihood();
    }

    Motion motion() {
        return motion;
    }

    /** Log-likelihood of the recent measurements, up to a constant that all tracked motions have in common. */
    double logLikelihood() {
        return logLikelihood;
    }
}
