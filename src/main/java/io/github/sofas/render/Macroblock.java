package io.github.sofas.render;

import java.util.Arrays;
import org.jcodec.codecs.h264.H264Const;
import org.jcodec.codecs.h264.decode.CoeffTransformer;

/**
 * A block of 16 x 16 pixels on its way into the film: its differences to what is predicted, in parts of 4 x 4 values,
 * which are transformed, quantised and written, and what the player makes of them. One serves all blocks, one after the
 * other.
 */
final class Macroblock {
    /** Brightness, where it is not looked up: 16 parts by rows, first of differences, then of coefficients. */
    final int[][] luma = new int[16][16];
    /** Blue and red, four parts each. */
    final int[][] colour = new int[8][16];

    private final int columns;
    private final PartTransform transform;
    /** Null where brightness is not looked up. */
    private final KnownParts known;
    /** The picture as the player sees it. */
    private final BlockPicture seen;
    /** How many coefficients each part of the picture has, in each plane. */
    private final byte[][] counts;
    /** Of each part of brightness its place among the known ones; -1 where it is as predicted. */
    private final int[] places = new int[16];
    /** Of each part its coefficients in steps, in the order in which they are written, and which are not zero. */
    private final int[][] lumaLevels = new int[16][16];
    private final int[] lumaFound = new int[16];
    private final int[][] colourLevels = new int[8][16];
    private final int[] colourFound = new int[8];
    /** First coefficients of the parts, where these are transformed again. */
    private final int[][] colourMeans = new int[2][4];
    private final int[] lumaMeans = new int[16];
    private final int[] lumaMeanLevels = new int[16];

    /**
     * Prepares for pictures of a size.
     *
     * @param transform of the coarseness of these pictures
     * @param known where brightness is looked up; null where it is not
     * @param seen the picture before as the player sees it; what is written is added to it
     */
    Macroblock(PartTransform transform, KnownParts known, BlockPicture seen) {
        this.columns = seen.columns;
        this.seen = seen;
        this.transform = transform;
        this.known = known;
        int blocks = columns * seen.rows;
        counts = new byte[][] {new byte[16 * blocks], new byte[4 * blocks], new byte[4 * blocks]};
    }

    /** Begins a picture. */
    void begin() {
        for (byte[] plane : counts) {
            Arrays.fill(plane, (byte) 0);
        }
    }

    /**
     * Transforms the brightness, or looks it up.
     *
     * @param differing the parts that are not as predicted, as bits
     * @param now the picture, and the block's first word in it
     * @param at see there
     * @param predicted the block as predicted, from its first word on
     * @param predictedAt see there
     * @return the quarters of the block that have anything to write, as bits
     */
    int transformLuma(int differing, long[] now, int at, long[] predicted, int predictedAt) {
        known.begin();
        Arrays.fill(places, -1);
        int quarters = 0;
        for (int rest = differing; rest != 0; rest &= rest - 1) {
            int i = Integer.numberOfTrailingZeros(rest);
            places[i] = known.find(i, now[at + 2 * i], now[at + 2 * i + 1], predicted[predictedAt + 2 * i],
                predicted[predictedAt + 2 * i + 1]);
            quarters |= known.count(places[i]) == 0 ? 0 : 1 << (i >> 3 << 1 | i >> 1 & 1);
        }
        return quarters;
    }

    /**
     * Transforms the differences of brightness, and the means of the parts again.
     *
     * @param differing the parts that have any, as bits
     * @return whether there is more to write than means
     */
    boolean transformLumaAndMeans(int differing) {
        int found = 0;
        for (int i = 0; i < 16; i++) {
            lumaMeans[i] = 0;
            lumaFound[i] = 0;
            if ((differing >> i & 1) != 0) {
                lumaFound[i] = transform.quantise(luma[i], 1, lumaLevels[i]);
                lumaMeans[i] = luma[i][0];
                found |= lumaFound[i];
            }
        }
        CoeffTransformer.fvdDC4x4(lumaMeans);
        CoeffTransformer.quantizeDC4x4(lumaMeans, transform.quantisation);
        return found != 0;
    }

    /**
     * Transforms the differences of colour.
     *
     * @param differing the parts that have any, four bits of blue and four of red
     * @return what is to be written: 0 nothing, 1 the means of the parts, 2 all
     */
    int transformColour(int differing) {
        int written = 0;
        for (int i = 0; i < 8; i++) {
            int mean = 0;
            int found = 0;
            if ((differing >> i & 1) != 0) {
                found = transform.quantise(colour[i], 1, colourLevels[i]);
                mean = colour[i][0];
                written |= found == 0 ? 0 : 2;
            }
            colourMeans[i >> 2][i & 3] = mean;
            colourFound[i] = found;
        }
        for (int[] means : colourMeans) {
            CoeffTransformer.fvdDC2x2(means);
            CoeffTransformer.quantizeDC2x2(means, transform.quantisation);
            written |= (means[0] | means[1] | means[2] | means[3]) == 0 ? 0 : 1;
        }
        return Math.min(2, written);
    }

