package io.github.sofas.simulate;

import java.util.Random;

/**
 * A surface like those of everyday things, as log intensity: leaves of random grey that hide each other, of sizes with
 * a density that falls with the third power, as far as the blur lets them be seen (Lee, Mumford, Huang, "Occlusion
 * models for natural images", International Journal of Computer Vision, 2001). It has edges of every direction and
 * length, and even patches between them. It repeats itself.
 */
final class Texture {
    private static final int TEXELS_PER_PX = 2;
    private static final double LARGEST_LEAF = 14;
    /** What is bare after so many leaves, in texels each, is a leaf of its own. */
    private static final int TEXELS_PER_LEAF = 8;

    private final int side;
    private final float[] logLight;

    /**
     * Makes one with a mean of 0.
     *
     * @param sidePx after how many px it repeats itself, a power of two
     * @param sd standard deviation of the log intensity
     * @param leafPx radius of the smallest leaves in px; the largest have {@value #LARGEST_LEAF} times that
     * @param blurPx standard deviation of the optical blur in px
     */
    Texture(int sidePx, double sd, double leafPx, double blurPx, Random random) {
        side = sidePx * TEXELS_PER_PX;
        float[] leaves = leaves(leafPx * TEXELS_PER_PX, random);
        logLight = transposedBlur(transposedBlur(leaves, blurPx * TEXELS_PER_PX), blurPx * TEXELS_PER_PX);
        double sum = 0;
        double squares = 0;
        for (float value : logLight) {
            sum += value;
            squares += (double) value * value;
        }
        double mean = sum / logLight.length;
        double spread = Math.sqrt(squares / logLight.length - mean * mean);
        for (int i = 0; i < logLight.length; i++) {
            logLight[i] = (float) ((logLight[i] - mean) * sd / spread);
        }
    }

    /** Front to back: a leaf shows where none was before. */
    private float[] leaves(double smallest, Random random) {
        float[] leaves = new float[side * side];
        boolean[] covered = new boolean[side * side];
        double largest = Math.min(smallest * LARGEST_LEAF, side / 4.0);
        double falls = 1 - smallest * smallest / (largest * largest);
        int bare = side * side;
        for (int count = 0; bare > 0 && count < side * side / TEXELS_PER_LEAF; count++) {
            // The inverse of the distribution function of a density that falls with the third power.
            double radius = smallest / Math.sqrt(1 - random.nextDouble() * falls);
            double midX = side * random.nextDouble();
            double midY = side * random.nextDouble();
            double turnedRad = Math.PI * random.nextDouble();
            float grey = (float) random.nextGaussian();
            Shape leaf = count % 2 == 0 ? new Shape.Disc(radius) : new Shape.Box(0, 0, 2.4 * radius, 1.3 * radius);
            bare -= cover(leaves, covered, leaf, midX, midY, turnedRad, grey);
        }
        return leaves;
    }

    private int cover(float[] leaves, boolean[] covered, Shape leaf, double midX, double midY, double turnedRad,
                      float grey) {
        double cos = StrictMath.cos(turnedRad);
        double sin = StrictMath.sin(turnedRad);
        double reach = leaf.radius();
        int more = 0;
        for (int y = (int) Math.floor(midY - reach); y <= midY + reach; y++) {
            for (int x = (int) Math.floor(midX - reach); x <= midX + reach; x++) {
                int texel = (y & side - 1) * side + (x & side - 1);
                if (!covered[texel]) {
                    double dx = x - midX;
                    double dy = y - midY;
                    if (leaf.signedDistance(cos * dx + sin * dy, cos * dy - sin * dx) < 0) {
                        covered[texel] = true;
                        leaves[texel] = grey;
                        more++;
                    }
                }
            }
        }
        return more;
    }

    /** Blurs along the rows and turns rows into columns, so that twice is a whole blur. */
    private float[] transposedBlur(float[] from, double sd) {
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

    /** Log intensity at a point of the surface, in px. */
    double logLightAt(double x, double y) {
        double column = x * TEXELS_PER_PX;
        double row = y * TEXELS_PER_PX;
        int left = (int) Math.floor(column);
        int top = (int) Math.floor(row);
        double shareX = column - left;
        double shareY = row - top;
        int mask = side - 1;
        int upper = (top & mask) * side;
        int lower = (top + 1 & mask) * side;
        int near = left & mask;
        int far = left + 1 & mask;
        double above = logLight[upper + near] + shareX * (logLight[upper + far] - logLight[upper + near]);
        double below = logLight[lower + near] + shareX * (logLight[lower + far] - logLight[lower + near]);
        return above + shareY * (below - above);
    }
}
