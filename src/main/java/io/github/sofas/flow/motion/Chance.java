package io.github.sofas.flow.motion;

/**
 * What noise does by chance.
 *
 * <p>How often there is noise of which m events are expected is taken for m / (1 + m): a little less than the
 * 1 - exp(-m) of a Poisson process, by a tenth where m is 0.25 and a fifth where it is 0.75, and the same on each
 * machine.
 */
public final class Chance {
    private Chance() {
    }

    /** How often there is noise of which so many events are expected, of 1. */
    public static double share(double expected) {
        return expected / (1 + expected);
    }

    /**
     * What so many parts of which each counts for itself seldom pass together.
     *
     * @param mean of what a part counts
     * @param square mean of its square
     * @param sigmas standard deviations over the mean of all parts
     */
    public static double most(int parts, double mean, double square, double sigmas) {
        return parts * mean + sigmas * Math.sqrt(parts * (square - mean * mean));
    }
}
