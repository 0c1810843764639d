package io.github.sofas.flow.track;

import io.github.sofas.flow.SofasParameters;
import io.github.sofas.flow.fit.MetricFit;
import io.github.sofas.flow.motion.Motion;

/**
 * The re-centring of a track plane (paper, section Track Plane): its live events, and when and how its motion is
 * measured from them.
 */
final class Recentring {
    /** A plane that gets no events is measured at the latest after this part of its lifetime, and this time. */
    private static final int LATE_PART = 4;
    private static final long LATE_US = 20_000;
    /** Shortest window that shows a motion. */
    private static final long SHORTEST_US = 10;
    /** Longest lifetime: what stands still would keep its events for ever. */
    private static final long MAX_LIFETIME_US = 1_000_000;
    /** Part of the events in which a velocity was looked for that must be new to look again. */
    private static final int LOOK_PART = 4;
    /** Longest travel in px, and time, of a burst; longer ones would have edges that follow, and what sets off. */
    private static final double BURST_PX = 0.5;
    private static final long BURST_US = 1_500;
    /** Standard deviations by which the metric along a new velocity must pass that along the motion, and at rest. */
    private static final double LOOK_SIGMAS = 10;
    /** The same where it sets off from rest, so that no motion is known to be given up. */
    private static final double SET_OFF_SIGMAS = 2;
    /** Share of the usual events over {@link FreshVelocity#TRAVEL_PX} that show how it sets off: 2.4 px of travel. */
    private static final double SET_OFF_SHARE = 0.6;

    private final Measurement measurement;
    private final EventDensity density = new EventDensity();
    private final FreshVelocity fresh = new FreshVelocity();
    private final SpeedByEvents byEvents = new SpeedByEvents();
    private final Rest rest = new Rest();
    private SofasParameters.Track p;
    private LiveEvents live = new LiveEvents();
    private long lifetimeUs;
    /** How long bursts last, worked out with the lifetime: it is asked for with each event. */
    private long burstUs;
    private int sinceMeasured;
    private long measuredUs;
    private long widenedUs;
    /** When its velocity was looked for anew last. */
    private long lookedUs;
    /** Events that it usually gave over {@link FreshVelocity#TRAVEL_PX}, while it sets off from rest; else 0. */
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

    /** Goes on with other parameters. */
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

    /** Keeps events for the time in which the structure travels the lifetime's pixels, also from a stand. */
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
     * Adds an event, if it is the first one of a burst and of a tile that is measured.
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

    /** Whether the motion is to be measured because it was not for long. */
    boolean isLate(long nowUs) {
        long since = nowUs - measuredUs;
        return sinceMeasured > 0 && since > LATE_US && since > lifetimeUs / LATE_PART;
    }

    /** Lets go the events of longer ago than the lifetime. */
    void expire(long nowUs) {
        live.expire(nowUs - lifetimeUs);
    }

    /** The same from time to time, and takes up the events of twice as many tiles where there are few. */
    void goOn(long nowUs) {
        expire(nowUs);
        if (nowUs - widenedUs > lifetimeUs) {
            // once per lifetime: the events of the tiles that are taken anew are complete only then
            widenedUs = nowUs;
            live.widen();
        }
    }

    /** Corrects a motion by how its events thin out, as {@link SpeedByEvents} does; returns whether it did. */
    boolean correctSpeed(Motion motion, double radius, boolean inFullView, MetricFit fit, long nowUs) {
        boolean isCorrected = byEvents.correct(motion, live, radius, inFullView, measurement, fit, nowUs);
        if (isCorrected) {
            followLifetime(motion, radius);
        }
        return isCorrected;
    }

    /** The time since which the structure is at rest; {@link Rest#NEVER} where it is not. */
    long restsSinceUs(Motion motion, double radius, boolean inFullView, long nowUs) {
        return rest.sinceUs(motion, live, density, radius, inFullView, nowUs);
    }

    /** Lets go all events of a structure that has come to rest, and waits for those by which it sets off. */
    void comeToRest(Motion motion, double radius) {
        setsOffWith = density.usually(live, FreshVelocity.TRAVEL_PX);
        live.clear();
        density.start();
        measurement.restart();
        sinceMeasured = 0;
        followLifetime(motion, radius);
    }

    /** Whether the structure gets fewer events than its motion lets expect. */
    boolean isStarved() {
        return density.isStarved(live, measurement.lifetimePx(), p.minShare());
    }

    /** Takes what events there are for usual, unless they rush: returns whether they do not. */
    boolean followDensity(Motion along, double radius, long nowUs) {
        if (density.isRushed(live, along, radius, nowUs)) {
            return false;
        }
        density.follow(live, measurement.lifetimePx());
        return true;
    }

    /** Begins to measure; returns whether there are live events. */
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
     * @return whether it was measured: then its reference is the middle of the window
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
            // what is left is noise, or too little
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
     * Looks for the velocity by which a structure sets off from rest, in all directions: from rest, measuring climbs as
     * often to one that goes back, of the first px of its edges.
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

    /** Looks for the velocity in the newest events alone, once a part of them is new; what came before is forgotten. */
    private void lookAnew(Motion motion, Motion before, double radius, MetricFit fit, long nowUs) {
        int usual = density.usually(live, FreshVelocity.TRAVEL_PX);
        int newest = Math.min(live.size(), usual);
        if (nowUs - lookedUs >= (nowUs - live.newestFromUs(newest)) / LOOK_PART) {
            lookedUs = nowUs;
            findAnew(newest, usual, LOOK_SIGMAS, motion, before, radius, fit, nowUs);
        }
    }

    /** Looks for the velocity in some of the newest of those that it usually gives; returns whether any is found. */
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
     * Takes over the events of another plane; the motion of all, as it is known, is measured with the next event.
     *
     * @param spare a ring to put them in
     * @return the ring that was used until now
     */
    LiveEvents merge(Recentring other, LiveEvents spare) {
        measurement.takeCommon();
        spare.fillFrom(live, other.live);
        LiveEvents used = live;
        live = spare;
        return used;
    }

    /** Takes the density of now for the usual one; the motion is measured with the next event, once for all changes. */
    void becomeAnother() {
        density.start(live, measurement.lifetimePx());
        sinceMeasured = live.size();
    }
}
