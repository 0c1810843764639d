package io.github.sofas.flow.motion;

/**
 * Probabilities of what noise does by chance.
 *
 * <p>Where m noise events are expected, the probability of at least one is taken as m / (1 + m). That is a little less
 * than the 1 - exp(-m) of a Poisson process: by a tenth for m = 0.25 and by a fifth for m = 0.75. In return, it is the
 * same on every machine.
 */
public final class Chance {
    private Chance() {
    }

    /** Probability, from 0 to 1, of at least one noise event where so many are expected. */
    public static double share(double expected) {
        return expected / (1 + expected);
    }

    /**
     * Count that so many independent parts together seldom exceed.
     *
     * @param mean mean count of one part
     * @param square mean of the square of that count
     * @param sigmas standard deviations by which the result lies above the mean of all parts together
     */
    public static double most(int parts, double mean, double square, double sigmas) {
        return parts * mean + sigmas * Math.sqrt(parts * (square - mean * mean));
    }
}
