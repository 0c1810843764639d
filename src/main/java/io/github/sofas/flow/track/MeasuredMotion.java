package io.github.sofas.flow.track;

import io.github.sofas.flow.motion.MeasuredMotions;
import io.github.sofas.flow.motion.Motion;

/**
 * The motion of a structure as it was measured last, and the telling of it: under the structure's number, once it has
 * one. Where it was found in a slice that is searched, it was measured before.
 */
final class MeasuredMotion {
    /** Share of the measured velocity by which another one may differ from it. */
    private static final double OTHER_SHARE = 0.25;

    private final MeasuredMotions listener;
    /** What was measured before the structure had a number, if anything was. */
    private final Motion untold = new Motion();
    private boolean hasUntold;
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
        hasUntold = false;
        vx = newVx;
        vy = newVy;
    }

    /** Gives the structure its number. */
    void number(int newId) {
        id = newId;
        if (hasUntold) {
            listener.measured(id, untold);
        }
    }

    /** Number of the structure, from 1 on; 0 where it has none yet. */
    int id() {
        return id;
    }

    /** Takes a motion that was measured, its reference the middle of the window that it was measured over. */
    void take(Motion motion) {
        vx = motion.vx;
        vy = motion.vy;
        if (id == 0) {
            hasUntold = true;
            untold.copyFrom(motion);
        } else {
            listener.measured(id, motion);
        }
    }

    /**
     * Whether a motion has gone on to another velocity than was measured: what reverses or pauses within a few pixels
     * seems to slow down or speed up without end, gets few events there, and would label others at that velocity.
     */
    boolean isOther(Motion motion) {
        double dx = motion.vx - vx;
        double dy = motion.vy - vy;
        return dx * dx + dy * dy > OTHER_SHARE * OTHER_SHARE * (vx * vx + vy * vy);
    }
}
