package io.github.sofas.flow.track;

/**
 * Events that a structure gives per pixel of its travel, as many at any speed: whether it gets as many as usual tells
 * whether it is where its motion expects it.
 */
final class EventDensity {
    /** What is left of the usual density with each look at it, and what is taken of the one of now. */
    private static final double USUAL_KEPT = 0.999;

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

    /** Events of the structure per px of travel. */
    private static double now(LiveEvents live, double lifetimePx) {
        return live.given() / lifetimePx;
    }
}
