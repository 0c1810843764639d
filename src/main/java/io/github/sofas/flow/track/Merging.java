package io.github.sofas.flow.track;

import io.github.sofas.flow.fit.CommonMotion;
import io.github.sofas.flow.motion.Motion;

/**
 * Whether two track planes describe one structure (paper, section Algorithm: such are merged). Ours: boxes that touch
 * or nearly do, and one motion that serves both with little loss of metric.
 */
final class Merging {
    /** Share of the metric that two planes may lose by one common motion: an edge knows a part of its velocity only. */
    private static final double MOST_LOST = 0.02;
    /** The same of planes that do not touch: small bodies whose speeds differ by a tenth lose a hundredth at most. */
    private static final double MOST_LOST_APART = 0.005;
    /**
     * Share of the speed by which rotation and growth must make their velocities differ for planes that do not touch to
     * lose as much as those that do: rotation and growth are known less well.
     */
    private static final double TURNING_SHARE = 0.05;
    /** Gap between boxes that may merge, as a share of the shorter of their longer sides, and at least so many px. */
    private static final double GAP_SHARE = 0.8;
    private static final double GAP_PX = 4;
    /**
     * Travel that both must have been tracked for if their boxes are farther apart than {@link #GAP_PX}: over less, two
     * bodies of about the same velocity cannot be told from two parts of one, and what has merged is parted late.
     */
    private static final double TRAVEL_PX = 8;

    private final CommonMotion common = new CommonMotion();

    /** Whether two planes describe one structure at a time; if so, {@link #motion} is that of both. */
    boolean areOne(TrackPlane a, TrackPlane b, long nowUs) {
        if (a.liveEvents() == 0 && b.liveEvents() == 0 || !a.measurement().isSharp() || !b.measurement().isSharp()) {
            return false;
        }
        boolean touch = a.contour().isWithin(GAP_PX, b.contour(), nowUs);
        return (touch || areNear(a, b, nowUs)) && shareMotion(a, b, touch, nowUs);
    }

    /** Whether planes that do not touch may merge by where they are, and by how far they have travelled. */
    private static boolean areNear(TrackPlane a, TrackPlane b, long nowUs) {
        double gap = GAP_SHARE * Math.min(a.contour().extent(), b.contour().extent());
        return a.travelPx(nowUs) >= TRAVEL_PX && b.travelPx(nowUs) >= TRAVEL_PX
            && a.contour().isWithin(gap, b.contour(), nowUs);
    }

    /**
     * Whether one motion serves both, in the middle of the shorter window that either is measured over, and now: an
     * acceleration that few events show for a moment carries the velocity of one through that of the other.
     */
    private boolean shareMotion(TrackPlane a, TrackPlane b, boolean touch, long nowUs) {
        long midUs = nowUs - Math.min(a.lifetimeUs(), b.lifetimeUs()) / 2;
        return shareMotionAt(midUs, a, b, touch) && shareMotionAt(nowUs, a, b, touch);
    }

    private boolean shareMotionAt(long timeUs, TrackPlane a, TrackPlane b, boolean touch) {
        return common.fit(a.motion(), a.measurement().loss(), b.motion(), b.measurement().loss(), timeUs)
            && common.lost() < (touch || common.turnsOrGrows(TURNING_SHARE) ? MOST_LOST : MOST_LOST_APART);
    }

    /** The motion that the two have in common which were asked for last and are one. */
    Motion motion() {
        return common.motion();
    }
}
