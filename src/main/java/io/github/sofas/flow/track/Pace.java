package io.github.sofas.flow.track;

import io.github.sofas.flow.motion.Motion;

/**
 * How fast a structure is now, as a multiple of the speed of its motion. Its events show this as an odometer does: a
 * structure gives about as many of them per px of travel at any speed.
 *
 * <p>Ours, because a motion is measured over some px of travel. How it has changed since then follows from its
 * acceleration, which is known late: a camera turned by hand was followed 40 ms late. Its events come faster or slower
 * at once.
 *
 * <p>They also do where something hides the structure, where it enters the picture, or where its path bends. The pace
 * is therefore believed as far as it was right before. Each measurement shows how fast the structure was in the middle
 * of its window. By how much the motion was wrong then, and what the pace said of it, gives the factor by which the
 * pace is believed (least squares, of logarithms). Means are left out, because a structure that comes near gives more
 * and more events. If the events per px vary by more than the motion was wrong, they are no odometer.
 *
 * <p>Only the velocities of labels follow the pace, not the motion itself, which the next measurement corrects.
 */
final class Pace {
    /** Newest events that show the pace: those of so much travel, in px, but not fewer than a number. */
    private static final double TRAVEL_PX = 0.5;
    private static final int LEAST_EVENTS = 100;
    /** The greatest pace, and the inverse of the least. */
    private static final double MOST = 2;
    /**
     * A measured velocity is a mean over its window, in which a change of the speed shows by about half: the pace is
     * believed by so many times what the measurements confirm.
     */
    private static final double CONFIRMED = 2;
    /** Least share of the square error of the motion that the pace must explain. */
    private static final double LEAST_EXPLAINED = 0.25;
    /** Variance of the logarithm of the events per px, as a share of that error, at which the pace is not believed. */
    private static final double UNEVEN = 0.5;
    /** Windows after which learning begins: at first, a motion is wrong because it is not yet known. */
    private static final double SETTLING_WINDOWS = 2;
    /** Number of half windows in which what was learnt fades to a third, and least weight of what is believed. */
    private static final double MEMORY_HALVES = 6;
    private static final double LEAST_WEIGHT = 0.3;
    /** Looks that are remembered, and how many of them are taken per lifetime. */
    private static final int LOOKS = 64;
    private static final int LOOKS_PER_LIFETIME = 32;
    /** Bytes that the arrays take. */
    static final long BYTES = LOOKS * (Long.BYTES + 2L * Float.BYTES);

    private final PastTravel travel = new PastTravel();
    private final Motion now = new Motion();
    // the looks, in a ring: time, and logarithms of speed and pace
    private final long[] us = new long[LOOKS];
    private final float[] speed = new float[LOOKS];
    private final float[] pace = new float[LOOKS];
    private long looks;
    /** Logarithm of the present number of events per px. */
    private double density;
    private double factor = 1;
    private long learntUs;
    /** Windows that have passed since the pace was first seen. */
    private double windows;
    // fading sums: of weights, of the pace, of squares and products about its mean, and of events per px
    private double weight;
    private double paces;
    private double spread;
    private double both;
    private double errors;
    private double densities;
    private double squares;

    /** Begins with a structure that has no events yet. */
    void start() {
        looks = 0;
        factor = 1;
        windows = 0;
        learntUs = Long.MIN_VALUE;
        weight = 0;
        paces = 0;
        spread = 0;
        both = 0;
        errors = 0;
        densities = 0;
        squares = 0;
    }

    /** What the speed of the motion is to be multiplied by, as far as the pace is believed. */
    double factor() {
        return factor;
    }

    /** Looks at how fast the newest events came. */
    void look(Motion motion, LiveEvents live, double radius, long lifetimeUs, long nowUs) {
        factor = 1;
        double belief = belief();
        boolean isDue = looks == 0 || nowUs - us[(int) ((looks - 1) % LOOKS)] >= lifetimeUs / LOOKS_PER_LIFETIME;
        if (belief == 0 && !isDue || live.size() < 2 * LEAST_EVENTS) {
            return;
        }
        double perPx = travel.eventsPerPx(motion, live, radius, nowUs);
        int newest = (int) Math.max(LEAST_EVENTS, perPx * TRAVEL_PX);
        if (newest > live.size() / 2) {
            return;
        }
        double seen = logarithm(newest / perPx / travel.px(motion, radius, live.newestFromUs(newest), nowUs));
        density = StrictMath.log(perPx * live.thinning());
        if (isDue) {
            now.copyFrom(motion);
            now.moveReference(nowUs);
            int i = (int) (looks++ % LOOKS);
            us[i] = nowUs;
            speed[i] = (float) StrictMath.log(now.speed(radius));
            pace[i] = (float) seen;
        }
        if (belief > 0) {
            factor = StrictMath.exp(belief * (seen - paces / weight));
        }
    }

    private static double logarithm(double ratio) {
        return StrictMath.log(Math.max(1 / MOST, Math.min(MOST, ratio)));
    }

    /** By how much the pace is believed, 0 to 1. */
    private double belief() {
        if (weight < LEAST_WEIGHT || both <= 0 || both * both < LEAST_EXPLAINED * spread * errors) {
            return 0;
        }
        double uneven = squares - densities * densities / weight;
        double even = Math.max(0, 1 - uneven / (UNEVEN * errors));
        return Math.min(1, CONFIRMED * both / spread * even);
    }

    /**
     * Learns from a measurement whether the pace was right.
     *
     * @param measured with its reference in the middle of the window, which ends now
     */
    void learn(Motion measured, double radius, long nowUs) {
        double half = Math.max(1, nowUs - measured.referenceUs);
        int then = lookAt(measured.referenceUs, half / 4);
        if (then < 0) {
            return;
        }
        double halves = learntUs == Long.MIN_VALUE ? 0 : (nowUs - learntUs) / half;
        learntUs = nowUs;
        windows += halves / 2;
        if (windows < SETTLING_WINDOWS) {
            return;
        }
        double kept = StrictMath.exp(-halves / MEMORY_HALVES);
        double news = 1 - kept;
        weight = kept * weight + news;
        paces = kept * paces + news * pace[then];
        double apart = pace[then] - paces / weight;
        double error = logarithm(measured.speed(radius) / StrictMath.exp(speed[then]));
        spread = kept * spread + news * apart * apart;
        both = kept * both + news * apart * error;
        errors = kept * errors + news * error * error;
        densities = kept * densities + news * density;
        squares = kept * squares + news * density * density;
    }

    /** Index of the look that is nearest to a time; -1 if none is as near as given. */
    private int lookAt(long atUs, double mostUs) {
        int nearest = -1;
        double nearestUs = mostUs;
        for (int i = 0; i < Math.min(looks, LOOKS); i++) {
            double apartUs = Math.abs(us[i] - atUs);
            if (apartUs < nearestUs) {
                nearestUs = apartUs;
                nearest = i;
            }
        }
        return nearest;
    }
}
