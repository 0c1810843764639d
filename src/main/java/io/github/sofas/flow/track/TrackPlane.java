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
 * <p>Ours, because hits alone leave the velocity a tenth off. The metric is compared instead of counting hits, and the
 * distances of neighbours follow from what is known along each axis instead of being halved and doubled. The motion has
 * an acceleration, a rotation and a growth, so that the velocity is the current one and not that of the middle of the
 * window.
 *
 * <p>This class begins, follows, parts, merges and ends a structure. The details are in {@link Recentring},
 * {@link MeasuredMotion}, {@link Pace}, {@link Outline}, {@link Wholeness} and {@link Life}.
 */
public final class TrackPlane {
    /**
     * Part of its lifetime for which a structure that gets too few events may depart from its measured motion: a
     * structure takes so long to turn back.
     */
    private static final int ADRIFT_PART = 2;
    /**
     * Standard deviations of the metric that a shift of both ends of the window by a pixel loses where the velocity is
     * known.
     */
    private static final double KNOWN_SIGMAS = 1;
    /** Travel, in px, from which on the motion may explain the events of another structure. */
    private static final double TAKING_TRAVEL_PX = 6;

    private final SensorSize sensor;
    private final Outline outline;
    private final Contour contour;
    private final Motion motion = new Motion();
    private final Motion before = new Motion();
    private final Turn turn = new Turn();
    private final Recentring recentring;
    private final MeasuredMotion measured;
    private final Pace pace = new Pace();
    private final Wholeness wholeness = new Wholeness();
    private final Life life = new Life();
    private final Companion companion = new Companion();
    private final OtherPart otherPart = new OtherPart();

    private int served;
    /** Whether the structure is waited for along a motion that was not measured. */
    private boolean adrift;

    TrackPlane(SensorSize sensor, Contour.Spare spare, SofasParameters.Track p, MeasuredMotions listener) {
        this.sensor = sensor;
        outline = new Outline(sensor, spare, p.memoryPx());
        contour = outline.contour();
        recentring = new Recentring(p);
        measured = new MeasuredMotion(listener);
    }

    /** The most bytes that the arrays of a plane take. */
    static long mostBytes(SensorSize sensor) {
        return Outline.bytes(sensor) + LiveEvents.BYTES + Pace.BYTES;
    }

    /**
     * Begins with the velocity of a new structure, which has no number yet. The events of the structure are to be added
     * afterwards.
     *
     * @param noise noise events per pixel and per µs, of each polarity
     */
    void start(long nowUs, double vx, double vy, double noise) {
        served++;
        adrift = false;
        life.start(nowUs);
        measured.start(vx, vy);
        pace.start();
        motion.set(nowUs, vx, vy);
        outline.start(motion, noise);
        recentring.start(nowUs);
        recentring.followLifetime(motion, contour.radius());
        wholeness.start(nowUs);
        companion.start();
        otherPart.start(nowUs);
    }

    /** Gives the structure its number, under which its motion is reported from then on. */
    void number(int id) {
        measured.number(id);
    }

    /** Number of structures that this plane has served, including the current one. */
    public int served() {
        return served;
    }

    /** Number of the structure, from 1 on; 0 while it has none yet. */
    public int id() {
        return measured.id();
    }

    /** The motion of the structure. */
    public Motion motion() {
        return motion;
    }

    /** What velocities along the motion are to be multiplied by, because the structure is faster or slower by now. */
    double pace() {
        return pace.factor();
    }

    /** How the motion was measured, and what is known of it. */
    Measurement measurement() {
        return recentring.measurement();
    }

    /** An older structure that this one may be one with, though the two lie apart. */
    Companion companion() {
        return companion;
    }

    /** The older structure that may be a part of the same body. */
    OtherPart otherPart() {
        return otherPart;
    }

    /** The events that the motion is measured from. */
    LiveEvents live() {
        return recentring.live();
    }

    /** Whether the structure is dense: it gives more events than are held, and is measured on some of its tiles. */
    boolean isDense() {
        return recentring.live().thinning() > 1;
    }

