package io.github.sofas.cli;

import io.github.sofas.event.EventBatch;
import io.github.sofas.event.EventSourceException;
import io.github.sofas.export.FlowCsvWriter;
import io.github.sofas.export.RecordingSummary;
import io.github.sofas.export.ResultFiles;
import io.github.sofas.export.RunSummary;
import io.github.sofas.export.WithoutFlow;
import io.github.sofas.flow.EventLabeller;
import io.github.sofas.flow.Labelling;
import io.github.sofas.flow.Segment;
import io.github.sofas.live.LiveSource;
import io.github.sofas.recording.Aedat2Writer;
import java.io.IOException;
import java.nio.ByteBuffer;
import java.nio.channels.FileChannel;
import java.nio.file.Files;
import java.nio.file.Path;
import java.nio.file.StandardOpenOption;
import java.util.ArrayList;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;
import java.util.function.Supplier;
import java.util.stream.Collectors;

/**
 * Runs a live stream from its first event to its result files. In a loop, it takes a packet, labels it and hands it to
 * a {@link LiveWriter}, until the source is stopped or fails.
 */
final class LiveRun {
    private static final int READ_BATCH = 2048;
    /** More than the segments and the summary take. */
    private static final int RESERVE_BYTES = 1 << 20;

    private final LiveSource source;
    private final MethodChoice method;
    private final ResultNames names;
    private final Path record;
    private final boolean replaces;
    private final LiveStatus status;

    private final List<Segment> segments = new ArrayList<>();
    /** Either this or {@link #ahead} labels the events; the other is null. */
    private final EventLabeller labeller;
    private final Labelling ahead;
    private final WithoutFlow withoutFlow;
    private volatile List<Path> written = List.of();
    private long events;
    private long eventsWithFlow;
    private long firstTimeUs;
    private long lastTimeUs;
    private long engineNs;
    private long outputNs;

    /** Makes the source start to send. */
    @FunctionalInterface
    interface Start {
        void start() throws EventSourceException;
    }

    /**
     * Creates a run.
     *
     * @param source a source that is not started
     * @param names of the results
     * @param record file in which the events are recorded; null for none
     * @param replaces whether existing files are replaced
     * @param status receives the progress and warnings
     */
    LiveRun(LiveSource source, MethodChoice method, ResultNames names, Path record, boolean replaces,
            LiveStatus status) {
        this.source = source;
        this.method = method;
        this.names = names;
        this.record = record;
        this.replaces = replaces;
        this.status = status;
        labeller = method.looksAhead() ? null : method.make(source.sensor(), segments::add);
        ahead = method.looksAhead() ? method.labelling(source.sensor(), segments::add) : null;
        withoutFlow = new WithoutFlow(source.sensor());
    }

    /**
     * Runs until the source ends. A source that fails has results, too, of every event before the failure. If the disk
     * is full or fails, the data on it stay, and their files are closed as well as possible.
     *
     * @throws EventSourceException if the source cannot be started; there are no results then
     * @throws IOException if the results cannot be begun, or cannot get their names; in the second case, the message
     *     gives the names that they have
     */
    RunOutcome run(Start start) throws EventSourceException, IOException {
        Path flow = names.flow();
        try (ResultFiles results = ResultFiles.ofCapture(replaces)) {
            List<LiveSink> sinks = new ArrayList<>();
            EventSourceException failure;
            long startNs;
            try (FileChannel reserve = reserve()) {
                assert reserve.isOpen();
                open(results, flow, sinks);
                written = results.temporaries();
                try (LiveWriter writer = new LiveWriter(sinks, status::warn)) {
                    startNs = System.nanoTime();
                    start.start();
                    results.keepAll();
                    Thread.currentThread().setPriority(Thread.MAX_PRIORITY);
                    failure = ahead == null ? label(writer) : labelAhead(writer);
                    outputNs = writer.finish();
                }
            } finally {
                sinks.forEach(LiveSink::close);
            }
            source.stop();
            segments.addAll(ahead == null ? labeller.segments() : ahead.segments());
            List<String> unwritten = new ArrayList<>();
            for (LiveSink sink : sinks) {
                if (sink.failure() != null) {
                    unwritten.add(sink.fault());
                }
            }
            RunSummary summary = summary(failure, unwritten, (System.nanoTime() - startNs) / 1e9);
            writeSegmentsAndSummary(results, summary, unwritten);
            commit(results);
            return new RunOutcome(summary, failure == null && !unwritten.isEmpty()
                ? new EventSourceException(unwritten.get(unwritten.size() - 1)) : failure, null);
        }
    }

    /** Number of bytes written so far. */
    long bytesWritten() {
        return written.stream().mapToLong(file -> file.toFile().length()).sum();
    }

    private void open(ResultFiles results, Path flow, List<LiveSink> sinks) throws IOException {
        FlowCsvWriter csv = new FlowCsvWriter(results.create(flow));
        sinks.add(LiveSink.rows(flow, results.temporary(flow), csv));
        if (record != null) {
            Aedat2Writer aedat = new Aedat2Writer(results.create(record), source.chip());
            sinks.add(LiveSink.records(record, results.temporary(record), aedat));
        }
    }

