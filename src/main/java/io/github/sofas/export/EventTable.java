package io.github.sofas.export;

import io.github.sofas.event.EventBatch;
import java.io.Closeable;
import java.io.IOException;
import java.nio.file.Path;
import java.util.List;
import java.util.Map;

/** Writes one row for every event without flow: {@code t_us}, {@code x}, {@code y}, {@code polarity}, 1 or -1. */
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
        rows.write(batch, (filled, row, from, count) -> { });
    }

    /** Writes what is left and closes the file. */
    @Override
    public void close() throws IOException {
        rows.close();
    }
}
