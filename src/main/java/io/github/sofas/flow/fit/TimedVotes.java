package io.github.sofas.flow.fit;

/**
 * The bilinear votes of events in three pictures: of the events, of their times, and of the squares of their times. One
 * scan of the cells gives the slope of the metric by every parameter of the motion, and the loss beside the motion.
 * Ours, because projections beside the motion need votes of their own, two for each parameter, and are less exact.
 *
 * <p>The metric is a sum over pairs of events of a function K of the distance between the two. Consider a parameter p
 * that shifts an event of time t by p t u, where u depends on the place and is about the same for events that meet. The
 * metric then rises by the sum of (t1 - t2) u K', and bends by the sum of (t1 - t2)² u² K''. Let V be the picture of
 * the events, T that of their times and Q that of the squares. Then these are sums over cells of 2 u T V', and of 2 u²
 * (Q V'' - T T''). What an event adds by meeting itself drops out of both, because its t1 - t2 is 0. Slopes and bends
 * of a picture are those of a parabola through neighbouring cells.
 */
final class TimedVotes {
    /** Times are whole numbers up to this, so that the squares of as many events as are measured fit an int. */
    static final int MOST_TIME = 22;
    private static final int TIME_BITS = 16;
    /** Cells of a block, as a power of two; blocks without votes are skipped. */
    private static final int BLOCK_BITS = 3;
    private static final int KEYS = BilinearAccumulator.KEYS;
    private static final double ONE = StrictMath.pow(BilinearAccumulator.SUB, -4);

    /** Votes in the low half, votes times time in the high half of each cell; all 0 between two calls. */
    private final long[] pairs;
    private final int[] squares;
    private final byte[] used;
    // over all events: sums of votes squared, and means of the square and the fourth power of time
    private long own;
    private double square;
    private double fourth;

    /** Makes three pictures of so many cells. */
    TimedVotes(int cells) {
        int blocks = (cells >> BLOCK_BITS) + 1;
        pairs = new long[blocks << BLOCK_BITS];
        squares = new int[blocks << BLOCK_BITS];
        used = new byte[blocks];
    }

    /** Bytes of the arrays for so many cells. */
    static long bytes(long cells) {
        return (Long.BYTES + Integer.BYTES) * cells + (cells >> BLOCK_BITS);
    }

    /**
     * Adds what the events show of each parameter.
     *
     * @param at cell, sign and place in the cell of each event, at least one; events on the outermost cells show
     *     nothing
     * @param time of each event from the reference in s
     * @param columns of the grid, and rows
     * @param x0 column of the first cell from the structure's centre, in px, and y0 its row
     */
    void addSlopes(int[] at, int size, ShiftProfile time, int columns, int rows, double x0, double y0, double cellPx,
                   MetricSlopes to) {
        int perTime = time.most() == 0 ? 0 : (MOST_TIME << TIME_BITS) / time.most();
        vote(at, size, time.shift, perTime, columns);
        double unit = perTime == 0 ? 0 : time.unit() * (1 << TIME_BITS) / perTime;
        look(columns, rows, x0, y0, cellPx, unit, to);
        to.changeShare = square == 0 ? 0 : (fourth - square * square) / (4 * square) * unit * unit;
        clear(columns * rows);
    }

    private void vote(int[] at, int size, int[] time, int perTime, int columns) {
        long[] cells = pairs;
        int[] ofSquares = squares;
        byte[] blocks = used;
        long ofVotes = 0;
        long ofTimes = 0;
        long ofFourths = 0;
        for (int i = 0; i < size; i++) {
            int c = at[i] >>> BilinearAccumulator.KEY_BITS;
            int k = at[i] & KEYS - 1;
            int w00 = BilinearAccumulator.VOTE_00[k];
            int w10 = BilinearAccumulator.VOTE_10[k];
            int w01 = BilinearAccumulator.VOTE_01[k];
            int w11 = BilinearAccumulator.VOTE_11[k];
            int below = c + columns;
            int t = time[i] * perTime + (1 << TIME_BITS - 1) >> TIME_BITS;
            int tt = t * t;
            long one = ((long) t << Integer.SIZE) + 1;
            cells[c] += w00 * one;
            cells[c + 1] += w10 * one;
            cells[below] += w01 * one;
            cells[below + 1] += w11 * one;
            ofSquares[c] += w00 * tt;
            ofSquares[c + 1] += w10 * tt;
            ofSquares[below] += w01 * tt;
            ofSquares[below + 1] += w11 * tt;
            blocks[c >> BLOCK_BITS] = 1;
            blocks[c + 1 >> BLOCK_BITS] = 1;
            blocks[below >> BLOCK_BITS] = 1;
            blocks[below + 1 >> BLOCK_BITS] = 1;
            ofVotes += DenseVotes.SQUARES[k];
            ofTimes += tt;
            ofFourths += tt * tt;
        }
        own = ofVotes;
        square = (double) ofTimes / size;
        fourth = (double) ofFourths / size;
    }

