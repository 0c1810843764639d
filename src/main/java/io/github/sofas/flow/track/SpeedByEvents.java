package io.github.sofas.flow.track;

import io.github.sofas.flow.fit.MetricFit;
import io.github.sofas.flow.motion.Motion;

/**
 * Corrects a motion by how its events thin out. A structure gives about as many events per px of its travel at any
 * speed, so that their number shows how far it has come.
 *
 * <p>Ours, because most of the events that a motion is measured from came while the structure was fast. A structure
 * that stopped and turned back was taken to go on, was lost there, and was found anew once it had moved off. With the
 * correction it is expected to turn back where it does, and its events show whether it does or stays.
 *
 * <p>Events also become fewer where something hides the structure, or where its path bends. A motion that is not known
 * to change its speed is therefore corrected only for a structure in view, and only if the metric agrees. No motion is
 * made faster, since more events may be those of something else.
 */
final class SpeedByEvents {
    /** Shift of the ends of the window by the acceleration along the motion, in px, above which the speed changes. */
    private static final double LEAST_BEND_PX = 0.25;
    /** Recent travel that is examined, in px: the shorter it is, the nearer to now. */
    private static final double TRAVEL_PX = 0.5;
    /** Fewest events over that travel that show the speed. */
    private static final int LEAST_EVENTS = 20;
    /**
     * Share of the travel along a motion that slows down, from which on the motion is not corrected: events come
     * unevenly.
     */
    private static final double SLOWING_SHARE = 0.8;
    /** The same for a motion that speeds up, as it does after the point where it was expected to turn back. */
    private static final double SPEEDING_SHARE = 0.5;
    /** The same for a motion of steady speed. */
    private static final double STEADY_SHARE = 0.7;

    private final PastTravel travel = new PastTravel();
    private final Motion slower = new Motion();

    /**
     * Slows a motion down if its events show this. The current velocity becomes less, and the velocity in the middle of
     * the window stays: it is the acceleration that was not known.
     *
     * @param motion gets now as its reference if it is corrected
     * @param live the structure's events
     * @param radius of the structure in px
     * @param inView whether nothing hides the structure, and the border of the sensor cuts off little of it
     * @return whether it was corrected
     */
    boolean correct(Motion motion, LiveEvents live, double radius, boolean inView, Measurement measurement,
                    MetricFit fit, long nowUs) {
        if (live.size() < Measurement.LEAST_EVENTS) {
            return false;
        }
        double share = share(motion, live, radius, nowUs);
        if (share >= SLOWING_SHARE) {
            return false;
        }
        double half = (nowUs - live.oldestUs()) * 0.5e-6;
        slow(motion, share, half, nowUs);
        double along = (motion.ax * motion.vx + motion.ay * motion.vy) / Math.hypot(motion.vx, motion.vy);
        boolean changesSpeed = Math.abs(along) * half * half / 2 > LEAST_BEND_PX;
        boolean isSlower = changesSpeed && share < (along < 0 ? SLOWING_SHARE : SPEEDING_SHARE)
            || inView && share < STEADY_SHARE && isSharper(motion, live, radius, measurement, fit, nowUs);
        if (isSlower) {
            motion.copyFrom(slower);
        }
        return isSlower;
    }

    /** Recent travel that the events indicate, as a share of that along the motion; 1 where the events are too few. */
    private double share(Motion motion, LiveEvents live, double radius, long nowUs) {
        double perPx = travel.eventsPerPx(motion, live, radius, nowUs);
        int newest = (int) (perPx * TRAVEL_PX);
        return newest < LEAST_EVENTS || newest > live.size() ? 1
            : TRAVEL_PX / travel.px(motion, radius, live.newestFromUs(newest), nowUs);
    }

    private void slow(Motion motion, double share, double half, long nowUs) {
        double perS = (share - 1) / half;
        slower.copyFrom(motion);
        slower.moveReference(nowUs);
        slower.ax += perS * slower.vx;
        slower.ay += perS * slower.vy;
        slower.vx *= share;
        slower.vy *= share;
    }

    /** Whether the events meet more often along the slower motion than along the known one. */
    private boolean isSharper(Motion motion, LiveEvents live, double radius, Measurement measurement, MetricFit fit,
                              long nowUs) {
        double known = measurement.metric(motion, live, radius, fit, nowUs);
        return measurement.metric(slower, live, radius, fit, nowUs) > known;
    }
}
