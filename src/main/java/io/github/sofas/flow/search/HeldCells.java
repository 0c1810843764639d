package io.github.sofas.flow.search;

/**
 * The cells of an accumulator that the events held fall on: of each row as many columns from one on, and so many rows.
 * The accumulator is a torus, larger than the sensor: they may go on at its other side. Ours, because looking through
 * all cells is a tenth of what dense texture costs, and less than half of them have votes.
 */
final class HeldCells {
    private final int columns;
    private final int rows;
    private int firstColumn;
    private int columnCount;
    private int firstRow;
    private int rowCount;

    /** Makes it for an accumulator of so many columns and rows. */
    HeldCells(int columns, int rows) {
        this.columns = columns;
        this.rows = rows;
    }

    /** Has other cells from now on; of more columns or rows than there are, all. */
    void set(int fromColumn, int itsColumns, int fromRow, int itsRows) {
        firstColumn = fromColumn;
        columnCount = Math.min(columns, itsColumns);
        firstRow = fromRow;
        rowCount = Math.min(rows, itsRows);
    }

    /** Whether a row has any. */
    boolean hasRow(int row) {
        return (row - firstRow & rows - 1) < rowCount;
    }

    /** Column after the last one of those at the beginning of each row, which go on from its end; 0 where none do. */
    int untilColumn() {
        return Math.max(0, firstColumn + columnCount - columns);
    }

    /** The first of the other columns. */
    int fromColumn() {
        return firstColumn;
    }

    /** Column after the last of those. */
    int endColumn() {
        return Math.min(columns, firstColumn + columnCount);
    }
}
