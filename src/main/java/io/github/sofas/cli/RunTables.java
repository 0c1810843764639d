package io.github.sofas.cli;

import io.github.sofas.event.EventBatch;
import io.github.sofas.export.FlowTable;
import io.github.sofas.export.FlowWriter;
import io.github.sofas.export.ResultFiles;
import io.github.sofas.export.TableFormat;
import io.github.sofas.export.TrackTable;
import io.github.sofas.flow.FlowOutput;
import java.io.Closeable;
import java.io.IOException;
import java.util.ArrayList;
import java.util.List;
import java.util.Map;

/** The tables of events and tracks of a run, in each of its formats. */
final class RunTables implements Closeable {
    private final List<FlowWriter> flows = new ArrayList<>();
    private final List<TrackTable> tracks = new ArrayList<>();

    /**
     * Opens both tables in one more format.
     *
     * @param metadata metadata of the tables
     * @throws IOException if a file cannot be written
     */
    void open(TableFormat format, ResultFiles results, ResultNames names, Map<String, String> metadata)
            throws IOException {
        flows.add(FlowTable.open(format, results, names.flow(format), metadata));
        tracks.add(TrackTable.open(format, results, names.tracks(format), metadata));
    }

    /** Writes labelled events to all tables. */
    void write(EventBatch batch, FlowOutput flow) throws IOException {
        for (FlowWriter each : flows) {
            each.write(batch, flow);
        }
        for (TrackTable each : tracks) {
            each.add(batch, flow);
        }
    }

    @Override
    public void close() throws IOException {
        IOException failure = null;
        List<Closeable> all = new ArrayList<>(flows);
        all.addAll(tracks);
        for (Closeable each : all) {
            try {
                each.close();
            } catch (IOException e) {
                failure = failure == null ? e : failure;
            }
        }
        if (failure != null) {
            throw failure;
        }
    }
}
