package io.github.sofas.render;

import java.awt.Graphics2D;
import java.awt.Rectangle;
import java.awt.RenderingHints;
import java.awt.image.BufferedImage;
import java.awt.image.DataBufferInt;
import java.util.Arrays;

/**
 * A picture whose ground stays: what is painted on it is remembered, and wiped off by copying the ground there. Painted
 * is what has been through {@link #fill}, {@link #blend} or {@link #stamp}; whoever paints the image itself paints the
 * ground, which {@link #keepAsGround} takes.
 *
 * <p>Strips of 16 pixels of a row are remembered, one store per pixel.
 */
final class Canvas {
    /** Pixels of a strip. */
    static final int SIDE = 16;
    private static final int SHIFT = 4;
    private static final int OPAQUE = 256;

    private final BufferedImage image;
    private final int width;
    private final int[] pixels;
    private final int[] ground;
    /** Whether a strip was painted on since it was wiped. */
    private final boolean[] painted;

    /** Makes a black canvas, with a ground to be painted; its width must be a multiple of 16. */
    Canvas(int width, int height) {
        this.width = width;
        image = new BufferedImage(width, height, BufferedImage.TYPE_INT_RGB);
        pixels = ((DataBufferInt) image.getRaster().getDataBuffer()).getData();
        ground = new int[pixels.length];
        painted = new boolean[pixels.length / SIDE];
    }

    /** Draws on any image with smooth edges. */
    static Graphics2D graphics(BufferedImage image) {
        Graphics2D g = image.createGraphics();
        g.setRenderingHint(RenderingHints.KEY_ANTIALIASING, RenderingHints.VALUE_ANTIALIAS_ON);
        g.setRenderingHint(RenderingHints.KEY_TEXT_ANTIALIASING, RenderingHints.VALUE_TEXT_ANTIALIAS_ON);
        return g;
    }

    BufferedImage image() {
        return image;
    }

    int width() {
        return width;
    }

    /** Takes the picture as it is for the ground. */
    void keepAsGround() {
        System.arraycopy(pixels, 0, ground, 0, pixels.length);
        Arrays.fill(painted, false);
    }

    /** Begins a picture: the ground is all that is left. */
    void wipe() {
        for (int strip = 0; strip < painted.length; strip++) {
            if (painted[strip]) {
                painted[strip] = false;
                System.arraycopy(ground, strip << SHIFT, pixels, strip << SHIFT, SIDE);
            }
        }
    }

    /** Paints a square, given by its first pixel and no larger than a strip is long. */
    void fill(int first, int side, int rgb) {
        for (int row = 0, from = first; row < side; row++, from += width) {
            painted[from >> SHIFT] = true;
            painted[from + side - 1 >> SHIFT] = true;
            // a few pixels: calls to fill an array would take longer
            for (int i = from; i < from + side; i++) {
                pixels[i] = rgb;
            }
        }
    }

    /** Mixes a colour into a pixel, by a share of 256. */
    void blend(int at, int rgb, int share) {
        painted[at >> SHIFT] = true;
        int below = pixels[at];
        int redBlue = (below & 0xFF00FF) * (OPAQUE - share) + (rgb & 0xFF00FF) * share >>> 8;
        int green = (below & 0xFF00) * (OPAQUE - share) + (rgb & 0xFF00) * share >>> 8;
        pixels[at] = redBlue & 0xFF00FF | green & 0xFF00;
    }

    /** Paints an image with transparency (ARGB) where it lies in a part of the picture. */
    void stamp(BufferedImage stamp, int left, int top, Rectangle part) {
        int[] colours = ((DataBufferInt) stamp.getRaster().getDataBuffer()).getData();
        int endX = Math.min(left + stamp.getWidth(), part.x + part.width);
        int endY = Math.min(top + stamp.getHeight(), part.y + part.height);
        for (int y = Math.max(top, part.y); y < endY; y++) {
            for (int x = Math.max(left, part.x); x < endX; x++) {
                int argb = colours[(y - top) * stamp.getWidth() + x - left];
                if (argb >>> 24 != 0) {
                    // 255 is all of it
                    blend(y * width + x, argb & 0xFFFFFF, (argb >>> 24) + (argb >>> 31));
                }
            }
        }
    }
}
