package io.github.sofas.export;

import io.github.sofas.event.EventBatch;
import java.io.Closeable;
import java.io.IOException;
import java.nio.file.Path;
import java.util.List;
import java.util.Map;

/**
 * Writes a table of plain events, without flow. Each event has one row: {@code t_us}, {@code x}, {@code y}, and
 * {@code polarity}, 1 or -1.
 */
public final class EventTable implements Closeable {
    private static final List<TableColumn> COLUMNS = EventRows.columns();

    private final EventRows rows;

    private EventTable(TableWriter table) {
        rows = new EventRows(table, COLUMNS);
    }

    /**
     * Starts a file.
     *
     * @param format of the file
     * @param results group that holds the file until it is complete
     * @param file path of the file after the commit
     * @param metadata descriptions of the table, by name
     * @return the table, without rows
     * @throws IOException if the file cannot be made
     */
    public static EventTable open(TableFormat format, ResultFiles results, Path file, Map<String, String> metadata)
            throws IOException {
        return new EventTable(format.open(results, file, COLUMNS, metadata));
    }

    /**
     * Writes the rows of a batch.
     *
     * @param batch the events
     * @throws IOException if the rows cannot be written
     */
    public void write(EventBatch batch) throws IOException {
        rows.write(batch, (filled, row, from, count) -> { });
    }

    /** Writes the remaining rows and closes the file. */
    @Override
    public void close() throws IOException {
        rows.close();
    }
}
