package io.github.sofas.flow.fit;

import io.github.sofas.flow.motion.Motion;

/**
 * How far the metric takes a structure that moves on to turn as its path does, and what it turns by without that.
 *
 * <p>Ours: an edge gives the more events the more squarely it moves, so that the front and the rear of a body give
 * many and its sides few, whichever way the body is turned. Where many are met by many the metric is high: it has one
 * top where edges meet themselves, at the body's rotation, and another where front stays front, at the rotation of the
 * path. What is found lies between the two. With events as many as the cosine of the angle between the way and an
 * edge's normal, those of times t apart lose (w t)² / 2 of their metric by a rotation w beside that of the path, which
 * is w² h² / 3 in the mean over a window of 2 h. How sharp the first top is grows with the square of the radius; discs
 * of 12, 20, 30 px with a texture seem to turn at 0.82, 0.95, 0.98 of their rotation.
 */
final class PathPull {
    /** Loss by the body's own rotation, in losses by that of the path, at which half of the pull is taken off. */
    private static final double HALF_FREED = 2;

    /** Rotation at which the metric has its top, and that of the path, in rad/s. */
    private double found;
    private double ofPath;
    /** What the metric loses beside either, per (rad/s)²: by the path's rotation, and by the structure's own. */
    private double loss;
    private double ownLoss;

    /**
     * Takes the rotation of a structure as it was fitted.
     *
     * @param fitted by the rotation, around the motion
     * @param metric of the events along the motion
     * @param motion that they were projected along, with its reference in the middle of the window
     * @param half half the window in s
     * @param radius of the structure in px
     */
    void take(Parabola fitted, double metric, Motion motion, double half, double radius) {
        found = motion.omega + fitted.step();
        double square = motion.vx * motion.vx + motion.vy * motion.vy;
        double turning = found * found * radius * radius;
        // of what turns on the spot, the same edges give many events for as long as it turns
        double movesOn = square > 0 ? square / (square + turning) : 0;
        ofPath = square > 0 ? (motion.vx * motion.ay - motion.vy * motion.ax) / square : 0;
        loss = movesOn * metric * half * half / 3;
        ownLoss = Math.max(0, fitted.loss() - loss);
    }

    /** What the metric loses by the structure's own rotation, per (rad/s)². */
    double ownLoss() {
        return ownLoss;
    }

    /**
     * The rotation without the pull, in rad/s; less of it is taken off where the structure hardly shows how it turns.
     */
    double freed() {
        return ownLoss > 0
            ? found + (found - ofPath) * loss / ownLoss * MetricFit.shown(ownLoss, HALF_FREED * loss) : found;
    }
}
