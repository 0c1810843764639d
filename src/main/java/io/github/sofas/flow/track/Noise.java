package io.github.sofas.flow.track;

import io.github.sofas.flow.motion.Chance;

/**
 * What noise alone reaches by chance, where each pixel fires noise of either polarity at some rate: support by a
 * contour, and a trace along a motion.
 *
 * <p>Ours, because a contour that takes noise supports more of it. In the dark, at a few events per second and pixel,
 * it grows from a structure all over the sensor. A share of the structure's own support separates its events from noise
 * in good light, but not where noise is about as dense as an edge.
 */
final class Noise {
    /** Cells that support an event. */
    private static final int CELLS = 9;
    /** Noise events that a contour may hold on these cells: with many, all sixteenths of its time have some. */
    private static final double MOST_ON_CELLS = 2;
    /** Standard deviations by which support must exceed that by noise: the structure's own is around. */
    private static final double SUPPORT_SIGMAS = 2;
    /** Pixels beside the one that an edge must have come over; events on them count for a trace, too. */
    private static final int BESIDE = 3;

    private Noise() {
    }

    /** Time after which more than a few noise events lie around a place, at a rate as for {@link #support}. */
    static long mostUs(double rate) {
        return (long) (MOST_ON_CELLS / (CELLS * rate));
    }

    /**
     * Support by a contour that noise seldom reaches.
     *
     * @param rate of noise events per pixel and per µs, of each polarity
     * @param us time for which the contour holds events
     */
    static int support(double rate, long us) {
        double sixteenths = ContourCells.SIXTEENTHS * Chance.share(CELLS * rate * us / ContourCells.SIXTEENTHS);
        // each sixteenth of its own polarity adds 2, each of the other takes off 1
        return (int) (sixteenths + SUPPORT_SIGMAS * Math.sqrt((2 * 2 + 1) * sixteenths));
    }

    /**
     * Trace that noise seldom reaches.
     *
     * @param rate of noise events per pixel and per µs, of each polarity
     * @param speed of the motion at the event, in px/s
     * @param sigmas standard deviations above the mean
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
