package io.github.sofas.flow.paper;

import java.util.Arrays;

/**
 * The accumulators of the 3 x 3 projections of a track plane: the number of live events on each cell (paper, section
 * Track Plane). The occupied cells of the central projection are the contour.
 */
final class Accumulators {
    private static final int SIDE = LiveEvents.SIDE;

    /** Live events per cell, one array for each projection. The low bits of a cell's index are its column. */
    private final short[][] f;
    /** Number of occupied cells of each projection. */
    private final int[] cells = new int[SIDE * SIDE];
    private final int shift;

    Accumulators(int columnBits, int cells) {
        shift = columnBits;
        f = new short[SIDE * SIDE][cells];
    }

    /** Upper bound of the bytes that the accumulators take. */
    static long bytes(long cells) {
        return cells * SIDE * SIDE * Short.BYTES;
    }

    /** Number of occupied cells of each projection, row by row; read only. */
    int[] cells() {
        return cells;
    }

    /** Cell on which an event falls in the k-th projection. */
    int cell(int k, LiveEvents live, int event) {
        return live.row[k / SIDE][event] << shift | live.column[k % SIDE][event];
    }

    boolean isOccupied(int k, int cell) {
        return f[k][cell] > 0;
    }

    void add(int k, int cell) {
        if (f[k][cell]++ == 0) {
            cells[k]++;
        }
    }

    /** Removes an event from all projections. */
    void remove(LiveEvents live, int event) {
        for (int k = 0; k < f.length; k++) {
            if (--f[k][cell(k, live, event)] == 0) {
                cells[k]--;
            }
        }
    }

    /** Adds all live events to accumulators that are empty. */
    void fill(LiveEvents live) {
        for (int k = 0; k < f.length; k++) {
            cells[k] = fill(f[k], live.column[k % SIDE], live.row[k / SIDE], live.tail, live.head);
        }
    }

    private int fill(short[] counts, short[] columns, short[] rows, int from, int to) {
        int occupied = 0;
        for (int i = from; i < to; i++) {
            int c = rows[i] << shift | columns[i];
            int before = counts[c];
            counts[c] = (short) (before + 1);
            occupied += before == 0 ? 1 : 0;
        }
        return occupied;
    }

    /** Empties the accumulators: clears the cells of the live events. */
    void clear(LiveEvents live) {
        for (int k = 0; k < f.length; k++) {
            clear(f[k], live.column[k % SIDE], live.row[k / SIDE], live.tail, live.head);
        }
        Arrays.fill(cells, 0);
    }

    private void clear(short[] counts, short[] columns, short[] rows, int from, int to) {
        for (int i = from; i < to; i++) {
            counts[rows[i] << shift | columns[i]] = 0;
        }
    }
}
