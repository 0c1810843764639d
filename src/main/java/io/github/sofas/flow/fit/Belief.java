package io.github.sofas.flow.fit;

/**
 * How far a measured change of a motion is believed, and how much of a new measurement is adopted. A change counts by a
 * share of 0 to 1: by the shift that it gives the ends of the window, or by what the metric gains by it, each compared
 * with noise.
 */
final class Belief {
    private Belief() {
    }

    /** The believed part of a change: at most half if it shifts the ends of the window no more than noise. */
    static double in(double value, double perPx, double noisePx) {
        return value * share(value, perPx, noisePx);
    }

    /**
     * How far a change is real, 0 to 1, by how far it shifts the ends of the window.
     *
     * @param perPx value that shifts them by one pixel
     * @param noisePx shift at which half of the change is believed
     */
    static double share(double value, double perPx, double noisePx) {
        double px = value / perPx;
        return shareOf(px * px, px * px + noisePx * noisePx);
    }

    /**
     * How far a change is real, 0 to 1, by what the metric gains; half where that is {@code sigmas} standard
     * deviations.
     */
    static double byGain(double gain, double sigmas, double metric) {
        return shareOf(gain * gain, gain * gain + sigmas * sigmas * Math.max(1, metric));
    }

    /**
     * Shift that may be noise: a part that remains for many events, and the part of one event, divided by their number.
     */
    static double noisePx(double ofMany, double ofOne, int events) {
        double byFewness = ofOne / Math.max(1, events);
        return Math.sqrt(ofMany * ofMany + byFewness * byFewness);
    }

    /**
     * A change, updated by a new measurement of it.
     *
     * @param share least share of the difference that is adopted; more is adopted the farther the difference exceeds
     *     noise
     * @param newsPx shift of the ends of the window by the difference at which half of the rest is adopted, too
     */
    static double taken(double before, double measured, double share, double perPx, double newsPx) {
        return before + (share + (1 - share) * share(measured - before, perPx, newsPx)) * (measured - before);
    }

    /** A part as a share of the whole; 0 where the whole is 0. */
    private static double shareOf(double part, double whole) {
        return whole > 0 ? part / whole : 0;
    }
}
