package io.github.sofas.flow.fit;

import io.github.sofas.flow.motion.Motion;

/**
 * Tracks the velocity and the rotation of a large structure from one measurement to the next. A measurement shows the
 * motion in the middle of its window, half a window ago. How the motion has changed since depends on its acceleration
 * and jerk, of which one window shows little, and several windows with other events show more. Ours, by multiple model
 * estimation (Magill 1965): a camera may rest on a tripod, be carried, or be moved by hand, and the events do not say
 * which. Each of several filters assumes another restlessness of the motion. The result is their mean, weighted by how
 * likely each filter found the recent measurements.
 *
 * <p>Measuring continues from the motion that was measured, not from that mean. A measurement shows only a part of the
 * error of a motion, so that the measured motion would oscillate about a mean that is corrected late.
 */
final class MotionTracker {
    /** Restlessness of each filter ({@link KalmanFilter}), from a tripod to a hand. */
    private static final double[] UNREST_PX = {0, 0.01, 0.05, 0.2};
    /** Number of half windows in which the likelihood of the filters fades to a third. */
    private static final double MEMORY_HALVES = 3;
    /**
     * Time, in s, after which a third is left of an acceleration, and of a jerk: a motion by hand or on foot changes
     * within that time. One camera swung once in 0.4 s, the length of its window; carried on in full, acceleration and
     * jerk doubled the swing.
     */
    private static final double ACCELERATION_S = 0.3;
    private static final double JERK_S = 0.2;
    /** Shift of the ends of the window, in px, that no motion of the same structure explains. */
    private static final double ANOTHER_PX = 0.3;

    private final TrackedMotion[] tracked = new TrackedMotion[UNREST_PX.length];
    private final double[] weights = new double[UNREST_PX.length];
    private final Motion measured = new Motion();
    private final Motion mean = new Motion();
    private boolean isTracking;
    /** Whether a motion was taken back and has not been tracked since. */
    private boolean isTakenBack;
    /** Whether the motion was replaced since the last measurement. */
    private boolean isReplaced;
    private long beforeUs;

    MotionTracker() {
        for (int i = 0; i < tracked.length; i++) {
            tracked[i] = new TrackedMotion(UNREST_PX[i]);
        }
    }

    /** Ends tracking; the motion stays as it is until it is tracked again. */
    void stop() {
        isTracking = false;
        isTakenBack = false;
    }

    /** Whether a motion is tracked. */
    boolean isTracking() {
        return isTracking;
    }

    /** Continues with a motion that was not measured. */
    void replace() {
        isReplaced = true;
    }

    /**
     * Takes a motion back to its measured state, at its present reference and centre. A motion that was not tracked
     * after the last such call is no longer the same.
     */
    void takeBack(Motion motion) {
        isTracking &= !isTakenBack;
        if (isTracking) {
            isTakenBack = true;
            measured.follow(motion);
            for (TrackedMotion t : tracked) {
                t.motion().follow(motion);
            }
            if (!isReplaced) {
                motion.copyFrom(measured);
            }
        }
        isReplaced = false;
    }

    /**
     * Takes a measurement, and sets the motion that follows from all measurements.
     *
     * @param motion as measured; its changes as believed
     * @param ax measured acceleration, before possible noise is removed
     * @param alpha the same for the change of the rotation
     * @param loss what the window knows of the motion
     * @param half half the window in s
     * @param radius of the structure in px
     */
    void track(Motion motion, double ax, double ay, double alpha, MotionLoss loss, double half, double radius) {
        isTakenBack = false;
        measured.copyFrom(motion);
        double dt = (motion.referenceUs - beforeUs) * 1e-6;
        beforeUs = motion.referenceUs;
        isTracking = isTracking && isOfSame(motion, half, radius);
        if (!isTracking) {
            for (TrackedMotion t : tracked) {
                t.start(motion, half);
            }
            isTracking = true;
            return;
        }
        motion.ax = ax;
        motion.ay = ay;
        motion.alpha = alpha;
        double kept = StrictMath.exp(-Math.max(0, dt) / (MEMORY_HALVES * half));
        for (TrackedMotion t : tracked) {
            t.correct(motion, loss, dt, half, radius, kept);
        }
        takeMean(motion);
        motion.copyFrom(mean);
        double share = lasting(half, ACCELERATION_S);
        motion.ax *= share;
        motion.ay *= share;
        motion.alpha *= share;
        share = lasting(half, JERK_S);
        motion.jerkX *= share;
        motion.jerkY *= share;
        motion.alphaChange *= share;
    }

    private static double lasting(double half, double seconds) {
        return StrictMath.exp(-half * half / (seconds * seconds));
    }

    private boolean isOfSame(Motion motion, double half, double radius) {
        takeMean(motion);
        double turned = radius * Math.abs(motion.omega - mean.omega);
        return Math.max(Math.hypot(motion.vx - mean.vx, motion.vy - mean.vy), turned) * half < ANOTHER_PX;
    }

    /** Finds the mean of all filters, weighted by their likelihood, with the growth of a motion. */
    private void takeMean(Motion motion) {
        double most = Double.NEGATIVE_INFINITY;
        for (TrackedMotion t : tracked) {
            most = Math.max(most, t.logLikelihood());
        }
        double sum = 0;
        for (int i = 0; i < tracked.length; i++) {
            weights[i] = StrictMath.exp(tracked[i].logLikelihood() - most);
            sum += weights[i];
        }
        mean.copyFrom(motion);
        mean.vx = 0;
        mean.vy = 0;
        mean.omega = 0;
        mean.ax = 0;
        mean.ay = 0;
        mean.alpha = 0;
        mean.jerkX = 0;
        mean.jerkY = 0;
        mean.alphaChange = 0;
        for (int i = 0; i < tracked.length; i++) {
            Motion each = tracked[i].motion();
            double share = weights[i] / sum;
            mean.vx += share * each.vx;
            mean.vy += share * each.vy;
            mean.omega += share * each.omega;
            mean.ax += share * each.ax;
            mean.ay += share * each.ay;
            mean.alpha += share * each.alpha;
            mean.jerkX += share * each.jerkX;
            mean.jerkY += share * each.jerkY;
            mean.alphaChange += share * each.alphaChange;
        }
    }
}