    /** Where events of the structure fell recently. */
    Contour contour() {
        return contour;
    }

    /** Whether the velocity is known along both axes. That of a straight edge is not known along the edge. */
    public boolean isVelocityKnown() {
        MotionLoss loss = measurement().loss();
        double px = 2e6 / lifetimeUs();
        return loss.least() * px * px > KNOWN_SIGMAS * MetricFit.sd(loss.metric);
    }

    /** Number of live events that the structure gave, some of which may not be measured. */
    public long liveEvents() {
        return recentring.live().given();
    }

    /** The polarity that all of the live events have except for noise, as those of an edge do; 0 if there is none. */
    int commonPolarity() {
        return recentring.live().commonPolarity();
    }

    /** Root mean square speed of the contour in px/s. */
    public double speed() {
        return motion.speed(contour.radius());
    }

    /** Travel since the structure was found, in px, at its current speed. */
    double travelPx(long nowUs) {
        return (nowUs - life.firstUs()) * 1e-6 * speed();
    }

    /** Support of an event by the contour; at least {@link #threshold} if the event belongs to it. */
    public int support(int x, int y, long timeUs, int polarity) {
        return contour.support(x, y, timeUs, polarity);
    }

    /** Support by the nearest cells, of the event whose support was asked for last, if it had any. */
    int closeSupport(int polarity) {
        return contour.closeSupport(polarity);
    }

    /** Least support that puts an event on the contour. */
    public int threshold() {
        return contour.threshold();
    }

    /** Close support below which it is doubtful whether an event belongs to the structure. */
    double sureSupport() {
        return contour.sureSupport();
    }

    /**
     * Share of the time for which the contour holds events that a place of the structure has been in sight, if it came
     * in over the border: 0 to 1.
     */
    double shareInSight(int x, int y, long timeUs) {
        return outline.shareInSight(x, y, timeUs, lifetimeUs());
    }

    long lifetimeUs() {
        return recentring.lifetimeUs();
    }

    /** How long the bursts of the structure's pixels last. */
    long burstUs() {
        return recentring.burstUs();
    }

    /** Where the contour was seen before. */
    ContourMemory memory() {
        return outline.memory();
    }

    /**
     * Adds an event of the structure's past, before its motion is measured for the first time.
     *
     * @param beginsBurst whether it is the first event of a burst: no other event is measured
     */
    void addPast(int x, int y, long timeUs, int polarity, boolean beginsBurst) {
        int tile = outline.see(x, y, timeUs, polarity, Math.max(0, life.firstUs() - timeUs), lifetimeUs());
        if (beginsBurst) {
            recentring.live().add(x, y, timeUs, polarity, Claim.OWN, tile);
        }
    }

    /** Notes a past event on the contour, as a place where more events are expected. */
    void see(int x, int y, long timeUs, int polarity, long nowUs) {
        outline.see(x, y, timeUs, polarity, nowUs - timeUs, lifetimeUs());
    }

    /** Whether a place of the sensor lies in the box of the contour, or at most so many px beside it. */
    public boolean isAround(int x, int y, double marginPx, long nowUs) {
        return contour.isAround(x, y, marginPx, nowUs);
    }

    /** Widens a box so that it holds the contour. */
    public void includeIn(Bounds box, long nowUs) {
        contour.includeIn(box, nowUs);
    }

    /**
     * Takes an event, and measures the motion when enough events have come.
     *
     * @param claim why the event is taken; unless this is {@link Claim#REMEMBERED}, it is the event whose support was
     *     asked for last
     * @param bursts identifies the first event of each burst: no other event is measured
     */
    void take(int x, int y, long timeUs, int polarity, Claim claim, Bursts bursts, MetricFit fit) {
        if (isPredictive()) {
            // otherwise the event got no flow
            life.note(timeUs);
        }
        int tile = outline.take(x, y, timeUs, polarity, claim, lifetimeUs());
        if (recentring.add(x, y, timeUs, polarity, claim, tile, bursts)) {
            recentre(fit, timeUs);
        }
    }

