package io.github.sofas.flow.paper;

import java.util.Arrays;

/**
 * Cells raised by events that missed the contour. Past a threshold, a cell becomes contour (paper, section Track
 * Plane).
 *
 * <p>Raised cells have no lifetime, so that a later cell may fold to the same place of the torus. Time only advances,
 * and the velocity stays the same: by then, the earlier cell is off the sensor for good, and the later one starts anew.
 */
final class RaisedCells {
    /** Number of times each cell was raised, and which of the cells that fold to this place it is. */
    private final short[] raised;
    private final int[] fold;
    private int[] list = new int[64];
    private int size;

    RaisedCells(int cells) {
        raised = new short[cells];
        fold = new int[cells];
    }

    /** Upper bound of the bytes that the arrays take, with a list of all cells at the length it may have grown to. */
    static long mostBytes(long cells) {
        return cells * (Short.BYTES + 3 * Integer.BYTES);
    }

    /** Raises a cell; returns whether the cell is past the threshold. */
    boolean raise(int c, int whichFold, int threshold) {
        if (raised[c] == 0) {
            if (size == list.length) {
                list = Arrays.copyOf(list, 2 * size);
            }
            list[size++] = c;
        } else if (fold[c] != whichFold) {
            raised[c] = 0;
        }
        fold[c] = whichFold;
        if (raised[c] <= threshold) {
            raised[c]++;
        }
        return raised[c] > threshold;
    }

    void clear() {
        for (int i = 0; i < size; i++) {
            raised[list[i]] = 0;
        }
        size = 0;
    }
}
