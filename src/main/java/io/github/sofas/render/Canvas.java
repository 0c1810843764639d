package io.github.sofas.render;

import java.awt.Graphics2D;
import java.awt.Rectangle;
import java.awt.RenderingHints;
import java.awt.image.BufferedImage;
import java.awt.image.DataBufferInt;
import java.util.Arrays;

/**
 * A picture in front of a fixed ground. The canvas records where the picture is painted, so that {@link #wipe} restores
 * the ground there and nowhere else.
 *
 * <p>{@link #fill}, {@link #blend} and {@link #stamp} paint the picture. To paint the ground, draw on the image itself
 * and call {@link #keepAsGround}.
 *
 * <p>The record is kept for strips of 16 pixels of a row and costs about one store per pixel painted.
 */
final class Canvas {
    /** Length of a strip in pixels. */
    static final int SIDE = 16;
    private static final int SHIFT = 4;
    private static final int OPAQUE = 256;

    private final BufferedImage image;
    private final int width;
    private final int[] pixels;
    private final int[] ground;
    /** Whether each strip was painted on since the last wipe. */
    private final boolean[] painted;

    /** Makes a black canvas whose ground is still to be painted. The width must be a multiple of 16. */
    Canvas(int width, int height) {
        this.width = width;
        image = new BufferedImage(width, height, BufferedImage.TYPE_INT_RGB);
        pixels = ((DataBufferInt) image.getRaster().getDataBuffer()).getData();
        ground = new int[pixels.length];
        painted = new boolean[pixels.length / SIDE];
    }

    /** Returns a graphics context that draws on any image with smooth edges. */
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

    /** Takes the present picture as the ground. */
    void keepAsGround() {
        System.arraycopy(pixels, 0, ground, 0, pixels.length);
        Arrays.fill(painted, false);
    }

    /** Begins a new picture: restores the ground. */
    void wipe() {
        for (int strip = 0; strip < painted.length; strip++) {
            if (painted[strip]) {
                painted[strip] = false;
                System.arraycopy(ground, strip << SHIFT, pixels, strip << SHIFT, SIDE);
            }
        }
    }

    /** Paints a square, given by the index of its top left pixel. Its side must be at most {@link #SIDE}. */
    void fill(int first, int side, int rgb) {
        for (int row = 0, from = first; row < side; row++, from += width) {
            painted[from >> SHIFT] = true;
            painted[from + side - 1 >> SHIFT] = true;
            // so few pixels that calls to fill an array would take longer
            for (int i = from; i < from + side; i++) {
                pixels[i] = rgb;
            }
        }
    }

    /** Mixes a colour into a pixel, with a weight of {@code share} / 256. */
    void blend(int at, int rgb, int share) {
        painted[at >> SHIFT] = true;
        int below = pixels[at];
        int redBlue = (below & 0xFF00FF) * (OPAQUE - share) + (rgb & 0xFF00FF) * share >>> 8;
        int green = (below & 0xFF00) * (OPAQUE - share) + (rgb & 0xFF00) * share >>> 8;
        pixels[at] = redBlue & 0xFF00FF | green & 0xFF00;
    }

    /** Paints an image with transparency (ARGB), clipped to a part of the picture. */
    void stamp(BufferedImage stamp, int left, int top, Rectangle part) {
        int[] colours = ((DataBufferInt) stamp.getRaster().getDataBuffer()).getData();
        int endX = Math.min(left + stamp.getWidth(), part.x + part.width);
        int endY = Math.min(top + stamp.getHeight(), part.y + part.height);
        for (int y = Math.max(top, part.y); y < endY; y++) {
            for (int x = Math.max(left, part.x); x < endX; x++) {
                int argb = colours[(y - top) * stamp.getWidth() + x - left];
                if (argb >>> 24 != 0) {
                    // alpha 255 is the whole share, 256
                    blend(y * width + x, argb & 0xFFFFFF, (argb >>> 24) + (argb >>> 31));
                }
            }
        }
    }
}
