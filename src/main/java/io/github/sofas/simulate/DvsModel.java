package io.github.sofas.simulate;

/**
 * The threshold model by which a pixel turns light into events, including noise and other flaws. A pixel remembers the
 * logarithm of the light at its last event, and fires when the logarithm has changed by more than a threshold since.
 *
 * @param onThreshold rise of log intensity that makes an ON event, above 0
 * @param offThreshold fall of log intensity that makes an OFF event, above 0
 * @param mismatchSd standard deviation of both thresholds over the pixels, in log intensity; a threshold is never made
 *     smaller than a fifth of its nominal value
 * @param jitterSdUs standard deviation of the latency in µs; the latency is normally distributed with a mean of three
 *     standard deviations, cut off at 0 and at six
 * @param refractoryUs time after an event in which the pixel is blind, in µs; the pixel remembers the light at the end
 *     of that time
 * @param noiseHzPerPx background activity in events per s and pixel, of random polarity
 * @param hotPixels number of pixels that fire by themselves
 * @param hotPixelHz rate at which each hot pixel fires, in Hz, always ON
 */
public record DvsModel(double onThreshold, double offThreshold, double mismatchSd, double jitterSdUs,
                       double refractoryUs, double noiseHzPerPx, int hotPixels, double hotPixelHz) {
    /**
     * Checks every component.
     *
     * @param onThreshold rise of log intensity that makes an ON event, above 0
     * @param offThreshold fall of log intensity that makes an OFF event, above 0
     * @param mismatchSd standard deviation of both thresholds over the pixels, in log intensity; a threshold is never
     *     made smaller than a fifth of its nominal value
     * @param jitterSdUs standard deviation of the latency in µs; the latency is normally distributed with a mean of
     *     three standard deviations, cut off at 0 and at six
     * @param refractoryUs time after an event in which the pixel is blind, in µs; the pixel remembers the light at the
     *     end of that time
     * @param noiseHzPerPx background activity in events per s and pixel, of random polarity
     * @param hotPixels number of pixels that fire by themselves
     * @param hotPixelHz rate at which each hot pixel fires, in Hz, always ON
     * @throws IllegalArgumentException if a component is out of range
     */
    public DvsModel {
        requireAbove("onThreshold", onThreshold);
        requireAbove("offThreshold", offThreshold);
        requireNotNegative("mismatchSd", mismatchSd);
        requireNotNegative("jitterSdUs", jitterSdUs);
        requireNotNegative("refractoryUs", refractoryUs);
        requireNotNegative("noiseHzPerPx", noiseHzPerPx);
        requireNotNegative("hotPixels", hotPixels);
        requireNotNegative("hotPixelHz", hotPixelHz);
    }

    /**
     * {@return a model like a DAVIS240C in good light} Thresholds of 0.2 (a change by a fifth) with a mismatch of 0.03,
     * 100 µs of jitter and of refractory time, 0.1 Hz/px of background activity, no hot pixels (they fire at 100 Hz if
     * some are requested).
     */
    public static DvsModel davis() {
        return new DvsModel(0.2, 0.2, 0.03, 100, 100, 0.1, 0, 100);
    }

    /** {@return a sensor without flaws, for results computed by hand: both thresholds 0.2, everything else 0} */
    public static DvsModel ideal() {
        return new DvsModel(0.2, 0.2, 0, 0, 0, 0, 0, 0);
    }

    /**
     * {@return the same model with other thresholds}
     *
     * @param on rise of log intensity that makes an ON event
     * @param off fall of log intensity that makes an OFF event
     */
    public DvsModel withThresholds(double on, double off) {
        return new DvsModel(on, off, mismatchSd, jitterSdUs, refractoryUs, noiseHzPerPx, hotPixels, hotPixelHz);
    }

    /**
     * {@return the same model with another spread of thresholds}
     *
     * @param sd standard deviation of the thresholds
     */
    public DvsModel withMismatchSd(double sd) {
        return new DvsModel(onThreshold, offThreshold, sd, jitterSdUs, refractoryUs, noiseHzPerPx, hotPixels,
                hotPixelHz);
    }

    /**
     * {@return the same model with another spread of latency}
     *
     * @param us standard deviation in µs
     */
    public DvsModel withJitterSdUs(double us) {
        return new DvsModel(onThreshold, offThreshold, mismatchSd, us, refractoryUs, noiseHzPerPx, hotPixels,
                hotPixelHz);
    }

    /**
     * {@return the same model with another refractory time}
     *
     * @param us refractory time in µs
     */
    public DvsModel withRefractoryUs(double us) {
        return new DvsModel(onThreshold, offThreshold, mismatchSd, jitterSdUs, us, noiseHzPerPx, hotPixels,
                hotPixelHz);
    }

    /**
     * {@return the same model with another rate of background activity}
     *
     * @param hz events per second and pixel
     */
    public DvsModel withNoiseHzPerPx(double hz) {
        return new DvsModel(onThreshold, offThreshold, mismatchSd, jitterSdUs, refractoryUs, hz, hotPixels,
                hotPixelHz);
    }

    /**
     * {@return the same model with other hot pixels}
     *
     * @param count number of hot pixels
     * @param hz events per second and hot pixel
     */
    public DvsModel withHotPixels(int count, double hz) {
        return new DvsModel(onThreshold, offThreshold, mismatchSd, jitterSdUs, refractoryUs, noiseHzPerPx, count, hz);
    }

    private static void requireAbove(String name, double value) {
        if (!(value > 0) || Double.isInfinite(value)) {
            throw new IllegalArgumentException(name + " must be positive but was " + value);
        }
    }

    private static void requireNotNegative(String name, double value) {
        if (!(value >= 0) || Double.isInfinite(value)) {
            throw new IllegalArgumentException(name + " must not be negative but was " + value);
        }
    }
}
