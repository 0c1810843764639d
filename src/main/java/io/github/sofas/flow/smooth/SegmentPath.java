package io.github.sofas.flow.smooth;

import io.github.sofas.flow.motion.Deformation;
import io.github.sofas.flow.motion.Motion;
import io.github.sofas.flow.motion.PixelBox;
import java.util.ArrayList;
import java.util.List;

/**
 * The motion of a segment over the time that is looked at. Its knots are measured motions, each at the middle of the
 * window that it was measured over. Between two knots the motion changes evenly. Before the first knot the segment
 * moves steadily. After the last one the motion changes on as it did there, but no longer than the segment has events.
 */
final class SegmentPath {
    private static final int FIRST_CAPACITY = 64;

    /**
     * Travel on either side over which a motion is measured anew, and travel from one such measurement to the next, in
     * px.
     */
    private static final double REFINED_PX = 8;
    private static final double REFINED_EVERY_PX = 4;
    /** Speed of a segment at rest. */
    private static final double LEAST_PX_PER_S = 1e-3;
    /** Events from which on a shorter window shows the motion, as is needed where a structure slows down to reverse. */
    private static final int MANY_EVENTS = 1000;
    /** Shift by rotation and growth on either side, in px, below which nothing is measured anew. */
    private static final double LEAST_SHIFT_PX = 0.25;

    /** Parts of the time over which two paths are compared for moving together. */
    private static final int PARTS = 8;
    /**
     * How far two paths of one body may seem to part: in px, and as shares of their way and of the shift by turning.
     */
    private static final double APART_PX = 3;
    private static final double APART_SHARE = 0.15;
    private static final double APART_TURNING = 0.5;
    /**
     * Share of its speed by which a motion may change after its last measurement: a structure that reverses or pauses
     * seems to slow down without end.
     */
    private static final double MOST_CHANGE = 0.25;

    private final int id;
    /** In order of time. */
    private final List<Motion> knots = new ArrayList<>();
    private long newestUs = Long.MIN_VALUE;
    private long firstSeenUs = Long.MAX_VALUE;
    private long endUs = Long.MAX_VALUE;
    private long sureUntilUs = Long.MIN_VALUE;
    /** Approximate root mean square distance of its events from their middle, where they were looked at last. */
    private double radius;
    /** Time in which an event comes there, in µs. */
    private double perEventUs = Double.POSITIVE_INFINITY;
    private final PathMean mean = new PathMean(this);
    private final Motion before = new Motion();
    private final Motion after = new Motion();
    private final Deformation deformation = new Deformation();

    SegmentPath(int id) {
        this.id = id;
    }

    int id() {
        return id;
    }

    /** Time of its newest event or measurement in µs. */
    long newestUs() {
        return newestUs;
    }

    /** Notes an event that the causal labels give to the segment. */
    void see(long timeUs) {
        firstSeenUs = Math.min(firstSeenUs, timeUs);
        newestUs = Math.max(newestUs, timeUs);
        endUs = Math.max(endUs, timeUs);
    }

    /** Ends it at its newest time: its events are those of another segment from now on. */
    void end() {
        endUs = newestUs;
    }

    /** Time in µs at which its events became those of another segment. */
    long endUs() {
        return endUs;
    }

    /** Whether its events became those of another segment. */
    boolean hasEnded() {
        return endUs < Long.MAX_VALUE;
    }

    /** Time in µs up to which its events are known to move along it beyond doubt. */
    long sureUntilUs() {
        return sureUntilUs;
    }

    /** Notes that its events move along it beyond doubt up to a time. */
    void beSure(long untilUs) {
        sureUntilUs = untilUs;
    }

    /** Time in µs of the first event that the causal labels give to the segment. */
    long firstSeenUs() {
        return firstSeenUs;
    }

    /** Whether the causal labels give the segment events of a slice, but none at its beginning or before. */
    boolean isFirstSeenIn(Slice slice) {
        return firstSeenUs > slice.fromUs && firstSeenUs < slice.untilUs;
    }

    /** The earliest known motion. */
    Motion first() {
        return knots.get(0);
    }

    /** The latest known motion. */
    Motion last() {
        return knots.get(knots.size() - 1);
    }

    /**
     * Whether the segment may have been one body with another for as long as both are known: one of the two went where
     * the motion of the other takes a point there. One direction is enough, because a piece may not show that it turns.
     */
    boolean movedAsOneWith(SegmentPath other) {
        return carriedAlong(other) || other.carriedAlong(this);
    }

