package io.github.sofas.simulate;

/**
 * Functions on tiles: square pictures that repeat themselves. The side of a tile is a power of two, and its texels are
 * stored row by row.
 */
final class Tile {
    private Tile() {
    }

    /**
     * {@return the tile blurred by a Gaussian}
     *
     * @param sd standard deviation of the Gaussian, in texels
     */
    static float[] blurred(float[] texels, int side, double sd) {
        return transposedBlur(transposedBlur(texels, side, sd), side, sd);
    }

    /** Blurs along the rows and turns rows into columns, so that two calls make a whole blur. */
    private static float[] transposedBlur(float[] from, int side, double sd) {
        int radius = (int) Math.ceil(4 * sd);
        double[] weights = new double[2 * radius + 1];
        double sum = 0;
        for (int i = -radius; i <= radius; i++) {
            weights[i + radius] = StrictMath.exp(-i * i / (2 * sd * sd));
            sum += weights[i + radius];
        }
        float[] to = new float[side * side];
        for (int y = 0; y < side; y++) {
            for (int x = 0; x < side; x++) {
                double value = 0;
                for (int i = -radius; i <= radius; i++) {
                    value += weights[i + radius] * from[y * side + (x + i & side - 1)];
                }
                to[x * side + y] = (float) (value / sum);
            }
        }
        return to;
    }

    /** Shifts and scales a tile to a mean of 0 and the given standard deviation. */
    static void scale(float[] texels, double sd) {
        double sum = 0;
        double squares = 0;
        for (float value : texels) {
            sum += value;
            squares += (double) value * value;
        }
        double mean = sum / texels.length;
        double spread = Math.sqrt(squares / texels.length - mean * mean);
        for (int i = 0; i < texels.length; i++) {
            texels[i] = (float) ((texels[i] - mean) * sd / spread);
        }
    }
}
