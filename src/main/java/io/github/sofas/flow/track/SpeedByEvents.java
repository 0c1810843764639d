package io.github.sofas.flow.track;

import io.github.sofas.flow.fit.MetricFit;
import io.github.sofas.flow.motion.Motion;

/**
 * Corrects a motion by how its events thin out: a structure gives about as many for each px of its travel, so that they
 * tell how far it has come.
 *
 * <p>Ours, because most of the events that a motion is measured from came while it was fast: what stopped and turned
 * back was taken to go on, was lost there, and found anew once it had moved off. So corrected, it is expected to turn
 * back where it does; whether it does or stays, its events tell, too. They also become fewer where something hides the
 * structure, or where its path bends: of a motion that is not known to change its speed, only that of a structure in
 * full view is corrected, and only if the metric agrees. No motion is made faster, since more events may be those of
 * something else.
 */
final class SpeedByEvents {
    /** Shift of the ends of the window by the acceleration along the motion from which on its speed changes, in px. */
    private static final double LEAST_BEND_PX = 0.25;
    /** Travel of late that is looked at, in px: the shorter, the nearer to now. */
    private static final double TRAVEL_PX = 0.5;
    /** Fewest events that tell it. */
    private static final int LEAST_EVENTS = 20;
    /** Share of the travel along a motion that slows down, from which on the motion stays: events come unevenly. */
    private static final double SLOWING_SHARE = 0.8;
    /** The same of one that speeds up, as it goes on to do from where it was expected to turn back. */
    private static final double SPEEDING_SHARE = 0.5;
    /** The same of one that goes on as it is. */
    private static final double STEADY_SHARE = 0.7;

    private final PastTravel travel = new PastTravel();
    private final Motion slower = new Motion();

    /**
     * Has a motion go on more slowly, if the events tell so. The velocity of now becomes less, and that in the middle
     * of the window stays: the acceleration is what was not known.
     *
     * @param motion gets now as its reference where it is corrected
     * @param live the structure's events
     * @param radius of the structure in px
     * @param inFullView whether nothing hides it, nor is it cut off by the border of the sensor
     * @return whether it was corrected
     */
    boolean correct(Motion motion, LiveEvents live, double radius, boolean inFullView, Measurement measurement,
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
            || inFullView && share < STEADY_SHARE && isSharper(motion, live, radius, measurement, fit, nowUs);
        if (isSlower) {
            motion.copyFrom(slower);
        }
        return isSlower;
    }

    /** Travel of late that the events tell of, as a share of that along the motion; 1 where they are too few. */
    private double share(Motion motion, LiveEvents live, double radius, long nowUs) {
        double perPx = live.size() / travel.px(motion, radius, live.oldestUs(), nowUs);
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

    /** Whether the events meet more often along the slower motion than along the one that is known. */
    private boolean isSharper(Motion motion, LiveEvents live, double radius, Measurement measurement, MetricFit fit,
                              long nowUs) {
        double known = measurement.metric(motion, live, radius, fit, nowUs);
        return measurement.metric(slower, live, radius, fit, nowUs) > known;
    }
}
