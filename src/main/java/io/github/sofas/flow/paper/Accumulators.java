package io.github.sofas.flow.paper;

import java.util.Arrays;

/**
 * The accumulators of a track plane's 3 x 3 projections: how many live events fall on each cell (section Track Plane).
 * The occupied cells of the central one are the contour.
 */
final class Accumulators {
    private static final int SIDE = LiveEvents.SIDE;

    /** Live events per cell, one array for each projection; of a cell, columns are the low bits. */
    private final short[][] f;
    /** Occupied cells of each projection. */
    private final int[] cells = new int[SIDE * SIDE];
    private final int shift;

    Accumulators(int columnBits, int cells) {
        shift = columnBits;
        f = new short[SIDE * SIDE][cells];
    }

    /** The most bytes that they take. */
    static long bytes(long cells) {
        return cells * SIDE * SIDE * Short.BYTES;
    }

    /** Occupied cells of each projection, row by row; read only. */
    int[] cells() {
        return cells;
    }

    /** Cell of an event in the k-th projection. */
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

    /** Takes an event out of all projections. */
    void remove(LiveEvents live, int event) {
        for (int k = 0; k < f.length; k++) {
            if (--f[k][cell(k, live, event)] == 0) {
                cells[k]--;
            }
        }
    }

    /** Puts the live events on empty accumulators. */
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

    /** Empties them of the live events. */
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
