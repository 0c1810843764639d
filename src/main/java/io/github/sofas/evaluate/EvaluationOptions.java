package io.github.sofas.evaluate;

/**
 * Options that determine which events an {@link Evaluation} counts, and how it cuts time into windows and bins.
 *
 * @param skipFirstShare share of the recording's time, from its first event, that is left out of the flow, noise and
 *     segmentation figures, 0 to below 1. jAER drops the first eight estimates instead, which depends on the event rate
 * @param windowUs length of the windows of the segmentation figures in µs, positive
 * @param convergenceBinUs length of the bins of time since appearance in µs, positive
 * @param convergenceBins how many such bins, at least 1
 */
public record EvaluationOptions(double skipFirstShare, long windowUs, long convergenceBinUs, int convergenceBins) {
    /** Share that is left out by default, while the objects are still entering the view. */
    public static final double DEFAULT_SKIP_FIRST_SHARE = 0.15;
    /** Segmentation figures use windows of 50 ms by default. */
    public static final long DEFAULT_WINDOW_US = 50_000;
    /** Convergence is shown in bins of 20 ms by default. */
    public static final long DEFAULT_CONVERGENCE_BIN_US = 20_000;
    /** The default bins cover the first second after an object appears. */
    public static final int DEFAULT_CONVERGENCE_BINS = 50;

    /**
     * Checks the components.
     *
     * @param skipFirstShare share of the recording's time, from its first event, that is left out of the flow, noise
     *     and segmentation figures, 0 to below 1. jAER drops the first eight estimates instead, which depends on the
     *     event rate
     * @param windowUs length of the windows of the segmentation figures in µs, positive
     * @param convergenceBinUs length of the bins of time since appearance in µs, positive
     * @param convergenceBins how many such bins, at least 1
     * @throws IllegalArgumentException if a component is outside its range
     */
    public EvaluationOptions {
        if (!(skipFirstShare >= 0 && skipFirstShare < 1)) {
            throw new IllegalArgumentException("skipFirstShare must be at least 0 and below 1 but was "
                    + skipFirstShare);
        }
        if (windowUs <= 0) {
            throw new IllegalArgumentException("windowUs must be positive but was " + windowUs);
        }
        if (convergenceBinUs <= 0) {
            throw new IllegalArgumentException("convergenceBinUs must be positive but was " + convergenceBinUs);
        }
        if (convergenceBins < 1) {
            throw new IllegalArgumentException("convergenceBins must be at least 1 but was " + convergenceBins);
        }
    }

    /** {@return the documented defaults} */
    public static EvaluationOptions defaults() {
        return new EvaluationOptions(DEFAULT_SKIP_FIRST_SHARE, DEFAULT_WINDOW_US, DEFAULT_CONVERGENCE_BIN_US,
                DEFAULT_CONVERGENCE_BINS);
    }

    /**
     * {@return the same options with another share left out}
     *
     * @param share share of the recording's time, 0 to below 1
     */
    public EvaluationOptions withSkipFirstShare(double share) {
        return new EvaluationOptions(share, windowUs, convergenceBinUs, convergenceBins);
    }
}
