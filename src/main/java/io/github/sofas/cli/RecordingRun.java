package io.github.sofas.cli;

import io.github.sofas.event.EventBatch;
import io.github.sofas.event.EventSourceException;
import io.github.sofas.export.FlowTable;
import io.github.sofas.export.FlowWriter;
import io.github.sofas.export.RecordingSummary;
import io.github.sofas.export.ResultFiles;
import io.github.sofas.export.RunSummary;
import io.github.sofas.export.SegmentsCsv;
import io.github.sofas.export.TableFormat;
import io.github.sofas.export.TrackTable;
import io.github.sofas.export.WithoutFlow;
import io.github.sofas.flow.EventLabeller;
import io.github.sofas.flow.FlowOutput;
import io.github.sofas.flow.Segment;
import io.github.sofas.flow.SmoothedSofas;
import io.github.sofas.recording.RecordingOptions;
import io.github.sofas.recording.RecordingReader;
import io.github.sofas.recording.Recordings;
import io.github.sofas.report.ReportCollector;
import java.io.Closeable;
import java.io.File;
import java.io.IOException;
import java.io.OutputStream;
import java.lang.management.ManagementFactory;
import java.lang.management.MemoryPoolMXBean;
import java.lang.management.MemoryType;
import java.nio.charset.StandardCharsets;
import java.nio.file.Path;
import java.security.MessageDigest;
import java.security.NoSuchAlgorithmException;
import java.util.ArrayList;
import java.util.HexFormat;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;
import java.util.function.Consumer;
import java.util.stream.Collectors;

/**
 * One recording from its first event to its result files: read a batch, label it, write its rows, again
 * ({@link BatchPipeline}).
 *
 * @param recording what is read
 * @param source the recording as the summary names it
 * @param options how it is read
 * @param method labels the events
 * @param out folder of the results
 * @param name of the results, without their endings
 * @param reportedCommand what the report says was typed; null where no report is written
 * @param replaces whether results that exist are replaced
 * @param formats of the tables of events and tracks, each once, in the order of the enum
 */
