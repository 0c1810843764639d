package io.github.sofas.flow.track;

import io.github.sofas.flow.SofasParameters;
import io.github.sofas.flow.fit.MetricFit;
import io.github.sofas.flow.fit.MotionChange;
import io.github.sofas.flow.fit.MotionLoss;
import io.github.sofas.flow.fit.VelocityTop;
import io.github.sofas.flow.motion.Motion;
import io.github.sofas.flow.motion.SteppedProjection;

/**
 * Measures the motion of a structure again and again from its live events (paper, section Track Plane: the best of
 * 3 x 3 projections becomes the centre). It also keeps how well the motion is known, and over how much travel it is to
 * be measured.
 *
 * <p>A measurement projects a sample of the live events to the middle of their window. It fits the velocity, and then
 * how the motion changes ({@link MotionChange}).
 */
final class Measurement {
    /** Fewest events that a motion is measured from. */
    static final int LEAST_EVENTS = 12;
    /** Most events that are measured at once. */
    static final int MOST_EVENTS = 1 << 14;
    /**
     * Measurements that evaluate all nine projections: so many at first, and one in so many later, to follow a
     * structure that turns.
     */
    private static final int LEAST_FULL = 3;
    private static final int FULL_EVERY = 4;
    /**
     * Length of the lifetime, in shortest lifetimes, from which on a motion has been steady for so long that slopes
     * suffice. Projections follow a structure that reverses better: a head in 20 of 21 runs, against 15 to 18 with
     * slopes from the start.
     */
    private static final double STEADY_LIFETIMES = 1.5;
    /** Correction over half the window, in px, after which the top may lie beyond the reach of the slopes. */
    private static final double RESTLESS_PX = 0.5;
    /**
     * First measurements of a structure, in which it may be coming in over the border. If the border cuts it off, these
     * give more weight to what is in sight for a part of the window only. If all measurements did, a rectangle that
     * turns at up to 20 rad/s would be 2 % less sharp.
     */
    private static final int COMING_IN = 40;
    /** Measurements after which a motion is judged: before them, it is still that of the search. */
    private static final int LEAST_JUDGED = 2;
    /** Step, in px, by which events are projected for a measurement: finer than the resolution of positions. */
    private static final double STEP_PX = 1.0 / 32;

    /** Standard deviations of the metric from which on a correction or an acceleration is not noise. Noise has 0.5. */
    private static final double CLEAR_SIGMAS = 0.9;
    /**
     * Share of events that two planes claim above which no change of motion is measured: the planes pull at each other.
     */
    private static final double MAX_SHARED = 0.15;
    /**
     * Share of the metric per px that a direction must lose for the motion to follow half of the fitted step in it.
     * Along a direction that loses less, and so is known weakly, the motion follows more slowly.
     */
    private static final double STIFFNESS = 0.002;
    /**
     * Share of the velocity along a straight edge that each measurement drops. Nothing measures that component, so it
     * would drift otherwise.
     */
    private static final double FLAT_DECAY = 0.05;
    /**
     * Least share of the metric that a shift of both ends of the window by a pixel costs where there is a structure.
     * Structures lose 0.1 to 0.5, noise and the remains of several structures 0.02.
     */
    private static final double LEAST_SHARPNESS = 0.03;
    /** Travel without such sharpness, in px, after which there is no structure. */
    private static final double BLURRED_PX = 5;

    private final SteppedProjection stepped = new SteppedProjection();
    private final Motion mid = new Motion();
    private final MotionChange change = new MotionChange();
    private final Turn turn = new Turn();
    private final MotionLoss loss = new MotionLoss();
    private final Prediction prediction = new Prediction();
    private final MeasuredTravel travel;
    private final Sample sample = new Sample();
    private SofasParameters.Track p;
    private int count;
    /** Factor by which the frame is wider after a step that left it. */
    private double widen;
    /** Whether the last measurement moved the motion far. */
    private boolean restless;
    /** Whether the border cuts off a part of the events that were loaded last. */
    private boolean isCutOff;
    /** Travel for which the live events have not been sharp, in px. */
    private double blurredPx;
    private long measuredUs;

