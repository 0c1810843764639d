package io.github.sofas.flow.fit;

import io.github.sofas.flow.SofasParameters;
import io.github.sofas.flow.motion.Motion;

/**
 * How the motion of a structure differs from one constant velocity: acceleration ({@link AccelerationFit}), rotation,
 * its change, and growth. Each is measured separately ({@link ChangeFit}), and believed as far as it exceeds what noise
 * could be ({@link Belief}). Rotation and growth of a large structure are measured with its deformation
 * ({@link PlaneChange}), and its motion is tracked from window to window ({@link MotionTracker}). Ours, because a
 * velocity that is that of the middle of the window lags: by 25 of a pendulum's 380 px/s.
 */
public final class MotionChange {
    /**
     * Shift of the end of the window, in px, by a new change of the rotation at which half of what {@link #CHANGE_GAIN}
     * leaves is adopted at once, too.
     */
    private static final double NEWS_PX = 1;
    /** Part of new evidence that is adopted with each measurement. */
    private static final double EVIDENCE_GAIN = 0.3;
    /** Evidence that makes rotation and growth sure, and the lack of it that leaves half of them. */
    private static final double SURE_SIGMAS = 0.2;
    private static final double HALF_SURE_SIGMAS = 0.14;
    /** Evidence beyond doubt, and the number of measurements per check of it from then on. */
    private static final double EVIDENT_SIGMAS = 1;
    private static final int EVIDENT_EVERY = 4;
    /**
     * Shift at the end of the window, in px, by rotation or growth below which neither shows within parts of the
     * structure.
     */
    private static final double LEAST_SHOWN_PX = 0.03;
    /** Gain of the metric by a rotation or growth, in standard deviations, at which half of it is believed. */
    private static final double GAIN_SIGMAS = 0.2;
    /** The same for a growth that is not evident: with a velocity, it also explains more of what is not one body. */
    private static final double NEW_GROWTH_SIGMAS = 2;
    /**
     * Belief in a rotation, 0 to 1, below which its change is taken as none: little of a measured change would be left.
     */
    private static final double LEAST_SPINNING = 0.1;
    /** Number of measurements per look at how alike the parameters of the motion are. */
    private static final int STRUCTURE_EVERY = 4;
    /** Share of a newly measured change that is adopted: successive windows share most of their events. */
    private static final double CHANGE_GAIN = 0.5;
    /**
     * Shift at the end of the window, in px, by rotation, growth and their changes that may be noise: most structures
     * neither turn nor grow.
     */
    private static final double TURN_PX = 0.03;
    /**
     * Measurements for which a new structure settles. Until then, a larger shift counts as noise: corrections of the
     * first velocity look like changes of motion, and changes that are believed too early oscillate.
     */
    private static final int SETTLING = 40;
    private static final double SETTLING_TURN_PX = 0.05;
    /** What a single event would add to that noise, in px; several events add that divided by their number. */
    private static final double EVENT_TURN_PX = 60;
    /** Share of a change that is kept at each measurement that cannot be made. */
    private static final double HELD = 0.8;
    /**
     * Knowledge of the second axis, as a share of that of the best known one, from which a plane is clear, and is
     * tracked.
     */
    private static final double CLEAR = 0.35;
    /** Smallest radius of a structure, in px, for which rotation and growth are measured. */
    private static final double LEAST_RADIUS_PX = 1;

    /** The measured change of the rotation, before possible noise is removed. */
    private double alpha;
    private final AccelerationFit acceleration = new AccelerationFit();
    private final SeriesSlope growthSlope = new SeriesSlope();
    private final StructureTensor structure = new StructureTensor();
    private final PlaneChange plane = new PlaneChange();
    private final MotionTracker tracker = new MotionTracker();
    private final PathPull pull = new PathPull();
    private final GrowthFit growthFit = new GrowthFit();
    private int measurements;
    private boolean isClear;
    /** How clearly rotation and growth recently showed within parts of the structure, in standard deviations. */
    private double evidence;
    /** Whether the structure is known to turn as one body, and to grow as one, whatever shows within parts of it. */
    private boolean turnsAsOne;
    private boolean growsAsOne;
    /**
     * Whether the structure is assumed to approach or recede at a steady speed in depth, apart from what events show
     * beyond.
     */
    private boolean isSteadyInDepth;
    /** Rotation and growth that the whole structure shows if it is one body. */
    private double ofAllOmega;
    private double ofAllGrowth;
    /** Radius of the structure when it was measured last, in px. */
    private double radius;
    /** Shift at the end of the window, in px, that may be noise with the number of measured events. */
    private double turnNoisePx;

