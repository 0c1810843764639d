package io.github.sofas.simulate;

import java.util.Random;

/**
 * Paints a tile with leaves of random grey that hide each other. The density of their sizes falls with the third
 * power; half of them are discs and half are boxes (Lee, Mumford, Huang, "Occlusion models for natural images",
 * International Journal of Computer Vision, 2001). The leaves have edges of every direction and length, and even
 * patches between the edges.
 */
final class Leaves {
    private static final double LARGEST_LEAF = 14;
    /** At most one leaf falls per this number of texels. The area that is still bare then is a leaf of its own. */
    private static final int TEXELS_PER_LEAF = 8;

    private final int side;
    private final float[] greys;
    private final boolean[] covered;

    private Leaves(int side) {
        this.side = side;
        greys = new float[side * side];
        covered = new boolean[side * side];
    }

    /**
     * {@return a tile of leaves, painted front to back: a leaf shows where no leaf was before}
     *
     * @param smallest radius of the smallest leaves in texels; the largest are {@value #LARGEST_LEAF} times as large
     */
    static float[] tile(int side, double smallest, Random random) {
        Leaves leaves = new Leaves(side);
        leaves.fall(smallest, random);
        return leaves.greys;
    }

    private void fall(double smallest, Random random) {
        double largest = Math.min(smallest * LARGEST_LEAF, side / 4.0);
        double falls = 1 - smallest * smallest / (largest * largest);
        int bare = side * side;
        for (int count = 0; bare > 0 && count < side * side / TEXELS_PER_LEAF; count++) {
            // The inverse of the distribution function whose density falls with the third power.
            double radius = smallest / Math.sqrt(1 - random.nextDouble() * falls);
            double midX = side * random.nextDouble();
            double midY = side * random.nextDouble();
            double turnedRad = Math.PI * random.nextDouble();
            float grey = (float) random.nextGaussian();
            Shape leaf = count % 2 == 0 ? new Shape.Disc(radius) : new Shape.Box(0, 0, 2.4 * radius, 1.3 * radius);
            bare -= cover(leaf, midX, midY, turnedRad, grey);
        }
    }

    /** {@return the number of bare texels that the leaf covers} */
    private int cover(Shape leaf, double midX, double midY, double turnedRad, float grey) {
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
                        greys[texel] = grey;
                        more++;
                    }
                }
            }
        }
        return more;
    }
}
