package io.github.sofas.flow.track;

import io.github.sofas.flow.motion.Motion;

/**
 * The number of events that a structure gives per pixel of its travel, which is the same at any speed. Fewer events
 * than usual show that the structure is not where its motion expects it. Events that come too fast show that the
 * structure moves faster than its motion says.
 */
final class EventDensity {
    /** Travel, in px, whose usual number of events is used to find how fast events come now. */
    private static final double RUSH_PX = 1;
    /** Part of that travel that the motion must explain: if it explains less, events come too fast for it. */
    private static final double RUSH_SHARE = 0.35;
    /** Fewest events that show a rush. */
    private static final int LEAST_RUSH = 100;
    /** Share of the usual density that each look keeps; the rest is taken from the current density. */
    private static final double USUAL_KEPT = 0.999;

    private final PastTravel travel = new PastTravel();
    private double usual;

    /** Starts with a structure whose usual density is not known yet. */
    void start() {
        usual = 0;
    }

    /** Starts anew, where the structure has changed: the current density becomes the usual one. */
    void start(LiveEvents live, double lifetimePx) {
        usual = now(live, lifetimePx);
    }

    /** Looks at the current density: a higher one becomes usual at once, a lower one slowly. */
    void follow(LiveEvents live, double lifetimePx) {
        double now = now(live, lifetimePx);
        usual = Math.max(now, usual * USUAL_KEPT + now * (1 - USUAL_KEPT));
    }

    /** Whether there are fewer live events than a share of the usual number, or too few for any motion. */
    boolean isStarved(LiveEvents live, double lifetimePx, double share) {
        return live.size() < Measurement.LEAST_EVENTS || now(live, lifetimePx) < share * usual;
    }

    /** Returns the usual number of live events over some travel, on the tiles that are taken. */
    int usually(LiveEvents live, double px) {
        return (int) Math.min(Integer.MAX_VALUE, usual * px / live.thinning());
    }

    /**
     * Whether the newest events come so fast that the structure must move about three times as fast as its motion says.
     * A motion that was followed is never so far off: the structure now moves in another direction.
     *
     * @param radius of the structure in px
     */
    boolean isRushed(LiveEvents live, Motion motion, double radius, long nowUs) {
        int newest = usually(live, RUSH_PX);
        if (newest < LEAST_RUSH || newest > live.size()) {
            return false;
        }
        return travel.px(motion, radius, live.newestFromUs(newest), nowUs) < RUSH_SHARE * RUSH_PX;
    }

    /** Returns the events of the structure per px of travel. */
    private static double now(LiveEvents live, double lifetimePx) {
        return live.given() / lifetimePx;
    }
}
