package io.github.sofas.flow.track;

import io.github.sofas.flow.motion.Chance;

/**
 * What noise alone gives by chance, where the pixels of a polarity fire at some rate: support by a contour, and a trace
 * along a motion.
 *
 * <p>Ours, because a contour that takes noise supports more of it, and in the dark, at a few events per second and
 * pixel, grows from a structure all over the sensor. What a share of the structure's own support tells apart from noise
 * in good light does not where noise is about as dense as an edge.
 */
final class Noise {
    /** Cells that support an event. */
    private static final int CELLS = 9;
    /** Events of noise on them that a contour may hold: where they are many, all sixteenths of its time have some. */
    private static final double MOST_ON_CELLS = 2;
    /** Standard deviations by which support must pass that by noise: the structure's own is around. */
    private static final double SUPPORT_SIGMAS = 2;
    /** Pixels beside the one that an edge must have come over, which count for a trace, too. */
    private static final int BESIDE = 3;

    private Noise() {
    }

    /** Time after which more than a few events of a rate, as below, lie around a place. */
    static long mostUs(double rate) {
        return (long) (MOST_ON_CELLS / (CELLS * rate));
    }

    /**
     * Support by a contour that noise seldom has.
     *
     * @param rate of the noise events of a pixel, of either polarity, per µs
     * @param us time for which the contour holds events
     */
    static int support(double rate, long us) {
        double sixteenths = ContourCells.SIXTEENTHS * Chance.share(CELLS * rate * us / ContourCells.SIXTEENTHS);
        // 2 for each of its own polarity, less 1 for each of the other
        return (int) (sixteenths + SUPPORT_SIGMAS * Math.sqrt((2 * 2 + 1) * sixteenths));
    }

    /**
     * Trace that noise seldom has.
     *
     * @param rate of the noise events of a pixel, of either polarity, per µs
     * @param speed of the motion at the event, in px/s
     * @param sigmas standard deviations over the mean
     */
    static int trace(double rate, double speed, double sigmas) {
        double expected = rate * 1e6 / Math.max(PixelHistory.SLOWEST_PX_PER_S, speed);
        double onIt = Chance.share(expected);
        double beside = (1 - onIt) * Chance.share(BESIDE * expected);
        double mean = PixelHistory.ON_THE_PIXEL * onIt + beside;
        double square = PixelHistory.ON_THE_PIXEL * PixelHistory.ON_THE_PIXEL * onIt + beside;
        return (int) Chance.most(PixelHistory.TRACE_PX, mean, square, sigmas);
    }
}
