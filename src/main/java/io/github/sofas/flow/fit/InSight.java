package io.github.sofas.flow.fit;

/**
 * The share of the window for which each cell of the grid is in sight, that is, within the sensor along a velocity; and
 * a metric in which each meeting counts 1 / f on a cell that was in sight for a share f of the window.
 *
 * <p>Ours, because the border hides a part of an edge that enters or leaves. A slanted edge that enters shows one point
 * that stays in sight, its end at the border, which slides along the border at any speed. Along the true velocity,
 * cells have fewer votes than along the velocity of that end. A cell that was in sight for a share f of the window has
 * the share f of the votes that it would have; n² / f is the same along any velocity that an edge may have.
 */
final class InSight {
    /** Weight of a cell that was in sight all the time, as a power of two. */
    private static final int ONE_BITS = 4;
    private static final int ONE = 1 << ONE_BITS;
    /** Greatest factor for a cell: one that was hardly in sight has few votes, and these by chance. */
    private static final double MOST = 4;
    /** Velocity in px/s below which nothing leaves the sensor. */
    private static final double STILL = 1e-6;

    private final Axis alongColumns;
    private final Axis alongRows;
    private final int[] weights;
    private boolean isCutOff;
    private boolean isPaused;
    private double vx;
    private double vy;
    /** Half the window in s. */
    private double half;

    /** Makes weights for grids of at most so many columns and rows. */
    InSight(int sensorWidth, int sensorHeight, int columns, int rows) {
        alongColumns = new Axis(sensorWidth, columns);
        alongRows = new Axis(sensorHeight, rows);
        weights = new int[columns * rows];
    }

    /** Bytes of the weights. */
    static long bytes(long cells) {
        return Integer.BYTES * cells;
    }

    /** Treats all cells as in sight all the time. */
    void clear() {
        isCutOff = false;
    }

    /**
     * Accounts for a border that cuts off events that move at (ofVx, ofVy) px/s; the grid shows them as in the middle
     * of a window of twice {@code halfS}.
     */
    void cutOff(double ofVx, double ofVy, double halfS) {
        isCutOff = halfS > 0;
        vx = ofVx;
        vy = ofVy;
        half = halfS;
    }

    /** Whether the border cuts events off. */
    boolean isCutOff() {
        return isCutOff && !isPaused;
    }

    /** Treats all cells as in sight during a pause, whatever the border cuts off. */
    void pause(boolean pauses) {
        isPaused = pauses;
    }

    /**
     * Weighs the cells of a grid.
     *
     * @param left side of its first column in px, top that of its first row
     * @param besideVx velocity relative to that of the events, in px/s, and besideVy
     */
    void weigh(int columns, int rows, double left, double top, double cellPx, double besideVx, double besideVy) {
        alongColumns.take(columns, left, cellPx, vx + besideVx);
        alongRows.take(rows, top, cellPx, vy + besideVy);
        for (int row = 0; row < rows; row++) {
            boolean isAll = alongRows.isAll(row);
            for (int column = 0; column < columns; column++) {
                weights[row * columns + column] = isAll && alongColumns.isAll(column) ? ONE : weight(column, row);
            }
        }
    }

    private int weight(int column, int row) {
        double from = Math.max(alongColumns.from[column], alongRows.from[row]);
        double until = Math.min(alongColumns.until[column], alongRows.until[row]);
        double share = (until - from) / (2 * half);
        double counts = share * MOST > 1 ? 1 / share : MOST;
        return (int) Math.rint(counts * ONE);
    }

    /**
     * The times, from the middle of the window, at which columns or rows of a grid enter and leave the sensor along one
     * axis.
     */
    private final class Axis {
        private final double side;
        private final double[] from;
        private final double[] until;

        Axis(double side, int most) {
            this.side = side;
            from = new double[most];
            until = new double[most];
        }

        void take(int count, double first, double cellPx, double pxPerS) {
            boolean moves = Math.abs(pxPerS) > STILL;
            for (int k = 0; k < count; k++) {
                double px = first + (k + 0.5) * cellPx;
                double comes = moves ? -px / pxPerS : -half;
                double goes = moves ? (side - px) / pxPerS : half;
                from[k] = Math.max(-half, Math.min(comes, goes));
                until[k] = Math.min(half, Math.max(comes, goes));
            }
        }

        /** Whether a column or row is in sight all the time. */
        boolean isAll(int k) {
            return from[k] == -half && until[k] == half;
        }
    }

    /**
     * Counts the votes of events on cells that were weighed, as {@link BilinearAccumulator} does, but weighs each
     * meeting by its cell.
     *
     * @param keys cells of the events, with their places in them
     * @param grid empty
     */
    long vote(int[] keys, int size, int[] grid, int columns) {
        long sum = 0;
        for (int i = 0; i < size; i++) {
            int c = keys[i] >>> BilinearAccumulator.KEY_BITS;
            int k = keys[i] & BilinearAccumulator.KEYS - 1;
            int w00 = BilinearAccumulator.VOTE_00[k];
            int w10 = BilinearAccumulator.VOTE_10[k];
            int w01 = BilinearAccumulator.VOTE_01[k];
            int w11 = BilinearAccumulator.VOTE_11[k];
            int below = c + columns;
            sum += (long) weights[c] * (w00 * grid[c] + w10 * grid[c + 1] + w01 * grid[below] + w11 * grid[below + 1]);
            grid[c] += w00;
            grid[c + 1] += w10;
            grid[below] += w01;
            grid[below + 1] += w11;
        }
        return sum >> ONE_BITS;
    }
}
