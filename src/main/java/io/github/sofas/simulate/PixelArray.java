package io.github.sofas.simulate;

import java.util.Arrays;
import java.util.Random;

/**
 * The pixels of the camera. The array keeps the log intensity that each pixel remembers, and determines when a change
 * of light makes a pixel fire.
 */
final class PixelArray {
    /** Receives each event at the moment at which the threshold is crossed, before any latency. */
    interface Crossing {
        void crossed(int pixel, double timeUs, int polarity);
    }

    private static final double SMALLEST_SHARE_OF_THRESHOLD = 0.2;
    private static final double NOT_BLIND = -1;

    private final double refractoryUs;
    private final double[] onThreshold;
    private final double[] offThreshold;
    /** Log intensity now. */
    private final double[] logLight;
    /** Log intensity that the pixel compares the light with. */
    private final double[] remembered;
    /** When the pixel sees again after an event and remembers the light; {@link #NOT_BLIND} if the pixel sees now. */
    private final double[] blindUntilUs;

    PixelArray(int pixels, DvsModel model, Random random) {
        refractoryUs = model.refractoryUs();
        onThreshold = thresholds(pixels, model.onThreshold(), model.mismatchSd(), random);
        offThreshold = thresholds(pixels, model.offThreshold(), model.mismatchSd(), random);
        logLight = new double[pixels];
        remembered = new double[pixels];
        blindUntilUs = new double[pixels];
    }

    private static double[] thresholds(int pixels, double nominal, double sd, Random random) {
        double[] thresholds = new double[pixels];
        for (int i = 0; i < pixels; i++) {
            double off = sd == 0 ? 0 : sd * random.nextGaussian();
            thresholds[i] = Math.max(nominal * SMALLEST_SHARE_OF_THRESHOLD, nominal + off);
        }
        return thresholds;
    }

    /** Makes every pixel see and remember the given light, without an event. */
    void restart(double[] light) {
        for (int i = 0; i < light.length; i++) {
            logLight[i] = StrictMath.log(light[i]);
        }
        System.arraycopy(logLight, 0, remembered, 0, light.length);
        Arrays.fill(blindUntilUs, NOT_BLIND);
    }

    /** Moves the log intensity of one pixel linearly to a new value and reports each crossing of a threshold. */
    void change(int pixel, double newLogLight, double fromUs, double toUs, Crossing listener) {
        double start = logLight[pixel];
        double perUs = (newLogLight - start) / (toUs - fromUs);
        logLight[pixel] = newLogLight;
        if (!awake(pixel, start, perUs, fromUs, toUs)) {
            return;
        }
        int polarity = perUs > 0 ? 1 : -1;
        double step = perUs > 0 ? onThreshold[pixel] : -offThreshold[pixel];
        double level = remembered[pixel] + step;
        while ((newLogLight - level) * polarity >= 0) {
            double timeUs = Math.min(toUs, fromUs + (level - start) / perUs);
            listener.crossed(pixel, timeUs, polarity);
            double blindUs = timeUs + refractoryUs;
            if (blindUs >= toUs) {
                blindUntilUs[pixel] = blindUs;
                return;
            }
            // Without refractory time, take exactly the level, so that no rounding error accumulates.
            remembered[pixel] = refractoryUs == 0 ? level : start + perUs * (blindUs - fromUs);
            level = remembered[pixel] + step;
        }
    }

    /** Fires an event that the light did not cause, and makes the pixel blind; false if it is blind already. */
    boolean fireUnprompted(int pixel, double timeUs) {
        if (blindUntilUs[pixel] > timeUs) {
            return false;
        }
        blindUntilUs[pixel] = timeUs + refractoryUs;
        return true;
    }

    private boolean awake(int pixel, double start, double perUs, double fromUs, double toUs) {
        double blindUs = blindUntilUs[pixel];
        if (blindUs == NOT_BLIND) {
            return true;
        }
        if (blindUs >= toUs) {
            return false;
        }
        remembered[pixel] = blindUs > fromUs ? start + perUs * (blindUs - fromUs) : start;
        blindUntilUs[pixel] = NOT_BLIND;
        return true;
    }
}