    /** Begins with a steady motion. */
    public void restart() {
        alpha = 0;
        acceleration.restart();
        tracker.stop();
        isClear = false;
        growthSlope.restart();
        evidence = 0;
        ofAllOmega = 0;
        ofAllGrowth = 0;
        radius = 0;
        measurements = 0;
        structure.restart();
        plane.restart();
    }

    /** Begins to measure a motion at its present reference: takes it back from its tracked to its measured state. */
    public void begin(Motion motion) {
        tracker.takeBack(motion);
    }

    /**
     * Measures the changes, from the events that the velocity was fitted to, and sets them in the motion. The velocity
     * at the reference, the middle of the window, changes only by what comes with growth, with the deformation of a
     * plane, or with tracking from window to window.
     *
     * @param loss receives what is known of rotation and growth
     * @param half half the window in s
     * @param structureRadius of the structure in px
     * @param isOfOnePolarity whether its events have one polarity, as those on all sides of a body that approaches or
     *     recedes
     */
    public void measure(MetricFit fit, Motion motion, MotionLoss loss, double half, double structureRadius,
                        boolean isOfOnePolarity, SofasParameters.Track p) {
        isSteadyInDepth = isOfOnePolarity && growsAsOne;
        boolean isPlane = planeRadius(fit.size(), structureRadius, p) > 0;
        radius = structureRadius;
        measurements++;
        boolean settles = measurements < SETTLING;
        turnNoisePx = Belief.noisePx(settles ? SETTLING_TURN_PX : TURN_PX, EVENT_TURN_PX, fit.size());
        if (p.acceleration()) {
            // a body steady in depth has the size s / (T - t), the growth g = 1 / (T - t), and at each point the
            // acceleration 2 g v, which is more than a window shows
            double perSpeed = isSteadyInDepth ? 2 * motion.growth : 0;
            acceleration.measure(fit, motion, loss, half, perSpeed, settles, isPlane);
        } else {
            acceleration.leaveOut(motion);
        }
        double turned = motion.omega;
        double grown = motion.growth;
        if (radius > LEAST_RADIUS_PX && (p.rotation() || p.growth())) {
            measureTurnAndGrowth(fit, motion, loss, half, isPlane, p);
        }
        if (isPlane) {
            plane.measure(fit, loss.metric, motion, turned, grown, half, radius);
        } else {
            motion.deformation.clear();
        }
        isClear = acceleration.isVector() && (tracker.isTracking() || loss.flatness() > CLEAR);
        if (isClear && !settles) {
            tracker.track(motion, acceleration.measuredX(), acceleration.measuredY(), alpha, loss, half, radius);
        } else {
            tracker.stop();
            motion.alphaChange = 0;
        }
    }

    /** Radius of a structure if its next measurement looks for the deformation of a plane, else 0. */
    public double planeRadius(int events, double structureRadius, SofasParameters.Track p) {
        return p.rotation() && p.growth() && PlaneChange.mayBe(events, structureRadius, measurements + 1)
            ? structureRadius : 0;
    }