    /**
     * Takes an event that is not measured as one of the contour, without asking whether it is.
     *
     * @return whether it is taken; an event that is measured, or that no motion predicts, is to be asked
     */
    boolean takesUnasked(int x, int y, long timeUs, int polarity) {
        if (!isPredictive() || recentring.live().takes(outline.tile(x, y, timeUs))) {
            return false;
        }
        life.note(timeUs);
        outline.takeLocated(x, y, timeUs, polarity);
        return true;
    }

    /** Whether the motion predicts where the events come from. If not, they get no flow until it does again. */
    public boolean isPredictive() {
        return recentring.measurement().isPredictive() && !adrift;
    }

    /**
     * Corrects the motion by how its events thin out, or end, or show that the structure only turns by now. This comes
     * before {@link #update} drops events, since those of a slower structure are kept for longer. The speed of a
     * straight edge is not corrected, because its velocity is not known: an edge that slides along itself gives more or
     * fewer events at any speed.
     *
     * @param isHidden whether other structures lie where they may hide a part of this one
     */
    void correctSpeed(boolean isHidden, MetricFit fit, long nowUs) {
        long turnsSinceUs = recentring.turnsInPlaceSinceUs(motion, contour.radius(), fit, nowUs);
        if (turnsSinceUs != Rest.NEVER) {
            turnInPlace(turnsSinceUs, nowUs);
            return;
        }
        if (!isVelocityKnown()) {
            return;
        }
        boolean inView = !isHidden && contour.isInSight(nowUs);
        long restsSinceUs = recentring.restsSinceUs(motion, contour.radius(), inView, nowUs);
        if (restsSinceUs != Rest.NEVER) {
            if (recentring.turnsInPlace(restsSinceUs, motion, contour.radius(), fit)) {
                turnInPlace(restsSinceUs, nowUs);
            } else {
                rest(restsSinceUs, nowUs);
            }
        } else if (recentring.correctSpeed(motion, contour.radius(), inView, fit, nowUs)) {
            contour.follow(motion);
        }
    }

    /** Takes the structure to have come to rest: from then on it is waited for where it was. */
    private void rest(long sinceUs, long nowUs) {
        motion.moveReference(sinceUs);
        outline.remember(motion);
        motion.set(sinceUs, 0, 0);
        contour.follow(motion);
        outline.remember(motion);
        motion.moveReference(nowUs);
        recentring.comeToRest(motion, contour.radius());
    }

    /** Takes the structure to have stopped where it was, and to turn on. */
    private void turnInPlace(long sinceUs, long nowUs) {
        motion.moveReference(sinceUs);
        motion.turnInPlace();
        contour.follow(motion);
        motion.moveReference(nowUs);
        recentring.turnInPlace(sinceUs, motion, contour.radius());
    }

    /**
     * Drops old events, and goes to the state that the structure is in by now.
     *
     * @param noise noise events per pixel and per µs, of each polarity
     */
    Life.State update(long nowUs, double noise) {
        recentring.goOn(nowUs);
        lookAtPace(nowUs);
        turn.take(motion, nowUs);
        outline.pass(nowUs, noise, turn.isNear(lifetimeUs()), lifetimeUs());
        recentring.followDensity(motion, contour.radius(), nowUs);
        Life.State state = life.goOn(recentring.isStarved(), recentring.measurement().isBlurred(),
            !contour.hasLeft(nowUs), outline.memoryUs(motion), nowUs);
        adrift = life.isWaitedFor(lifetimeUs() / ADRIFT_PART, nowUs) && measured.isOther(motion);
        return state;
    }

    /** Measures the motion of a structure that gets few events and would otherwise wait for long. */
    void measureIfLate(MetricFit fit, long nowUs) {
        if (recentring.isLate(nowUs)) {
            recentre(fit, nowUs);
        }
    }

    /** Measures the motion from the live events, and lets the outline follow it. */
    void recentre(MetricFit fit, long nowUs) {
        if (!recentring.begin(nowUs)) {
            return;
        }
        before.copyFrom(motion);
        before.moveReference(nowUs);
        if (recentring.measure(motion, before, contour.radius(), fit, nowUs)) {
            measured.take(motion);
            pace.learn(motion, contour.radius(), nowUs);
        }
        carryOn(nowUs);
        lookAtPace(nowUs);
    }

