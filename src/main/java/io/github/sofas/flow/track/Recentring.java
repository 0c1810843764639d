package io.github.sofas.flow.track;

import io.github.sofas.flow.SofasParameters;
import io.github.sofas.flow.fit.MetricFit;
import io.github.sofas.flow.motion.Motion;

/**
 * The re-centring of a track plane (paper, section Track Plane): its live events, and when and how its motion is
 * measured from them. Where measuring alone would fail, the velocity is looked for anew ({@link FreshVelocity}), the
 * speed is corrected ({@link SpeedByEvents}), or the structure is taken to rest ({@link Rest}) or to turn in place
 * ({@link PureRotation}).
 */
final class Recentring {
    /**
     * A plane that gets no further events is measured after both this part of its lifetime and this time, at the
     * latest.
     */
    private static final int LATE_PART = 4;
    private static final long LATE_US = 20_000;
    /** Shortest window that shows a motion. */
    private static final long SHORTEST_US = 10;
    /** Longest lifetime: a structure that stands still would keep its events for ever. */
    private static final long MAX_LIFETIME_US = 1_000_000;
    /** Part of the events last searched for a velocity that must be new before the next search. */
    private static final int LOOK_PART = 4;
    /**
     * Longest travel in px, and longest time, of a burst. Longer bursts would include edges that follow, and events of
     * a structure that sets off.
     */
    private static final double BURST_PX = 0.5;
    private static final long BURST_US = 1_500;
    /**
     * Standard deviations by which the metric along a new velocity must exceed that along the motion, and that at rest.
     */
    private static final double LOOK_SIGMAS = 10;
    /** The same where the structure sets off from rest, so that no known motion is given up. */
    private static final double SET_OFF_SIGMAS = 2;
    /**
     * Share of the usual events over {@link FreshVelocity#TRAVEL_PX} that shows how a structure sets off: 2.4 px of
     * travel.
     */
    private static final double SET_OFF_SHARE = 0.6;

    private final Measurement measurement;
    private final EventDensity density = new EventDensity();
    private final FreshVelocity fresh = new FreshVelocity();
    private final SpeedByEvents byEvents = new SpeedByEvents();
    private final Rest rest = new Rest();
    private final PureRotation rotation = new PureRotation();
    private SofasParameters.Track p;
    private LiveEvents live = new LiveEvents();
    private long lifetimeUs;
    /** How long bursts last. It is computed with the lifetime, because each event asks for it. */
    private long burstUs;
    private int sinceMeasured;
    private long measuredUs;
    private long widenedUs;
    /** When the velocity was looked for anew last. */
    private long lookedUs;
    /**
     * Events that the structure usually gave over {@link FreshVelocity#TRAVEL_PX}, while it sets off from rest; else 0.
     */
    private int setsOffWith;

    Recentring(SofasParameters.Track p) {
        this.p = p;
        measurement = new Measurement(p);
    }

    /** Begins with a structure that has no events yet. */
    void start(long nowUs) {
        density.start();
        setsOffWith = 0;
        live.clear();
        measurement.restart();
        measurement.doubtBody();
        sinceMeasured = 0;
        measuredUs = nowUs;
        widenedUs = nowUs;
        lookedUs = nowUs;
    }

    /** Continues with other parameters. */
    void setParameters(SofasParameters.Track next) {
        p = next;
        measurement.setParameters(next);
    }

    LiveEvents live() {
        return live;
    }

    /** How the motion is measured, and what is known of it. */
    Measurement measurement() {
        return measurement;
    }

    /**
     * Sets the lifetime of events to the time in which the structure travels the lifetime's pixels, also from a
     * standstill.
     */
    void followLifetime(Motion along, double radius) {
        double speed = along.speed(radius);
        double spin = along.alpha * radius;
        double gained = Math.sqrt(along.ax * along.ax + along.ay * along.ay + spin * spin)
            * measurement.lifetimePx() / 2;
        lifetimeUs = (long) Math.min(MAX_LIFETIME_US,
            measurement.lifetimePx() / Math.max(Math.sqrt(speed * speed + gained), 1e-3) * 1e6);
        burstUs = (long) Math.min(BURST_US, BURST_PX / measurement.lifetimePx() * lifetimeUs);
    }