    private void look(int columns, int rows, double x0, double y0, double cellPx, double unit, MetricSlopes to) {
        // the slope is half the difference of the cells on both sides, and counts for each of the two events of a pair
        double slope = -ONE / cellPx * unit;
        double loss = -ONE / (cellPx * cellPx) * unit * unit;
        double perColumn = 1.0 / columns;
        // cells with neighbours all around
        int last = columns * (rows - 1) - 1;
        long met = -own;
        double vx = 0;
        double vy = 0;
        double ax = 0;
        double ay = 0;
        double turn = 0;
        double spin = 0;
        double grow = 0;
        double lossXx = 0;
        double lossXy = 0;
        double lossYy = 0;
        double lossTurn = 0;
        double lossGrow = 0;
        for (int block = 0; block << BLOCK_BITS < columns * rows; block++) {
            if (used[block] == 0) {
                continue;
            }
            int end = Math.min(block + 1 << BLOCK_BITS, last);
            for (int c = Math.max(block << BLOCK_BITS, columns + 1); c < end; c++) {
                long pair = pairs[c];
                int q = squares[c];
                if (pair == 0 && q == 0) {
                    continue;
                }
                int v = (int) pair;
                long t = pair - v >> Integer.SIZE;
                met += (long) v * v;
                int row = (int) ((c + 0.5) * perColumn);
                double rx = x0 + (c - row * columns) * cellPx;
                double ry = y0 + row * cellPx;
                int gx = (int) (pairs[c + 1] - pairs[c - 1]);
                int gy = (int) (pairs[c + columns] - pairs[c - columns]);
                // squares of time count by their difference from the mean: what shifts all events alike changes nothing
                double late = q - square * v;
                vx += (double) gx * t;
                vy += (double) gy * t;
                ax += gx * late;
                ay += gy * late;
                double across = gy * rx - gx * ry;
                turn += across * t;
                spin += across * late;
                grow += (gx * rx + gy * ry) * t;
                double bx = bend(q, t, pairs[c - 1] + pairs[c + 1] - 2 * pair);
                double by = bend(q, t, pairs[c - columns] + pairs[c + columns] - 2 * pair);
                double bxy = bend(q, t, pairs[c + columns + 1] - pairs[c - columns + 1] - pairs[c + columns - 1]
                    + pairs[c - columns - 1]) / 4;
                lossXx += bx;
                lossXy += bxy;
                lossYy += by;
                lossTurn += bx * ry * ry - 2 * bxy * rx * ry + by * rx * rx;
                lossGrow += bx * rx * rx + 2 * bxy * rx * ry + by * ry * ry;
                if (to.plane != null) {
                    to.plane.add(rx, ry, slope * gx * t, slope * gy * t, loss * bx, loss * bxy, loss * by);
                }
            }
        }
        to.metric += met * ONE;
        to.vx += vx * slope;
        to.vy += vy * slope;
        to.ax += ax * slope * unit / 2;
        to.ay += ay * slope * unit / 2;
        to.turn += turn * slope;
        to.spin += spin * slope * unit / 2;
        to.grow += grow * slope;
        to.lossXx += lossXx * loss;
        to.lossXy += lossXy * loss;
        to.lossYy += lossYy * loss;
        to.lossTurn += lossTurn * loss;
        to.lossGrow += lossGrow * loss;
    }

    /**
     * The part of a cell in the sum over pairs of (t1 - t2)² K''; {@code both} holds K'' of two pictures in one number.
     */
    private static double bend(int q, long t, long both) {
        int ofEvents = (int) both;
        return (double) q * ofEvents - (double) t * (both - ofEvents >> Integer.SIZE);
    }

    private void clear(int cells) {
        for (int block = 0; block << BLOCK_BITS < cells; block++) {
            if (used[block] != 0) {
                used[block] = 0;
                int end = block + 1 << BLOCK_BITS;
                for (int c = block << BLOCK_BITS; c < end; c++) {
                    pairs[c] = 0;
                    squares[c] = 0;
                }
            }
        }
    }
}
