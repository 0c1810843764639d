package io.github.sofas.flow.track;

import io.github.sofas.flow.motion.MeasuredMotions;
import io.github.sofas.flow.motion.Motion;

/**
 * The motion of a structure as it was measured last. Each measurement is reported to a listener under the number of the
 * structure. A structure that is found in a slice that is being searched is measured before it has a number; its last
 * motion is reported once it gets one.
 */
final class MeasuredMotion {
    /** Difference from the measured velocity, as a share of it, beyond which a velocity counts as another. */
    private static final double OTHER_SHARE = 0.25;

    private final MeasuredMotions listener;
    /** The last motion that was measured before the structure had a number, if any was. */
    private final Motion unreported = new Motion();
    private boolean hasUnreported;
    private int id;
    /** Velocity that was measured last, in px/s. */
    private double vx;
    private double vy;

    MeasuredMotion(MeasuredMotions listener) {
        this.listener = listener;
    }

    /** Begins with the velocity of a new structure, which has no number yet. */
    void start(double newVx, double newVy) {
        id = 0;
        hasUnreported = false;
        vx = newVx;
        vy = newVy;
    }

    /** Gives the structure its number, and reports the motion that was measured before, if any was. */
    void number(int newId) {
        id = newId;
        if (hasUnreported) {
            listener.measured(id, unreported);
        }
    }

    /** Number of the structure, from 1 on; 0 where it has none yet. */
    int id() {
        return id;
    }

    /** Takes a measured motion, whose reference is the middle of the window that it was measured over. */
    void take(Motion motion) {
        vx = motion.vx;
        vy = motion.vy;
        if (id == 0) {
            hasUnreported = true;
            unreported.copyFrom(motion);
        } else {
            listener.measured(id, motion);
        }
    }

    /**
     * Whether a motion has departed from the velocity that was measured last. A structure that reverses or pauses
     * within a few pixels seems to slow down or speed up without end. It gets few events at such a velocity, and would
     * label others with it.
     */
    boolean isOther(Motion motion) {
        double dx = motion.vx - vx;
        double dy = motion.vy - vy;
        return dx * dx + dy * dy > OTHER_SHARE * OTHER_SHARE * (vx * vx + vy * vy);
    }
}
