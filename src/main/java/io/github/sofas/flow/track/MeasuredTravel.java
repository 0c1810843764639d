package io.github.sofas.flow.track;

import io.github.sofas.flow.SofasParameters;
import io.github.sofas.flow.motion.Motion;

/**
 * Over how much travel a motion is measured: the lifetime of the live events (paper, section Track Plane), which is
 * longer while the motion is steady, and shorter where it changes. Ours, because the longer a window is the more it
 * tells of a velocity, but the less of when it changed.
 */
final class MeasuredTravel {
    /** Correction over half the window below which a velocity is steady. */
    private static final double STEADY_PX = 0.1;
    /** Shift at the end of the window by an acceleration above which the lifetime shrinks: it soon ends. */
    private static final double MAX_BEND_PX = 0.25;
    /**
     * Longest window of a clear plane in s, and travel in lifetimes that it holds at least. A hand swings within that
     * time. What is less clear keeps long windows, because its edges lock to rows and columns of pixels.
     */
    private static final double CLEAR_WINDOW_S = 0.2;
    private static final double CLEAR_LIFETIMES = 1.6;

    private SofasParameters.Track p;
    private double px;

    MeasuredTravel(SofasParameters.Track p) {
        this.p = p;
    }

    /** Begins with the shortest. */
    void restart() {
        px = p.lifetimePx();
    }

    /** Goes on with other bounds. */
    void setParameters(SofasParameters.Track next) {
        p = next;
        px = Math.max(p.lifetimePx(), Math.min(p.maxLifetimePx(), px));
    }

    /** That travel in px. */
    double px() {
        return px;
    }

    /**
     * Grows while the motion is steady, and shrinks where it changes.
     *
     * @param moved what the velocity was corrected by, in px, and bend what the acceleration shifts the ends of the
     *     window by, as far as either is more than noise: of few events that takes a long lifetime to tell
     * @param mostPx travel that it may grow to
     */
    void adapt(double moved, double bend, double mostPx) {
        if (bend > MAX_BEND_PX) {
            shrinkTo(0.75);
        } else if (moved < STEADY_PX && bend < 0.7 * MAX_BEND_PX) {
            px = Math.min(mostPx, px * 1.08);
        }
    }

    /** Shrinks where the velocity was corrected by much, in px, as far as that is more than noise. */
    void shrinkIfCorrected(double moved) {
        if (moved > 3 * STEADY_PX) {
            shrinkTo(0.8);
        }
    }

    private void shrinkTo(double share) {
        px = Math.max(p.lifetimePx(), px * share);
    }

    /** Most travel that a motion may be measured over, in px. */
    double mostPx() {
        return p.maxLifetimePx();
    }

    /**
     * The same of a clear plane: less where it is slow. Growth does not count for its travel: it shows least, and takes
     * long windows.
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
