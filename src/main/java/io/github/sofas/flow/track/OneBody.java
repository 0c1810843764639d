package io.github.sofas.flow.track;

import io.github.sofas.flow.fit.MetricFit;
import io.github.sofas.flow.motion.Motion;
import io.github.sofas.flow.motion.SteppedProjection;

/**
 * Whether two structures are parts of one body that turns or grows, though neither shows this by itself. They are if
 * the events of both meet at least as often along one motion with rotation and growth as along the separate velocity of
 * each.
 *
 * <p>Ours, because the ends of a body that turns or grows are found at two velocities, and a round or straight end
 * shows neither rotation nor growth. Some rotation and growth explain any two velocities, but two bodies that neither
 * turn nor grow lose metric by them. {@link TwoBodies} is the reverse.
 *
 * <p>The straight or round sides of a body that comes near lose nothing by velocities of their own. But all of them
 * cover the background, so they give events of one polarity, and they go apart. The sides of a body that goes away
 * uncover the background, and go together. Bodies that move on give events of either polarity, because they uncover
 * behind them what they cover.
 */
final class OneBody {
    /** Gain of one motion that cannot be determined, or that clearly loses. */
    static final double NOTHING = Double.NEGATIVE_INFINITY;

    /** Fewest live events of either part. */
    private static final int LEAST_EVENTS = 50;
    /** Shift of the ends of the window by rotation and growth, in px, below which two bodies would lose too little. */
    private static final double LEAST_TURN_PX = 0.7;
    /** Turn in rad, or growth as a share, over half the window, above which the parts lie too near to each other. */
    private static final double MOST_TURN = 0.5;
    /**
     * Least metric along the motion that the two velocities ask for, as a share of the metric along these velocities.
     * Most pairs of bodies have less.
     */
    private static final double LEAST_SHARE = 0.8;
    /** Standard deviations that the common motion may lose each time that it was improved: two bodies lose more. */
    private static final double HOPELESS_SIGMAS = 8;
    /** Fewest live events of either part of a body that grows or shrinks. */
    private static final int LEAST_GROWING_EVENTS = 100;
    /** Growths to start with, as shares of the growth that the two velocities ask for. */
    private static final double[] GROWING_SHARES = {1, 0.8, 0.64, 0.5};
    /** Standard deviations that a growing body may lose by one motion: its sides, straight or round, gain nothing. */
    private static final double MOST_LOST_SIGMAS = 2;
    /** Least velocity at which the parts go apart, as a share of the velocity at which the body moves on. */
    private static final double LEAST_SPREAD = 0.5;
    /** Growth per s that is too fast for one body, which would be 0.4 s before the camera. */
    private static final double MOST_GROWTH_PER_S = 2.5;
    /** How often the common motion is improved. */
    private static final int ROUNDS = 2;
    /** Step, in px, by which events are projected. */
    private static final double STEP_PX = 1.0 / 32;

    private final Motion motion = new Motion();
    private final Motion best = new Motion();
    private final SteppedProjection stepped = new SteppedProjection();
    private final OwnVelocity own = new OwnVelocity();

    /** One of the two parts, and its motion in the middle of the window, as it is asked about. */
    private static final class Part {
        private final Motion motion = new Motion();
        private LiveEvents live;
        private Motion its;
    }

    private final Part one = new Part();
    private final Part other = new Part();
    /** Radius of the larger structure, in px. */
    private double radius;
    // the window that both parts have in common: its beginning, and half its length in s
    private long fromUs;
    private double half;
    /** Distance between the centres of the parts, and greatest distance of an event from the middle, in px. */
    private double apart;
    private double reach;

    /**
     * Takes the two structures to ask about, with the events of all of their tiles.
     *
     * @param radiusPx of the larger structure
     */
    void take(LiveEvents ones, Motion ofOne, LiveEvents others, Motion ofOther, double radiusPx) {
        one.live = ones;
        one.its = ofOne;
        other.live = others;
        other.its = ofOther;
        radius = radiusPx;
    }

