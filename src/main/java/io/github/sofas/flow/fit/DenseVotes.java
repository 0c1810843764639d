package io.github.sofas.flow.fit;

import java.util.Arrays;

/**
 * The bilinear votes of events that fill their grid. What the cells hold in the end tells how often the events met: the
 * sum of 2 w f, each vote w with what the cell held before it, is the sum of the squares of all cells less that of all
 * votes, exactly. Ours, because so an event has two numbers to add to and none to read, which takes up to a third less
 * time; where few events lie on many cells, looking through the cells takes more.
 *
 * <p>The votes for two cells side by side are the halves of one number, which is added to at the left one of them. A
 * cell then holds the low half of its own number and the high half of the one to its left.
 */
final class DenseVotes {
    /** Most cells of a grid: few enough to stay in a near cache. */
    static final int MOST_CELLS = 1 << 13;
    /** Bytes of its array. */
    static final long BYTES = (long) MOST_CELLS * Long.BYTES;
    private static final int SUB = BilinearAccumulator.SUB;
    private static final int SUB_BITS = BilinearAccumulator.SUB_BITS;
    /** Places in a cell, for either polarity. */
    private static final int PLACES = SUB * SUB;
    /** Votes for the two upper cells, and for the two lower ones, by place in the cell and polarity. */
    private static final long[] ABOVE = new long[2 * PLACES];
    private static final long[] BELOW = new long[2 * PLACES];
    /** Sum of the squares of the four votes. */
    private static final int[] SQUARES = new int[2 * PLACES];

    static {
        for (int k = 0; k < 2 * PLACES; k++) {
            int fx = k % SUB;
            int fy = k / SUB % SUB;
            int sign = k < PLACES ? 1 : -1;
            ABOVE[k] = sign * (SUB - fy) * pair(fx);
            BELOW[k] = sign * fy * pair(fx);
            SQUARES[k] = (fx * fx + (SUB - fx) * (SUB - fx)) * (fy * fy + (SUB - fy) * (SUB - fy));
        }
    }

    private final long[] pairs = new long[MOST_CELLS];

    private static long pair(int fx) {
        return ((long) fx << Integer.SIZE) + SUB - fx;
    }

    /** Number of a vote in the tables. */
    private static int number(int px, int py, int vote) {
        // +1 and -1 differ in the second bit
        return (vote & 2) << 2 * SUB_BITS - 1 | (py & SUB - 1) << SUB_BITS | px & SUB - 1;
    }

    /**
     * Sum of w f over the votes of events; one beyond the last column or row has none.
     *
     * @param x position of each event in parts of a cell
     * @param vote +1 or -1
     * @param size number of events
     * @param columns of a grid of at most {@link #MOST_CELLS}
     */
    long vote(int[] x, int[] y, byte[] vote, int size, int columns, int rows) {
        Arrays.fill(pairs, 0, columns * rows, 0);
        long own = add(x, y, vote, size, columns, rows);
        return (squares(columns * rows) - own) / 2;
    }

    /** Adds the votes to the grid; returns the sum of their squares. */
    private long add(int[] x, int[] y, byte[] vote, int size, int columns, int rows) {
        long[] cells = pairs;
        int limitX = (columns - 1) * SUB;
        int limitY = (rows - 1) * SUB;
        long own = 0;
        for (int i = 0; i < size; i++) {
            int px = x[i];
            int py = y[i];
            // an event that leaves the grid meets no other
            if ((px | py) < 0 || px >= limitX || py >= limitY) {
                continue;
            }
            int c = (py >> SUB_BITS) * columns + (px >> SUB_BITS);
            int k = number(px, py, vote[i]);
            cells[c] += ABOVE[k];
            cells[c + columns] += BELOW[k];
            own += SQUARES[k];
        }
        return own;
    }

    /** Sum of the squares of what so many cells hold. */
    private long squares(int cells) {
        long[] of = pairs;
        long sum = 0;
        long fromLeft = 0;
        for (int c = 0; c < cells; c++) {
            long pair = of[c];
            int own = (int) pair;
            long f = own + fromLeft;
            sum += f * f;
            // no event lies in the last column, so that the next row gets nothing from it
            fromLeft = pair - own >> Integer.SIZE;
        }
        return sum;
    }
}