    /** Looks at how fast the structure is now, along the motion as it is known now. */
    private void lookAtPace(long nowUs) {
        pace.look(motion, recentring.live(), contour.radius(), lifetimeUs(), nowUs);
    }

    /** Continues along the motion as it is known now. */
    private void carryOn(long nowUs) {
        motion.moveReference(nowUs);
        if (!isDense() && isMovedOff()) {
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

    /** Whether the motion was corrected by so much that the contour no longer lies where the structure is. */
    private boolean isMovedOff() {
        return contour.isEmpty()
            || motion.speedFrom(before, contour.radius()) * (lifetimeUs() * 0.5e-6) > Contour.REDRAWN_PX;
    }

    /**
     * Takes over the events of another plane. The motion of all is measured with the next event.
     *
     * @param common the motion that serves both
     * @param bond why the two are one
     * @param spare a ring to put the events in
     * @return the ring that this plane used until now
     */
    LiveEvents merge(TrackPlane other, Motion common, Merging.Bond bond, LiveEvents spare, long nowUs) {
        motion.copyFrom(common);
        LiveEvents used = recentring.merge(other.recentring, spare);
        if (bond == Merging.Bond.EDGES || bond == Merging.Bond.TOGETHER) {
            measurement().believeTurning();
        } else if (bond == Merging.Bond.BODY) {
            measurement().believeAll();
        }
        life.takeOver(other.life);
        motion.moveReference(nowUs);
        if (!isDense()) {
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

    /**
     * Takes the current density of events as usual. The motion is measured with the next event, once for all changes.
     */
    private void becomeAnother() {
        recentring.becomeAnother();
        wholeness.doubt();
    }

    /**
     * Whether the structure has travelled so far since it was last asked what it is made of that it is to be asked
     * again.
     */
    boolean beginsToPart(long nowUs) {
        return life.isTracked() && wholeness.beginsToAsk(speed(), nowUs);
    }

    /**
     * Looks for a part of the structure that is a body of its own, and notes if the structure is clearly one body.
     *
     * @return whether there is a part, which is to be given up to another plane
     */
    boolean findPart(Parting parting, MetricFit fit) {
        return wholeness.findPart(parting, recentring.live(), motion, contour.radius(), measurement(), fit);
    }

    /**
     * Begins to ask whether others take this plane over; false for a dense structure, of which only some tiles are
     * known.
     */
    boolean offerTo(TakenOver taken) {
        return !isDense() && taken.begin(recentring.live(), motion, contour.radius());
    }

    /**
     * Whether the motion at a place changes by more than half of its speed over the travel of a trace: an edge there
     * came another way.
     */
    boolean isBent(int x, int y, long timeUs) {
        return motion.bendsWithin(PixelHistory.TRACE_PX, x, y, timeUs);
    }

    /** The same at the centre of the structure, as for a structure that turns back. */
    boolean isBent() {
        return isBent((int) motion.centreX, (int) motion.centreY, motion.referenceUs);
    }

    /** Whether the motion is known so well that it may explain the events of another structure. */
    boolean mayTakeOver(long nowUs) {
        return life.isTracked() && isVelocityKnown() && measurement().isSharp() && isPredictive()
            && travelPx(nowUs) >= TAKING_TRAVEL_PX;
    }

    /** Gives the part that was found up to another plane, whose motion is measured from the events of that part. */
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

    /** Continues with other parameters. */
    void setParameters(SofasParameters.Track next) {
        outline.setMemoryPx(next.memoryPx());
        recentring.setParameters(next);
    }

    /** Drops all events, so that the plane can serve another structure. */
    void clear() {
        contour.wipe();
        recentring.live().clear();
    }

    /** Returns what is known of the structure. */
    Segment segment(Segment.Fate fate, int mergedInto) {
        // a contour that has faded completely was last seen about its centre
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
