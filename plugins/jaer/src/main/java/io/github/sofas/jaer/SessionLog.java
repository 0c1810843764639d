package io.github.sofas.jaer;

import io.github.sofas.event.EventBatch;
import io.github.sofas.export.FlowCsvWriter;
import io.github.sofas.export.SegmentsCsv;
import io.github.sofas.export.TrackTable;
import io.github.sofas.flow.FlowOutput;
import io.github.sofas.flow.Segment;
import java.io.IOException;
import java.io.OutputStream;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.List;
import java.util.Locale;

/**
 * Writes flow, segments and tracks to files as the runner does: NAME.flow.csv, NAME.segments.csv and NAME.tracks.csv,
 * with the runner's columns, digits and axes. Any thread may use a log.
 */
final class SessionLog {
    private static final List<String> KINDS = List.of(".flow.csv", ".segments.csv", ".tracks.csv");

    private final Path name;
    private final FlowCsvWriter flow;
    private final TrackTable tracks;
    private final OutputStream segmentsOut;
    private final List<Segment> ended = new ArrayList<>();
    private long events;
    private IOException failure;

    private SessionLog(Path name, OutputStream flow, OutputStream segments, OutputStream tracks) throws IOException {
        this.name = name;
        this.flow = new FlowCsvWriter(flow);
        this.tracks = TrackTable.csv(tracks);
        segmentsOut = segments;
    }

    /** The files of a log of this name that exist already. */
    static List<Path> existing(Path name) {
        return KINDS.stream().map(kind -> file(name, kind)).filter(Files::exists).toList();
    }

    private static Path file(Path name, String kind) {
        return name.resolveSibling(name.getFileName() + kind);
    }

    /**
     * Opens the files, and replaces existing ones.
     *
     * @throws IOException if a file cannot be written
     */
    static SessionLog open(Path name) throws IOException {
        List<OutputStream> open = new ArrayList<>();
        try {
            for (String kind : KINDS) {
                open.add(Files.newOutputStream(file(name, kind)));
            }
            return new SessionLog(name, open.get(0), open.get(1), open.get(2));
        } catch (IOException e) {
            for (OutputStream out : open) {
                out.close();
            }
            throw e;
        }
    }

    /** Adds the events of a packet; does nothing after a failure, which {@link #close} reports. */
    synchronized void add(EventBatch batch, FlowOutput output) {
        if (failure == null) {
            try {
                flow.write(batch, output);
                tracks.add(batch, output);
                events += batch.size();
            } catch (IOException e) {
                failure = e;
            }
        }
    }

    /** Adds a segment that has ended. */
    synchronized void add(Segment segment) {
        ended.add(segment);
    }

    Path name() {
        return name;
    }

    synchronized boolean hasFailed() {
        return failure != null;
    }

    /**
     * Completes and closes the files.
     *
     * @param living segments that are tracked now
     * @return a message about the files, for jAER's log
     * @throws IOException if anything could not be written, now or before
     */
    synchronized String close(List<Segment> living) throws IOException {
        List<Segment> all = new ArrayList<>(ended);
        all.addAll(living);
        try (segmentsOut; tracks; flow) {
            if (failure != null) {
                throw failure;
            }
            SegmentsCsv.write(segmentsOut, all);
        }
        return String.format(Locale.ROOT, "SOFAS wrote %,d events and %,d segments to %s.flow.csv,"
            + " .segments.csv and .tracks.csv", events, all.size(), name);
    }
}