    Measurement(SofasParameters.Track p) {
        this.p = p;
        travel = new MeasuredTravel(p);
    }

    /** Begins with a structure of which only a first velocity is known. */
    void restart() {
        change.restart();
        loss.clear();
        prediction.restart();
        count = 0;
        sample.restart();
        blurredPx = 0;
        measuredUs = 0;
        widen = 1;
        restless = false;
        travel.restart();
    }

    /** Continues with other parameters. */
    void setParameters(SofasParameters.Track next) {
        p = next;
        travel.setParameters(next);
    }

    /** Travel that the motion is measured over, in px. */
    double lifetimePx() {
        return travel.px();
    }

    /** Whether the structure is so new that it may be coming in over the border. */
    boolean mayComeIn() {
        return count < COMING_IN;
    }

    /** Whether the live events are sharp along the motion, as those of one structure are. */
    boolean isSharp() {
        return blurredPx == 0;
    }

    /**
     * Whether the live events have been blurred, or have contradicted the motion, for so long that there is no
     * structure, or none that moves like this.
     */
    boolean isBlurred() {
        return blurredPx > BLURRED_PX || prediction.isRefuted();
    }

    /** Whether the motion predicts the live events. */
    boolean isPredictive() {
        return prediction.holds();
    }

    /** What is known of the motion. */
    MotionLoss loss() {
        return loss;
    }

    /** New events that are needed until the motion is measured again. */
    int newsNeeded(int liveEvents) {
        return sample.newsNeeded(liveEvents, change.isKnownAlike());
    }

    /** Holds the motion where it cannot be measured. */
    void hold(Motion motion) {
        change.hold(motion);
    }

    /** Takes a structure that turns for one body, whose rotation need not show within its parts. */
    void believeTurning() {
        change.believeTurning();
    }

    /**
     * Takes a structure that turns and grows for one body, whose rotation and growth need not show within its parts.
     */
    void believeAll() {
        change.believeAll();
    }

    /** Gives a motion the rotation and growth that it has if the structure is one body. */
    void applyOfAll(Motion motion) {
        change.applyOfAll(motion);
    }

    /** Takes the structure for one body only as far as rotation and growth show within its parts. */
    void doubtBody() {
        change.doubtBody();
    }

    /** Continues with a structure that only turns from now on, as it did. */
    void turnInPlace() {
        change.turnInPlace();
        prediction.restart();
        blurredPx = 0;
    }

    /** Continues with the motion that this structure has in common with another, which was not measured. */
    void takeCommon() {
        change.take();
    }

    /**
     * Measures a motion. Its reference becomes the middle of the window of the live events.
     *
     * @param lifetimeUs time in which the structure travels the lifetime
     */
    void measure(Motion motion, LiveEvents live, double radius, MetricFit fit, long lifetimeUs, long nowUs) {
        long windowUs = nowUs - live.oldestUs();
        double half = windowUs * 0.5e-6;
        motion.moveReference(live.oldestUs() + windowUs / 2);
        change.begin(motion);
        int shared = load(motion, live, radius, fit);
        if (fit.size() >= LEAST_EVENTS) {
            if (isCutOff) {
                fit.cutOff(motion.vx, motion.vy, half);
            }
            improve(motion, live, half, radius, fit, (double) shared / (shared + fit.size()));
            followSharpness(half, lifetimeUs, nowUs);
        }
    }