    /** Writes what {@link #transformLuma} found in the quarters, and shows it. */
    void writeLuma(int column, int row, int quarters, CoefficientWriter bits) {
        int at = seen.block(column, row);
        for (int i = 0; i < 16; i++) {
            if ((quarters >> (i >> 2) & 1) != 0) {
                int part = H264Const.BLK_INV_MAP[i];
                int x = column * 4 + (part & 3);
                int y = row * 4 + (part >> 2);
                int neighbours = neighbours(0, x, y);
                int place = places[part];
                if (place < 0) {
                    bits.writeToken(0, neighbours);
                } else {
                    known.write(place, neighbours, bits);
                    known.show(place, seen.words, at + 2 * part);
                    counts[0][y * columns * 4 + x] = (byte) known.count(place);
                }
            }
        }
    }

    /** Writes the means that {@link #transformLumaAndMeans} found, and the rest or not, and adds it to what is seen. */
    void writeLumaAndMeans(int column, int row, boolean withRest, CoefficientWriter bits) {
        int found = 0;
        for (int i = 0; i < 16; i++) {
            lumaMeanLevels[i] = lumaMeans[CoefficientWriter.SCAN[i]];
            found |= lumaMeanLevels[i] == 0 ? 0 : 1 << i;
        }
        bits.writeBlock(lumaMeanLevels, found, 0, neighbours(0, column << 2, row << 2));
        for (int i = 0; i < 16 && withRest; i++) {
            int part = H264Const.BLK_INV_MAP[i];
            write(0, part, column, row, lumaLevels[part], lumaFound[part], bits);
        }
        CoeffTransformer.invDC4x4(lumaMeans);
        CoeffTransformer.dequantizeDC4x4(lumaMeans, transform.quantisation, null);
        int at = seen.block(column, row);
        for (int i = 0; i < 16; i++) {
            restoreAndAdd(at + 2 * i, luma[i], lumaLevels[i], lumaFound[i], lumaMeans[i]);
        }
    }

    /** Writes what {@link #transformColour} found, as it returned it, and adds it to what is seen. */
    void writeColour(int column, int row, int written, CoefficientWriter bits) {
        if (written == 0) {
            return;
        }
        for (int[] means : colourMeans) {
            bits.writeColourMeans(means);
            CoeffTransformer.invDC2x2(means);
            CoeffTransformer.dequantizeDC2x2(means, transform.quantisation, null);
        }
        int at = seen.block(column, row) + 2 * BlockPicture.COLOUR_PARTS;
        for (int i = 0; i < 8; i++) {
            if (written == 2) {
                write(1 + (i >> 2), i & 3, column, row, colourLevels[i], colourFound[i], bits);
            }
            restoreAndAdd(at + 2 * i, colour[i], colourLevels[i], colourFound[i], colourMeans[i >> 2][i & 3]);
        }
    }

    /** Writes a part but for its mean, in the code that the number of coefficients left and above asks for. */
    private void write(int plane, int part, int column, int row, int[] levels, int found, CoefficientWriter bits) {
        int across = BlockPicture.side(plane) >> 2;
        int x = column * across + part % across;
        int y = row * across + part / across;
        bits.writeBlock(levels, found, 1, neighbours(plane, x, y));
        counts[plane][y * columns * across + x] = (byte) Integer.bitCount(found);
    }

    /** The mean of the coefficients that the parts left and above have. */
    private int neighbours(int plane, int x, int y) {
        int stride = columns * (BlockPicture.side(plane) >> 2);
        int at = y * stride + x;
        int left = x > 0 ? counts[plane][at - 1] : 0;
        int above = y > 0 ? counts[plane][at - stride] : 0;
        return x > 0 && y > 0 ? left + above + 1 >> 1 : left + above;
    }

    /** Makes differences of what was found, as the player does, and adds them to a part that is seen. */
    private void restoreAndAdd(int at, int[] part, int[] levels, int found, int mean) {
        if (found != 0 || mean != 0) {
            transform.restore(levels, found, mean, part);
            seen.words[at] = PartTransform.add(seen.words[at], part, 0);
            seen.words[at + 1] = PartTransform.add(seen.words[at + 1], part, 8);
        }
    }
}
