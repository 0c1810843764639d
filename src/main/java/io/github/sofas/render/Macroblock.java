package io.github.sofas.render;

import java.util.Arrays;
import org.jcodec.codecs.h264.H264Const;
import org.jcodec.codecs.h264.decode.CoeffTransformer;
import org.jcodec.common.model.Picture;

/**
 * A block of 16 x 16 pixels on its way into the film: its differences to what is predicted, in parts of 4 x 4 values,
 * which are transformed, quantised and written, and what the player makes of them. One serves all blocks, one after the
 * other.
 *
 * <p>The transforms are jcodec's. It quantises and writes all of a part's coefficients, of which most are zero.
 */
final class Macroblock {
    /** Brightness: 16 parts by rows, first of differences, then of coefficients. */
    final int[][] luma = new int[16][16];
    /** Blue and red, four parts each. */
    final int[][][] colour = new int[2][4][16];

    private final int columns;
    private final int quantisation;
    /** Coefficient by coefficient in the order in which they are written: what a step is, and what to divide by it. */
    private final int[] steps = new int[16];
    private final int[] factors = new int[16];
    private final int addition;
    private final int shift;
    /** The picture as the player sees it. */
    private final Picture seen;
    /** How many coefficients each part of the picture has, in each plane. */
    private final byte[][] counts;
    /** Of each part its coefficients in steps, in the order in which they are written, and which are not zero. */
    private final int[][] lumaLevels = new int[16][16];
    private final int[] lumaFound = new int[16];
    private final int[][][] colourLevels = new int[2][4][16];
    private final int[][] colourFound = new int[2][4];
    /** First coefficients of the parts, where these are transformed again. */
    private final int[][] colourMeans = new int[2][4];
    private final int[] lumaMeans = new int[16];
    private final int[] lumaMeanLevels = new int[16];

    /**
     * Prepares for pictures of a size.
     *
     * @param columns blocks in a row
     * @param quantisation coarseness, 0 to 51
     * @param seen the picture before as the player sees it; what is written is added to it
     */
    Macroblock(int columns, int rows, int quantisation, Picture seen) {
        this.columns = columns;
        this.quantisation = quantisation;
        this.seen = seen;
        int blocks = columns * rows;
        counts = new byte[][] {new byte[16 * blocks], new byte[4 * blocks], new byte[4 * blocks]};
        int[] byPlace = new int[16];
        Arrays.fill(byPlace, 1);
        CoeffTransformer.dequantizeAC(byPlace, quantisation, null);
        shift = 15 + quantisation / 6;
        // thirds of a step and more count as one
        addition = (1 << shift) / 3;
        for (int i = 0; i < 16; i++) {
            int place = CoefficientWriter.SCAN[i];
            steps[i] = byPlace[place];
            // jcodec's forward transform is longer along odd rows and columns than its inverse
            double length = ((place & 1) == 0 ? 1 : 0.8) * ((place >> 2 & 1) == 0 ? 1 : 0.8);
            factors[i] = (int) Math.round((4 << shift) * length / steps[i]);
        }
    }

    /** Begins a picture. */
    void begin() {
        for (byte[] plane : counts) {
            Arrays.fill(plane, (byte) 0);
        }
    }

    /** Values that a block has in a row of a plane. */
    static int side(int plane) {
        return plane == 0 ? 16 : 8;
    }

    /** The first value of a part in a plane. */
    int place(int part, int plane, int column, int row) {
        int side = side(plane);
        int partsAcross = side >> 2;
        int y = row * side + (part / partsAcross << 2);
        return y * columns * side + column * side + (part % partsAcross << 2);
    }

