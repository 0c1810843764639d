package io.github.sofas.flow.track;

/**
 * Selects the live events that a motion is measured from, and determines how many must be new until it is measured
 * again. Ours, so that the cost per event does not grow with the number of events.
 */
final class Sample {
    /**
     * A sample has this part of the live events, but at least {@link #WHOLE} and at most {@link #MOST}. The more events
     * there are, the rarer are measurements, so that the cost per event does not grow. The velocity along edges is
     * known weakly, and needs many events.
     */
    private static final int PART = 2;
    private static final int MOST = 4096;
    /** The same for a plane that is no straight edge: twice as many events, half as often, determine more. */
    private static final int MOST_OF_PLANE = 8192;
    /** Fewest events between two measurements. */
    private static final int LEAST_NEWS = 40;
    /**
     * One in so many events must be new: of events that are all measured, of a sample, and of all live events. With
     * fewer measurements, a structure that swings or comes near is followed late. Measurements of a sample in stretches
     * are off by the same each time, so that more of them carry a motion away.
     */
    private static final int WHOLE_NEWS_PART = 8;
    private static final int NEWS_PART = 4;
    private static final int LIVE_NEWS_PART = 12;
    /**
     * Stretches of the window that a sample is made of, from its beginning to its end. Events of one stretch meet as
     * often as if all were taken, and those of two stretches lie so far apart in time that they show the velocity.
     * Events that follow each other at once do not show it, and those of real pixels make it look too fast. A stretch
     * that is shorter than a pixel of travel begins and ends while an edge along a row or column still fires, which
     * looks like another velocity and an acceleration. So few events are taken whole.
     */
    private static final int STRETCHES = 4;
    /**
     * Live events up to which all are measured: with half as many, the velocity of a lonely hexagon swings by a tenth.
     */
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
     * Learns from a measurement how often the events meet.
     *
     * @param metric of the measured events; measured is their number, and live the number of live events
     */
    void meets(double metric, int measured, int live) {
        // the events of a thinned sample meet less often, by its share of the live events
        density = metric / measured * live / measured;
    }

    /**
     * New events needed until the motion is measured again: an eighth of few, a twelfth of many, more where a sample is
     * large.
     *
     * @param isPlane whether the live events are those of a plane that is no straight edge
     */
    int newsNeeded(int live, boolean isPlane) {
        int sample = size(live, isPlane);
        int ofSample = sample / (sample == live ? WHOLE_NEWS_PART : NEWS_PART);
        return Math.max(LEAST_NEWS, Math.max(ofSample, live / LIVE_NEWS_PART));
    }

    /**
     * How many of the live events a measurement needs. Thinning events thins their meetings by the square, so that many
     * events that meet seldom are taken whole.
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

    /** Index among the live events of the k-th event of a sample, in stretches from the first event to the last. */
    static int number(int k, int want, int live) {
        return live == want ? k : k + (live - want) * (k * STRETCHES / want) / (STRETCHES - 1);
    }
}
