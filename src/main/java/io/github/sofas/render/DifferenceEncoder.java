package io.github.sofas.render;

import java.lang.invoke.MethodHandles;
import java.lang.invoke.VarHandle;
import java.nio.ByteOrder;
import java.util.Arrays;
import org.jcodec.codecs.h264.H264Const;
import org.jcodec.codecs.h264.io.model.MBType;
import org.jcodec.common.model.Picture;

/**
 * Encodes what a picture has other than the picture before, in H.264 without smoothing. Each block of 16 x 16 pixels is
 * predicted either as it was, or as the ground: the rightmost pixel of each row, which the standard continues beyond
 * the picture's edge, and which a motion vector as long as the picture is wide therefore finds from every block. So
 * dots that go cost nothing, dots that come leave nothing of those before them, and what stands still is copied.
 *
 * <p>Motion is not searched for: dots that jump from picture to picture have none that a block could follow.
 */
final class DifferenceEncoder {
    /** Coarseness, 0 to 51: thin arrows and letters stay clean. */
    static final int QUANTISATION = 28;
    /** Difference of colour, in steps of 1 / 256, that is not worth writing. */
    private static final int UNSEEN = 3;
    /** Longest motion vector, in pixels. */
    private static final int FARTHEST = 2047;
    private static final int QUARTERS = 4;
    /** Four pixels at once. */
    private static final VarHandle FOUR = MethodHandles.byteArrayViewVarHandle(int[].class, ByteOrder.LITTLE_ENDIAN);
    private static final int ALL_FOUR = 0x01010101;

    private final int columns;
    private final int rows;
    /** The picture before as it was given, and as the player sees it. */
    private final Picture before;
    private final Picture seen;
    private final Macroblock block;
    /** Which blocks of 16 x 16 are predicted as ground. */
    private final boolean[] isGround;
    /** Blocks that were not written since the last that was. */
    private int skipped;
    /** Ground of each row of pixels of a row of blocks, in each plane: as it is given now, and as the player saw it. */
    private final byte[][] groundNow = {new byte[16], new byte[8], new byte[8]};
    private final byte[][] groundSeen = {new byte[16], new byte[8], new byte[8]};

    /**
     * Prepares for pictures of a size.
     *
     * @param before the picture before, which the caller brings up to date after each
     * @param seen the same as the player sees it; kept up to date here
     */
    DifferenceEncoder(int columns, int rows, Picture before, Picture seen) {
        this.columns = columns;
        this.rows = rows;
        this.before = before;
        this.seen = seen;
        block = new Macroblock(columns, rows, QUANTISATION, seen);
        isGround = new boolean[columns * rows];
    }

    /**
     * Writes a picture's blocks.
     *
     * @param changed of each block, row by row, whether it may differ from the picture before
     */
    void encode(Picture picture, boolean[] changed, CoefficientWriter bits) {
        block.begin();
        skipped = 0;
        for (int row = 0; row < rows; row++) {
            boolean groundStays = findGround(picture, row) && columns * 16 <= FARTHEST;
            for (int column = 0; column < columns; column++) {
                encode(picture, column, row, changed[row * columns + column], groundStays, bits);
            }
        }
        if (skipped > 0) {
            bits.writeUnsigned(skipped);
        }
    }

    private void encode(Picture picture, int column, int row, boolean hasChanged, boolean groundStays,
                        CoefficientWriter bits) {
        int at = row * columns + column;
        boolean skipsToGround = column > 0 && row > 0 && isGround[at - 1] && isGround[at - columns];
        int parts = hasChanged ? differing(picture, 0, column, row, false) : 0;
        boolean fromGround = false;
        if (groundStays && (hasChanged || skipsToGround)) {
            // nearer is what fewer of the 16 parts differ from
            int besideGround = differing(picture, 0, column, row, true);
            int fewer = Integer.bitCount(parts) - Integer.bitCount(besideGround);
            fromGround = fewer > 0 || fewer == 0 && skipsToGround;
            parts = fromGround ? besideGround : parts;
        }
        isGround[at] = fromGround;
        int pattern = fromGround || hasChanged ? transform(picture, column, row, fromGround, parts) : 0;
        if (fromGround) {
            paintGround(column, row);
        }
        if (pattern == 0 && fromGround == skipsToGround) {
            skipped++;
            return;
        }
        bits.writeUnsigned(skipped);
        skipped = 0;
        bits.writeUnsigned(MBType.P_16x16.code());
        int farther = (fromGround ? 1 : 0) - (expectsGround(column, row) ? 1 : 0);
        bits.writeSigned(farther * columns * 16 * QUARTERS);
        bits.writeSigned(0);
        bits.writeUnsigned(H264Const.CODED_BLOCK_PATTERN_INTER_COLOR_INV[pattern]);
        if (pattern > 0) {
            // no change of coarseness
            bits.writeSigned(0);
            block.writeLuma(column, row, pattern & 15, bits);
            block.writeColour(column, row, pattern >> 4, bits);
        }
    }

