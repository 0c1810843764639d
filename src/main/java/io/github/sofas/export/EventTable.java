package io.github.sofas.export;

import io.github.sofas.event.EventBatch;
import io.github.sofas.export.TableColumn.Type;
import java.io.Closeable;
import java.io.IOException;
import java.nio.file.Path;
import java.util.List;
import java.util.Map;

/** Writes one row for every event without flow: {@code t_us}, {@code x}, {@code y}, {@code polarity}, 1 or -1. */
public final class EventTable implements Closeable {
    private static final int ROWS = 1 << 14;
    private static final List<TableColumn> COLUMNS = List.of(new TableColumn("t_us", Type.INT64),
        new TableColumn("x", Type.INT16), new TableColumn("y", Type.INT16), new TableColumn("polarity", Type.INT8));

    private final TableWriter table;
    private final TableRows rows = new TableRows(COLUMNS, ROWS);

    private EventTable(TableWriter table) {
        this.table = table;
    }

    /**
     * Starts a file.
     *
     * @param format of the file
     * @param results holds the file until it is whole
     * @param file where it will be
     * @param metadata what is said of the table, by name
     * @return the table, without a row
     * @throws IOException where it cannot be made
     */
    public static EventTable open(TableFormat format, ResultFiles results, Path file, Map<String, String> metadata)
            throws IOException {
        return new EventTable(format.open(results, file, COLUMNS, metadata));
    }

    /**
     * Writes the rows of a batch.
     *
     * @param batch the events
     * @throws IOException where they cannot be written
     */
    public void write(EventBatch batch) throws IOException {
        for (int from = 0; from < batch.size();) {
            int n = rows.size();
            int count = Math.min(batch.size() - from, rows.capacity() - n);
            System.arraycopy(batch.timeUs, from, rows.longs(0), n, count);
            System.arraycopy(batch.x, from, rows.shorts(1), n, count);
            System.arraycopy(batch.y, from, rows.shorts(2), n, count);
            System.arraycopy(batch.polarity, from, rows.bytes(3), n, count);
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

    /** Writes what is left and closes the file. */
    @Override
    public void close() throws IOException {
        try (table) {
            flush();
        }
    }
}
