package io.github.sofas.flow.track;

import io.github.sofas.event.SensorSize;
import io.github.sofas.flow.Segment;
import io.github.sofas.flow.SofasParameters;
import io.github.sofas.flow.fit.MetricFit;
import io.github.sofas.flow.fit.MotionLoss;
import io.github.sofas.flow.motion.Bounds;
import io.github.sofas.flow.motion.MeasuredMotions;
import io.github.sofas.flow.motion.Motion;

/**
 * A structure that is tracked (paper, section Track Plane): its contour, and its motion, which is measured again and
 * again as the top of the metric of 3 x 3 projections.
 *
 * <p>Ours, because hits alone leave the velocity a tenth off: the metric is compared, not hits counted; neighbours are
 * spaced by what is known along each axis instead of halved and doubled; and the motion has an acceleration, a rotation
 * and a growth, so that the velocity is that of now and not of the middle of the window.
 *
 * <p>What begins, follows, parts, merges and ends a structure is here in one place. What each of these does is in
 * {@link Recentring}, {@link MeasuredMotion}, {@link Outline}, {@link Wholeness} and {@link Life}.
 */
public final class TrackPlane {
    /**
     * Part of its lifetime for which what gets too few events may move otherwise than was measured: so long a structure
     * takes to turn back.
     */
    private static final int ADRIFT_PART = 2;
    /** Standard deviations of the metric that a shift of both ends of the window by a pixel loses where it is known. */
    private static final double KNOWN_SIGMAS = 1;
    /** Travel from which on the motion explains the events of another structure, in px. */
    private static final double TAKING_TRAVEL_PX = 6;

    private final SensorSize sensor;
    private final Outline outline;
    private final Contour contour;
    private final Motion motion = new Motion();
    private final Motion before = new Motion();
    private final Turn turn = new Turn();
    private final Recentring recentring;
    private final MeasuredMotion measured;
    private final Wholeness wholeness = new Wholeness();
    private final Life life = new Life();
    private final Companion companion = new Companion();
    private final OtherPart otherPart = new OtherPart();

    private int served;
    /** Whether it is waited for along a motion that was not measured. */
    private boolean adrift;

    TrackPlane(SensorSize sensor, Contour.Spare spare, SofasParameters.Track p, MeasuredMotions listener) {
        this.sensor = sensor;
        outline = new Outline(sensor, spare, p.memoryPx());
        contour = outline.contour();
        recentring = new Recentring(p);
        measured = new MeasuredMotion(listener);
    }

    /** The most bytes that its arrays take. */
    static long mostBytes(SensorSize sensor) {
        return Outline.bytes(sensor) + LiveEvents.BYTES;
    }

    /**
     * Begins with the velocity of a new structure, which has no number yet; its events are to be added.
     *
     * @param noise how many noise events a pixel gives of either polarity, per µs
     */
    void start(long nowUs, double vx, double vy, double noise) {
        served++;
        adrift = false;
        life.start(nowUs);
        measured.start(vx, vy);
        motion.set(nowUs, vx, vy);
        outline.start(motion, noise);
        recentring.start(nowUs);
        recentring.followLifetime(motion, contour.radius());
        wholeness.start(nowUs);
        companion.start();
        otherPart.start(nowUs);
    }

    /** Gives it its number, under which its motion is told from then on. */
    void number(int id) {
        measured.number(id);
    }

    /** How many structures it has served, with this one. */
    public int served() {
        return served;
    }

    /** Its number, from 1 on; 0 where it has none yet. */
    public int id() {
        return measured.id();
    }

    /** How it moves. */
    public Motion motion() {
        return motion;
    }

    /** How its motion was measured, and what is known of it. */
    Measurement measurement() {
        return recentring.measurement();
    }

    /** An older structure that it may be one with, though they lie apart. */
    Companion companion() {
        return companion;
    }

    /** The older structure that may be a part of the same body. */
    OtherPart otherPart() {
        return otherPart;
    }

    /** The events that its motion is measured from. */
    LiveEvents live() {
        return recentring.live();
    }

