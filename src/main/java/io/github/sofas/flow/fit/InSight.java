package io.github.sofas.flow.fit;

/**
 * For how much of the window each cell of the grid was within the sensor, along a velocity, and the metric of votes
 * that counts what was in sight for a share f of the window as 1 / f.
 *
 * <p>Ours, because the border hides a part of what comes in or leaves. A slanted edge that comes in shows one point
 * that stays in sight, its end at the border, which slides along the border at any speed: along the true velocity cells
 * have fewer votes than along that of the end. A cell that was in sight for the share f of the window has f of the
 * votes that it would have; n² / f is the same along any velocity that an edge may have.
 */
final class InSight {
    /** Weight of what was in sight all the time, a power of two. */
    private static final int ONE_BITS = 4;
    private static final int ONE = 1 << ONE_BITS;
    /** Most that a cell counts: what was hardly in sight has few votes, by chance. */
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

    /** Makes one for grids of so many columns and rows at most. */
    InSight(int sensorWidth, int sensorHeight, int columns, int rows) {
        alongColumns = new Axis(sensorWidth, columns);
        alongRows = new Axis(sensorHeight, rows);
        weights = new int[columns * rows];
    }

    /** Bytes of the weights. */
    static long bytes(long cells) {
        return Integer.BYTES * cells;
    }

    /** Takes everything to be in sight all the time. */
    void clear() {
        isCutOff = false;
    }

    /** Takes the border to cut events off that move at (vx, vy) px/s, in the middle of a window of twice so long. */
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

    /** Takes everything to be in sight for as long as it pauses, whatever the border cuts off. */
    void pause(boolean pauses) {
        isPaused = pauses;
    }

    /**
     * Weighs the cells of a grid.
     *
     * @param left of its first column in px, top of its first row
     * @param besideVx velocity beside that at which the events move, in px/s, and besideVy
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

    /** When the columns or the rows of a grid are between 0 and a side of the sensor, from the middle of the window. */
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

        /** Whether it is there all the time. */
        boolean isAll(int k) {
            return from[k] == -half && until[k] == half;
        }
    }

    /**
     * Lets events vote on cells that were weighed; as {@link BilinearAccumulator} does, but that each meeting counts by
     * its cell.
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
