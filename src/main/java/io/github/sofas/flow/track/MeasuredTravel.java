package io.github.sofas.flow.track;

import io.github.sofas.flow.SofasParameters;
import io.github.sofas.flow.motion.Motion;

/**
 * Travel over which a motion is measured: the lifetime of the live events (paper, section Track Plane). It is longer
 * while the motion is steady, and shorter where the motion changes. Ours, because a longer window shows more of the
 * velocity, but less of when the velocity changed.
 */
final class MeasuredTravel {
    /** Correction of the velocity, in px over half the window, below which the motion is steady. */
    private static final double STEADY_PX = 0.1;
    /**
     * Shift of the end of the window by the acceleration, in px, above which the lifetime shrinks: an acceleration soon
     * ends.
     */
    private static final double MAX_BEND_PX = 0.25;
    /**
     * Longest window of a clear plane, in s, and the least travel that its window holds nevertheless, in shortest
     * lifetimes. A hand swings within that time. A plane that is less clear keeps long windows, because its edges lock
     * to rows and columns of pixels.
     */
    private static final double CLEAR_WINDOW_S = 0.2;
    private static final double CLEAR_LIFETIMES = 1.6;

    private SofasParameters.Track p;
    private double px;

    MeasuredTravel(SofasParameters.Track p) {
        this.p = p;
    }

    /** Begins with the shortest travel. */
    void restart() {
        px = p.lifetimePx();
    }

    /** Continues with other bounds. */
    void setParameters(SofasParameters.Track next) {
        p = next;
        px = Math.max(p.lifetimePx(), Math.min(p.maxLifetimePx(), px));
    }

    /** Travel that the motion is measured over, in px. */
    double px() {
        return px;
    }

    /**
     * Lengthens the travel while the motion is steady, and shortens it where the motion changes.
     *
     * @param moved correction of the velocity, in px, and bend the shift of the ends of the window by the acceleration,
     *     as far as either is more than noise: with few events, a long lifetime is needed to distinguish change from
     *     noise
     * @param mostPx longest travel that it may grow to
     */
    void adapt(double moved, double bend, double mostPx) {
        if (bend > MAX_BEND_PX) {
            shrinkTo(0.75);
        } else if (moved < STEADY_PX && bend < 0.7 * MAX_BEND_PX) {
            px = Math.min(mostPx, px * 1.08);
        }
    }

    /**
     * Shortens the travel where the velocity was corrected by much, in px, as far as the correction is more than noise.
     */
    void shrinkIfCorrected(double moved) {
        if (moved > 3 * STEADY_PX) {
            shrinkTo(0.8);
        }
    }

    private void shrinkTo(double share) {
        px = Math.max(p.lifetimePx(), px * share);
    }

    /** Longest travel that a motion may be measured over, in px. */
    double mostPx() {
        return p.maxLifetimePx();
    }

    /**
     * The same for a clear plane: less where the plane is slow. The part of its speed that is growth does not count as
     * travel here: growth shows least, and takes long windows.
     *
     * @param half half the window in s
     * @param radius of the plane in px
     */
    double mostPxOfClear(Motion motion, double half, double radius) {
        double speed = motion.speed(radius);
        double growing = motion.growth * radius;
        double withoutGrowth = Math.sqrt(Math.max(speed * speed - growing * growing, Double.MIN_NORMAL));
        double leastPx = CLEAR_LIFETIMES * p.lifetimePx() * speed / withoutGrowth;
        return Math.min(p.maxLifetimePx(), Math.max(leastPx, px * CLEAR_WINDOW_S / (2 * half)));
    }
}
