package io.github.sofas.export;

import io.github.sofas.event.EventBatch;
import io.github.sofas.export.TableColumn.Type;
import io.github.sofas.flow.FlowOutput;
import java.io.IOException;
import java.nio.file.Path;
import java.util.List;
import java.util.Map;

/**
 * Writes one row for every event, its flow and segment, with the columns of {@link FlowCsvWriter} and their types:
 * {@code t_us} of 64 bits, {@code x} and {@code y} of 16, {@code polarity} of 8, velocities as 32-bit floats that are
 * NaN where the event has no flow, {@code segment} of 32. CSV is written by {@link FlowCsvWriter}.
 */
public final class FlowTable implements FlowWriter {
    private static final int ROWS = 1 << 14;
    private static final List<TableColumn> COLUMNS = List.of(new TableColumn("t_us", Type.INT64),
        new TableColumn("x", Type.INT16), new TableColumn("y", Type.INT16), new TableColumn("polarity", Type.INT8),
        new TableColumn("vx_px_per_s", Type.FLOAT32), new TableColumn("vy_px_per_s", Type.FLOAT32),
        new TableColumn("segment", Type.INT32));

    private final TableWriter table;
    private final TableRows rows = new TableRows(COLUMNS, ROWS);

    private FlowTable(TableWriter table) {
        this.table = table;
    }

    /**
     * Starts a file.
     *
     * @param format of the file
     * @param results that the file is one of
     * @param file where it will be
     * @param metadata what is said of the table, by name
     * @return the writer
     * @throws IOException where it cannot be made
     */
    public static FlowWriter open(TableFormat format, ResultFiles results, Path file, Map<String, String> metadata)
            throws IOException {
        return format == TableFormat.CSV ? new FlowCsvWriter(results.create(file))
            : new FlowTable(format.open(results, file, COLUMNS, metadata));
    }

    @Override
    public void write(EventBatch batch, FlowOutput flow) throws IOException {
        for (int from = 0; from < batch.size();) {
            int n = rows.size();
            int count = Math.min(batch.size() - from, rows.capacity() - n);
            System.arraycopy(batch.timeUs, from, rows.longs(0), n, count);
            System.arraycopy(batch.x, from, rows.shorts(1), n, count);
            System.arraycopy(batch.y, from, rows.shorts(2), n, count);
            System.arraycopy(batch.polarity, from, rows.bytes(3), n, count);
            float[] vx = rows.floats(4);
            float[] vy = rows.floats(5);
            int[] segments = rows.ints(6);
            for (int i = 0; i < count; i++) {
                int segment = flow.segment[from + i];
                vx[n + i] = segment == 0 ? Float.NaN : flow.vxPxPerS[from + i];
                vy[n + i] = segment == 0 ? Float.NaN : flow.vyPxPerS[from + i];
                segments[n + i] = segment;
            }
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

    @Override
    public void close() throws IOException {
        try (table) {
            flush();
        }
    }
}
