package io.github.sofas.render;

import org.jcodec.codecs.h264.io.model.MBType;

/**
 * Encodes a picture in H.264 without another: each block of 16 x 16 pixels is predicted as the mean of the pixels left
 * of it and above it, which is exact where there is nothing but ground.
 */
final class WholeEncoder {
    /** Coarseness, 0 to 51: what stands still is seen as it is here until the next whole picture. */
    static final int QUANTISATION = 15;
    /** Which of the standard's predictions it is. */
    private static final int FROM_MEAN = 2;
    /** Of a type of block: whether it has colours, in which detail, and more than means of brightness. */
    private static final int COLOUR = 4;
    private static final int REST = 12;

    private final BlockPicture seen;
    private final Macroblock block;

    /**
     * Prepares for pictures of a size.
     *
     * @param seen gets the picture as the player sees it
     */
    WholeEncoder(BlockPicture seen) {
        this.seen = seen;
        block = new Macroblock(new PartTransform(QUANTISATION), null, seen);
    }

    /** Writes a picture's blocks. */
    void encode(BlockPicture picture, CoefficientWriter bits) {
        block.begin();
        for (int row = 0; row < picture.rows; row++) {
            for (int column = 0; column < picture.columns; column++) {
                encode(picture, column, row, bits);
            }
        }
    }

    private void encode(BlockPicture picture, int column, int row, CoefficientWriter bits) {
        boolean withRest = block.transformLumaAndMeans(predictLuma(picture, column, row));
        int written = block.transformColour(predictColour(picture, column, row));
        bits.writeUnsigned(MBType.I_16x16.code() + FROM_MEAN + written * COLOUR + (withRest ? REST : 0));
        // colours are predicted from means too; no change of coarseness
        bits.writeUnsigned(0);
        bits.writeSigned(0);
        block.writeLumaAndMeans(column, row, withRest, bits);
        block.writeColour(column, row, written, bits);
    }

    /** Subtracts what is predicted of the brightness; the parts that differ from it, as bits. */
    private int predictLuma(BlockPicture picture, int column, int row) {
        byte mean = mean(0, column << 4, row << 4, column << 4, row << 4, 16, column > 0, row > 0);
        int differing = 0;
        for (int part = 0; part < 16; part++) {
            differing |= subtract(picture, picture.block(column, row) + 2 * part, mean, block.luma[part]) << part;
        }
        return differing;
    }

    /** Subtracts what is predicted of the colours; the parts that differ from it, four bits of blue and four of red. */
    private int predictColour(BlockPicture picture, int column, int row) {
        int at = picture.block(column, row) + 2 * BlockPicture.COLOUR_PARTS;
        int differing = 0;
        for (int k = 0; k < 2; k++) {
            for (int part = 0; part < 4; part++) {
                // of the two beside the diagonal only the side counts that is nearer, where there is one
                boolean fromLeft = column > 0 && (part != 1 || row == 0);
                boolean fromAbove = row > 0 && (part != 2 || column == 0);
                byte mean = mean(k + 1, column << 3, row << 3, (column << 3) + (part & 1) * 4,
                    (row << 3) + (part >> 1) * 4, 4, fromLeft, fromAbove);
                int i = 4 * k + part;
                differing |= subtract(picture, at + 2 * i, mean, block.colour[i]) << i;
            }
        }
        return differing;
    }

    /** Mean of the pixels left of a block and above it, beside some of its columns and rows; grey where none counts. */
    private byte mean(int plane, int blockX, int blockY, int x, int y, int side, boolean fromLeft, boolean fromAbove) {
        int sum = 0;
        for (int i = 0; i < side; i++) {
            sum += fromLeft ? seen.value(plane, blockX - 1, y + i) : 0;
            sum += fromAbove ? seen.value(plane, x + i, blockY - 1) : 0;
        }
        int count = (fromLeft ? side : 0) + (fromAbove ? side : 0);
        return (byte) (count == 0 ? 0 : Math.floorDiv(sum + count / 2, count));
    }

    /** Takes the difference of a part to a value, which is seen from now on; 1 where there is any. */
    private int subtract(BlockPicture picture, int at, byte value, int[] part) {
        long predicted = BlockPicture.word(value);
        seen.words[at] = predicted;
        seen.words[at + 1] = predicted;
        int greatest = PartTransform.subtract(picture.words[at], predicted, part, 0)
            | PartTransform.subtract(picture.words[at + 1], predicted, part, 8);
        return greatest == 0 ? 0 : 1;
    }
}