    /** That time, as it is known now. */
    long lifetimeUs() {
        return lifetimeUs;
    }

    /** How long the bursts of its pixels last. */
    long burstUs() {
        return burstUs;
    }

    /**
     * Adds an event if it is the first of a burst, and lies on a tile that is measured.
     *
     * @return whether the motion is to be measured with it
     */
    boolean add(int x, int y, long timeUs, int polarity, Claim claim, int tile, Bursts bursts) {
        if (!live.takes(tile) || !bursts.begins(x, y, timeUs, polarity, burstUs())) {
            return false;
        }
        live.add(x, y, timeUs, polarity, claim, tile);
        sinceMeasured++;
        return sinceMeasured >= measurement.newsNeeded(live.size());
    }

    /** Whether the motion is to be measured because the last measurement was long ago. */
    boolean isLate(long nowUs) {
        long since = nowUs - measuredUs;
        return sinceMeasured > 0 && since > LATE_US && since > lifetimeUs / LATE_PART;
    }

    /** Drops the events that are older than the lifetime. */
    void expire(long nowUs) {
        live.expire(nowUs - lifetimeUs);
    }

    /** Drops old events. From time to time, takes up the events of twice as many tiles where there are few. */
    void goOn(long nowUs) {
        expire(nowUs);
        if (nowUs - widenedUs > lifetimeUs) {
            // once per lifetime: only then are the events of the newly taken tiles complete
            widenedUs = nowUs;
            live.widen();
        }
    }

    /** Corrects a motion by how its events thin out, as {@link SpeedByEvents} does; returns whether it did. */
    boolean correctSpeed(Motion motion, double radius, boolean inView, MetricFit fit, long nowUs) {
        boolean isCorrected = byEvents.correct(motion, live, radius, inView, measurement, fit, nowUs);
        if (isCorrected) {
            followLifetime(motion, radius);
        }
        return isCorrected;
    }

    /** The time since which the structure is at rest; {@link Rest#NEVER} where it is not. */
    long restsSinceUs(Motion motion, double radius, boolean inView, long nowUs) {
        return rest.sinceUs(motion, live, density, radius, inView, nowUs);
    }

    /**
     * The time since which the structure, which was to turn back, turns in place; {@link Rest#NEVER} where it does not,
     * or is so new that its rotation is not known yet.
     */
    long turnsInPlaceSinceUs(Motion motion, double radius, MetricFit fit, long nowUs) {
        return measurement.mayComeIn() ? Rest.NEVER : rotation.sinceUs(motion, live, radius, fit, nowUs);
    }

    /** Whether the events of a structure that has come to rest show that it turns in place. */
    boolean turnsInPlace(long sinceUs, Motion motion, double radius, MetricFit fit) {
        return rotation.showsSince(sinceUs, motion, live, radius, fit);
    }

    /** Drops the events of before the structure stopped. The others go on showing its rotation. */
    void turnInPlace(long sinceUs, Motion motion, double radius) {
        live.expire(sinceUs + 1);
        density.start();
        measurement.turnInPlace();
        sinceMeasured = 0;
        followLifetime(motion, radius);
    }

    /** Drops all events of a structure that has come to rest, and waits for the events by which it sets off. */
    void comeToRest(Motion motion, double radius) {
        setsOffWith = density.usually(live, FreshVelocity.TRAVEL_PX);
        live.clear();
        density.start();
        measurement.restart();
        sinceMeasured = 0;
        followLifetime(motion, radius);
    }

    /** Whether the structure gets fewer events than are to be expected of its motion. */
    boolean isStarved() {
        return density.isStarved(live, measurement.lifetimePx(), p.minShare());
    }

    /** Takes the current density of events as usual, unless the events rush. Returns whether they do not. */
    boolean followDensity(Motion along, double radius, long nowUs) {
        if (density.isRushed(live, along, radius, nowUs)) {
            return false;
        }
        density.follow(live, measurement.lifetimePx());
        return true;
    }