    /**
     * Judges whether the motion predicts the live events.
     *
     * @param wasMeasured whether the motion was measured from these events just now; else it was held
     */
    void judge(boolean wasMeasured, Motion motion, LiveEvents live, double radius, MetricFit fit, long nowUs) {
        if (count < LEAST_JUDGED || wasMeasured && prediction.isSure(nowUs)) {
            return;
        }
        double along = wasMeasured && !isCutOff && fit.size() >= LEAST_EVENTS ? loss.metric : 0;
        loadAtRest(motion, live, fit);
        if (fit.size() < LEAST_EVENTS) {
            // hidden events do not contradict the motion
            return;
        }
        double atRest = fit.metric();
        if (along <= Math.max(0, atRest)) {
            // along the motion as it is now, which the measurement has improved; a metric of 0 is not known yet
            load(motion, live, radius, fit);
            along = Math.max(along, fit.metric());
        }
        prediction.judge(along, atRest, fit.size(), motion.speed(radius), nowUs - live.oldestUs(), nowUs);
    }

    /**
     * Fits the velocity: by all nine projections, by the slopes of a steady motion, or by the five nearest projections.
     */
    private VelocityTop fitVelocity(boolean isSteady, double px, double radius, MetricFit fit) {
        if (count < LEAST_FULL || count % FULL_EVERY == 0 && (!isSteady || fit.isBroad(px))) {
            return fit.fit(0, 0, MetricFit.FLAT_SIGMAS);
        }
        return isSteady ? fit.fitSlopes(px, MetricFit.FLAT_SIGMAS, change.planeRadius(fit.size(), radius, p))
            : fit.fitCross(0, 0, MetricFit.FLAT_SIGMAS);
    }

    /** Notes how far the structure has travelled without being sharp. */
    private void followSharpness(double half, long lifetimeUs, long nowUs) {
        boolean sharp = loss.best() >= LEAST_SHARPNESS * loss.metric * half * half;
        double travelledPx = measuredUs == 0 ? 0 : travel.px() * (nowUs - measuredUs) / Math.max(1, lifetimeUs);
        blurredPx = sharp ? 0 : blurredPx + Math.max(travelledPx, Double.MIN_VALUE);
        measuredUs = nowUs;
    }

    /** Metric of the live events along a motion, projected to the middle of their window. */
    double metric(Motion motion, LiveEvents live, double radius, MetricFit fit, long nowUs) {
        mid.copyFrom(motion);
        mid.moveReference(live.oldestUs() + (nowUs - live.oldestUs()) / 2);
        load(mid, live, radius, fit);
        return fit.metric();
    }

    /**
     * Projects a sample of the live events to the motion's reference. Where the motion reversed within the window,
     * events from before the turn count with the polarity that their edges fire now, if this makes the whole sample
     * sharper. If it does not, the turn is not known yet.
     *
     * @return number of events in the sample that are shared
     */
    private int load(Motion motion, LiveEvents live, double radius, MetricFit fit) {
        int shared = load(motion, live, radius, fit, false);
        turn.take(motion, live.newestUs());
        if (turn.isAfter(live.oldestUs())) {
            double metric = fit.metric();
            load(motion, live, radius, fit, true);
            if (fit.metric() < metric) {
                load(motion, live, radius, fit, false);
            }
        }
        return shared;
    }

    private int load(Motion motion, LiveEvents live, double radius, MetricFit fit, boolean turned) {
        fit.clear();
        int want = sample.size(live.size(), change.isKnownAlike());
        int shared = 0;
        isCutOff = false;
        // the border cuts off little of a structure that is measured on a part of its events
        boolean mayBeCutOff = mayComeIn() && want == live.size() && live.thinning() == 1;
        stepped.begin(motion, motion.referenceUs - live.oldestUs(), 2 * radius, STEP_PX);
        for (int k = 0; k < want; k++) {
            int i = live.index(Sample.number(k, want, live.size()));
            Claim claim = live.claim(i);
            if (claim != Claim.OWN) {
                shared += claim == Claim.SHARED ? 1 : 0;
                continue;
            }
            stepped.advance(live.timeUs[i]);
            fit.add(motion, stepped.x(live.x[i], live.y[i]), stepped.y(live.x[i], live.y[i]),
                (live.timeUs[i] - motion.referenceUs) * 1e-6,
                turned ? turn.polarity(live.timeUs[i], live.sign[i]) : live.sign[i]);
            isCutOff |= mayBeCutOff && fit.isAtBorder(live.x[i], live.y[i]);
        }
        return shared;
    }

