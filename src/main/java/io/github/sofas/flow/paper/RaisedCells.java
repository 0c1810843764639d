package io.github.sofas.flow.paper;

import java.util.Arrays;

/**
 * Cells that events which missed the contour have raised; past a threshold a cell is contour (section Track Plane).
 *
 * <p>Raised cells have no lifetime, so that a later one may fold to the same place of the torus. Time and velocity only
 * lead on: the earlier one is then off the sensor for good, and the later one starts anew.
 */
final class RaisedCells {
    /** How often each cell was raised, and which of the cells that fold to it. */
    private final short[] raised;
    private final int[] fold;
    private int[] list = new int[64];
    private int size;

    RaisedCells(int cells) {
        raised = new short[cells];
        fold = new int[cells];
    }

    /** The most bytes that its arrays take: the list of a cell each, as long as it may have grown. */
    static long mostBytes(long cells) {
        return cells * (Short.BYTES + 3 * Integer.BYTES);
    }

    /** Raises a cell; returns whether it is past the threshold. */
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
