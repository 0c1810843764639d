package io.github.sofas.flow.fit;

/**
 * The bilinear votes of events that fill their grid. What the cells hold in the end tells how often the events met: the
 * sum of 2 w f, each vote w with what the cell held before it, is the sum of the squares of all cells less that of all
 * votes, exactly. Ours, because so an event has two numbers to add to and none to read, which takes up to a half less
 * time; where few events lie on many cells, looking through the cells takes more. Blocks of cells that no event has a
 * vote for are passed over.
 *
 * <p>The votes for two cells side by side are the halves of one number, which is added to at the left one of them. A
 * cell then holds the low half of its own number and the high half of the one to its left.
 */
final class DenseVotes {
    /** Most cells of a grid: few enough to stay in a near cache. */
    static final int MOST_CELLS = 1 << 13;
    /** Cells of a block: a line of the cache. */
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

    /** Empty between two calls. */
    private final long[] pairs = new long[MOST_CELLS];
    /** Blocks that any event has a vote for, 1 of each; none between two calls. */
    private final byte[] used = new byte[BLOCKS];

    /**
     * Sum of w f over the votes of events.
     *
     * @param at cell, sign and place in the cell of each event
     * @param size number of events
     * @param columns of a grid of at most {@link #MOST_CELLS}
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

    /** Sum of the squares of what so many cells hold, which are emptied. */
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
                // no event lies in the last column, so that the next row gets nothing from it
                fromLeft = pair - own >> Integer.SIZE;
            }
        }
        return sum;
    }
}