    /** Loads the same events where they are, as if at rest. */
    private void loadAtRest(Motion motion, LiveEvents live, MetricFit fit) {
        fit.clear();
        int want = sample.size(live.size(), change.isKnownAlike());
        for (int k = 0; k < want; k++) {
            int i = live.index(Sample.number(k, want, live.size()));
            if (live.claim(i) == Claim.OWN) {
                fit.add(live.x[i], live.y[i], (live.timeUs[i] - motion.referenceUs) * 1e-6f, 0, 0, live.sign[i]);
            }
        }
    }

    private void improve(Motion motion, LiveEvents live, double half, double radius, MetricFit fit, double crossing) {
        double px = 1 / half; // velocity that shifts both ends of the window by one pixel
        if (count == 0) {
            fit.frame(px);
        } else {
            fit.frame(loss.metric, loss.xx, loss.xy, loss.yy, MetricFit.neighbourLoss(loss.metric), px);
            fit.widen(widen);
        }
        boolean isSteady = travel.px() > STEADY_LIFETIMES * p.lifetimePx() && !restless;
        VelocityTop top = fitVelocity(isSteady, px, radius, fit);
        sample.meets(top.metric(), fit.size(), live.size());
        loss.take(top);
        widen = top.steps() > 1 ? Math.min(3, widen * 1.5) : Math.max(1, widen * 0.7);
        double moved = step(motion, top, px, crossing) / px;
        restless = moved > RESTLESS_PX;
        boolean moves = top.slopeSigmas() > CLEAR_SIGMAS;
        if (crossing > MAX_SHARED) {
            change.hold(motion);
        } else if (count >= 2 && moved < 1) {
            change.measure(fit, motion, loss, half, radius, live.commonPolarity() != 0, p);
            travel.adapt(moves ? moved : 0, change.bendSigmas() > CLEAR_SIGMAS ? change.bendPx(half) : 0,
                change.isClear() ? travel.mostPxOfClear(motion, half, radius) : travel.mostPx());
        }
        if (moves) {
            travel.shrinkIfCorrected(moved);
        }
        count++;
    }

    /**
     * Takes the step of the fit, multiplied by (L + S)^-1 L. L is the loss and S a stiffness that is equal in all
     * directions, so that the motion moves slowly along directions that are known weakly. Along a straight edge, where
     * nothing is known, the velocity returns towards the normal flow.
     *
     * @return length of the step in px/s
     */
    private double step(Motion motion, VelocityTop top, double px, double crossing) {
        double stepX = top.stepX();
        double stepY = top.stepY();
        if (count > 0) {
            double stiff = STIFFNESS * (1 + 10 * crossing) * loss.metric / (px * px);
            double xx = loss.xx + stiff;
            double yy = loss.yy + stiff;
            double det = xx * yy - loss.xy * loss.xy;
            double rx = loss.xx * stepX + loss.xy * stepY;
            double ry = loss.xy * stepX + loss.yy * stepY;
            stepX = det > 0 ? (yy * rx - loss.xy * ry) / det : 0;
            stepY = det > 0 ? (xx * ry - loss.xy * rx) / det : 0;
        }
        motion.vx += stepX;
        motion.vy += stepY;
        if (top.isFlat()) {
            double along = (motion.vy * loss.axisX - motion.vx * loss.axisY) * FLAT_DECAY;
            motion.vx += along * loss.axisY;
            motion.vy -= along * loss.axisX;
        }
        return Math.sqrt(stepX * stepX + stepY * stepY);
    }
}
