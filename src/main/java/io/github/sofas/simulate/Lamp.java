package io.github.sofas.simulate;

import io.github.sofas.event.SensorSize;
import java.util.Arrays;
import java.util.Random;

/**
 * A lamp that flickers over a still scene: the log intensity of the pixels that the lamp lights follows a sine. The
 * lamp lights a round part of the picture, most in the middle, and each surface there according to its orientation.
 */
final class Lamp {
    /** Twice the frequency of Europe's mains. */
    private static final double HZ = 100;
    private static final double LEAST_TURNED = 0.3;
    /** Least swing of a lit pixel: a smaller one does not matter to any pixel. */
    private static final double LEAST_SWING = 0.01;

    private final int[] pixels;
    private final double[] swings;

    /**
     * Makes a lamp.
     *
     * @param radiusPx distance at which the swing has fallen to 1 / e
     * @param swing greatest change of the log intensity from its mean
     */
    Lamp(SensorSize sensor, double midX, double midY, double radiusPx, double swing, Random random) {
        Texture surfaces = new Texture(Surface.LEAVES, 256, 0.3, 6, 0.7, random);
        int[] lit = new int[sensor.width() * sensor.height()];
        double[] swingOf = new double[lit.length];
        int count = 0;
        for (int y = 0, pixel = 0; y < sensor.height(); y++) {
            for (int x = 0; x < sensor.width(); x++, pixel++) {
                double away = ((x - midX) * (x - midX) + (y - midY) * (y - midY)) / (radiusPx * radiusPx);
                double turned = Math.max(LEAST_TURNED, Math.min(1, 0.7 + surfaces.logLightAt(x, y)));
                double of = swing * StrictMath.exp(-away) * turned;
                if (of > LEAST_SWING) {
                    lit[count] = pixel;
                    swingOf[count++] = of;
                }
            }
        }
        pixels = Arrays.copyOf(lit, count);
        swings = Arrays.copyOf(swingOf, count);
    }

    /** Period of the flicker in s. */
    static double periodS() {
        return 1 / HZ;
    }

    /** The pixels that the lamp lights. */
    int[] pixels() {
        return pixels;
    }

    /** Log intensity of the i-th lit pixel, relative to its mean. */
    double logLight(int i, double timeS) {
        return swings[i] * StrictMath.sin(2 * Math.PI * HZ * timeS);
    }
}