    /** Gain of the metric of their events by one motion, in standard deviations, or {@link #NOTHING}. */
    double sigmasGained(MetricFit fit) {
        if (!begin(LEAST_EVENTS, fit) || !showsTurning()) {
            return NOTHING;
        }
        double separately = separately(fit);
        together(fit);
        return isWorse(separately, fit) ? NOTHING : gained(true, separately, fit);
    }

    /**
     * Whether two structures that give events of the same polarity grow or shrink as one body. If so, their events meet
     * as often along one motion that does not turn, and the two go apart, or together, at half of its velocity or more.
     */
    boolean growsOrShrinks(MetricFit fit) {
        if (!begin(LEAST_GROWING_EVENTS, fit)) {
            return false;
        }
        motion.omega = 0;
        if (!showsTurning()) {
            return false;
        }
        double separately = separately(fit);
        startGrowing(fit);
        return !isWorse(separately, fit) && gained(false, separately, fit) > -MOST_LOST_SIGMAS
            && Math.abs(motion.growth) < MOST_GROWTH_PER_S
            && Math.abs(motion.growth) * apart > LEAST_SPREAD * Math.hypot(motion.vx, motion.vy);
    }

    /**
     * Starts with the best of the growths that the two velocities may ask for. The growth that the two edges of a
     * corner show is that of its tip, which lies farther out than its middle.
     */
    private void startGrowing(MetricFit fit) {
        double vx = motion.vx;
        double vy = motion.vy;
        double asked = motion.growth;
        double most = Double.NEGATIVE_INFINITY;
        for (double share : GROWING_SHARES) {
            motion.vx = vx;
            motion.vy = vy;
            motion.growth = share * asked;
            together(fit);
            improve(motion, fit);
            together(fit);
            if (fit.metric() > most) {
                most = fit.metric();
                best.copyFrom(motion);
            }
        }
        motion.copyFrom(best);
        together(fit);
    }

    /** Whether the events that are loaded along the one motion are too few, or meet much less often along it. */
    private boolean isWorse(double separately, MetricFit fit) {
        return fit.size() < 2 * LEAST_EVENTS || fit.metric() < LEAST_SHARE * separately;
    }

    /**
     * Gain of the metric by the one motion, in standard deviations, once that motion and the velocities of both parts
     * have been improved; {@link #NOTHING} as soon as the motion proves hopeless.
     *
     * @param turns whether the motion may turn
     * @param before metric along the velocities of both parts before these are improved
     * @param fit holds the events of both along it
     */
    private double gained(boolean turns, double before, MetricFit fit) {
        for (int round = 0; round < ROUNDS; round++) {
            improve(motion, fit);
            together(fit);
            double perPx = 2 / (half * reach);
            if (turns) {
                fit.stepTurnAndGrowth(motion, perPx);
            } else {
                fit.stepGrowth(motion, perPx);
            }
            if (!showsTurning()) {
                return NOTHING;
            }
            together(fit);
            if (fit.metric() < before - HOPELESS_SIGMAS * MetricFit.sd(before)) {
                return NOTHING;
            }
        }
        double metric = fit.metric();
        improve(one, fit);
        improve(other, fit);
        return (metric - separately(fit)) / MetricFit.sd(metric);
    }

    /**
     * The motion of both as one body, in the middle of the window that they had in common when they were asked about.
     */
    Motion motion() {
        return motion;
    }

    /**
     * Begins with the rotation and the growth that the two velocities ask for. Returns whether there are enough events,
     * and not more than can be measured.
     */
    private boolean begin(int leastEvents, MetricFit fit) {
        if (Math.min(one.live.size(), other.live.size()) < leastEvents
                || one.live.size() + other.live.size() > fit.capacity()) {
            return false;
        }
        one.motion.copyFrom(one.its);
        other.motion.copyFrom(other.its);
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
        return true;
    }

    private static double mean(double a, double b, double shareOfB) {
        return a + shareOfB * (b - a);
    }

    /**
     * Whether rotation and growth shift the ends of the window, at the centres of the parts, by enough to show, and are
     * not too much to be measured.
     */
    private boolean showsTurning() {
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

    /** Takes a motion to the velocity along which the loaded events meet most often. */
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