    /** Where its events fell of late. */
    Contour contour() {
        return contour;
    }

    /** Whether its velocity is known along both axes: that of a straight edge is not along the edge. */
    public boolean isVelocityKnown() {
        MotionLoss loss = measurement().loss();
        double px = 2e6 / lifetimeUs();
        return loss.least() * px * px > KNOWN_SIGMAS * MetricFit.sd(loss.metric);
    }

    /** How many live events its structure gave, of which some may not be measured. */
    public long liveEvents() {
        return recentring.live().given();
    }

    /** The polarity that all of its live events have but for noise, as those of an edge; 0 where there is none. */
    int commonPolarity() {
        return recentring.live().commonPolarity();
    }

    /** Speed of its contour in px/s, root of the mean square. */
    public double speed() {
        return motion.speed(contour.radius());
    }

    /** How far it has travelled since it was found, in px, at its speed of now. */
    double travelPx(long nowUs) {
        return (nowUs - life.firstUs()) * 1e-6 * speed();
    }

    /** Support of an event by the contour; at least {@link #threshold} where it belongs. */
    public int support(int x, int y, long timeUs, int polarity) {
        return contour.support(x, y, timeUs, polarity);
    }

    /** Support by what is nearest, of the event whose support was asked for last and that has any. */
    int closeSupport(int polarity) {
        return contour.closeSupport(polarity);
    }

    /** Least support that puts an event on the contour. */
    public int threshold() {
        return contour.threshold();
    }

    /** Close support below which it is doubtful whether an event belongs. */
    double sureSupport() {
        return contour.sureSupport();
    }

    long lifetimeUs() {
        return recentring.lifetimeUs();
    }

    /** How long the bursts of its pixels last. */
    long burstUs() {
        return recentring.burstUs();
    }

    /** What it was seen as before. */
    ContourMemory memory() {
        return outline.memory();
    }

    /**
     * Adds an event of the structure's past, before its motion is measured for the first time.
     *
     * @param beginsBurst whether it is the first event of a burst: no other is measured
     */
    void addPast(int x, int y, long timeUs, int polarity, boolean beginsBurst) {
        int tile = outline.see(x, y, timeUs, polarity, Math.max(0, life.firstUs() - timeUs), lifetimeUs());
        if (beginsBurst) {
            recentring.live().add(x, y, timeUs, polarity, Claim.OWN, tile);
        }
    }

    /** Notes an event of the past on the contour, as one where more are to come. */
    void see(int x, int y, long timeUs, int polarity, long nowUs) {
        outline.see(x, y, timeUs, polarity, nowUs - timeUs, lifetimeUs());
    }

    /** Whether a place of the sensor lies in the box of the contour, or beside it by so many px at most. */
    public boolean isAround(int x, int y, double marginPx, long nowUs) {
        return contour.isAround(x, y, marginPx, nowUs);
    }

    /** Widens a box so that it holds the contour. */
    public void includeIn(Bounds box, long nowUs) {
        contour.includeIn(box, nowUs);
    }

    /**
     * Takes an event, and measures the motion when enough have come.
     *
     * @param claim why it is taken; unless it is remembered, it is the event whose support was asked for last
     * @param bursts tells the first event of each burst: no other is measured
     */
    void take(int x, int y, long timeUs, int polarity, Claim claim, Bursts bursts, MetricFit fit) {
        if (isPredictive()) {
            // else it got no flow
            life.note(timeUs);
        }
        int tile = outline.take(x, y, timeUs, polarity, claim, lifetimeUs());
        if (recentring.add(x, y, timeUs, polarity, claim, tile, bursts)) {
            recentre(fit, timeUs);
        }
    }

    /** Whether its motion tells where its events come from: else they get no flow until it does again. */
    public boolean isPredictive() {
        return recentring.measurement().isPredictive() && !adrift;
    }

