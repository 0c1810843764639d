package io.github.sofas.flow.track;

import io.github.sofas.flow.fit.MetricFit;
import io.github.sofas.flow.motion.Motion;

/**
 * Whether a structure has stopped, and only turns on in place.
 *
 * <p>Ours, because such a structure is not at rest ({@link Rest}): it goes on giving events, though far fewer than on
 * its way. Most of the events that its motion is measured from are of before it stopped. That motion slows down, and is
 * taken to turn back, away from where the structure stays. The events since the turn show which of the two it does.
 * What is nearly round stands still, as far as they show.
 */
final class PureRotation {
    /** Way back along the motion, in px, from which on the events show whether the structure takes it. */
    private static final double BACK_PX = 0.75;
    /**
     * Root mean square travel by rotation in the same time, in px, below which the structure stands still as far as is
     * known: what turns back gives few events there, too.
     */
    private static final double TURN_PX = 0.25;
    private static final int LEAST_EVENTS = 12;
    /** Most events, over that way: more show by themselves how a structure goes on, as those of a wall do. */
    private static final int MOST_EVENTS = 3000;
    /** Standard deviations that are not chance. */
    private static final double SIGMAS = 1;

    private final Turn turn = new Turn();
    private final Motion back = new Motion();
    private final Motion inPlace = new Motion();
    private final NewestEvents events = new NewestEvents();

    /**
     * The time since which the structure turns in place instead of going back; {@link Rest#NEVER} if its events do not
     * show that it does.
     *
     * @param live the structure's events
     * @param radius of the structure in px
     */
    long sinceUs(Motion motion, LiveEvents live, double radius, MetricFit fit, long nowUs) {
        turn.take(motion, nowUs);
        if (live.size() == 0 || !turn.isAfter(live.oldestUs())) {
            return Rest.NEVER;
        }
        long sinceUs = turn.us();
        double seconds = (nowUs - sinceUs) * 1e-6;
        back.copyFrom(motion);
        back.moveReference(nowUs);
        if (Math.hypot(back.vx, back.vy) * seconds / 2 < BACK_PX) {
            return Rest.NEVER;
        }
        int newest = live.since(sinceUs);
        if (newest < LEAST_EVENTS || newest > MOST_EVENTS) {
            return Rest.NEVER;
        }
        events.load(live, newest, back, radius, fit);
        double metric = fit.metric();
        loadInPlace(motion, sinceUs, live, newest, radius, fit);
        boolean turns = Math.abs(back.omega) * radius * seconds >= TURN_PX;
        return fit.size() >= LEAST_EVENTS && passes(fit.metric(), metric, turns ? 0 : SIGMAS) ? sinceUs : Rest.NEVER;
    }

    /** Whether events since a time show that the structure turns in place, and is not at rest. */
    boolean showsSince(long sinceUs, Motion motion, LiveEvents live, double radius, MetricFit fit) {
        int newest = live.since(sinceUs);
        if (motion.omega == 0 || newest < LEAST_EVENTS) {
            return false;
        }
        loadInPlace(motion, sinceUs, live, newest, radius, fit);
        double metric = fit.metric();
        inPlace.omega = 0;
        events.load(live, newest, inPlace, radius, fit);
        return passes(metric, fit.metric(), SIGMAS);
    }

    private static boolean passes(double metric, double other, double sigmas) {
        return metric - other >= sigmas * MetricFit.sd(Math.max(metric, other));
    }

    private void loadInPlace(Motion motion, long sinceUs, LiveEvents live, int newest, double radius, MetricFit fit) {
        inPlace.copyFrom(motion);
        inPlace.moveReference(sinceUs);
        inPlace.turnInPlace();
        events.load(live, newest, inPlace, radius, fit);
    }
}
