package io.github.sofas.simulate;

import java.util.Arrays;
import java.util.Optional;
import java.util.Random;
import java.util.stream.Collectors;

/**
 * What walls and textured objects are made of. How well a velocity can be known depends on it: edges show it best, what
 * is smooth least.
 */
public enum Surface {
    /**
     * Leaves of random grey that hide each other, as those of everyday things (Lee, Mumford, Huang 2001): edges of
     * every direction and length, and even patches between them.
     */
    LEAVES("leaves") {
        @Override
        float[] paint(int side, double grain, Random random) {
            return Leaves.tile(side, grain, random);
        }
    },
    /** Gaussian noise blurred by a Gaussian: no edges, and nothing is even. */
    SMOOTH("smooth") {
        @Override
        float[] paint(int side, double grain, Random random) {
            return Tile.blurred(noise(side, random), side, Math.min(grain, largest(side)));
        }
    },
    /**
     * Noise whose amplitude falls with the frequency, as that of photographs (Field, "Relations between the statistics
     * of natural images and the response properties of cortical cells", Journal of the Optical Society of America A,
     * 1987): as much of each octave of sizes. Few edges, most of them faint.
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

    /** {@return the name that users call it by, in lower case} */
    public String surfaceName() {
        return surfaceName;
    }

    /**
     * {@return the surface of a name, if there is one}
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
     * {@return the light of a tile of so many texels by as many, of any mean and spread}
     *
     * @param grain size of the smallest that it shows, in texels: the radius of leaves, the standard deviation of blurs
     */
    abstract float[] paint(int side, double grain, Random random);

    /** Largest standard deviation of a blur, in texels: more would leave nothing of what is repeated. */
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
