package io.github.sofas.export;

import io.github.sofas.event.EventBatch;
import io.github.sofas.export.TableColumn.Type;
import java.io.Closeable;
import java.io.IOException;
import java.util.ArrayList;
import java.util.List;

/**
 * Collects rows of events and writes them to a table whenever enough have come together. A row has the columns of an
 * event, followed by those of its labels.
 */
final class EventRows implements Closeable {
    private static final int ROWS = 1 << 14;
    private static final List<TableColumn> EVENT = List.of(new TableColumn("t_us", Type.INT64),
        new TableColumn("x", Type.INT16), new TableColumn("y", Type.INT16), new TableColumn("polarity", Type.INT8));
    /** Index of the first column of the labels. */
    static final int LABELS = EVENT.size();

    /** Fills the columns of the labels in new rows. */
    interface Labels {
        /**
         * Fills {@code count} rows, beginning at {@code row}, for the events of the batch beginning at {@code from}.
         */
        void fill(TableRows rows, int row, int from, int count);
    }

    private final TableWriter table;
    private final TableRows rows;

    /** Starts without rows, for a table of these columns. */
    EventRows(TableWriter table, List<TableColumn> columns) {
        this.table = table;
        rows = new TableRows(columns, ROWS);
    }

    /** The columns of an event, followed by others. */
    static List<TableColumn> columns(TableColumn... labels) {
        List<TableColumn> columns = new ArrayList<>(EVENT);
        columns.addAll(List.of(labels));
        return List.copyOf(columns);
    }

    void write(EventBatch batch, Labels labels) throws IOException {
        for (int from = 0; from < batch.size();) {
            int n = rows.size();
            int count = Math.min(batch.size() - from, rows.capacity() - n);
            System.arraycopy(batch.timeUs, from, rows.longs(0), n, count);
            System.arraycopy(batch.x, from, rows.shorts(1), n, count);
            System.arraycopy(batch.y, from, rows.shorts(2), n, count);
            System.arraycopy(batch.polarity, from, rows.bytes(3), n, count);
            labels.fill(rows, n, from, count);
            rows.setSize(n + count);
            if (n + count == rows.capacity()) {
                flush();
            }
            from += count;
        }
    }

    private void flush() throws IOException {
        table.write(rows);
        rows.setSize(0);
    }

    /** Writes the remaining rows and closes the file. */
    @Override
    public void close() throws IOException {
        try (table) {
            flush();
        }
    }
}
