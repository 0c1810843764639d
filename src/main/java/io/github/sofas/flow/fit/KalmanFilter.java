package io.github.sofas.flow.fit;

/**
 * The Kalman filter of one component of a motion: of a velocity, its acceleration and its jerk, which changes by
 * chance. Each window measures the first two, and the filter weighs what that corrects the state by.
 *
 * <p>Noise is given in px that the ends of the window shift by, because that is what events show: the same numbers
 * hold for windows of any length. The state itself lives in the motion.
 */
final class KalmanFilter {
    /** Least noise of the velocity and of the acceleration that a window shows of which {@link #NEW_PART} is new. */
    private static final double VELOCITY_PX = 0.03;
    private static final double ACCELERATION_PX = 0.05;
    /** Noise of the velocity as a part of that of the metric. That of the acceleration is as many times its least. */
    private static final double OF_METRIC = 0.5;
    /** Times the least noise that what hardly shows has. */
    private static final double MOST_NOISY = 20;
    /** Noise of a first velocity, and what a first acceleration may be. */
    private static final double FIRST_VELOCITY_PX = 0.1;
    private static final double FIRST_ACCELERATION_PX = 0.05;
    /** A first jerk may be so many times what it changes by. */
    private static final double FIRST_UNREST = 2;
    /** Part of half a window: windows overlap, and the fewer events are new, the less they tell. */
    private static final double NEW_PART = 0.2;
    private static final double LEAST_NEWS = 1e-3;
    /**
     * Noise that is added along an axis of the sensor where the picture moves by less than {@link #LOCKED_TRAVEL_PX} in
     * a window: edges stay on their rows or columns and then pass to the next ones together, as if they swung.
     */
    private static final double LOCKED_VELOCITY_PX = 0.1;
    private static final double LOCKED_ACCELERATION_PX = 0.15;
    private static final double LOCKED_TRAVEL_PX = 1.5;
    /** What a jerk of 1 adds to the velocity that fits all of a window best, by the square of half the window. */
    private static final double JERK_IN_VELOCITY = 0.1;
    /** What any velocity changes by in half a window. */
    private static final double WALK_PX = 0.003;

    private final double unrestPx;
    // covariance of velocity, acceleration and jerk
    private double p00;
    private double p01;
    private double p02;
    private double p11;
    private double p12;
    private double p22;
    // what the last measurement corrects them by
    private double velocity;
    private double acceleration;
    private double jerk;
    private double logLikelihood;

    /**
     * @param unrestPx shift of the end of a window by what the jerk changes by in half of it; 0 for what moves
     *     steadily, without acceleration
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
     * @param offAcceleration the same of the acceleration, in px/s²
     * @param predictedJerk in px/s³
     * @param travelPx travel along an axis of the sensor within the window
     * @param metricPx noise of the metric over what it loses by a shift of a pixel, times that pixel
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

    /** Carries what is known on to another time. */
    private void predict(double dt) {
        p00 += dt * (2 * p01 + dt * (p11 + p02 + dt * (p12 + dt * p22 / 4)));
        p01 += dt * (p11 + p02 + dt * (1.5 * p12 + dt * p22 / 2));
        p02 += dt * (p12 + dt * p22 / 2);
        p11 += dt * (2 * p12 + dt * p22);
        p12 += dt * p22;
    }

    /** Adds what may have changed in that time. */
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

    /** Takes one number that was measured, with its covariances with the state, and its variance. */
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

    /** What the last measurement corrects the velocity by, in px/s. */
    double velocity() {
        return velocity;
    }

    /** The same of the acceleration, in px/s². */
    double acceleration() {
        return acceleration;
    }

    /** The same of the jerk, in px/s³. */
    double jerk() {
        return jerk;
    }

    /** Logarithm of how likely the last measurement was, but for a constant; by as much as it had of new events. */
    double logLikelihood() {
        return logLikelihood;
    }
}
