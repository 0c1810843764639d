package io.github.sofas.render;

import org.jcodec.codecs.h264.H264Const;
import org.jcodec.codecs.h264.io.model.MBType;

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
    private static final int LUMA_PARTS = 0xFFFF;
    /** Parts at the right edge of a block, in all planes. */
    private static final int EDGE_PARTS = 0xAA8888;

    private final int columns;
    private final int rows;
    /** The picture before as the player sees it. */
    private final BlockPicture seen;
    private final Macroblock block;
    /** Which blocks of 16 x 16 are predicted as ground. */
    private final boolean[] isGround;
    /** Blocks that were not written since the last that was. */
    private int skipped;
    /** Ground of a row of blocks, as a block of its own: as it is given now, and as the player saw it. */
    private final long[] groundNow = new long[BlockPicture.BLOCK_WORDS];
    private final long[] groundSeen = new long[BlockPicture.BLOCK_WORDS];

    /**
     * Prepares for pictures of a size.
     *
     * @param seen the picture before as the player sees it; kept up to date here
     */
    DifferenceEncoder(BlockPicture seen) {
        this.columns = seen.columns;
        this.rows = seen.rows;
        this.seen = seen;
        PartTransform transform = new PartTransform(QUANTISATION);
        block = new Macroblock(transform, new KnownParts(transform), seen);
        isGround = new boolean[columns * rows];
    }

    /**
     * Writes a picture's blocks.
     *
     * @param changed of each block, row by row, the parts that differ from the picture before, as bits
     */
    void encode(BlockPicture picture, int[] changed, CoefficientWriter bits) {
        block.begin();
        skipped = 0;
        for (int row = 0; row < rows; row++) {
            int last = (row + 1) * columns - 1;
            ground(picture.words, last * BlockPicture.BLOCK_WORDS, groundNow);
            ground(seen.words, last * BlockPicture.BLOCK_WORDS, groundSeen);
            boolean groundStays = (changed[last] & EDGE_PARTS) == 0 && columns * 16 <= FARTHEST;
            for (int column = 0; column < columns; column++) {
                encode(picture, column, row, changed[row * columns + column], groundStays, bits);
            }
        }
        if (skipped > 0) {
            bits.writeUnsigned(skipped);
        }
    }

    private void encode(BlockPicture picture, int column, int row, int changed, boolean groundStays,
                        CoefficientWriter bits) {
        int at = row * columns + column;
        boolean skipsToGround = column > 0 && row > 0 && isGround[at - 1] && isGround[at - columns];
        int parts = changed;
        boolean fromGround = false;
        if (groundStays && (changed != 0 || skipsToGround)) {
            // nearer is what fewer of the 16 parts of brightness differ from
            int besideGround = besideGround(picture.words, at * BlockPicture.BLOCK_WORDS);
            int fewer = Integer.bitCount(changed & LUMA_PARTS) - Integer.bitCount(besideGround & LUMA_PARTS);
            fromGround = fewer > 0 || fewer == 0 && skipsToGround;
            parts = fromGround ? besideGround : parts;
        }
        isGround[at] = fromGround;
        int pattern = parts == 0 ? 0 : transform(picture.words, at * BlockPicture.BLOCK_WORDS, fromGround, parts);
        if (fromGround) {
            System.arraycopy(groundSeen, 0, seen.words, at * BlockPicture.BLOCK_WORDS, BlockPicture.BLOCK_WORDS);
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

    /** Continues the rightmost values of a block over a block. */
    private static void ground(long[] words, int last, long[] ground) {
        for (int plane = 0; plane < 3; plane++) {
            int across = BlockPicture.side(plane) >> 2;
            int first = BlockPicture.firstPart(plane);
            for (int part = 0; part < across * across; part++) {
                int edge = last + 2 * (first + part / across * across + across - 1);
                for (int half = 0; half < 2; half++) {
                    // the last of either row of four
                    long upper = words[edge + half] >>> 24 & 0xFF;
                    long lower = words[edge + half] >>> 56;
                    ground[2 * (first + part) + half] = (upper | lower << 32) * 0x01010101L;
                }
            }
        }
    }

    /** The parts of a block that differ from the ground, as bits. */
    private int besideGround(long[] words, int at) {
        int differing = 0;
        for (int i = 0; i < BlockPicture.BLOCK_WORDS; i += 2) {
            long difference = words[at + i] ^ groundNow[i] | words[at + i + 1] ^ groundNow[i + 1];
            differing |= difference == 0 ? 0 : 1 << (i >> 1);
        }
        return differing;
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

    /** Transforms the differences of parts to what is predicted; the coded block pattern. */
    private int transform(long[] now, int at, boolean fromGround, int parts) {
        long[] predicted = fromGround ? groundSeen : seen.words;
        int predictedAt = fromGround ? 0 : at;
        int quarters = block.transformLuma(parts & LUMA_PARTS, now, at, predicted, predictedAt);
        int colourParts = parts >> BlockPicture.COLOUR_PARTS;
        int greatest = 0;
        for (int rest = colourParts; rest != 0; rest &= rest - 1) {
            int i = Integer.numberOfTrailingZeros(rest);
            int word = 2 * (BlockPicture.COLOUR_PARTS + i);
            greatest = Math.max(greatest, PartTransform.subtract(now[at + word], predicted[predictedAt + word],
                block.colour[i], 0));
            greatest = Math.max(greatest, PartTransform.subtract(now[at + word + 1], predicted[predictedAt + word + 1],
                block.colour[i], 8));
        }
        return quarters | (greatest > UNSEEN ? block.transformColour(colourParts) << 4 : 0);
    }
}
