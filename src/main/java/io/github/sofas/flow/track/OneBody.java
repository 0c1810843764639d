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
 *
 * <p>The straight or round sides of what comes near lose nothing by velocities of their own. But they all cover what is
 * behind them, so that they give events of one polarity, and go apart; of what goes away they uncover it, and go
 * together. Bodies that move on give events of either polarity, because they uncover behind them what they cover.
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
    /** Fewest live events of either part of what grows or shrinks. */
    private static final int LEAST_GROWING_EVENTS = 100;
    /** Growths that it is started with, of that which the two velocities ask for. */
    private static final double[] GROWING_SHARES = {1, 0.8, 0.64, 0.5};
    /** Standard deviations that it may lose by one motion: its sides, straight or round, gain nothing. */
    private static final double MOST_LOST_SIGMAS = 2;
    /** Velocity at which its parts go apart at least, of that at which they go on. */
    private static final double LEAST_SPREAD = 0.5;
    /** Growth per s that is too fast to be one body's: what grows so is 0.4 s before the camera. */
    private static final double MOST_GROWTH_PER_S = 2.5;
    /** How often that motion is improved. */
    private static final int ROUNDS = 2;
    /** Events are projected in steps of this part of a pixel. */
    private static final double STEP_PX = 1.0 / 32;

    private final Motion motion = new Motion();
    private final Motion best = new Motion();
    private final SteppedProjection stepped = new SteppedProjection();
    private final OwnVelocity own = new OwnVelocity();

    /** A part, and its motion in the middle of the window, as it is asked about. */
    private static final class Part {
        private final Motion motion = new Motion();
        private LiveEvents live;
        private Motion its;
    }

    private final Part one = new Part();
    private final Part other = new Part();
    /** Of the larger one, in px. */
    private double radius;
    // the window that both have in common: its beginning, and half of it in s
    private long fromUs;
    private double half;
    /** Distance of the parts' centres, and the greatest of an event from the middle, in px. */
    private double apart;
    private double reach;

    /**
     * Takes two structures, of all tiles, to ask it of.
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

    /** What the metric of their events gains by one motion, in standard deviations, or {@link #NOTHING}. */
    double sigmasGained(MetricFit fit) {
        if (!begin(LEAST_EVENTS, fit) || !isTold()) {
            return NOTHING;
        }
        double separately = separately(fit);
        together(fit);
        return isWorse(separately, fit) ? NOTHING : gained(true, fit);
    }

    /**
     * Whether two structures that give events of the same polarity grow or shrink as one body: their events meet as
     * often along one motion that does not turn, and the two go apart, or together, at half of its velocity or more.
     */
    boolean growsOrShrinks(MetricFit fit) {
        if (!begin(LEAST_GROWING_EVENTS, fit)) {
            return false;
        }
        motion.omega = 0;
        if (!isTold()) {
            return false;
        }
        double separately = separately(fit);
        startGrowing(fit);
        return !isWorse(separately, fit) && gained(false, fit) > -MOST_LOST_SIGMAS
            && Math.abs(motion.growth) < MOST_GROWTH_PER_S
            && Math.abs(motion.growth) * apart > LEAST_SPREAD * Math.hypot(motion.vx, motion.vy);
    }

    /**
     * Starts with the growth that is best of those that the two velocities may ask for. That of a corner, which its two
     * edges show, is that of its tip, farther out than its middle.
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

    /** Whether the events that are loaded along the one motion are too few, or meet much less often by it. */
    private boolean isWorse(double separately, MetricFit fit) {
        return fit.size() < 2 * LEAST_EVENTS || fit.metric() < LEAST_SHARE * separately;
    }

    /**
     * What the metric gains by the one motion, once that and the velocities of both are improved.
     *
     * @param turns whether it may turn
     * @param fit has the events of both along it
     */
    private double gained(boolean turns, MetricFit fit) {
        for (int round = 0; round < ROUNDS; round++) {
            improve(motion, fit);
            together(fit);
            double perPx = 2 / (half * reach);
            if (turns) {
                fit.stepTurnAndGrowth(motion, perPx);
            } else {
                fit.stepGrowth(motion, perPx);
            }
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

    /**
     * Begins with the rotation and the growth that the two velocities ask for; returns whether there are events enough,
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