    /**
     * Transforms the differences of brightness.
     *
     * @param differing the parts that have any, as bits
     * @return the quarters of the block that have anything to write, as bits
     */
    int transformLuma(int differing) {
        int quarters = 0;
        for (int i = 0; i < 16; i++) {
            lumaFound[i] = 0;
            if ((differing >> i & 1) != 0) {
                CoeffTransformer.fdct4x4(luma[i]);
                lumaFound[i] = quantise(luma[i], 0, lumaLevels[i]);
                quarters |= lumaFound[i] == 0 ? 0 : 1 << (i >> 3 << 1 | i >> 1 & 1);
            }
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
                CoeffTransformer.fdct4x4(luma[i]);
                lumaMeans[i] = luma[i][0];
                lumaFound[i] = quantise(luma[i], 1, lumaLevels[i]);
                found |= lumaFound[i];
            }
        }
        CoeffTransformer.fvdDC4x4(lumaMeans);
        CoeffTransformer.quantizeDC4x4(lumaMeans, quantisation);
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
        for (int k = 0; k < 2; k++) {
            for (int i = 0; i < 4; i++) {
                colourMeans[k][i] = 0;
                colourFound[k][i] = 0;
                if ((differing >> 4 * k + i & 1) != 0) {
                    int[] part = colour[k][i];
                    CoeffTransformer.fdct4x4(part);
                    colourMeans[k][i] = part[0];
                    colourFound[k][i] = quantise(part, 1, colourLevels[k][i]);
                    written |= colourFound[k][i] == 0 ? 0 : 2;
                }
            }
            CoeffTransformer.fvdDC2x2(colourMeans[k]);
            CoeffTransformer.quantizeDC2x2(colourMeans[k], quantisation);
            for (int mean : colourMeans[k]) {
                written |= mean == 0 ? 0 : 1;
            }
        }
        return Math.min(2, written);
    }

    /** Counts coefficients in steps, from one on; which of them are not zero. */
    private int quantise(int[] part, int first, int[] levels) {
        int found = 0;
        for (int i = first; i < 16; i++) {
            int coefficient = part[CoefficientWriter.SCAN[i]];
            int sign = coefficient >> 31;
            int level = ((coefficient ^ sign) - sign) * factors[i] + addition >> shift;
            levels[i] = (level ^ sign) - sign;
            found |= -level >>> 31 << i;
        }
        return found;
    }

    /** Writes what {@link #transformLuma} found in the quarters, and adds it to what is seen. */
    void writeLuma(int column, int row, int quarters, CoefficientWriter bits) {
        for (int i = 0; i < 16; i++) {
            if ((quarters >> (i >> 2) & 1) != 0) {
                int part = H264Const.BLK_INV_MAP[i];
                int found = lumaFound[part];
                write(0, part, column, row, lumaLevels[part], found, 0, bits);
                restoreAndAdd(0, part, column, row, luma[part], lumaLevels[part], found, 0);
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
            write(0, part, column, row, lumaLevels[part], lumaFound[part], 1, bits);
        }
        CoeffTransformer.invDC4x4(lumaMeans);
        CoeffTransformer.dequantizeDC4x4(lumaMeans, quantisation, null);
        for (int i = 0; i < 16; i++) {
            restoreAndAdd(0, i, column, row, luma[i], lumaLevels[i], lumaFound[i], lumaMeans[i]);
        }
    }

    /** Writes what {@link #transformColour} found, as it returned it, and adds it to what is seen. */
    void writeColour(int column, int row, int written, CoefficientWriter bits) {
        if (written == 0) {
            return;
        }
        bits.writeColourMeans(colourMeans[0]);
        bits.writeColourMeans(colourMeans[1]);
        for (int k = 0; k < 2; k++) {
            CoeffTransformer.invDC2x2(colourMeans[k]);
            CoeffTransformer.dequantizeDC2x2(colourMeans[k], quantisation, null);
            for (int i = 0; i < 4; i++) {
                int found = colourFound[k][i];
                if (written == 2) {
                    write(k + 1, i, column, row, colourLevels[k][i], found, 1, bits);
                }
                restoreAndAdd(k + 1, i, column, row, colour[k][i], colourLevels[k][i], found, colourMeans[k][i]);
            }
        }
    }

    /** Writes a part in the code that the number of coefficients left and above asks for. */
    private void write(int plane, int part, int column, int row, int[] levels, int found, int first,
                       CoefficientWriter bits) {
        int across = side(plane) >> 2;
        int x = column * across + part % across;
        int y = row * across + part / across;
        bits.writeBlock(levels, found, first, neighbours(plane, x, y));
        counts[plane][y * columns * across + x] = (byte) Integer.bitCount(found);
    }

    /** The mean of the coefficients that the parts left and above have. */
    private int neighbours(int plane, int x, int y) {
        int stride = columns * (side(plane) >> 2);
        int at = y * stride + x;
        int left = x > 0 ? counts[plane][at - 1] : 0;
        int above = y > 0 ? counts[plane][at - stride] : 0;
        return x > 0 && y > 0 ? left + above + 1 >> 1 : left + above;
    }

    /** Makes differences of what was found, as the player does, and adds them to what is seen. */
    private void restoreAndAdd(int plane, int part, int column, int row, int[] values, int[] levels, int found,
                               int mean) {
        if (found == 0 && mean == 0) {
            return;
        }
        Arrays.fill(values, 0);
        values[0] = mean;
        for (int rest = found; rest != 0; rest &= rest - 1) {
            int i = Integer.numberOfTrailingZeros(rest);
            values[CoefficientWriter.SCAN[i]] = levels[i] * steps[i];
        }
        CoeffTransformer.idct4x4(values);
        byte[] pixels = seen.getPlaneData(plane);
        int stride = columns * side(plane);
        int at = place(part, plane, column, row);
        for (int i = 0; i < 16; i++) {
            int pixel = at + (i >> 2) * stride + (i & 3);
            pixels[pixel] = (byte) Math.max(-128, Math.min(127, pixels[pixel] + values[i]));
        }
    }
}