    /**
     * Corrects the motion by how its events thin out, or end; before {@link #update} lets events go, since of what is
     * slower they are kept for longer. Not along a straight edge, whose velocity is not known: what slides along itself
     * gives more or fewer events at any speed.
     *
     * @param isHidden whether others lie where they may hide a part of it
     */
    void correctSpeed(boolean isHidden, MetricFit fit, long nowUs) {
        if (!isVelocityKnown()) {
            return;
        }
        boolean inFullView = !isHidden && contour.isInside(nowUs);
        long restsSinceUs = recentring.restsSinceUs(motion, contour.radius(), inFullView, nowUs);
        if (restsSinceUs != Rest.NEVER) {
            rest(restsSinceUs, nowUs);
        } else if (recentring.correctSpeed(motion, contour.radius(), inFullView, fit, nowUs)) {
            contour.follow(motion);
        }
    }

    /** Takes it to have come to rest: from then on it is waited for where it was. */
    private void rest(long sinceUs, long nowUs) {
        motion.moveReference(sinceUs);
        outline.remember(motion);
        motion.set(sinceUs, 0, 0);
        contour.follow(motion);
        outline.remember(motion);
        motion.moveReference(nowUs);
        recentring.comeToRest(motion, contour.radius());
    }

    /**
     * Lets events go, and goes to the state that it is in by now.
     *
     * @param noise how many noise events a pixel gives of either polarity, per µs
     */
    Life.State update(long nowUs, double noise) {
        recentring.goOn(nowUs);
        turn.take(motion, nowUs);
        outline.pass(nowUs, noise, turn.isNear(lifetimeUs()), lifetimeUs());
        recentring.followDensity(motion, contour.radius(), nowUs);
        Life.State state = life.goOn(recentring.isStarved(), recentring.measurement().isBlurred(),
            !contour.hasLeft(nowUs), outline.memoryUs(motion), nowUs);
        adrift = life.isWaitedFor(lifetimeUs() / ADRIFT_PART, nowUs) && measured.isOther(motion);
        return state;
    }

    /** Measures the motion of a structure that gets few events and would else wait long. */
    void measureIfLate(MetricFit fit, long nowUs) {
        if (recentring.isLate(nowUs)) {
            recentre(fit, nowUs);
        }
    }

    /** Measures the motion over the live events, and lets the outline follow it. */
    void recentre(MetricFit fit, long nowUs) {
        if (!recentring.begin(nowUs)) {
            return;
        }
        before.copyFrom(motion);
        before.moveReference(nowUs);
        if (recentring.measure(motion, before, contour.radius(), fit, nowUs)) {
            measured.take(motion);
        }
        carryOn(nowUs);
    }

    /** Goes on along the motion as it is known now. */
    private void carryOn(long nowUs) {
        motion.moveReference(nowUs);
        if (recentring.live().thinning() == 1 && isMovedOff()) {
            outline.draw(recentring.live(), motion, lifetimeUs());
        } else {
            outline.follow(motion, lifetimeUs());
        }
        followOutline();
    }

    /** Takes centre and lifetime from the outline as it lies now. */
    private void followOutline() {
        outline.measure(recentring.live(), motion, lifetimeUs());
        recentring.followLifetime(motion, contour.radius());
    }

    /** Whether the motion was corrected by so much that the contour no longer lies where it is. */
    private boolean isMovedOff() {
        return contour.isEmpty()
            || motion.speedFrom(before, contour.radius()) * (lifetimeUs() * 0.5e-6) > Contour.REDRAWN_PX;
    }

    /**
     * Takes over the events of another plane; the motion of all is measured with the next event.
     *
     * @param common the motion that serves both
     * @param bond by what the two are one
     * @param spare a ring to put them in
     * @return the ring that this plane used until now
     */
    LiveEvents merge(TrackPlane other, Motion common, Merging.Bond bond, LiveEvents spare, long nowUs) {
        motion.copyFrom(common);
        LiveEvents used = recentring.merge(other.recentring, spare);
        if (bond == Merging.Bond.EDGES) {
            measurement().believeTurning();
        } else if (bond == Merging.Bond.BODY) {
            measurement().believeAll();
        }
        life.takeOver(other.life);
        motion.moveReference(nowUs);
        if (recentring.live().thinning() == 1) {
            outline.draw(recentring.live(), motion, lifetimeUs());
        } else {
            contour.absorb(other.contour, motion);
        }
        followOutline();
        outline.remember(other.recentring.live());
        recentring.expire(nowUs);
        becomeAnother();
        return used;
    }

