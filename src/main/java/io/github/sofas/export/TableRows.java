package io.github.sofas.export;

import java.util.List;

/**
 * Rows of a table, with an array for each column. The arrays are made once and filled again and again. For one thread
 * at a time.
 */
final class TableRows {
    private final List<TableColumn> columns;
    private final Object[] arrays;
    private final int capacity;
    private int size;

    /** Makes room for {@code capacity} rows. */
    TableRows(List<TableColumn> columns, int capacity) {
        this.columns = List.copyOf(columns);
        this.capacity = capacity;
        arrays = new Object[columns.size()];
        for (int i = 0; i < arrays.length; i++) {
            switch (columns.get(i).type()) {
                case INT64:
                    arrays[i] = new long[capacity];
                    break;
                case INT32:
                    arrays[i] = new int[capacity];
                    break;
                case INT16:
                    arrays[i] = new short[capacity];
                    break;
                case INT8:
                    arrays[i] = new byte[capacity];
                    break;
                default:
                    arrays[i] = new float[capacity];
                    break;
            }
        }
    }

    List<TableColumn> columns() {
        return columns;
    }

    int capacity() {
        return capacity;
    }

    /** Number of rows filled. */
    int size() {
        return size;
    }

    void setSize(int newSize) {
        size = newSize;
    }

    long[] longs(int column) {
        return (long[]) arrays[column];
    }

    int[] ints(int column) {
        return (int[]) arrays[column];
    }

    short[] shorts(int column) {
        return (short[]) arrays[column];
    }

    byte[] bytes(int column) {
        return (byte[]) arrays[column];
    }

    float[] floats(int column) {
        return (float[]) arrays[column];
    }
}
