package io.github.sofas.cli;

import io.github.sofas.event.EventSourceException;
import io.github.sofas.export.RecordingSummary;
import io.github.sofas.export.ResultFiles;
import io.github.sofas.export.RunSummary;
import io.github.sofas.export.TableFormat;
import io.github.sofas.recording.RecordingOptions;
import io.github.sofas.recording.RecordingReader;
import io.github.sofas.recording.Recordings;
import io.github.sofas.report.ReportCollector;
import java.io.File;
import java.io.IOException;
import java.io.OutputStream;
import java.nio.charset.StandardCharsets;
import java.nio.file.Path;
import java.security.MessageDigest;
import java.security.NoSuchAlgorithmException;
import java.util.HexFormat;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;
import java.util.stream.Collectors;

/**
 * Runs one recording from its first event to its result files. In a loop, a batch is read, labelled and written
 * ({@link BatchPipeline}, {@link RunSteps}).
 *
 * @param recording the file that is read
 * @param source name of the recording in the summary
 * @param options how the recording is read
 * @param method labels the events
 * @param names of the results
 * @param reportedCommand the command that the report shows as typed; null if no report is written
 * @param replaces whether existing results are replaced
 * @param formats of the tables of events and tracks, each once, in the order of the enum
 */
record RecordingRun(Path recording, String source, RecordingOptions options, MethodChoice method, ResultNames names,
                    String reportedCommand, boolean replaces, List<TableFormat> formats) {
    /** All files that this run writes, the summary last except for the report. */
    List<Path> files() {
        List<Path> files = names.ofRun(formats);
        if (reportedCommand != null) {
            files.add(names.report());
        }
        return files;
    }

    /** The results of this run that exist. */
    List<Path> existing() {
        return files().stream().filter(OutputFiles::isThere).toList();
    }

    /** The same run with another name of the recording in the summary. */
    RecordingRun of(String shownSource) {
        return new RecordingRun(recording, shownSource, options, method, names, reportedCommand, replaces, formats);
    }

    /** The same run, but existing results are replaced. */
    RecordingRun replacing() {
        return new RecordingRun(recording, source, options, method, names, reportedCommand, true, formats);
    }

    /**
     * Everything that determines the results: the program's version, the recording's size and time of change, and a
     * fingerprint. The fingerprint covers how the recording is read, the method with its parameters, and which results
     * are written.
     */
    String request() {
        File file = recording.toFile();
        return request(file.length(), file.lastModified());
    }

    /** The same for a recording that was not fetched: its size in bytes, and its time of change in ms since 1970. */
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

    /** Why the existing results are not those of this run of the whole recording; null if they are. */
    String whyNotDone() {
        EarlierRun earlier = EarlierRun.of(names.summary());
        return earlier == null ? "there is no summary, or it is cut" : earlier.whyNot(request(), files().stream()
            .collect(Collectors.toMap(file -> file.getFileName().toString(), file -> file.toFile().length())));
    }

    /**
     * Labels the recording and writes the results. A damaged recording has results, too, of every event before the
     * damage.
     *
     * @param threads number of threads, 1 to {@value BatchPipeline#MOST_THREADS}; results do not depend on it
     * @throws EventSourceException if the recording cannot be opened; there are no results then
     * @throws IOException if the results cannot be written; there are none then
     */
    RunOutcome run(RunProgress progress, int threads) throws EventSourceException, IOException, InterruptedException {
        long start = System.nanoTime();
        String request = request();
        try (RecordingReader reader = Recordings.open(recording, options);
                ResultFiles results = new ResultFiles(replaces)) {
            long openNs = System.nanoTime() - start;
            ReportCollector report = reportedCommand == null ? null : new ReportCollector(reader.sensor());
            RunSteps steps;
            try (RunTables tables = new RunTables()) {
                Map<String, String> metadata = metadata(reader);
                for (TableFormat format : formats) {
                    tables.open(format, results, names, metadata);
                }
                steps = RunSteps.of(reader, method, tables, report, progress);
                BatchPipeline.run(steps, threads);
            }
            RecordingSummary read = Summaries.of(source, reader, steps.damage());
            RunSummary summary = new RunSummary(Version.text(), request, read, method.method(), method.preset(),
                method.parameters(), steps.eventsWithFlow(), steps.likelyReason(), steps.segments(),
                Summaries.dropped(reader.counts()), steps.seconds(System.nanoTime() - start, openNs),
                Summaries.peakHeapBytes());
            Exception reportFailure = steps.reportFailure();
            if (report != null && reportFailure == null) {
                reportFailure = writeReport(results, report, summary);
            }
            Summaries.write(summary, results, names);
            results.commit();
            return new RunOutcome(summary, steps.damage(), reportFailure);
        }
    }

    /** Metadata of a table, if its format has a place for them; repeating a run gives the same metadata. */
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

    /** Writes the report. A failure costs the report, not the results, and is returned; null if there is none. */
    private Exception writeReport(ResultFiles results, ReportCollector report, RunSummary summary) {
        try (OutputStream file = results.create(names.report())) {
            report.write(file, summary, reportedCommand, results.temporary(names.flow()));
            return null;
        } catch (IOException | RuntimeException e) {
            results.forget(names.report());
            return e;
        }
    }
}