    /**
     * Whether another segment went about where the motion of this one takes a point there; turning may be known late.
     */
    private boolean carriedAlong(SegmentPath other) {
        long fromUs = Math.max(first().referenceUs, other.first().referenceUs);
        double seconds = (Math.min(last().referenceUs, other.last().referenceUs) - fromUs) * 1e-6 / PARTS;
        double x = 0;
        double y = 0;
        double may = APART_PX;
        for (int part = 0; part < PARTS && seconds > 0; part++) {
            at(fromUs + (long) ((part + 0.5) * seconds * 1e6), before);
            other.at(before.referenceUs, after);
            double distance = Math.hypot(after.centreX - before.centreX, after.centreY - before.centreY);
            double turning = Math.max(Math.hypot(before.omega, before.growth), Math.hypot(after.omega, after.growth));
            may += (APART_SHARE * Math.hypot(after.vx, after.vy) + APART_TURNING * turning * distance) * seconds;
            before.moveCentre(after.centreX, after.centreY);
            x += (after.vx - before.vx) * seconds;
            y += (after.vy - before.vy) * seconds;
        }
        return Math.hypot(x, y) <= may;
    }

    /** Takes over the knots of a segment that proved to be the same, for the times without knots here. */
    void takeOver(SegmentPath other) {
        int k = 0;
        for (Motion knot : other.knots) {
            if (knots.size() == k || knot.referenceUs < knots.get(k).referenceUs) {
                knots.add(k++, knot);
            } else if (knot.referenceUs > last().referenceUs) {
                knots.add(knot);
            }
        }
        newestUs = Math.max(newestUs, other.newestUs);
        mean.forget();
    }

    /** Drops the knots that no time from a given one on needs. */
    void forget(long us) {
        int needless = knotsUntil(us) - 1;
        if (needless > 0) {
            knots.subList(0, needless).clear();
        }
    }

    /** Adds a measurement, which replaces those of the same or a later time. */
    void add(Motion measured) {
        Motion knot = new Motion();
        knot.copyFrom(measured);
        while (!knots.isEmpty() && knots.get(knots.size() - 1).referenceUs >= knot.referenceUs) {
            knots.remove(knots.size() - 1);
        }
        knots.add(knot);
        newestUs = Math.max(newestUs, knot.referenceUs);
        mean.forget();
    }

    /** Measures the motion at a time over so many µs on either side; null if it cannot, or has too few events. */
    @FunctionalInterface
    interface Refinement {
        Motion at(long us, long sideUs, int leastEvents);
    }

    /**
     * Measures the knots of a slice anew where the segment turns or grows. The window is so many px of travel at the
     * greatest speed around a knot, if that has enough events. Otherwise the speed is that at the knot, where the
     * segment may be reversing.
     */
    void refine(Slice slice, long mostSideUs, Refinement refinement) {
        PixelBox box = slice.box(id);
        radius = box.radius();
        perEventUs = (double) (slice.untilUs - slice.fromUs) / box.events;
        for (int k = knotsUntil(slice.fromUs - 1); k < knots.size() && knots.get(k).referenceUs < slice.untilUs; k++) {
            Motion knot = knots.get(k);
            double speed = speed(knot);
            long sideUs = refinedUs(speed, mostSideUs);
            double shift = Math.sqrt(knot.omega * knot.omega + knot.growth * knot.growth) * radius * sideUs * 1e-6;
            if (shift < LEAST_SHIFT_PX) {
                continue;
            }
            double greatest = greatestSpeed(knot, sideUs);
            Motion refined = greatest > speed
                ? refinement.at(knot.referenceUs, refinedUs(greatest, mostSideUs), MANY_EVENTS) : null;
            if (refined != null) {
                speed = greatest;
            } else {
                refined = refinement.at(knot.referenceUs, sideUs, 0);
            }
            if (refined != null) {
                knot.copyFrom(refined);
                long untilUs = knot.referenceUs + Math.max(1, (long) (REFINED_EVERY_PX / speed * 1e6));
                replace(knot.referenceUs, Math.min(untilUs, slice.untilUs), List.of(knot));
            }
        }
    }

    /** Half the time, in µs, over which a motion of a speed in px/s is measured anew. */
    private static long refinedUs(double speed, long mostSideUs) {
        return (long) Math.min(REFINED_PX / speed * 1e6, mostSideUs);
    }

