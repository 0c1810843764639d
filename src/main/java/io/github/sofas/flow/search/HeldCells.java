package io.github.sofas.flow.search;

/**
 * The cells of an accumulator on which the held events fall: a range of columns, the same in each row, and a range of
 * rows. The accumulator is a torus larger than the sensor, so that either range may wrap around. Ours, because looking
 * through all cells is a tenth of the cost of dense texture, and fewer than half of the cells have votes.
 */
final class HeldCells {
    private final int columns;
    private final int rows;
    private int firstColumn;
    private int columnCount;
    private int firstRow;
    private int rowCount;

    /** Creates ranges for an accumulator with the given numbers of columns and rows. */
    HeldCells(int columns, int rows) {
        this.columns = columns;
        this.rows = rows;
    }

    /** Sets the ranges. Counts greater than those of the accumulator mean all columns or rows. */
    void set(int fromColumn, int itsColumns, int fromRow, int itsRows) {
        firstColumn = fromColumn;
        columnCount = Math.min(columns, itsColumns);
        firstRow = fromRow;
        rowCount = Math.min(rows, itsRows);
    }

    /** Whether a row is in the range of rows. */
    boolean hasRow(int row) {
        return (row - firstRow & rows - 1) < rowCount;
    }

    /** End, exclusive, of the columns that wrap around to the beginning of each row; 0 where none do. */
    int untilColumn() {
        return Math.max(0, firstColumn + columnCount - columns);
    }

    /** First column of the range. */
    int fromColumn() {
        return firstColumn;
    }

    /** End, exclusive, of the columns that do not wrap around. */
    int endColumn() {
        return Math.min(columns, firstColumn + columnCount);
    }
}
