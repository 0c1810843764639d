package io.github.sofas.render;

import java.util.Arrays;

/**
 * The speed for which the full colour stands. The speed is either given, or follows the speeds in the pictures, upwards
 * only.
 */
final class SpeedScale {
    /** Speeds to choose from, px/s. */
    private static final int[] SPEEDS = {1, 2, 5, 10, 20, 50, 100, 200, 500, 1000, 2000, 5000, 10_000, 20_000, 50_000,
        100_000};
    private static final int FIRST = 20;
    /** Factor by which the weight of a picture's speeds falls with each later picture. */
    private static final double FADING = 0.95;
    /** Share of the pixels that must not be faster than the full colour. */
    private static final double MOST = 0.9;
    /** Fewest pixels from which a speed is derived. */
    private static final int LEAST_PIXELS = 12;

    private final boolean isGiven;
    private double fullPxPerS;
    /**
     * Number of pixels of this picture by speed: entry k counts those up to speed k of {@link #SPEEDS} and above the
     * one before.
     */
    private final int[] speeds = new int[SPEEDS.length];
    /** The same for the recent pictures, each with less weight than the one after it. */
    private final double[] recentSpeeds = new double[SPEEDS.length];

    /** Makes a scale with a given speed in px/s, or with 0 one that follows the pictures. */
    SpeedScale(double givenPxPerS) {
        isGiven = givenPxPerS > 0;
        fullPxPerS = isGiven ? givenPxPerS : FIRST;
    }

    /** The speed of the full colour, px/s. */
    double fullPxPerS() {
        return fullPxPerS;
    }

    /** Begins a picture. */
    void clear() {
        Arrays.fill(speeds, 0);
    }

    /** Adds a pixel of the picture. */
    void add(float vxPxPerS, float vyPxPerS) {
        float square = vxPxPerS * vxPxPerS + vyPxPerS * vyPxPerS;
        int k = 0;
        while (k < SPEEDS.length - 1 && SPEEDS[k] * (float) SPEEDS[k] < square) {
            k++;
        }
        speeds[k]++;
    }

    /**
     * Raises the speed of the full colour, if necessary, to the one that nine tenths of the pixels of the recent
     * pictures do not exceed.
     */
    void follow() {
        double withFlow = 0;
        for (int k = 0; k < speeds.length; k++) {
            recentSpeeds[k] = FADING * recentSpeeds[k] + speeds[k];
            withFlow += recentSpeeds[k];
        }
        if (!isGiven && withFlow >= LEAST_PIXELS) {
            double below = 0;
            int k = 0;
            while (k < SPEEDS.length - 1 && below + recentSpeeds[k] < MOST * withFlow) {
                below += recentSpeeds[k++];
            }
            fullPxPerS = Math.max(fullPxPerS, SPEEDS[k]);
        }
    }
}
