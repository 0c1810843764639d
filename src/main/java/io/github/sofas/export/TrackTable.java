package io.github.sofas.export;

import io.github.sofas.event.EventBatch;
import io.github.sofas.export.TableColumn.Type;
import io.github.sofas.flow.FlowOutput;
import java.io.Closeable;
import java.io.IOException;
import java.io.OutputStream;
import java.nio.file.Path;
import java.util.List;
import java.util.Map;
import java.util.TreeMap;

/**
 * Writes where each segment was and how it moved. The table has one row for every {@value #STEP_US} µs and segment with
 * events in this step, sorted by time, then by segment. All values are computed from the segment's events in the step.
 *
 * <p>{@code t_us} is the start of the step, a multiple of {@value #STEP_US}. {@code x} and {@code y} are the mean of
 * the events' pixels, and {@code min_x} to {@code max_y} their bounding box. {@code vx_px_per_s} and
 * {@code vy_px_per_s} are the mean of their velocities.
 *
 * <p>{@code turn_rad_per_s} (positive from right to down) and {@code growth_per_s} are the turn and growth of the
 * velocities about the centre by least squares: v = v0 + turn (-y, x) + growth (x, y). Both are empty if the events lie
 * too close together to determine them. {@code events} is the number of events.
 */
public final class TrackTable implements Closeable {
    /** Length of a step. */
    public static final int STEP_US = 10_000;

    private static final int ROWS = 1024;
    /** Mean square distance from the centre below which turn and growth cannot be determined, px². */
    private static final double LEAST_SQUARE_PX = 1;
    private static final List<TableColumn> COLUMNS = List.of(new TableColumn("t_us", Type.INT64),
        new TableColumn("segment", Type.INT32), new TableColumn("x", Type.FLOAT32),
        new TableColumn("y", Type.FLOAT32), new TableColumn("min_x", Type.INT16),
        new TableColumn("min_y", Type.INT16), new TableColumn("max_x", Type.INT16),
        new TableColumn("max_y", Type.INT16), new TableColumn("vx_px_per_s", Type.FLOAT32),
        new TableColumn("vy_px_per_s", Type.FLOAT32), new TableColumn("turn_rad_per_s", Type.FLOAT32),
        new TableColumn("growth_per_s", Type.FLOAT32), new TableColumn("events", Type.INT32));

    private final TableWriter table;
    private final TableRows rows = new TableRows(COLUMNS, ROWS);
    /** Sums of the segments of the current step, by id. */
    private final TreeMap<Integer, Sums> sums = new TreeMap<>();
    private Sums last;
    private int lastSegment;
    private long step = Long.MIN_VALUE;

    /** Sums over the events of a segment in one step. */
    private static final class Sums {
        private int count;
        private double x;
        private double y;
        private double squares;
        private double vx;
        private double vy;
        private double turns;
        private double growths;
        private int minX = Integer.MAX_VALUE;
        private int minY = Integer.MAX_VALUE;
        private int maxX = Integer.MIN_VALUE;
        private int maxY = Integer.MIN_VALUE;

        void add(int px, int py, double pvx, double pvy) {
            count++;
            x += px;
            y += py;
            squares += (double) px * px + (double) py * py;
            vx += pvx;
            vy += pvy;
            turns += px * pvy - py * pvx;
            growths += px * pvx + py * pvy;
            minX = Math.min(minX, px);
            minY = Math.min(minY, py);
            maxX = Math.max(maxX, px);
            maxY = Math.max(maxY, py);
        }
    }

    private TrackTable(TableWriter table) {
        this.table = table;
    }

    /**
     * Starts a file.
     *
     * @param format of the file
     * @param results group that holds the file until it is complete
     * @param file path of the file after the commit
     * @param metadata descriptions of the table, by name
     * @return the table
     * @throws IOException if the file cannot be made
     */
    public static TrackTable open(TableFormat format, ResultFiles results, Path file, Map<String, String> metadata)
            throws IOException {
        return new TrackTable(format.open(results, file, COLUMNS, metadata));
    }

    /**
     * Starts a table as CSV.
     *
     * @param out receives the text; closed by {@link #close()}
     * @return the table
     */
    public static TrackTable csv(OutputStream out) {
        return new TrackTable(new CsvTable(out, COLUMNS));
    }

    /**
     * Takes a batch, and writes the steps that are over.
     *
     * @param batch the events
     * @param flow labels of the same events
     * @throws IOException if the rows cannot be written
     */
    public void add(EventBatch batch, FlowOutput flow) throws IOException {
        for (int i = 0; i < batch.size(); i++) {
            int segment = flow.segment[i];
            if (segment == 0) {
                continue;
            }
            long its = Math.floorDiv(batch.timeUs[i], STEP_US);
            if (its != step) {
                endStep();
                step = its;
            }
            if (last == null || segment != lastSegment) {
                last = sums.computeIfAbsent(segment, id -> new Sums());
                lastSegment = segment;
            }
            last.add(batch.x[i], batch.y[i], flow.vxPxPerS[i], flow.vyPxPerS[i]);
        }
    }

    private void endStep() throws IOException {
        for (Map.Entry<Integer, Sums> each : sums.entrySet()) {
            put(each.getKey(), each.getValue());
        }
        sums.clear();
        last = null;
    }

    private void put(int segment, Sums of) throws IOException {
        int row = rows.size();
        double x = of.x / of.count;
        double y = of.y / of.count;
        double vx = of.vx / of.count;
        double vy = of.vy / of.count;
        double square = of.squares / of.count - x * x - y * y;
        boolean isWide = square >= LEAST_SQUARE_PX;
        rows.longs(0)[row] = step * STEP_US;
        rows.ints(1)[row] = segment;
        rows.floats(2)[row] = (float) x;
        rows.floats(3)[row] = (float) y;
        rows.shorts(4)[row] = (short) of.minX;
        rows.shorts(5)[row] = (short) of.minY;
        rows.shorts(6)[row] = (short) of.maxX;
        rows.shorts(7)[row] = (short) of.maxY;
        rows.floats(8)[row] = (float) vx;
        rows.floats(9)[row] = (float) vy;
        rows.floats(10)[row] = isWide ? (float) ((of.turns / of.count - x * vy + y * vx) / square) : Float.NaN;
        rows.floats(11)[row] = isWide ? (float) ((of.growths / of.count - x * vx - y * vy) / square) : Float.NaN;
        rows.ints(12)[row] = of.count;
        rows.setSize(row + 1);
        if (rows.size() == rows.capacity()) {
            flush();
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
            endStep();
            flush();
        }
    }
}