    /**
     * Reserves room on the disk for the files that are written at the end, even if the disk is full by then. Closing
     * the channel frees the room. If the system allows it, the file has no name meanwhile, so that a killed program
     * leaves nothing of it.
     */
    private FileChannel reserve() throws IOException {
        Path file = names.out().resolve("." + names.name() + "." + ProcessHandle.current().pid() + ".reserve");
        FileChannel reserve = FileChannel.open(file, StandardOpenOption.CREATE, StandardOpenOption.WRITE,
            StandardOpenOption.DELETE_ON_CLOSE);
        try {
            reserve.write(ByteBuffer.allocate(RESERVE_BYTES));
            Files.deleteIfExists(file);
        } catch (IOException e) {
            reserve.close();
            throw e;
        }
        return reserve;
    }

    private void writeSegmentsAndSummary(ResultFiles results, RunSummary summary, List<String> unwritten) {
        try {
            Summaries.write(summary, results, names);
        } catch (IOException e) {
            results.forget(names.segments());
            results.forget(names.summary());
            unwritten.add("[" + names.name() + "] segments and summary cannot be written: " + FileFailure.text(e));
        }
    }

    private void commit(ResultFiles results) throws IOException {
        List<Path> kept = results.temporaries();
        try {
            results.commit();
        } catch (IOException e) {
            throw new IOException(FileFailure.text(e) + "; what was caught is in " + kept.stream()
                .filter(Files::exists).map(Path::toString).collect(Collectors.joining(", ")), e);
        }
    }

    /** Labels to the end of the stream, and returns the failure of the source that ended it; null if there was none. */
    private EventSourceException label(LiveWriter writer) {
        while (true) {
            LiveWriter.Labelled next;
            try {
                next = writer.empty();
            } catch (IOException e) {
                // no file can be written any more
                return null;
            }
            EventBatch batch = next.events;
            try {
                if (!source.next(batch)) {
                    return null;
                }
            } catch (EventSourceException e) {
                return e;
            }
            long beforeEngine = System.nanoTime();
            labeller.process(batch, next.flow);
            long afterEngine = System.nanoTime();
            engineNs += afterEngine - beforeEngine;
            note(next, afterEngine - source.receivedNs(), labeller::segments);
            writer.handOn(next);
        }
    }

    /** The same with look-ahead: events are handed on once their labels know what came after them. */
    private EventSourceException labelAhead(LiveWriter writer) {
        EventBatch read = new EventBatch(READ_BATCH);
        EventSourceException failure = null;
        try {
            LiveWriter.Labelled next = writer.empty();
            for (boolean more = true; more;) {
                try {
                    more = source.next(read);
                } catch (EventSourceException e) {
                    failure = e;
                    more = false;
                }
                long beforeEngine = System.nanoTime();
                long newestUs = more ? read.timeUs[read.size() - 1] : lastTimeUs;
                if (more) {
                    ahead.add(read);
                } else {
                    ahead.finish();
                }
                while (ahead.next(next.events, next.flow)) {
                    long heldNs = 1000 * Math.max(0, newestUs - next.events.timeUs[next.events.size() - 1]);
                    note(next, heldNs + System.nanoTime() - source.receivedNs(), ahead::segments);
                    writer.handOn(next);
                    next = writer.empty();
                }
                engineNs += System.nanoTime() - beforeEngine;
            }
        } catch (IOException e) {
            // no file can be written any more
            return failure;
        }
        return failure;
    }

    /** Counts a labelled batch. */
    private void note(LiveWriter.Labelled labelled, long latencyNs, Supplier<List<Segment>> living) {
        EventBatch batch = labelled.events;
        if (events == 0) {
            firstTimeUs = batch.timeUs[0];
        }
        lastTimeUs = batch.timeUs[batch.size() - 1];
        events += batch.size();
        int withFlow = RunSteps.countWithFlow(batch, labelled.flow);
        eventsWithFlow += withFlow;
        withoutFlow.add(batch, labelled.flow);
        status.labelled(batch.size(), withFlow, latencyNs, living);
    }

    private RunSummary summary(EventSourceException failure, List<String> unwritten, double wallS) {
        Map<String, Long> counts = new LinkedHashMap<>();
        counts.put("dvs_events", events);
        counts.putAll(source.counts());
        List<String> faults = new ArrayList<>(source.faults());
        if (failure != null) {
            faults.add(failure.getMessage());
        }
        faults.addAll(unwritten);
        RecordingSummary read = new RecordingSummary(source.name(), source.formatName(), source.chip().name(),
            source.sensor(), events, firstTimeUs, lastTimeUs, counts,
            failure == null && unwritten.isEmpty(), faults, List.of(), 0);
        RunSummary.Seconds seconds = new RunSummary.Seconds(wallS, source.decodeS(), engineNs / 1e9, outputNs / 1e9);
        return new RunSummary(Version.text(), "", read, method.method(), method.preset(), method.parameters(),
            eventsWithFlow, withoutFlow.likelyReason(), segments, source.dropped(), seconds,
            Summaries.peakHeapBytes());
    }
}
