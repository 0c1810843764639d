package io.github.sofas.flow.fit;

/**
 * The Kalman filter of one component of a motion. Its state is a velocity, an acceleration and a jerk, which changes by
 * chance. Each window measures the first two, and the filter determines by how much that corrects the state.
 *
 * <p>Noise is given as a shift of the ends of the window in px, because that is what events show: the same numbers hold
 * for windows of any length. The motion itself holds the state.
 */
final class KalmanFilter {
    /** Least noise of the velocity and of the acceleration from a window of which {@link #NEW_PART} is new. */
    private static final double VELOCITY_PX = 0.03;
    private static final double ACCELERATION_PX = 0.05;
    /**
     * Noise of the velocity, as a part of that of the metric. That of the acceleration grows from its least by the same
     * factor.
     */
    private static final double OF_METRIC = 0.5;
    /** Greatest factor on the least noise, for a motion that hardly shows. */
    private static final double MOST_NOISY = 20;
    /** Noise of a first velocity, and the size that a first acceleration may have. */
    private static final double FIRST_VELOCITY_PX = 0.1;
    private static final double FIRST_ACCELERATION_PX = 0.05;
    /** Size that a first jerk may have, in multiples of what the jerk changes by in half a window. */
    private static final double FIRST_UNREST = 2;
    /** New part of half a window to which the noise refers: windows overlap, and fewer new events show less. */
    private static final double NEW_PART = 0.2;
    private static final double LEAST_NEWS = 1e-3;
    /**
     * Noise that is added along an axis of the sensor where the picture moves by less than {@link #LOCKED_TRAVEL_PX} in
     * a window: edges stay on their rows or columns, then pass to the next ones together, as if they swung.
     */
    private static final double LOCKED_VELOCITY_PX = 0.1;
    private static final double LOCKED_ACCELERATION_PX = 0.15;
    private static final double LOCKED_TRAVEL_PX = 1.5;
    /**
     * What a jerk of 1 adds to the velocity that fits the whole window best, as a share of the square of half the
     * window.
     */
    private static final double JERK_IN_VELOCITY = 0.1;
    /** Random change of any velocity in half a window. */
    private static final double WALK_PX = 0.003;

    private final double unrestPx;
    // covariance of velocity, acceleration and jerk
    private double p00;
    private double p01;
    private double p02;
    private double p11;
    private double p12;
    private double p22;
    // corrections of the state by the last measurement
    private double velocity;
    private double acceleration;
    private double jerk;
    private double logLikelihood;

    /**
     * Makes a filter.
     *
     * @param unrestPx shift of the end of a window by the change of the jerk in half of it; 0 for a steady motion,
     *     without acceleration
     */
    KalmanFilter(double unrestPx) {
        this.unrestPx = unrestPx;
    }

    /**
     * Begins with a first measurement.
     *
     * @param half half the window in s
     */
    void start(double half) {
        p00 = square(FIRST_VELOCITY_PX / half);
        p11 = unrestPx > 0 ? square(2 * FIRST_ACCELERATION_PX / (half * half)) : 0;
        p22 = square(6 * FIRST_UNREST * unrestPx / (half * half * half));
        p01 = 0;
        p02 = 0;
        p12 = 0;
    }

    /**
     * Takes a measurement.
     *
     * @param dt time between the middles of the window before and of this one, in s
     * @param half half the window in s
     * @param offVelocity measured velocity less the predicted one, in px/s
     * @param offAcceleration the same for the acceleration, in px/s²
     * @param predictedJerk in px/s³
     * @param travelPx travel along an axis of the sensor within the window
     * @param metricPx noise of the metric, divided by what the metric loses by a shift of one pixel, in px
     */
    void correct(double dt, double half, double offVelocity, double offAcceleration, double predictedJerk,
                 double travelPx, double metricPx) {
        predict(dt);
        change(Math.max(0, dt), half);
        double news = Math.max(LEAST_NEWS, dt / (NEW_PART * half));
        double locked = StrictMath.exp(-square(travelPx / LOCKED_TRAVEL_PX));
        velocity = 0;
        acceleration = 0;
        jerk = 0;
        logLikelihood = 0;
        double ofJerk = JERK_IN_VELOCITY * half * half;
        double noisy = Math.max(1, Math.min(MOST_NOISY, OF_METRIC * metricPx / VELOCITY_PX));
        double noise = (square(noisy * VELOCITY_PX) + square(LOCKED_VELOCITY_PX * locked)) / (half * half * news);
        double c0 = p00 + ofJerk * p02;
        double c2 = p02 + ofJerk * p22;
        take(offVelocity - ofJerk * predictedJerk, c0, p01 + ofJerk * p12, c2, c0 + ofJerk * c2 + noise);
        double perPx = 2 / (half * half);
        noise = (square(noisy * ACCELERATION_PX) + square(LOCKED_ACCELERATION_PX * locked)) * perPx * perPx / news;
        take(offAcceleration - acceleration, p01, p11, p12, p11 + noise);
        logLikelihood *= Math.min(1, news);
    }

    /** Carries the covariance on to another time. */
    private void predict(double dt) {
        p00 += dt * (2 * p01 + dt * (p11 + p02 + dt * (p12 + dt * p22 / 4)));
        p01 += dt * (p11 + p02 + dt * (1.5 * p12 + dt * p22 / 2));
        p02 += dt * (p12 + dt * p22 / 2);
        p11 += dt * (2 * p12 + dt * p22);
        p12 += dt * p22;
    }

    /** Adds the variance of what may have changed in that time. */
    private void change(double dt, double half) {
        double perS = square(6 * unrestPx / (half * half * half)) / half;
        double dt2 = dt * dt;
        p00 += perS * dt2 * dt2 * dt / 20 + square(WALK_PX / half) * dt / half;
        p01 += perS * dt2 * dt2 / 8;
        p02 += perS * dt2 * dt / 6;
        p11 += perS * dt2 * dt / 3;
        p12 += perS * dt2 / 2;
        p22 += perS * dt;
    }

    /** Takes one measured number, with its covariances with the state, and its variance. */
    private void take(double off, double c0, double c1, double c2, double variance) {
        double gain0 = c0 / variance;
        double gain1 = c1 / variance;
        double gain2 = c2 / variance;
        velocity += gain0 * off;
        acceleration += gain1 * off;
        jerk += gain2 * off;
        p00 -= gain0 * c0;
        p01 -= gain0 * c1;
        p02 -= gain0 * c2;
        p11 -= gain1 * c1;
        p12 -= gain1 * c2;
        p22 -= gain2 * c2;
        logLikelihood -= (off * off / variance + StrictMath.log(variance)) / 2;
    }

    private static double square(double x) {
        return x * x;
    }

    /** Correction of the velocity by the last measurement, in px/s. */
    double velocity() {
        return velocity;
    }

    /** The same for the acceleration, in px/s². */
    double acceleration() {
        return acceleration;
    }

    /** The same for the jerk, in px/s³. */
    double jerk() {
        return jerk;
    }

    /** Log-likelihood of the last measurement, up to a constant; scaled down where few of its events are new. */
    double logLikelihood() {
        return logLikelihood;
    }
}
