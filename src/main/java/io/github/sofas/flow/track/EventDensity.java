package io.github.sofas.flow.track;

import io.github.sofas.flow.motion.Motion;

/**
 * Events that a structure gives per pixel of its travel, as many at any speed: whether it gets as many as usual tells
 * whether it is where its motion expects it, and whether they come faster than its motion takes it on.
 */
final class EventDensity {
    /** Travel whose usual events tell how fast they come now, in px. */
    private static final double RUSH_PX = 1;
    /** Part of that travel which the motion explains, below which events come too fast for it. */
    private static final double RUSH_SHARE = 0.35;
    /** Fewest events that tell it. */
    private static final int LEAST_RUSH = 100;
    /** What is left of the usual density with each look at it, and what is taken of the one of now. */
    private static final double USUAL_KEPT = 0.999;

    private final PastTravel travel = new PastTravel();
    private double usual;

    /** Begins with a structure of which nothing is usual yet. */
    void start() {
        usual = 0;
    }

    /** Begins anew with the density of now as the usual one, where the structure has become another. */
    void start(LiveEvents live, double lifetimePx) {
        usual = now(live, lifetimePx);
    }

    /** Looks at what there is: more than usual is usual from then on, less is so slowly. */
    void follow(LiveEvents live, double lifetimePx) {
        double now = now(live, lifetimePx);
        usual = Math.max(now, usual * USUAL_KEPT + now * (1 - USUAL_KEPT));
    }

    /** Whether there are fewer live events than a share of the usual ones, or too few for any motion. */
    boolean isStarved(LiveEvents live, double lifetimePx, double share) {
        return live.size() < Measurement.LEAST_EVENTS || now(live, lifetimePx) < share * usual;
    }

    /** How many live events it usually gives over some travel, of the tiles that are taken. */
    int usually(LiveEvents live, double px) {
        return (int) Math.min(Integer.MAX_VALUE, usual * px / live.thinning());
    }

    /**
     * Whether the newest events come so fast that the structure must move about three times as fast as its motion says.
     * So far off is none that was followed: it moves in another direction.
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

    /** Events of the structure per px of travel. */
    private static double now(LiveEvents live, double lifetimePx) {
        return live.given() / lifetimePx;
    }
}
