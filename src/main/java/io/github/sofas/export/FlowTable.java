package io.github.sofas.export;

import io.github.sofas.event.EventBatch;
import io.github.sofas.export.TableColumn.Type;
import io.github.sofas.flow.FlowOutput;
import java.io.IOException;
import java.nio.file.Path;
import java.util.List;
import java.util.Map;

/**
 * Writes one row for every event, with its flow and segment. The columns are those of {@link FlowCsvWriter}, with
 * types: {@code t_us} has 64 bits, {@code x} and {@code y} have 16, {@code polarity} has 8 and {@code segment} 32.
 * Velocities are 32-bit floats, NaN if the event has no flow. {@link FlowCsvWriter} itself writes CSV.
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
     * @param results group that holds the file until it is complete
     * @param file path of the file after the commit
     * @param metadata descriptions of the table, by name
     * @return the writer
     * @throws IOException if the file cannot be made
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
