package io.github.sofas.flow.track;

import io.github.sofas.flow.motion.Motion;

/**
 * Whether a structure has come to rest: its motion takes it on, but its events do not come.
 *
 * <p>Ours, because what rests fires no events that could show it: as it slowed down it was expected to turn back, or
 * to go on, and what set off again was found anew. What goes behind something fires no events either: only a structure
 * in full view is taken to rest, whose events end sooner than a border could hide it, or one that was expected to turn
 * back just now.
 */
final class Rest {
    /** Where the structure has not come to rest. */
    static final long NEVER = Long.MAX_VALUE;

    /** Travel along the motion in which it gives too few events, in px. */
    private static final double TRAVEL_PX = 1.5;
    /** Share of the usual events over a px that comes in that travel at most. */
    private static final double SHARE = 0.4;
    /**
     * Times the longest pause in which so few events came, so that it is no pause of its own: a source that sees in
     * frames, as a simulator of video does, gives none between them.
     */
    private static final double PAUSES = 2;
    /** Fewest events that tell it. */
    private static final int LEAST_EVENTS = 4;

    private final PastTravel travel = new PastTravel();
    private final Turn turn = new Turn();

    /**
     * The time since which a structure is at rest, about which its last events came; {@link #NEVER} where it is not.
     *
     * @param live the structure's events
     * @param density how many it usually gives
     * @param radius of the structure in px
     * @param inFullView whether no other structure hides it, nor is it cut off by the border of the sensor
     */
    long sinceUs(Motion motion, LiveEvents live, EventDensity density, double radius, boolean inFullView,
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
        return inFullView || turn.isAfter(sinceUs) ? sinceUs : NEVER;
    }

    /** The longest time that so many events in a row took. */
    private static long longestUs(LiveEvents live, int newest) {
        long longestUs = 0;
        for (int k = newest - 1; k <= live.size() - newest; k++) {
            longestUs = Math.max(longestUs, live.timeUs[live.index(k)] - live.timeUs[live.index(k - newest + 1)]);
        }
        return longestUs;
    }
}
