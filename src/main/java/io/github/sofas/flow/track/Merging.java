package io.github.sofas.flow.track;

import io.github.sofas.flow.fit.CommonMotion;
import io.github.sofas.flow.fit.MetricFit;
import io.github.sofas.flow.motion.Motion;

/**
 * Whether two track planes describe one structure (paper, section Algorithm: such planes are merged). Ours: their boxes
 * touch or nearly do, or the planes have gone together for long, and one motion serves both with little loss of metric.
 *
 * <p>A structure that moves along itself is seen by its two ends alone. One end covers the background and the other
 * uncovers it, so one fires ON and the other OFF events. Two such ends belong together across a gap in which nothing
 * fires.
 */
final class Merging {
    /** Share of its metric that a plane may lose by the common motion: an edge knows only a part of its velocity. */
    private static final double MOST_LOST = 0.02;
    /**
     * The same for planes that do not touch, unless they have gone together for long: small bodies whose speeds differ
     * by a tenth lose a hundredth at most.
     */
    private static final double MOST_LOST_APART = 0.005;
    /**
     * Least difference of the two velocities that rotation and growth cause, as a share of the speed, for planes that
     * do not touch to be allowed the loss of those that do: rotation and growth are known less well.
     */
    private static final double TURNING_SHARE = 0.05;
    /**
     * Greatest gap between the boxes of planes that may merge, as a share of the shorter of their longer sides, and at
     * least so many px.
     */
    private static final double GAP_SHARE = 0.8;
    private static final double GAP_PX = 4;
    /**
     * Travel, in px, over which both planes must have been tracked if their boxes are farther apart than
     * {@link #GAP_PX}. Less travel does not distinguish two bodies of about the same velocity from two parts of one,
     * and merged bodies are parted late.
     */
    private static final double TRAVEL_PX = 8;

    /**
     * Greatest gap between the leading and the trailing edge of one body, as the same share: the long sides of the
     * body, which lie along its way, fire no events.
     */
    private static final double BODY_SHARE = 3;
    /**
     * Travel, in px, over which both edges must have been tracked: over less, the rear of one body goes with the front
     * of the next.
     */
    private static final double EDGES_TRAVEL_PX = 6;
    /**
     * Time in s for which a change of speed counts as travel: two planes that change alike show more than two that
     * continue alike.
     */
    private static final double CHANGE_S = 0.2;
    /**
     * Travel, in px, over which two parts of a structure that grows or shrinks must both have been tracked. The sides
     * of a structure that comes near are slow.
     */
    private static final double GROWING_TRAVEL_PX = 2;

    /** Share of its metric that either part of a body that turns loses by one velocity at most, to second order. */
    private static final double MOST_LOST_TURNING = 0.6;

    /** Why two planes are one. */
    enum Bond {
        /** They move alike. */
        MOTION,
        /** They are the leading and the trailing edge of one body, across a gap. */
        EDGES,
        /** They have gone together for long, far apart from each other. */
        TOGETHER,
        /** They turn or grow as one body, though none of its parts need show it. */
        BODY
    }

    private final CommonMotion common = new CommonMotion();
    private final OneBody body = new OneBody();
    /** Why the two planes that were asked about last are one, if they are. */
    private Bond bond = Bond.MOTION;

    /** Whether two planes describe one structure at a time; if so, {@link #motion} is the motion of both. */
    boolean areOne(TrackPlane a, TrackPlane b, MetricFit fit, long nowUs) {
        if (a.liveEvents() == 0 && b.liveEvents() == 0 || !a.measurement().isSharp() || !b.measurement().isSharp()) {
            return false;
        }
        boolean touch = a.contour().isWithin(GAP_PX, b.contour(), nowUs);
        bond = !touch && a.commonPolarity() * b.commonPolarity() < 0 ? Bond.EDGES : Bond.MOTION;
        if (touch || areNear(a, b, nowUs)) {
            return shareMotion(a, b, touch, nowUs) || touch && areOneBody(a, b, fit, nowUs);
        }
        bond = Bond.TOGETHER;
        return haveGoneTogether(a, b, nowUs);
    }

    /** Whether the distance and the travel of two planes that do not touch allow them to merge. */
    private boolean areNear(TrackPlane a, TrackPlane b, long nowUs) {
        boolean areEdges = bond == Bond.EDGES;
        double travelPx = areEdges ? EDGES_TRAVEL_PX : TRAVEL_PX;
        double gap = (areEdges ? BODY_SHARE : GAP_SHARE) * Math.min(a.contour().extent(), b.contour().extent());
        return a.travelPx(nowUs) >= travelPx && b.travelPx(nowUs) >= travelPx
            && a.contour().isWithin(gap, b.contour(), nowUs);
    }

