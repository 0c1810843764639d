package io.github.sofas.baseline;

/**
 * Drops velocities far above the running mean speed, as jAER's flow filters do by default: mean = 0.999 mean + 0.001
 * speed over all events that were looked at, those without flow with speed 0; dropped where speed &gt; 2 mean. The mean
 * begins at 0, so that the first several hundred events go without flow.
 */
final class SpeedControl {
    private static final double MIXING = 1e-3;
    private static final double EXCESS_FACTOR = 2;

    private final boolean enabled;
    private double meanPxPerS;

    SpeedControl(boolean enabled) {
        this.enabled = enabled;
    }

    boolean accepts(double speedPxPerS) {
        if (!enabled) {
            return true;
        }
        meanPxPerS = (1 - MIXING) * meanPxPerS + MIXING * speedPxPerS;
        return speedPxPerS <= EXCESS_FACTOR * meanPxPerS;
    }

    void reset() {
        meanPxPerS = 0;
    }
}