    /** Greatest of the speeds at a knot, and so many µs before and after it, in px/s. */
    private double greatestSpeed(Motion knot, long sideUs) {
        at(knot.referenceUs - sideUs, before);
        at(knot.referenceUs + sideUs, after);
        return Math.max(knot.speed(radius), Math.max(before.speed(radius), after.speed(radius)));
    }

    /** Replaces the knots from one time to before another by better ones. */
    void replace(long fromUs, long untilUs, List<Motion> by) {
        int k = knotsUntil(fromUs - 1);
        knots.subList(k, knotsUntil(untilUs - 1)).clear();
        knots.addAll(k, by);
        mean.forget();
    }

    /** Whether its motion was ever measured. */
    boolean isMeasured() {
        return !knots.isEmpty();
    }

    /** Number of knots at a time or before. */
    private int knotsUntil(long us) {
        int low = 0;
        int high = knots.size();
        while (low < high) {
            int middle = (low + high) >>> 1;
            if (knots.get(middle).referenceUs <= us) {
                low = middle + 1;
            } else {
                high = middle;
            }
        }
        return low;
    }

    /** The mean motion in the middle of the block of time that contains a time. The next call changes the result. */
    Motion about(long us, long blockUs) {
        return mean.about(us, blockUs);
    }

    /** Speed of a motion of the segment with its rotation and growth, in px/s; not 0. */
    double speed(Motion motion) {
        return Math.max(motion.speed(radius), LEAST_PX_PER_S);
    }

    /** Time in which an event comes, in µs. */
    double perEventUs() {
        return perEventUs;
    }

    /** The motion at a time. */
    void at(long us, Motion to) {
        int k = knotsUntil(us);
        if (k == 0) {
            to.copyFrom(first());
            to.hold();
            to.moveReference(us);
            return;
        }
        if (k == knots.size()) {
            goOn(us, to);
            return;
        }
        Motion a = knots.get(k - 1);
        Motion b = knots.get(k);
        double seconds = (b.referenceUs - a.referenceUs) * 1e-6;
        // both motions about the same point of the structure
        to.copyFrom(b);
        to.moveCentre(a.centreX + a.vx * seconds, a.centreY + a.vy * seconds);
        double ax = (to.vx - a.vx) / seconds;
        double ay = (to.vy - a.vy) / seconds;
        deformation.copyFrom(to.deformation);
        to.copyFrom(a);
        to.hold();
        to.ax = ax;
        to.ay = ay;
        to.alpha = (b.omega - a.omega) / seconds;
        to.growthChange = (b.growth - a.growth) / seconds;
        to.moveReference(us);
        to.hold();
        double share = (us - a.referenceUs) * 1e-6 / seconds;
        to.deformation.multiply(1 - share);
        to.deformation.add(deformation, share);
    }

    /**
     * The motion at a time after the last measurement: it changes until the newest event, or until the segment may have
     * reversed, and is steady from then on.
     */
    private void goOn(long us, Motion to) {
        to.copyFrom(last());
        double turns = Math.hypot(to.alpha, to.growthChange) * radius;
        double perS = Math.hypot(Math.hypot(to.ax, to.ay), turns);
        double seconds = MOST_CHANGE * to.speed(radius) / Math.max(perS, 1e-9);
        long changesUntilUs = Math.min(newestUs, to.referenceUs + (long) (seconds * 1e6));
        to.moveReference(Math.min(us, changesUntilUs));
        to.hold();
        to.moveReference(us);
    }

    /**
     * The motion at a time, about that point of the structure which is the centre of another motion at its reference
     * time.
     */
    void at(long us, Motion of, Motion to) {
        long fromUs = us - of.referenceUs;
        at(us, to);
        to.moveCentre(of.centreX + of.vx * fromUs * 1e-6, of.centreY + of.vy * fromUs * 1e-6);
    }

    /** The motion at a time, with the mean change from a time before it to as long after it. */
    void bending(long us, long sideUs, Motion to) {
        at(us, to);
        at(us - sideUs, to, before);
        at(us + sideUs, to, after);
        to.ax = (after.vx - before.vx) / (2e-6 * sideUs);
        to.ay = (after.vy - before.vy) / (2e-6 * sideUs);
        to.alpha = (after.omega - before.omega) / (2e-6 * sideUs);
        to.growthChange = (after.growth - before.growth) / (2e-6 * sideUs);
    }
}
