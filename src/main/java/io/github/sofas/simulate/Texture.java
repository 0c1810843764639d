package io.github.sofas.simulate;

import java.util.Random;

/**
 * Log intensity of a painted surface, as visible through the optical blur. The texture repeats itself, so that it
 * covers a plane of any size.
 */
final class Texture {
    private static final int TEXELS_PER_PX = 2;

    private final int side;
    private final float[] logLight;

    /**
     * Makes a texture with a mean of 0.
     *
     * @param surface the material
     * @param sidePx distance after which the texture repeats itself, in px; a power of two
     * @param sd standard deviation of the log intensity
     * @param grainPx size of the smallest structure, in px
     * @param blurPx standard deviation of the optical blur in px
     */
    Texture(Surface surface, int sidePx, double sd, double grainPx, double blurPx, Random random) {
        side = sidePx * TEXELS_PER_PX;
        logLight = Tile.blurred(surface.paint(side, grainPx * TEXELS_PER_PX, random), side, blurPx * TEXELS_PER_PX);
        Tile.scale(logLight, sd);
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
