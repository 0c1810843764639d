package io.github.sofas.flow.fit;

import io.github.sofas.flow.motion.Motion;

/**
 * How far the metric pulls the rotation of a structure that moves on towards the rotation of its path, and the rotation
 * without that pull.
 *
 * <p>Ours: the more squarely an edge moves, the more events it gives. The front and the rear of a body therefore give
 * many events and its sides few, whichever way the body is turned. The metric is high where many events meet many. It
 * has one top where edges meet themselves, at the body's rotation, and another where the front stays the front, at the
 * rotation of the path. The rotation that is found lies between the two. Let the number of events be proportional to
 * the cosine of the angle between the path and an edge's normal. Events a time t apart then lose (w t)² / 2 of their
 * metric by a rotation w beside that of the path, which is w² h² / 3 in the mean over a window of 2 h. The sharpness of
 * the first top grows with the square of the radius: textured discs of 12, 20, 30 px seem to turn at 0.82, 0.95, 0.98
 * of their rotation.
 */
final class PathPull {
    /** Loss by the body's own rotation, in multiples of that by the path's, at which half of the pull is removed. */
    private static final double HALF_FREED = 2;

    /** Rotation at which the metric has its top, and that of the path, in rad/s. */
    private double found;
    private double ofPath;
    /** Loss of the metric per (rad/s)²: beside the path's rotation, and beside the structure's own. */
    private double loss;
    private double ownLoss;

    /**
     * Takes the fitted rotation of a structure.
     *
     * @param fitted by the rotation, around the motion
     * @param metric of the events along the motion
     * @param motion that the events were projected along, with its reference in the middle of the window
     * @param half half the window in s
     * @param radius of the structure in px
     */
    void take(Parabola fitted, double metric, Motion motion, double half, double radius) {
        found = motion.omega + fitted.step();
        double square = motion.vx * motion.vx + motion.vy * motion.vy;
        double turning = found * found * radius * radius;
        // where a structure turns on the spot, the same edges give many events for as long as it turns
        double movesOn = square > 0 ? square / (square + turning) : 0;
        ofPath = square > 0 ? (motion.vx * motion.ay - motion.vy * motion.ax) / square : 0;
        loss = movesOn * metric * half * half / 3;
        ownLoss = Math.max(0, fitted.loss() - loss);
    }

    /** Loss of the metric beside the structure's own rotation, per (rad/s)². */
    double ownLoss() {
        return ownLoss;
    }

    /**
     * The rotation without the pull, in rad/s. Less of the pull is removed where the structure hardly shows its
     * rotation.
     */
    double freed() {
        return ownLoss > 0
            ? found + (found - ofPath) * loss / ownLoss * MetricFit.shown(ownLoss, HALF_FREED * loss) : found;
    }
}
