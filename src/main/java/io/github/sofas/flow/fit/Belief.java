package io.github.sofas.flow.fit;

/** How far a change of a motion, as it was measured, is believed, and how much of a new one is taken over. */
final class Belief {
    private Belief() {
    }

    /** A change that shifts the ends of the window by no more than the noise is none. */
    static double in(double value, double perPx, double noisePx) {
        return value * share(value, perPx, noisePx);
    }

    /**
     * How far a change is real, 0 to 1, by what it shifts the ends of the window by.
     *
     * @param perPx what shifts them by one pixel
     * @param noisePx shift at which half of it is believed
     */
    static double share(double value, double perPx, double noisePx) {
        double px = value / perPx;
        return shareOf(px * px, px * px + noisePx * noisePx);
    }

    /** How far a change is real, 0 to 1, that gains so much of the metric; half where that is so many deviations. */
    static double byGain(double gain, double sigmas, double metric) {
        return shareOf(gain * gain, gain * gain + sigmas * sigmas * Math.max(1, metric));
    }

    /** Shift that may be noise: what many events have in common, and what one has, the less the more there are. */
    static double noisePx(double ofMany, double ofOne, int events) {
        double byFewness = ofOne / Math.max(1, events);
        return Math.sqrt(ofMany * ofMany + byFewness * byFewness);
    }

    /**
     * A change with a new measurement of it.
     *
     * @param share of the new one that is taken over at least, the more the farther it is from what noise could be
     * @param newsPx shift of the ends of the window by the difference at which half of the rest is, too
     */
    static double taken(double before, double measured, double share, double perPx, double newsPx) {
        return before + (share + (1 - share) * share(measured - before, perPx, newsPx)) * (measured - before);
    }

    /** A share of what is known; where nothing is known, none. */
    private static double shareOf(double part, double whole) {
        return whole > 0 ? part / whole : 0;
    }
}
