package io.github.sofas.flow.track;

import io.github.sofas.flow.motion.Motion;

/**
 * Whether a structure has come to rest: its motion takes it on, but its events do not come.
 *
 * <p>Ours, because a structure at rest fires no events that could show it. As it slowed down, it was expected to turn
 * back or to go on, and once it set off again it was found anew. A structure that goes behind another fires no events
 * either. So only two kinds of structure are taken to rest. One is in view, and its events end sooner than the border
 * of the sensor could hide it. The other was expected to turn back just now.
 */
final class Rest {
    /** Stands for a structure that has not come to rest. */
    static final long NEVER = Long.MAX_VALUE;

    /** Travel along the motion, in px, over which the structure gives too few events. */
    private static final double TRAVEL_PX = 1.5;
    /** Greatest share of the usual events per px of travel that comes over that travel. */
    private static final double SHARE = 0.4;
    /**
     * Least time of that travel, as a multiple of the longest pause in which so few events came, so that it is not
     * another such pause. A source that sees in frames, as a simulator of video does, gives no events between them.
     */
    private static final double PAUSES = 2;
    /** Fewest events that show a rest. */
    private static final int LEAST_EVENTS = 4;

    private final PastTravel travel = new PastTravel();
    private final Turn turn = new Turn();

    /**
     * The time since which a structure is at rest, which is about when its last events came; {@link #NEVER} if it is
     * not.
     *
     * @param live the structure's events
     * @param density of the events that the structure usually gives
     * @param radius of the structure in px
     * @param inView whether no other structure hides it, and the border of the sensor cuts off little of it
     */
    long sinceUs(Motion motion, LiveEvents live, EventDensity density, double radius, boolean inView,
                 long nowUs) {
        int newest = density.usually(live, SHARE);
        if (newest < LEAST_EVENTS || live.size() == 0) {
            return NEVER;
        }
        long sinceUs = live.newestFromUs(Math.min(newest, live.size()));
        if (travel.px(motion, radius, sinceUs, nowUs) < TRAVEL_PX
                || nowUs - sinceUs < PAUSES * longestUs(live, newest)) {
            return NEVER;
        }
        turn.take(motion, nowUs);
        return inView || turn.isAfter(sinceUs) ? sinceUs : NEVER;
    }

    /** The longest time that so many successive events took. */
    private static long longestUs(LiveEvents live, int newest) {
        long longestUs = 0;
        for (int k = newest - 1; k <= live.size() - newest; k++) {
            longestUs = Math.max(longestUs, live.timeUs[live.index(k)] - live.timeUs[live.index(k - newest + 1)]);
        }
        return longestUs;
    }
}
