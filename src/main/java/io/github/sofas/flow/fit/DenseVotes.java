package io.github.sofas.flow.fit;

/**
 * The bilinear votes of events that fill their grid. The final content of the cells shows how often the events met: the
 * sum of 2 w f, of each vote w and what its cell held before, equals exactly the sum of the squares of all cells less
 * that of all votes. Ours, because an event then has two numbers to add to and none to read, which takes up to a half
 * less time. Where few events lie on many cells, scanning the cells takes more. Blocks of cells without votes are
 * skipped.
 *
 * <p>The votes for two adjacent cells are the halves of one number, which is kept at the left cell. A cell thus holds
 * the low half of its own number and the high half of the number to its left.
 */
final class DenseVotes {
    /** Most cells of a grid: few enough to stay in a near cache. */
    static final int MOST_CELLS = 1 << 13;
    /** Cells of a block, as a power of two: one cache line. */
    private static final int BLOCK_BITS = 3;
    private static final int BLOCKS = MOST_CELLS >> BLOCK_BITS;
    /** Bytes of its arrays. */
    static final long BYTES = (long) MOST_CELLS * Long.BYTES + BLOCKS;
    private static final int KEYS = BilinearAccumulator.KEYS;
    // votes for the two upper cells, and for the two lower ones, by place in the cell and sign
    private static final long[] ABOVE = new long[KEYS];
    private static final long[] BELOW = new long[KEYS];
    /** Sum of the squares of the four votes. */
    static final int[] SQUARES = new int[KEYS];

    static {
        for (int k = 0; k < KEYS; k++) {
            int w00 = BilinearAccumulator.VOTE_00[k];
            int w10 = BilinearAccumulator.VOTE_10[k];
            int w01 = BilinearAccumulator.VOTE_01[k];
            int w11 = BilinearAccumulator.VOTE_11[k];
            ABOVE[k] = ((long) w10 << Integer.SIZE) + w00;
            BELOW[k] = ((long) w11 << Integer.SIZE) + w01;
            SQUARES[k] = w00 * w00 + w10 * w10 + w01 * w01 + w11 * w11;
        }
    }

    /** Votes for pairs of cells; all 0 between two calls. */
    private final long[] pairs = new long[MOST_CELLS];
    /** 1 for each block with votes; all 0 between two calls. */
    private final byte[] used = new byte[BLOCKS];

    /**
     * Sum of w f over the votes of events.
     *
     * @param at cell, sign and place in the cell of each event
     * @param size number of events
     * @param columns of a grid of at most {@link #MOST_CELLS} cells
     */
    long vote(int[] at, int size, int columns, int rows) {
        int own = add(at, size, columns);
        return (squares(columns * rows) - own) / 2;
    }

    /** Adds the votes to the grid; returns the sum of their squares. */
    private int add(int[] at, int size, int columns) {
        long[] cells = pairs;
        byte[] blocks = used;
        int own = 0;
        for (int i = 0; i < size; i++) {
            int c = at[i] >>> BilinearAccumulator.KEY_BITS;
            int k = at[i] & KEYS - 1;
            int below = c + columns;
            cells[c] += ABOVE[k];
            cells[below] += BELOW[k];
            blocks[c >>> BLOCK_BITS] = 1;
            blocks[below >>> BLOCK_BITS] = 1;
            own += SQUARES[k];
        }
        return own;
    }

    /** Returns the sum of the squares of the first cells, and empties these. */
    private long squares(int cells) {
        long[] of = pairs;
        long sum = 0;
        long fromLeft = 0;
        for (int block = 0; block << BLOCK_BITS < cells; block++) {
            if (used[block] == 0) {
                sum += fromLeft * fromLeft;
                fromLeft = 0;
                continue;
            }
            used[block] = 0;
            int end = block + 1 << BLOCK_BITS;
            for (int c = block << BLOCK_BITS; c < end; c++) {
                long pair = of[c];
                of[c] = 0;
                int own = (int) pair;
                long f = own + fromLeft;
                sum += f * f;
                // no event lies in the last column, so that nothing carries over to the next row
                fromLeft = pair - own >> Integer.SIZE;
            }
        }
        return sum;
    }
}
