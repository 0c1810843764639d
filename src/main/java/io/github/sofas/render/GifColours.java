package io.github.sofas.render;

import java.awt.image.DataBuffer;
import java.awt.image.IndexColorModel;
import java.util.Arrays;

/**
 * The palette of one picture of a GIF: at most 255 colours, and one transparent entry that shows the picture before.
 * Colours count as one if red, green and blue each fall into the same 8 of 256 steps. If there are too many colours,
 * the palette holds the most frequent ones, and the nearest of these replaces each of the others.
 */
final class GifColours {
    /** Index of the transparent entry, which shows the picture before. */
    static final int TRANSPARENT = 255;

    private static final int BINS = 1 << 15;

    private final int[] counts = new int[BINS];
    private final int[] colour = new int[BINS];
    private final byte[] index = new byte[BINS];
    private final int[] used = new int[BINS];
    private int size;

    private static int bin(int rgb) {
        return rgb >> 9 & 0x7C00 | rgb >> 6 & 0x3E0 | rgb >> 3 & 0x1F;
    }

    void clear() {
        for (int i = 0; i < size; i++) {
            counts[used[i]] = 0;
        }
        size = 0;
    }

    void count(int rgb) {
        int bin = bin(rgb);
        if (counts[bin]++ == 0) {
            colour[bin] = rgb;
            used[size++] = bin;
        }
    }

    /** Chooses the palette from the colours counted. */
    IndexColorModel choose() {
        long[] frequent = new long[size];
        for (int i = 0; i < size; i++) {
            frequent[i] = (long) -counts[used[i]] << 15 | used[i];
        }
        Arrays.sort(frequent);
        int chosen = Math.min(size, TRANSPARENT);
        int[] palette = new int[TRANSPARENT + 1];
        for (int i = 0; i < size; i++) {
            int bin = (int) (frequent[i] & BINS - 1);
            if (i < chosen) {
                palette[i] = 0xFF000000 | colour[bin];
                index[bin] = (byte) i;
            } else {
                index[bin] = (byte) nearest(palette, chosen, colour[bin]);
            }
        }
        return new IndexColorModel(8, palette.length, palette, 0, true, TRANSPARENT,
            DataBuffer.TYPE_BYTE);
    }

    private static int nearest(int[] palette, int chosen, int rgb) {
        int nearest = 0;
        int least = Integer.MAX_VALUE;
        for (int i = 0; i < chosen; i++) {
            int r = (palette[i] >> 16 & 0xFF) - (rgb >> 16 & 0xFF);
            int g = (palette[i] >> 8 & 0xFF) - (rgb >> 8 & 0xFF);
            int b = (palette[i] & 0xFF) - (rgb & 0xFF);
            int distance = 2 * r * r + 4 * g * g + b * b;
            if (distance < least) {
                least = distance;
                nearest = i;
            }
        }
        return nearest;
    }

    /** Index in the palette of a colour that was counted, or of its replacement. */
    byte index(int rgb) {
        return index[bin(rgb)];
    }
}