    /** Begins a measurement; returns whether there are live events. */
    boolean begin(long nowUs) {
        expire(nowUs);
        sinceMeasured = 0;
        measuredUs = nowUs;
        return live.size() > 0;
    }

    /**
     * Measures a motion over the live events, or holds it where they are too few.
     *
     * @param before the motion as it was, with its reference at now
     * @return whether the motion was measured; if so, its reference is the middle of the window
     */
    boolean measure(Motion motion, Motion before, double radius, MetricFit fit, long nowUs) {
        if (setsOffWith > 0 && !setsOff(motion, before, radius, fit, nowUs)) {
            measurement.hold(motion);
            return false;
        }
        if (!followDensity(motion, radius, nowUs)) {
            lookAnew(motion, before, radius, fit, nowUs);
        }
        if (isStarved()) {
            // the remaining events are noise, or too few
            measurement.hold(motion);
            measurement.judge(false, motion, live, radius, fit, nowUs);
            return false;
        }
        if (nowUs - live.oldestUs() <= SHORTEST_US) {
            return false;
        }
        measurement.measure(motion, live, radius, fit, lifetimeUs, nowUs);
        measurement.judge(true, motion, live, radius, fit, nowUs);
        return true;
    }

    /**
     * Looks in all directions for the velocity by which a structure sets off from rest. Measuring from rest, by the
     * first px of its edges, climbs as often to a velocity in the reverse direction.
     *
     * @return whether the motion may be measured, because a velocity was found or as many events came as should show it
     */
    private boolean setsOff(Motion motion, Motion before, double radius, MetricFit fit, long nowUs) {
        int newest = Math.min(live.size(), setsOffWith);
        boolean isFound = findAnew(newest, setsOffWith, SET_OFF_SIGMAS, motion, before, radius, fit, nowUs);
        if (!isFound && newest < SET_OFF_SHARE * setsOffWith) {
            return false;
        }
        setsOffWith = 0;
        return true;
    }

    /**
     * Looks for the velocity in the newest events alone, once a part of them is new. If one is found, earlier events
     * are forgotten.
     */
    private void lookAnew(Motion motion, Motion before, double radius, MetricFit fit, long nowUs) {
        int usual = density.usually(live, FreshVelocity.TRAVEL_PX);
        int newest = Math.min(live.size(), usual);
        if (nowUs - lookedUs >= (nowUs - live.newestFromUs(newest)) / LOOK_PART) {
            lookedUs = nowUs;
            findAnew(newest, usual, LOOK_SIGMAS, motion, before, radius, fit, nowUs);
        }
    }

    /**
     * Looks for the velocity in the newest events; the structure usually gives so many over
     * {@link FreshVelocity#TRAVEL_PX}. Returns whether one is found.
     */
    private boolean findAnew(int newest, int usual, double sigmas, Motion motion, Motion before, double radius,
                             MetricFit fit, long nowUs) {
        long fromUs = live.newestFromUs(newest);
        if (!fresh.find(live, newest, FreshVelocity.TRAVEL_PX * newest / usual, sigmas, before, radius, fit)) {
            return false;
        }
        live.keepNewest(newest);
        motion.set(fromUs + (nowUs - fromUs) / 2, fresh.vx(), fresh.vy());
        measurement.restart();
        followLifetime(motion, radius);
        return true;
    }

    /**
     * Takes over the events of another plane. The motion of all, as it is known, is measured with the next event.
     *
     * @param spare a ring to put the events in
     * @return the ring that was used until now
     */
    LiveEvents merge(Recentring other, LiveEvents spare) {
        measurement.takeCommon();
        spare.fillFrom(live, other.live);
        LiveEvents used = live;
        live = spare;
        return used;
    }

    /**
     * Takes the current density of events as usual. The motion is measured with the next event, once for all changes.
     */
    void becomeAnother() {
        density.start(live, measurement.lifetimePx());
        sinceMeasured = live.size();
    }
}