    private void measureTurnAndGrowth(MetricFit fit, Motion motion, MotionLoss loss, double half,
                                      boolean isPlane, SofasParameters.Track p) {
        if (measurements % STRUCTURE_EVERY == 1) {
            fit.structure(structure, radius);
        }
        double perPx = 1 / (half * radius); // shifts both ends by one pixel at the radius
        double turned = motion.omega;
        double grown = motion.growth;
        double turns = 0;
        double grows = 0;
        double newOmega = 0;
        double newGrowth = 0;
        if (p.rotation()) {
            Parabola fitted = fit.changes().rotation(perPx * ChangeFit.APART_PX);
            pull.take(fitted, loss.metric, motion, half, radius);
            double omega = pull.freed();
            turns = Belief.byGain(pull.ownLoss() * structure.own(StructureTensor.TURN) * omega * omega, GAIN_SIGMAS,
                loss.metric);
            newOmega = Belief.in(omega, perPx, turnNoisePx) * turns;
            loss.turn = fitted.loss();
        }
        if (p.growth()) {
            growthFit.measure(fit, structure, grown, half, radius, isPlane);
            growthSlope.measured(growthFit.growth(), motion.referenceUs, growthFit.step(), perPx, half);
            boolean isEvident = isPlane || growsAsOne || evidence >= EVIDENT_SIGMAS;
            grows = Belief.byGain(growthFit.gain(), isEvident ? GAIN_SIGMAS : NEW_GROWTH_SIGMAS, loss.metric);
            newGrowth = Belief.in(growthFit.growth(), growthFit.perPx(), turnNoisePx) * grows;
            loss.grow = growthFit.lossAboutCentre(loss);
        }
        boolean mayShow = Math.max(Math.abs(newOmega), Math.abs(newGrowth)) > LEAST_SHOWN_PX * perPx;
        if (!mayShow || evidence < EVIDENT_SIGMAS || measurements % EVIDENT_EVERY == 0) {
            double shows = mayShow
                ? fit.localEvidence(newOmega, newGrowth, newOmega - turned, newGrowth - grown) : 0;
            evidence += EVIDENCE_GAIN * (shows - evidence);
        }
        ofAllOmega = newOmega;
        ofAllGrowth = newGrowth;
        double sure = growsAsOne ? 1 : sure();
        double sureOfTurning = turnsAsOne ? 1 : sure;
        motion.omega = sureOfTurning * newOmega;
        growthFit.give(motion, sure * newGrowth);
        motion.growthChange = isSteadyInDepth ? motion.growth * motion.growth
            : sure * grows * Belief.in(growthSlope.perS(), perPx / half, turnNoisePx);
        if (turns * sureOfTurning < LEAST_SPINNING) {
            alpha = 0;
            motion.alpha = 0;
        } else if (p.acceleration()) {
            double perPxOfSpin = 2 * perPx / half;
            double step = fit.changes().spin(perPxOfSpin * ChangeFit.APART_PX).step();
            alpha = Belief.taken(alpha, motion.alpha + step, CHANGE_GAIN, perPxOfSpin, NEWS_PX);
            motion.alpha = Belief.in(alpha, perPxOfSpin, turnNoisePx) * turns * sureOfTurning;
        }
    }

    /** How far rotation and growth are those of one body, 0 to 1. */
    private double sure() {
        double lacking = (SURE_SIGMAS - evidence) / HALF_SURE_SIGMAS;
        return lacking < 0 ? 1 : 1 / (1 + lacking * lacking);
    }

    /** Holds the motion steady where it cannot be measured, because another structure crosses or no events come. */
    public void hold(Motion motion) {
        tracker.stop();
        acceleration.hold(motion, HELD);
        alpha *= HELD;
        motion.omega *= HELD;
        motion.alpha *= HELD;
        motion.alphaChange *= HELD;
        motion.growth *= HELD;
        motion.growthChange *= HELD;
        growthSlope.hold(HELD);
        plane.hold(motion, HELD);
    }

    /** Takes the structure to turn as one body: parts of it that turn together need not each show the rotation. */
    public void believeTurning() {
        turnsAsOne = true;
    }

    /** Takes the structure to turn and grow as one body: none of its parts need show that by itself. */
    public void believeAll() {
        turnsAsOne = true;
        growsAsOne = true;
    }

    /** Takes the structure as one body only as far as rotation and growth show within parts of it. */
    public void doubtBody() {
        turnsAsOne = false;
        growsAsOne = false;
    }

    /** Gives a motion the rotation and growth of the structure as one body, whatever shows within parts of it. */
    public void applyOfAll(Motion motion) {
        motion.omega = ofAllOmega;
        motion.growth = ofAllGrowth;
    }

    /** Continues with a structure that only turns from now on, as it did. */
    public void turnInPlace() {
        alpha = 0;
        acceleration.restart();
        tracker.stop();
        growthSlope.restart();
    }

    /** Continues with a motion that is known from elsewhere, and does not measure how the motion changes. */
    public void take() {
        growthSlope.skip();
        tracker.replace();
    }

    /** Shift at the end of the window by the acceleration and by the change of the rotation, in px. */
    public double bendPx(double half) {
        return Math.hypot(acceleration.measured(), alpha * radius) * half * half / 2;
    }

    /** How clearly the acceleration shows, in standard deviations of the metric. */
    public double bendSigmas() {
        return acceleration.sigmas();
    }

    /** Whether the last acceleration was that of a plane whose axes are both known alike. */
    public boolean isKnownAlike() {
        return acceleration.isVector();
    }

    /** Whether both axes of that plane are known clearly, unlike those of an edge. */
    public boolean isClear() {
        return isClear;
    }
}