    /** Takes the density of now for the usual one; its motion is measured with the next event, once for all changes. */
    private void becomeAnother() {
        recentring.becomeAnother();
        wholeness.doubt();
    }

    /** Whether it has travelled so far since it was asked last that it is to be asked again what it is made of. */
    boolean beginsToPart(long nowUs) {
        return life.isTracked() && wholeness.beginsToAsk(speed(), nowUs);
    }

    /**
     * Looks whether a part of the structure is a body of its own, and notes if it is clearly one body.
     *
     * @return whether there is a part, which is to be given up to another plane
     */
    boolean findPart(Parting parting, MetricFit fit) {
        return wholeness.findPart(parting, recentring.live(), motion, contour.radius(), measurement(), fit);
    }

    /** Begins to ask whether others take it over; false of a dense structure, of which only some tiles are known. */
    boolean offerTo(TakenOver taken) {
        LiveEvents live = recentring.live();
        return live.thinning() == 1 && taken.begin(live, motion, contour.radius());
    }

    /** Whether its motion changes at a place by half of its speed within a trace: an edge there came another way. */
    boolean isBent(int x, int y, long timeUs) {
        return motion.bendsWithin(PixelHistory.TRACE_PX, x, y, timeUs);
    }

    /** The same in its middle, as that of what turns back. */
    boolean isBent() {
        return isBent((int) motion.centreX, (int) motion.centreY, motion.referenceUs);
    }

    /** Whether its motion is known so well that it may explain the events of another structure. */
    boolean mayTakeOver(long nowUs) {
        return life.isTracked() && isVelocityKnown() && measurement().isSharp() && isPredictive()
            && travelPx(nowUs) >= TAKING_TRAVEL_PX;
    }

    /** Gives the part that was found up to another plane, whose motion is measured from its events. */
    void giveUp(Parting parting, TrackPlane to, MetricFit fit, long nowUs) {
        to.start(nowUs, parting.motionOfPart().vx, parting.motionOfPart().vy, outline.noisePerUs());
        LiveEvents live = recentring.live();
        for (int k = 0; k < live.size(); k++) {
            int i = live.index(k);
            if (parting.isOfPart(i)) {
                to.addPast(live.x[i], live.y[i], live.timeUs[i], live.sign[i], true);
            }
        }
        to.recentre(fit, nowUs);
        live.keepIf(i -> !parting.isOfPart(i));
        measurement().doubtBody();
        motion.copyFrom(parting.rest());
        motion.moveReference(nowUs);
        outline.draw(live, motion, lifetimeUs());
        followOutline();
        becomeAnother();
    }

    /** Tracks on with other parameters. */
    void setParameters(SofasParameters.Track next) {
        outline.setMemoryPx(next.memoryPx());
        recentring.setParameters(next);
    }

    /** Lets all events go, so that the plane can serve another structure. */
    void clear() {
        contour.wipe();
        recentring.live().clear();
    }

    /** What is known of the structure. */
    Segment segment(Segment.Fate fate, int mergedInto) {
        // where all of the contour has faded it was seen last about its centre
        boolean faded = contour.isEmpty();
        long lastUs = life.lastUs();
        Bounds box = contour.box(lastUs);
        return new Segment(id(), life.firstUs(), lastUs, life.events(), (float) motion.vx, (float) motion.vy,
            (float) motion.omega, (float) motion.growth,
            clip(faded ? motion.centreX : box.left(), sensor.width()),
            clip(faded ? motion.centreY : box.top(), sensor.height()),
            clip(faded ? motion.centreX : box.right(), sensor.width()),
            clip(faded ? motion.centreY : box.bottom(), sensor.height()), fate, mergedInto);
    }

    private static int clip(double v, int size) {
        return (int) Math.max(0, Math.min(size - 1, Math.rint(v)));
    }
}