    /** Takes the ground of a row of blocks; whether it is as it was. */
    private boolean findGround(Picture picture, int row) {
        boolean stays = true;
        for (int plane = 0; plane < 3; plane++) {
            int side = Macroblock.side(plane);
            for (int y = 0; y < side; y++) {
                int last = (row * side + y + 1) * columns * side - 1;
                groundNow[plane][y] = picture.getPlaneData(plane)[last];
                groundSeen[plane][y] = seen.getPlaneData(plane)[last];
                stays &= groundNow[plane][y] == before.getPlaneData(plane)[last];
            }
        }
        return stays;
    }

    /** The parts of 4 x 4 values of a block in a plane that differ from the ground or the picture before, as bits. */
    private int differing(Picture picture, int plane, int column, int row, boolean fromGround) {
        int stride = columns * Macroblock.side(plane);
        int parts = plane == 0 ? 16 : 4;
        int differing = 0;
        for (int i = 0; i < parts; i++) {
            int at = block.place(i, plane, column, row);
            boolean differs = fromGround ? differsFromGround(picture, plane, at, stride, groundRow(i, plane))
                : hasChanged(picture, plane, at, stride);
            differing |= differs ? 1 << i : 0;
        }
        return differing;
    }

    /** The first row of a part in its block. */
    private static int groundRow(int part, int plane) {
        return plane == 0 ? part >> 2 << 2 : part >> 1 << 2;
    }

    /** Whether a block whose place is not told is expected to be ground, as most of its neighbours are. */
    private boolean expectsGround(int column, int row) {
        int at = row * columns + column;
        boolean left = column > 0 && isGround[at - 1];
        if (row == 0) {
            return left;
        }
        boolean above = isGround[at - columns];
        boolean corner = column < columns - 1 ? isGround[at - columns + 1]
            : column > 0 ? isGround[at - columns - 1] : above;
        return left && (above || corner) || above && corner;
    }

    /** Transforms the differences to what is predicted, of brightness in the parts given; the coded block pattern. */
    private int transform(Picture picture, int column, int row, boolean fromGround, int lumaParts) {
        for (int rest = lumaParts; rest != 0; rest &= rest - 1) {
            int i = Integer.numberOfTrailingZeros(rest);
            subtract(picture, 0, block.place(i, 0, column, row), fromGround ? groundRow(i, 0) : -1, block.luma[i]);
        }
        int quarters = block.transformLuma(lumaParts);
        int colourParts = 0;
        int greatest = 0;
        for (int k = 0; k < 2; k++) {
            int parts = differing(picture, k + 1, column, row, fromGround);
            for (int rest = parts; rest != 0; rest &= rest - 1) {
                int i = Integer.numberOfTrailingZeros(rest);
                greatest = Math.max(greatest, subtract(picture, k + 1, block.place(i, k + 1, column, row),
                    fromGround ? groundRow(i, 1) : -1, block.colour[k][i]));
            }
            colourParts |= parts << 4 * k;
        }
        return quarters | (greatest > UNSEEN ? block.transformColour(colourParts) << 4 : 0);
    }

    /**
     * Takes the difference of 4 x 4 values to what is predicted.
     *
     * @param groundRow row in the block, where ground is predicted; -1 where the picture before is
     * @return the greatest difference
     */
    private int subtract(Picture picture, int plane, int at, int groundRow, int[] part) {
        int stride = columns * Macroblock.side(plane);
        byte[] now = picture.getPlaneData(plane);
        byte[] then = seen.getPlaneData(plane);
        int greatest = 0;
        for (int i = 0; i < 16; i++) {
            int pixel = at + (i >> 2) * stride + (i & 3);
            part[i] = now[pixel] - (groundRow < 0 ? then[pixel] : groundSeen[plane][groundRow + (i >> 2)]);
            greatest = Math.max(greatest, Math.abs(part[i]));
        }
        return greatest;
    }

    /** Whether 4 x 4 values have. */
    private boolean hasChanged(Picture picture, int plane, int at, int stride) {
        byte[] now = picture.getPlaneData(plane);
        byte[] then = before.getPlaneData(plane);
        int difference = 0;
        for (int y = 0; y < 4; y++) {
            difference |= (int) FOUR.get(now, at + y * stride) ^ (int) FOUR.get(then, at + y * stride);
        }
        return difference != 0;
    }

    private boolean differsFromGround(Picture picture, int plane, int at, int stride, int groundRow) {
        byte[] now = picture.getPlaneData(plane);
        int difference = 0;
        for (int y = 0; y < 4; y++) {
            difference |= (int) FOUR.get(now, at + y * stride) ^ (groundNow[plane][groundRow + y] & 0xFF) * ALL_FOUR;
        }
        return difference != 0;
    }

    /** Makes a block that is seen ground. */
    private void paintGround(int column, int row) {
        for (int plane = 0; plane < 3; plane++) {
            byte[] pixels = seen.getPlaneData(plane);
            int side = Macroblock.side(plane);
            int at = block.place(0, plane, column, row);
            for (int y = 0; y < side; y++, at += columns * side) {
                Arrays.fill(pixels, at, at + side, groundSeen[plane][y]);
            }
        }
    }
}