record RecordingRun(Path recording, String source, RecordingOptions options, MethodChoice method, Path out,
                    String name, String reportedCommand, boolean replaces, List<TableFormat> formats) {
    /**
     * What came of it.
     *
     * @param summary as written
     * @param damage why the recording could not be read to its end; null where it was
     * @param reportFailure why there is no report; null where there is, or none was asked for
     */
    record Outcome(RunSummary summary, EventSourceException damage, Exception reportFailure) {
    }

    /** Where the row of every event goes. */
    static Path flowFile(Path out, String name) {
        return out.resolve(name + ".flow.csv");
    }

    /** The same in any format. */
    static Path flowFile(Path out, String name, TableFormat format) {
        return out.resolve(name + ".flow." + format.extension());
    }

    private static Path tracksFile(Path out, String name, TableFormat format) {
        return out.resolve(name + ".tracks." + format.extension());
    }

    /** Where the track planes go. */
    static Path segmentsFile(Path out, String name) {
        return out.resolve(name + ".segments.csv");
    }

    /** Where the figures of the run go. */
    static Path summaryFile(Path out, String name) {
        return out.resolve(name + ".summary.json");
    }

    /** The results of a name. */
    static List<Path> files(Path out, String name) {
        return List.of(flowFile(out, name), segmentsFile(out, name), summaryFile(out, name));
    }

    private Path reportFile() {
        return out.resolve(name + ".report.html");
    }

    /** All that this run writes, the summary last but for the report. */
    List<Path> files() {
        List<Path> files = files(out, name, formats);
        if (reportedCommand != null) {
            files.add(reportFile());
        }
        return files;
    }

    /** All that a run without a report writes, the summary last. */
    static List<Path> files(Path out, String name, List<TableFormat> formats) {
        List<Path> files = new ArrayList<>();
        for (TableFormat format : formats) {
            files.add(flowFile(out, name, format));
            files.add(tracksFile(out, name, format));
        }
        files.add(segmentsFile(out, name));
        files.add(summaryFile(out, name));
        return files;
    }

    /** The results of this run that exist. */
    List<Path> existing() {
        return files().stream().filter(OutputFiles::isThere).toList();
    }

    /** The same run, whose summary names the recording so. */
    RecordingRun of(String shownSource) {
        return new RecordingRun(recording, shownSource, options, method, out, name, reportedCommand, replaces, formats);
    }

    /** The same run, which replaces results that exist. */
    RecordingRun replacing() {
        return new RecordingRun(recording, source, options, method, out, name, reportedCommand, true, formats);
    }

    /**
     * All that the results follow from: the program's version, the recording's size and time of change, and a
     * fingerprint of how it is read and of the method with its parameters.
     */
    String request() {
        File file = recording.toFile();
        return request(file.length(), file.lastModified());
    }

    /** The same of a recording that was not fetched: its size, and when it was changed in ms since 1970. */
    String request(long bytes, long changedMs) {
        List<Object> all = List.of(String.valueOf(options.chip()), options.strict(), options.forceChip(),
            String.valueOf(options.columns()), String.valueOf(options.timeUnit()), method.method(), method.preset(),
            method.parameters(), reportedCommand != null, formats);
        try {
            byte[] hash = MessageDigest.getInstance("SHA-256").digest(all.toString().getBytes(StandardCharsets.UTF_8));
            return String.join(" ", Version.text(), bytes + "@" + changedMs,
                HexFormat.of().formatHex(hash));
        } catch (NoSuchAlgorithmException e) {
            throw new IllegalStateException("every Java has SHA-256", e);
        }
    }

    /** Why the results that are there are not those of this run, of the whole recording; null where they are. */
    String whyNotDone() {
        EarlierRun earlier = EarlierRun.of(summaryFile(out, name));
        return earlier == null ? "there is no summary, or it is cut" : earlier.whyNot(request(), files().stream()
            .collect(Collectors.toMap(file -> file.getFileName().toString(), file -> file.toFile().length())));
    }

    /**
     * Runs. A damaged recording has results too, of every event before the damage.
     *
     * @param threads how many work, 1 to {@value BatchPipeline#MOST_THREADS}; results do not depend on it
     * @throws EventSourceException where the recording cannot be opened; there are no results then
     * @throws IOException where the results cannot be written; there are none then
     */
    Outcome run(RunProgress progress, int threads) throws EventSourceException, IOException, InterruptedException {
        long start = System.nanoTime();
        String request = request();
        try (RecordingReader reader = Recordings.open(recording, options);
                ResultFiles results = new ResultFiles(replaces)) {
            ReportCollector report = reportedCommand == null ? null : new ReportCollector(reader.sensor());
            List<Segment> segments = new ArrayList<>();
            Steps steps = new Steps(reader, method, segments::add, report, progress);
            steps.decodeNs = System.nanoTime() - start;
            try (Tables tables = new Tables()) {
                steps.tables = tables;
                Map<String, String> metadata = metadata(reader);
                for (TableFormat format : formats) {
                    tables.flows.add(FlowTable.open(format, results, flowFile(out, name, format), metadata));
                    tables.tracks.add(TrackTable.open(format, results, tracksFile(out, name, format), metadata));
                }
                BatchPipeline.run(steps, threads);
            }
            segments.addAll(steps.livingSegments());
            RunSummary.Seconds seconds = new RunSummary.Seconds((System.nanoTime() - start) / 1e9,
                steps.decodeNs / 1e9, steps.engineNs() / 1e9, steps.outputNs / 1e9);
            RecordingSummary read = Summaries.of(source, reader, steps.damage);
            RunSummary summary = new RunSummary(Version.text(), request, read, method.method(), method.preset(),
                method.parameters(), steps.eventsWithFlow, steps.withoutFlow.likelyReason(), segments,
                Summaries.dropped(reader.counts()), seconds, peakHeapBytes());
            Exception reportFailure = steps.reportFailure;
            if (report != null && reportFailure == null) {
                reportFailure = writeReport(results, report, summary);
            }
            writeSegmentsAndSummary(results, out, name, summary);
            results.commit();
            return new Outcome(summary, steps.damage, reportFailure);
        }
    }

    /** What a table says of itself, where its format has a place for it; the same whenever the same is run. */
    private Map<String, String> metadata(RecordingReader reader) throws IOException {
        Map<String, String> metadata = new LinkedHashMap<>();
        metadata.put("sofas_version", Version.text());
        metadata.put("recording", recording.getFileName().toString());
        metadata.put("recording_format", reader.formatName());
        metadata.put("sensor", reader.sensor().toString());
        metadata.put("method", method.method());
        metadata.put("preset", method.preset());
        metadata.put("parameters", RunSummary.parametersAsJson(method.parameters()));
        return metadata;
    }

    /** The tables of events and tracks, in each format. */
    private static final class Tables implements Closeable {
        private final List<FlowWriter> flows = new ArrayList<>();
        private final List<TrackTable> tracks = new ArrayList<>();

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

    /** Writes the report; where that fails it costs the report, not the results. */
    private Exception writeReport(ResultFiles results, ReportCollector report, RunSummary summary) {
        try (OutputStream file = results.create(reportFile())) {
            report.write(file, summary, reportedCommand, results.temporary(flowFile(out, name)));
            return null;
        } catch (IOException | RuntimeException e) {
            results.forget(reportFile());
            return e;
        }
    }

    /** What is done with each batch, and how long it took; each step has its own figures. */
    private static final class Steps implements BatchPipeline.Steps {
        private final RecordingReader reader;
        /** One of the two; what looks ahead gives events back later than they are read. */
        private final EventLabeller labeller;
        private final SmoothedSofas ahead;
        private final ReportCollector report;
        private final RunProgress progress;
        private Tables tables;
        private EventSourceException damage;
        private Exception reportFailure;
        private long decodeNs;
        private long engineNs;
        private long lookAheadNs;
        private long outputNs;
        private final WithoutFlow withoutFlow;
        private long eventsWithFlow;
        private long bytesShown;

        Steps(RecordingReader reader, MethodChoice method, Consumer<Segment> ended, ReportCollector report,
              RunProgress progress) {
            this.reader = reader;
            labeller = method.looksAhead() ? null : method.make(reader.sensor(), ended);
            ahead = method.looksAhead() ? method.ahead(reader.sensor(), ended) : null;
            this.report = report;
            this.progress = progress;
            withoutFlow = new WithoutFlow(reader.sensor());
        }

        @Override
        public boolean read(BatchPipeline.Slot slot) {
            long start = System.nanoTime();
            boolean more = false;
            try {
                more = reader.next(slot.events);
            } catch (EventSourceException e) {
                damage = e;
            }
            slot.bytesRead = reader.bytesRead();
            decodeNs += System.nanoTime() - start;
            return more;
        }

        @Override
        public void helpedBy(Consumer<Runnable> helper) {
            if (ahead == null) {
                labeller.helpedBy(helper);
            } else {
                ahead.helpedBy(helper);
            }
        }

        @Override
        public void label(BatchPipeline.Slot slot) {
            long start = System.nanoTime();
            if (ahead == null) {
                labeller.process(slot.events, slot.flow);
            } else {
                ahead.label(slot.events, slot.causal);
            }
            engineNs += System.nanoTime() - start;
        }

        List<Segment> livingSegments() {
            return ahead == null ? labeller.segments() : ahead.segments();
        }

        private long engineNs() {
            return engineNs + lookAheadNs;
        }

        @Override
        public void write(BatchPipeline.Slot slot) throws IOException {
            if (ahead == null) {
                writeRows(slot);
            } else {
                lookAhead(() -> ahead.add(slot.causal), slot);
            }
        }

        @Override
        public void finish(BatchPipeline.Slot slot) throws IOException {
            if (ahead != null) {
                slot.bytesRead = bytesShown;
                lookAhead(ahead::finish, slot);
            }
        }

        /** Writes the events that can be labelled after a step, in place of those that were read. */
        private void lookAhead(Runnable step, BatchPipeline.Slot slot) throws IOException {
            long start = System.nanoTime();
            step.run();
            boolean more = ahead.next(slot.events, slot.flow);
            lookAheadNs += System.nanoTime() - start;
            while (more) {
                writeRows(slot);
                start = System.nanoTime();
                more = ahead.next(slot.events, slot.flow);
                lookAheadNs += System.nanoTime() - start;
            }
        }

        private void writeRows(BatchPipeline.Slot slot) throws IOException {
            long start = System.nanoTime();
            tables.write(slot.events, slot.flow);
            addToReport(slot);
            outputNs += System.nanoTime() - start;
            withoutFlow.add(slot.events, slot.flow);
            int withFlow = countWithFlow(slot.events, slot.flow);
            eventsWithFlow += withFlow;
            progress.add(slot.bytesRead - bytesShown, slot.events.size(), withFlow);
            bytesShown = slot.bytesRead;
        }

        private void addToReport(BatchPipeline.Slot slot) {
            if (report == null || reportFailure != null) {
                return;
            }
            try {
                report.add(slot.events, slot.flow);
            } catch (RuntimeException e) {
                reportFailure = e;
            }
        }
    }

    /**
     * Writes what is known only at the end; the summary last, whose presence shows that the others are complete.
     *
     * @throws IOException where it cannot be written
     */
    static void writeSegmentsAndSummary(ResultFiles results, Path out, String name, RunSummary summary)
            throws IOException {
        try (OutputStream file = results.create(segmentsFile(out, name))) {
            SegmentsCsv.write(file, summary.segments());
        }
        Map<String, Long> bytes = results.bytes();
        try (OutputStream file = results.create(summaryFile(out, name))) {
            summary.write(file, bytes);
        }
    }

    /** Events of a labelled batch that got flow. */
    static int countWithFlow(EventBatch batch, FlowOutput flow) {
        int count = 0;
        for (int i = 0; i < batch.size(); i++) {
            count += flow.segment[i] != 0 ? 1 : 0;
        }
        return count;
    }

    /** The sum over the parts of the heap, so at least the true peak: the parts need not have peaked together. */
    static long peakHeapBytes() {
        long peak = 0;
        for (MemoryPoolMXBean pool : ManagementFactory.getMemoryPoolMXBeans()) {
            if (pool.getType() == MemoryType.HEAP) {
                peak += pool.getPeakUsage().getUsed();
            }
        }
        return peak;
    }
}
