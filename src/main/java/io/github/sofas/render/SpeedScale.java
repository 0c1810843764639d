package io.github.sofas.render;

import java.util.Arrays;

/** The speed that the full colour stands for: a given one, or one that follows what is seen, upwards only. */
final class SpeedScale {
    /** Speeds that it may be, px/s. */
    private static final int[] SPEEDS = {1, 2, 5, 10, 20, 50, 100, 200, 500, 1000, 2000, 5000, 10_000, 20_000, 50_000,
        100_000};
    private static final int FIRST = 20;
    /** What a picture's speeds count for after the next one. */
    private static final double FADING = 0.95;
    /** Share of the pixels that are not to be faster. */
    private static final double MOST = 0.9;
    /** Fewer pixels say nothing. */
    private static final int LEAST_PIXELS = 12;

    private final boolean isGiven;
    private double fullPxPerS;
    /** How many pixels of this picture are as fast as each of {@link #SPEEDS}. */
    private final int[] speeds = new int[SPEEDS.length];
    /** The same of the last pictures, each of which counts less than the one after it. */
    private final double[] recentSpeeds = new double[SPEEDS.length];

    /** Makes a scale of a given speed in px/s; 0 for one that follows. */
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

    /** Lets the full colour stand for the speed that nine tenths of the pixels do not pass, of the last pictures. */
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
