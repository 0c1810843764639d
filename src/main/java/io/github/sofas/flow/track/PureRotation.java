package io.github.sofas.flow.track;

import io.github.sofas.flow.fit.MetricFit;
import io.github.sofas.flow.motion.Motion;

/**
 * Whether a structure that turns has stopped, and only turns on in place.
 *
 * <p>Ours, because such a structure is not at rest ({@link Rest}): it goes on giving events, though far fewer than on
 * its way. Most of the events that its motion is measured from are of before it stopped. That motion slows down, and is
 * taken to turn back, away from where the structure stays. The events since the turn show which of the two it does.
 */
final class PureRotation {
    /** Way back along the motion, in px, from which on the events show whether the structure takes it. */
    private static final double BACK_PX = 0.75;
    /** Root mean square travel by rotation in the same time, in px, without which the structure stands still. */
    private static final double TURN_PX = 0.25;
    private static final int LEAST_EVENTS = 12;
    /** Standard deviations by which the metric along the rotation passes that at rest. */
    private static final double TURNS_SIGMAS = 1;

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
        if (motion.omega == 0 || live.size() == 0 || !turn.isAfter(live.oldestUs())) {
            return Rest.NEVER;
        }
        long sinceUs = turn.us();
        double seconds = (nowUs - sinceUs) * 1e-6;
        back.copyFrom(motion);
        back.moveReference(nowUs);
        int newest = live.since(sinceUs);
        if (Math.hypot(back.vx, back.vy) * seconds / 2 < BACK_PX
                || Math.abs(back.omega) * radius * seconds < TURN_PX || newest < LEAST_EVENTS) {
            return Rest.NEVER;
        }
        events.load(live, newest, back, radius, fit);
        double metric = fit.metric();
        loadInPlace(motion, sinceUs, live, newest, radius, fit);
        return fit.size() >= LEAST_EVENTS && fit.metric() >= metric ? sinceUs : Rest.NEVER;
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
        double atRest = fit.metric();
        return metric - atRest > TURNS_SIGMAS * MetricFit.sd(Math.max(metric, atRest));
    }

    private void loadInPlace(Motion motion, long sinceUs, LiveEvents live, int newest, double radius, MetricFit fit) {
        inPlace.copyFrom(motion);
        inPlace.moveReference(sinceUs);
        inPlace.turnInPlace();
        events.load(live, newest, inPlace, radius, fit);
    }
}
