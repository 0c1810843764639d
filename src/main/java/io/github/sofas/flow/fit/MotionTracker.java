package io.github.sofas.flow.fit;

import io.github.sofas.flow.motion.Motion;

/**
 * Follows the velocity and the rotation of a large structure from one measurement to the next. A measurement shows the
 * motion in the middle of its window, half a window ago. Where it has gone since depends on its acceleration and its
 * jerk, of which one window tells little, and several, of other events, tell more. Ours, by multiple model estimation
 * (Magill 1965): a camera may rest on a tripod, be carried, or be moved by hand, and none of them says so. Several
 * filters have each its idea of how restless the motion is, and their mean counts, by how likely each found the
 * measurements of late.
 *
 * <p>Measuring goes on from what was measured, not from that mean: a measurement shows only a part of what a motion is
 * off by, so that it would swing about one that is corrected late.
 */
final class MotionTracker {
    /** Unrest of each filter ({@link KalmanFilter}), from a tripod to a hand. */
    private static final double[] UNREST_PX = {0, 0.01, 0.05, 0.2};
    /** Half windows in which what is known of how likely the filters are fades to a third. */
    private static final double MEMORY_HALVES = 3;
    /**
     * Time after which a third is left of an acceleration, and of a jerk, in s: what moves by hand or on foot changes
     * within that. A camera swung once in 0.4 s, which was its window; taken on, they doubled the swing.
     */
    private static final double ACCELERATION_S = 0.3;
    private static final double JERK_S = 0.2;
    /** Shift of the ends of the window that no motion of the same structure explains. */
    private static final double ANOTHER_PX = 0.3;

    private final TrackedMotion[] tracked = new TrackedMotion[UNREST_PX.length];
    private final double[] weights = new double[UNREST_PX.length];
    private final Motion measured = new Motion();
    private final Motion mean = new Motion();
    private boolean isTracking;
    /** Whether a motion was taken back and has not been tracked since. */
    private boolean isTakenBack;
    /** Whether the motion came from elsewhere since it was measured last. */
    private boolean isReplaced;
    private long beforeUs;

    MotionTracker() {
        for (int i = 0; i < tracked.length; i++) {
            tracked[i] = new TrackedMotion(UNREST_PX[i]);
        }
    }

    /** Ends; the motion stays as it is until it is tracked again. */
    void stop() {
        isTracking = false;
        isTakenBack = false;
    }

    /** Whether a motion is tracked. */
    boolean isTracking() {
        return isTracking;
    }

    /** Goes on with a motion that was not measured. */
    void replace() {
        isReplaced = true;
    }

    /**
     * Takes a motion back to what was measured of it, at the reference and the centre that it has now. One that was not
     * tracked after that the last time is no longer the same.
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
     * Takes a measurement, and gives the motion that follows from all of them.
     *
     * @param motion as measured; its changes as believed
     * @param ax acceleration as measured, before what may be noise is left out
     * @param alpha the same of the change of the rotation
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

    /** The mean of all by how likely each is, with the growth of a motion. */
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
