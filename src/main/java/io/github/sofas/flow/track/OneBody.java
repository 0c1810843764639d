package io.github.sofas.flow.track;

import io.github.sofas.flow.fit.MetricFit;
import io.github.sofas.flow.motion.Motion;
import io.github.sofas.flow.motion.SteppedProjection;

/**
 * Whether two structures are parts of one body that turns or grows, though neither shows it by itself: whether the
 * events of both meet at least as often along one motion with rotation and growth as each along its own velocity.
 *
 * <p>Ours, because the ends of what turns or grows are found at two velocities, and a round or straight end shows
 * neither rotation nor growth. Some rotation and growth explain any two velocities, but two bodies that do neither lose
 * by them. The reverse of {@link TwoBodies}.
 */
final class OneBody {
    /** What one motion gains where it cannot be told, or clearly loses. */
    static final double NOTHING = Double.NEGATIVE_INFINITY;

    /** Fewest live events of either part. */
    private static final int LEAST_EVENTS = 50;
    /** Shift of the ends of the window by rotation and growth, in px, below which two bodies would lose too little. */
    private static final double LEAST_TURN_PX = 0.7;
    /** Turn in rad, or growth as a share, over half the window, above which the parts lie too near. */
    private static final double MOST_TURN = 0.5;
    /** Share of the metric of both that the motion has which their velocities ask for: most two bodies have less. */
    private static final double LEAST_SHARE = 0.8;
    /** How often that motion is improved. */
    private static final int ROUNDS = 2;
    /** Events are projected in steps of this part of a pixel. */
    private static final double STEP_PX = 1.0 / 32;

    private final Motion motion = new Motion();
    private final SteppedProjection stepped = new SteppedProjection();
    private final OwnVelocity own = new OwnVelocity();

    /** A part with its motion in the middle of the window. */
    private static final class Part {
        private final Motion motion = new Motion();
        private LiveEvents live;

        void take(LiveEvents events, Motion its) {
            live = events;
            motion.copyFrom(its);
        }
    }

    private final Part one = new Part();
    private final Part other = new Part();
    // the window that both have in common: its beginning, and half of it in s
    private long fromUs;
    private double half;
    /** Distance of the parts' centres, and the greatest of an event from the middle, in px. */
    private double apart;
    private double reach;

    /**
     * Asks it of two structures, of all tiles.
     *
     * @param radius of the larger structure in px
     * @return what the metric of their events gains by one motion, in standard deviations, or {@link #NOTHING}
     */
    double sigmasGained(LiveEvents ones, Motion ofOne, LiveEvents others, Motion ofOther, double radius,
                        MetricFit fit) {
        if (Math.min(ones.size(), others.size()) < LEAST_EVENTS || ones.size() + others.size() > fit.capacity()) {
            return NOTHING;
        }
        one.take(ones, ofOne);
        other.take(others, ofOther);
        begin(radius);
        if (!isTold()) {
            return NOTHING;
        }
        double separately = separately(fit);
        together(fit);
        if (fit.size() < 2 * LEAST_EVENTS || fit.metric() < LEAST_SHARE * separately) {
            return NOTHING;
        }
        for (int round = 0; round < ROUNDS; round++) {
            improve(motion, fit);
            together(fit);
            fit.stepTurnAndGrowth(motion, 2 / (half * reach));
            if (!isTold()) {
                return NOTHING;
            }
            together(fit);
        }
        double metric = fit.metric();
        improve(one, fit);
        improve(other, fit);
        return (metric - separately(fit)) / MetricFit.sd(metric);
    }

    /** The motion of both as one body, in the middle of the window that they had in common when they were asked. */
    Motion motion() {
        return motion;
    }

    /** Begins with the rotation and the growth that the two velocities ask for. */
    private void begin(double radius) {
        fromUs = Math.max(one.live.oldestUs(), other.live.oldestUs());
        half = (Math.max(one.live.newestUs(), other.live.newestUs()) - fromUs) * 0.5e-6;
        long middleUs = fromUs + Math.round(half * 1e6);
        Motion first = one.motion;
        Motion second = other.motion;
        first.moveReference(middleUs);
        second.moveReference(middleUs);
        double share = (double) other.live.size() / (one.live.size() + other.live.size());
        motion.set(middleUs, mean(first.vx, second.vx, share), mean(first.vy, second.vy, share));
        motion.ax = mean(first.ax, second.ax, share);
        motion.ay = mean(first.ay, second.ay, share);
        motion.centreX = mean(first.centreX, second.centreX, share);
        motion.centreY = mean(first.centreY, second.centreY, share);
        double x = second.centreX - first.centreX;
        double y = second.centreY - first.centreY;
        double square = x * x + y * y;
        apart = Math.sqrt(square);
        reach = apart + radius;
        if (square > 0) {
            double vx = second.vx - first.vx;
            double vy = second.vy - first.vy;
            motion.omega = (x * vy - y * vx) / square;
            motion.growth = (x * vx + y * vy) / square;
        }
    }

    private static double mean(double a, double b, double shareOfB) {
        return a + shareOfB * (b - a);
    }

    /** Whether rotation and growth shift the ends of the window, at the centres of the parts, by enough to be told. */
    private boolean isTold() {
        double turn = Math.hypot(motion.omega, motion.growth) * half;
        return turn * apart / 2 >= LEAST_TURN_PX && turn <= MOST_TURN;
    }

    /** Loads the events of both along the one motion. */
    private void together(MetricFit fit) {
        fit.clear();
        add(one.live, motion, fit);
        add(other.live, motion, fit);
    }

    /** Metric of the events of both, each along its own motion. */
    private double separately(MetricFit fit) {
        fit.clear();
        add(one.live, one.motion, fit);
        add(other.live, other.motion, fit);
        return fit.metric();
    }

    /** Improves the velocity of a part by its own events. */
    private void improve(Part part, MetricFit fit) {
        fit.clear();
        add(part.live, part.motion, fit);
        improve(part.motion, fit);
    }

    /** Takes a motion to the velocity by which the loaded events meet most often. */
    private void improve(Motion along, MetricFit fit) {
        own.begin(fit, half);
        own.goOn(fit, half);
        along.vx += own.vx();
        along.vy += own.vy();
    }

    /** Adds the events that a part alone claims. */
    private void add(LiveEvents live, Motion along, MetricFit fit) {
        stepped.begin(along, along.referenceUs - fromUs, 2 * reach, STEP_PX);
        for (int k = 0; k < live.size(); k++) {
            int i = live.index(k);
            if (live.claim(i) == Claim.OWN && live.timeUs[i] >= fromUs) {
                stepped.advance(live.timeUs[i]);
                fit.add(along, stepped.x(live.x[i], live.y[i]), stepped.y(live.x[i], live.y[i]),
                    (live.timeUs[i] - along.referenceUs) * 1e-6, live.sign[i]);
            }
        }
    }
}
