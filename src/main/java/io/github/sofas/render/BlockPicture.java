package io.github.sofas.render;

/**
 * A picture in the order in which H.264 looks at it: blocks of 16 x 16 pixels row by row, and of each its 24 parts of
 * 4 x 4 values, one after the other. These are 16 of brightness by rows, four of blue and four of red, each colour
 * standing for 2 x 2 pixels. A value is a byte, less by 128; eight of them, two rows of a part, are a word, with the
 * first one lowest. So two parts are compared, copied or looked up by two words.
 */
final class BlockPicture {
    /** Words of a block. */
    static final int BLOCK_WORDS = 48;
    /** The first part of blue; those of red follow. */
    static final int COLOUR_PARTS = 16;

    final int columns;
    final int rows;
    final long[] words;

    /** Makes a grey picture of so many blocks. */
    BlockPicture(int columns, int rows) {
        this.columns = columns;
        this.rows = rows;
        words = new long[BLOCK_WORDS * columns * rows];
    }

    /** The first word of a block. */
    int block(int column, int row) {
        return (row * columns + column) * BLOCK_WORDS;
    }

    /** Values that a block has in a row of a plane: 0 brightness, 1 blue, 2 red. */
    static int side(int plane) {
        return plane == 0 ? 16 : 8;
    }

    /** The first part of a plane. */
    static int firstPart(int plane) {
        return plane == 0 ? 0 : COLOUR_PARTS + 4 * (plane - 1);
    }

    /** One value of a plane; slow. */
    byte value(int plane, int x, int y) {
        int side = side(plane);
        int part = firstPart(plane) + (y % side >> 2) * (side >> 2) + (x % side >> 2);
        return value(words, block(x / side, y / side) + 2 * part, (y & 3) * 4 + (x & 3));
    }

    /** One of the 16 values of a part, by its first word. */
    static byte value(long[] words, int at, int i) {
        return (byte) (words[at + (i >> 3)] >>> 8 * (i & 7));
    }

    /** Eight times the same value. */
    static long word(byte value) {
        return (value & 0xFF) * 0x0101010101010101L;
    }
}
