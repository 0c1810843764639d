package io.github.sofas.simulate;

import java.util.Arrays;
import java.util.Optional;
import java.util.Random;
import java.util.stream.Collectors;

/**
 * The material of walls and textured objects. The material determines how well a velocity can be known: edges show the
 * velocity best, smooth surfaces least.
 */
public enum Surface {
    /**
     * Leaves of random grey that hide each other, as everyday objects do (Lee, Mumford, Huang 2001): edges of every
     * direction and length, and even patches between them.
     */
    LEAVES("leaves") {
        @Override
        float[] paint(int side, double grain, Random random) {
            return Leaves.tile(side, grain, random);
        }
    },
    /** Gaussian noise blurred by a Gaussian: no edges, and no even patches. */
    SMOOTH("smooth") {
        @Override
        float[] paint(int side, double grain, Random random) {
            return Tile.blurred(noise(side, random), side, Math.min(grain, largest(side)));
        }
    },
    /**
     * Noise whose amplitude falls with the frequency, as in photographs (Field, "Relations between the statistics of
     * natural images and the response properties of cortical cells", Journal of the Optical Society of America A,
     * 1987): each octave of sizes contributes equally. There are few edges, most of them faint.
     */
    FRACTAL("fractal") {
        @Override
        float[] paint(int side, double grain, Random random) {
            float[] sum = new float[side * side];
            for (double size = Math.min(grain / 2, largest(side)); size <= largest(side); size *= 2) {
                float[] octave = Tile.blurred(noise(side, random), side, size);
                Tile.scale(octave, 1);
                for (int i = 0; i < sum.length; i++) {
                    sum[i] += octave[i];
                }
            }
            return sum;
        }
    };

    private final String surfaceName;

    Surface(String surfaceName) {
        this.surfaceName = surfaceName;
    }

    /** {@return the name of the surface for users, in lower case} */
    public String surfaceName() {
        return surfaceName;
    }

    /**
     * {@return the surface with a name, if there is one}
     *
     * @param name in lower case
     */
    public static Optional<Surface> named(String name) {
        return Arrays.stream(values()).filter(surface -> surface.surfaceName.equals(name)).findFirst();
    }

    /** {@return all names, separated by commas, for messages} */
    public static String names() {
        return Arrays.stream(values()).map(Surface::surfaceName).collect(Collectors.joining(", "));
    }

    /**
     * {@return the light of a square tile with the given side in texels, of any mean and spread}
     *
     * @param grain size of the smallest structure, in texels: the radius of leaves, the standard deviation of blurs
     */
    abstract float[] paint(int side, double grain, Random random);

    /** Largest standard deviation of a blur, in texels: a larger one would leave nothing of a tile that is repeated. */
    private static double largest(int side) {
        return side / 8.0;
    }

    private static float[] noise(int side, Random random) {
        float[] noise = new float[side * side];
        for (int i = 0; i < noise.length; i++) {
            noise[i] = (float) random.nextGaussian();
        }
        return noise;
    }
}
