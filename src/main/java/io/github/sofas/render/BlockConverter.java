package io.github.sofas.render;

import java.util.Arrays;

/**
 * Converts pixels to brightness and, for each 2 x 2 of them, colour, as ITU-R BT.601 has them for video. Pictures of
 * events are squares of few colours: what four pixels of one colour give is remembered.
 */
final class BlockConverter {
    /** Brightness of black in video, less by 128. */
    private static final int BLACK = 16 - 128;
    /** Where a quad, four pixels that share their colour, has its brightness: two bytes of either row. */
    private static final long LUMA = 0x0000FFFF_0000FFFFL;
    /** Where it has blue and red. */
    private static final int BLUE = 16;
    private static final int RED = 48;

    /** Places for colours that were met; a colour's is told by the highest bits of its product. */
    private static final int PLACES = 256;
    private static final int SPREAD = 0x9E3779B9;
    private static final int SPREAD_SHIFT = 24;

    private final int[] colours = new int[PLACES];
    private final long[] quads = new long[PLACES];

    /** Makes a converter that knows black, which is what the places for other colours hold, too. */
    BlockConverter() {
        Arrays.fill(quads, quad(0, 0, 0, 0));
    }

    /**
     * Converts a block of 16 x 16 pixels.
     *
     * @param rgb pixels as 0xRRGGBB
     * @param from the block's first pixel
     * @param width of the picture
     * @param words get the block
     * @param to its first word
     * @return the parts that are not as they were, as bits
     */
    int convert(int[] rgb, int from, int width, long[] words, int to) {
        int differing = 0;
        for (int eighth = 0; eighth < 8; eighth++) {
            differing |= convertEighth(rgb, from + (eighth >> 1) * 4 * width + (eighth & 1) * 8, width, words, to,
                eighth);
        }
        return differing;
    }

    /** Converts 8 x 4 pixels: two parts of brightness, half a part of blue and of red. */
    private int convertEighth(int[] rgb, int from, int width, long[] words, int to, int eighth) {
        int part = (eighth >> 1) * 4 + (eighth & 1) * 2;
        long blue = 0;
        long red = 0;
        int differing = 0;
        for (int half = 0; half < 2; half++) {
            int at = from + half * 2 * width;
            long a = quadAt(rgb, at, width);
            long b = quadAt(rgb, at + 2, width);
            long c = quadAt(rgb, at + 4, width);
            long d = quadAt(rgb, at + 6, width);
            differing |= put(words, to + 2 * part + half, a & LUMA | (b & LUMA) << 16) << part;
            differing |= put(words, to + 2 * part + 2 + half, c & LUMA | (d & LUMA) << 16) << part + 1;
            blue |= four(a, b, c, d, BLUE) << 32 * half;
            red |= four(a, b, c, d, RED) << 32 * half;
        }
        int bluePart = BlockPicture.COLOUR_PARTS + (eighth >> 2) * 2 + (eighth & 1);
        int half = eighth >> 1 & 1;
        differing |= put(words, to + 2 * bluePart + half, blue) << bluePart;
        return differing | put(words, to + 2 * bluePart + 8 + half, red) << bluePart + 4;
    }

    /** Puts a word; 1 where another was. */
    private static int put(long[] words, int at, long word) {
        int differs = words[at] == word ? 0 : 1;
        words[at] = word;
        return differs;
    }

    private static long four(long a, long b, long c, long d, int shift) {
        return a >>> shift & 0xFF | (b >>> shift & 0xFF) << 8 | (c >>> shift & 0xFF) << 16 | (d >>> shift & 0xFF) << 24;
    }

    private long quadAt(int[] rgb, int at, int width) {
        int first = rgb[at];
        if ((first ^ rgb[at + 1] | first ^ rgb[at + width] | first ^ rgb[at + width + 1]) != 0) {
            return quad(first, rgb[at + 1], rgb[at + width], rgb[at + width + 1]);
        }
        int place = first * SPREAD >>> SPREAD_SHIFT;
        if (colours[place] != first) {
            colours[place] = first;
            quads[place] = quad(first, first, first, first);
        }
        return quads[place];
    }

    private static long quad(int a, int b, int c, int d) {
        // sums of four: red and blue together, then green, as no part spills into another
        int rb = (a & 0xFF00FF) + (b & 0xFF00FF) + (c & 0xFF00FF) + (d & 0xFF00FF);
        int green = (a >> 8 & 0xFF) + (b >> 8 & 0xFF) + (c >> 8 & 0xFF) + (d >> 8 & 0xFF);
        int red = rb >> 16;
        int blue = rb & 0xFFFF;
        long toBlue = -38 * red - 74 * green + 112 * blue + 512 >> 10 & 0xFF;
        long toRed = 112 * red - 94 * green - 18 * blue + 512 >> 10 & 0xFF;
        return luma(a) | luma(b) << 8 | luma(c) << 32 | luma(d) << 40 | toBlue << BLUE | toRed << RED;
    }

    private static long luma(int c) {
        return (66 * (c >> 16 & 0xFF) + 129 * (c >> 8 & 0xFF) + 25 * (c & 0xFF) + 128 >> 8) + BLACK & 0xFF;
    }
}
