package io.github.sofas.flow.track;

/**
 * Which of the live events a motion is measured from, and how many must be new until it is measured again. Ours, so
 * that measuring costs no more per event the more there are.
 */
final class Sample {
    /**
     * A sample has this part of the live events, but no fewer and no more than {@link #WHOLE} and
     * {@link #MOST}: measurements are the rarer the more there are, so that it costs no more per event, and
     * what is weakly known, the velocity along edges, needs many.
     */
    private static final int PART = 2;
    private static final int MOST = 4096;
    /** The same of a plane that is no straight edge: twice as many, half as often, tell more. */
    private static final int MOST_OF_PLANE = 8192;
    /** Fewest events between two measurements. */
    private static final int LEAST_NEWS = 40;
    /**
     * Parts of events that are all measured, of a sample, and of all live events, of which one must be new. What swings
     * or comes near is followed late with fewer measurements; those of a sample in stretches are off by the same each
     * time, and more of them carry a motion away.
     */
    private static final int WHOLE_NEWS_PART = 8;
    private static final int NEWS_PART = 4;
    private static final int LIVE_NEWS_PART = 12;
    /**
     * Stretches of the window that a sample is made of, from its beginning to its end. Events of one stretch meet as
     * often as if all were taken, and those of two lie so far apart in time that they show the velocity; events that
     * follow each other at once do not, and those of real pixels make it look too fast. Where a stretch is shorter than
     * a pixel of travel, it begins and ends within what an edge along a row or column fires, which looks like another
     * velocity and an acceleration: few events are taken whole.
     */
    private static final int STRETCHES = 4;
    /** Live events that are measured whole: with half as many a lonely hexagon's velocity swings by a tenth. */
    private static final int WHOLE = 2000;
    /** Metric per event below which a sample is enlarged: thinning events thins their meetings by the square. */
    private static final double DENSITY = 1.5;

    /** Metric per event of all live events. */
    private double density;

    /** Begins without knowing how often the events meet. */
    void restart() {
        density = 0;
    }

    /**
     * Learns from a measurement how often they meet.
     *
     * @param metric of so many events that were measured, of so many live ones
     */
    void meets(double metric, int measured, int live) {
        // in a thinned sample events meet by so much less
        density = metric / measured * live / measured;
    }

    /**
     * New events until the motion is measured again: an eighth of few, a twelfth of many, more where a sample is large.
     *
     * @param isPlane whether the live events are those of a plane that is no straight edge
     */
    int newsNeeded(int live, boolean isPlane) {
        int sample = size(live, isPlane);
        int ofSample = sample / (sample == live ? WHOLE_NEWS_PART : NEWS_PART);
        return Math.max(LEAST_NEWS, Math.max(ofSample, live / LIVE_NEWS_PART));
    }

    /**
     * How many of so many live events a measurement needs: thinning them thins their meetings by the square, so that
     * many events that meet seldom are taken whole.
     *
     * @param isPlane whether they are those of a plane that is no straight edge
     */
    int size(int live, boolean isPlane) {
        int usual = Math.min(live / PART, isPlane ? MOST_OF_PLANE : MOST);
        int least = Math.max(WHOLE, usual);
        int most = Math.min(live, Measurement.MOST_EVENTS);
        return live <= least ? live
            : (int) Math.max(least, Math.min(most, live * DENSITY / Math.max(density, 1e-3)));
    }

    /** Number of the k-th event of a sample of so many events, in stretches from the first to the last. */
    static int number(int k, int want, int live) {
        return live == want ? k : k + (live - want) * (k * STRETCHES / want) / (STRETCHES - 1);
    }
}
