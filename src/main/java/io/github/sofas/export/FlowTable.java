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
    private static final List<TableColumn> COLUMNS = EventRows.columns(new TableColumn("vx_px_per_s", Type.FLOAT32),
        new TableColumn("vy_px_per_s", Type.FLOAT32), new TableColumn("segment", Type.INT32));

    private final EventRows rows;

    private FlowTable(TableWriter table) {
        rows = new EventRows(table, COLUMNS);
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
        rows.write(batch, (filled, row, from, count) -> {
            float[] vx = filled.floats(EventRows.LABELS);
            float[] vy = filled.floats(EventRows.LABELS + 1);
            int[] segments = filled.ints(EventRows.LABELS + 2);
            for (int i = 0; i < count; i++) {
                int segment = flow.segment[from + i];
                vx[row + i] = segment == 0 ? Float.NaN : flow.vxPxPerS[from + i];
                vy[row + i] = segment == 0 ? Float.NaN : flow.vyPxPerS[from + i];
                segments[row + i] = segment;
            }
        });
    }

    @Override
    public void close() throws IOException {
        rows.close();
    }
}
