package io.github.sofas.simulate;

/** Pictures as wide as high, a power of two, that repeat themselves: their texels by rows, row by row. */
final class Tile {
    private Tile() {
    }

    /**
     * {@return one blurred by a Gaussian}
     *
     * @param sd of the Gaussian, in texels
     */
    static float[] blurred(float[] texels, int side, double sd) {
        return transposedBlur(transposedBlur(texels, side, sd), side, sd);
    }

    /** Blurs along the rows and turns rows into columns, so that twice is a whole blur. */
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

    /** Shifts and scales one to a mean of 0 and a standard deviation. */
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