    /**
     * Whether planes that lie far apart have shared their motion over as many px of travel as lie between them, or over
     * less where the motion changed. The shapes of a poster before a moving camera do; bodies that move alike for a
     * moment do not.
     *
     * <p>The motions are compared in the middle of the window, where they are known best. Before a camera moved by
     * hand, the current velocities of two shapes differ by what either window does not show yet.
     */
    private boolean haveGoneTogether(TrackPlane a, TrackPlane b, long nowUs) {
        TrackPlane younger = a.id() > b.id() ? a : b;
        int older = younger == a ? b.id() : a.id();
        Companion companion = younger.companion();
        if (a.travelPx(nowUs) < TRAVEL_PX || b.travelPx(nowUs) < TRAVEL_PX || !companion.mayBe(older, nowUs)) {
            return false;
        }
        boolean isAlike = fit(middleUs(a, b, nowUs), a, b) && common.lost() < MOST_LOST;
        companion.note(older, isAlike, Math.min(evidencePxPerS(a), evidencePxPerS(b)), nowUs);
        // where they are one, both go on along the motion that they have in common now
        return isAlike && a.contour().isWithin(companion.togetherPx(), b.contour(), nowUs) && fit(nowUs, a, b);
    }

    /** Whether planes that touch and move differently are clearly parts of one body that turns or grows. */
    private boolean areOneBody(TrackPlane a, TrackPlane b, MetricFit fit, long nowUs) {
        TrackPlane younger = a.id() > b.id() ? a : b;
        TrackPlane older = younger == a ? b : a;
        OtherPart part = younger.otherPart();
        double travelPx = Math.min(a.travelPx(nowUs), b.travelPx(nowUs));
        boolean mayGrow = travelPx >= GROWING_TRAVEL_PX && a.commonPolarity() * b.commonPolarity() > 0;
        // planes that lose more by the common motion are two bodies, though a rotation explains them for a while
        boolean mayTurn = travelPx >= EDGES_TRAVEL_PX && common.lost() < MOST_LOST_TURNING;
        if (!mayGrow && !mayTurn || !part.isDue(older.id(), Math.max(a.speed(), b.speed()), nowUs)) {
            return false;
        }
        if (a.isDense() || b.isDense()) {
            part.note(older.id(), OneBody.NOTHING, nowUs);
            return false;
        }
        body.take(older.live(), older.motion(), younger.live(), younger.motion(),
            Math.max(a.contour().radius(), b.contour().radius()));
        boolean areOne = mayGrow && body.growsOrShrinks(fit)
            || part.note(older.id(), mayTurn ? body.sigmasGained(fit) : OneBody.NOTHING, nowUs);
        if (areOne) {
            bond = Bond.BODY;
        }
        return areOne;
    }

    /** Evidence that the motion of a plane gives per second of what else moves like it, in px. */
    private static double evidencePxPerS(TrackPlane plane) {
        return plane.speed() + CHANGE_S * Math.hypot(plane.motion().ax, plane.motion().ay);
    }

    /**
     * Whether one motion serves both planes, in the middle of the shorter of their windows as well as now. One time
     * alone does not suffice: an acceleration that few events show for a moment carries the velocity of one plane
     * through that of the other.
     */
    private boolean shareMotion(TrackPlane a, TrackPlane b, boolean touch, long nowUs) {
        return shareMotionAt(middleUs(a, b, nowUs), a, b, touch) && shareMotionAt(nowUs, a, b, touch);
    }

    /** Middle of the shorter of the windows that the motions were measured over. */
    private static long middleUs(TrackPlane a, TrackPlane b, long nowUs) {
        return nowUs - Math.min(a.lifetimeUs(), b.lifetimeUs()) / 2;
    }

    private boolean shareMotionAt(long timeUs, TrackPlane a, TrackPlane b, boolean touch) {
        if (bond == Bond.EDGES) {
            return common.fitEdges(a.motion(), a.measurement().loss(), b.motion(), b.measurement().loss(), timeUs)
                && common.lost() < MOST_LOST_APART;
        }
        return fit(timeUs, a, b)
            && common.lost() < (touch || common.turnsOrGrows(TURNING_SHARE) ? MOST_LOST : MOST_LOST_APART);
    }

    /** Fits the motion that suits both planes best at a time; returns whether they determine it. */
    private boolean fit(long timeUs, TrackPlane a, TrackPlane b) {
        return common.fit(a.motion(), a.measurement().loss(), b.motion(), b.measurement().loss(), timeUs);
    }

    /** The common motion of the two planes that were asked about last and are one. */
    Motion motion() {
        return bond == Bond.BODY ? body.motion() : common.motion();
    }

    /** Why those two planes are one. */
    Bond bond() {
        return bond;
    }
}
