package io.github.sofas.benchmark;

import io.github.sofas.event.EventBatch;
import io.github.sofas.event.EventSource;
import io.github.sofas.event.EventSourceException;
import io.github.sofas.export.FlowCsvWriter;
import io.github.sofas.flow.FlowOutput;
import io.github.sofas.flow.Sofas;
import java.io.IOException;
import java.io.InputStream;
import java.io.OutputStream;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.List;
import java.util.Map;
import java.util.concurrent.ExecutorService;
import java.util.concurrent.Executors;

/**
 * Measures the speed of one recording in parts: the engine on events in memory, with and without a helper; decoding;
 * writing CSV; and the whole run from file to file. Every part is warmed up and then timed several times. All runs of a
 * part must give the same result, which a checksum verifies.
 *
 * <p>Everything runs in one thread, apart from the thread that helps the engine where a helper is mentioned. A
 * benchmark needs about 30 bytes per event in addition to the engine's own memory.
 */
public final class Benchmark {
    /** Number of events per batch, the same as on the command line. */
    static final int BATCH = 4096;

    private final RecordingUnderTest recording;
    private final BenchmarkOptions options;
    private final Path folder;
    private final Stopwatch stopwatch;

    /** Rates of the parts that need the events in memory, and further figures of the engine from these parts. */
    private record InMemory(long size, Rates engine, Rates helped, Rates csv, EngineFigures figures) {
    }

    private Benchmark(RecordingUnderTest recording, BenchmarkOptions options, Path folder) {
        this.recording = recording;
        this.options = options;
        this.folder = folder;
        stopwatch = new Stopwatch(options);
    }

    /**
     * Measures a recording.
     *
     * @param folder folder for the rows of the whole run, in a file that is deleted afterwards
     * @throws EventSourceException if the recording cannot be opened, is damaged before the last event used, or has no
     *     event
     * @throws IOException if the rows cannot be written
     * @throws IllegalStateException if two runs over the same events give different results
     */
    public static RecordingFigures measure(RecordingUnderTest recording, BenchmarkOptions options, Path folder)
            throws EventSourceException, IOException {
        return new Benchmark(recording, options, folder).measure();
    }

    private RecordingFigures measure() throws EventSourceException, IOException {
        InMemory inMemory = measureInMemory();
        Rates decode = measureDecode(inMemory.size);
        Path rows = Files.createTempFile(folder, "sofas-bench", ".flow.csv");
        try {
            Memory.resetPeak();
            Rates run = stopwatch.time("whole runs", inMemory.size, () -> run(rows), () -> checksum(rows));
            long peakBytes = Memory.peakBytes();
            if (!run.checksum().equals(inMemory.csv.checksum())) {
                throw new IllegalStateException("the rows of a whole run must be those of the engine alone but their "
                    + "checksums were " + run.checksum() + " and " + inMemory.csv.checksum());
            }
            Map<Stage, Double> shares = StageSampler.shares(() -> run(rows), options.sampledMs());
            return new RecordingFigures(recording.name(), recording.format(), inMemory.engine, inMemory.helped,
                decode, inMemory.csv, run, shares, inMemory.figures, peakBytes);
        } finally {
            Files.delete(rows);
        }
    }

    /** A separate method, so that the events can be collected before the memory of a whole run is measured. */
    private InMemory measureInMemory() throws EventSourceException, IOException {
        EventsInMemory events;
        try (EventSource source = recording.open(options.mostEvents())) {
            events = EventsInMemory.read(source, BATCH);
        }
        if (events.size() == 0) {
            throw new EventSourceException("[" + recording.file().getFileName() + "] has no events to measure with");
        }
        List<FlowOutput> flows = new ArrayList<>();
        for (EventBatch batch : events.batches()) {
            flows.add(new FlowOutput(batch.size()));
        }
        long bytesWithout = Memory.usedBytes();
        Sofas sofas = new Sofas(events.sensor(), options.parameters());
        long[] allocated = new long[1];
        Rates engine = stopwatch.time("the engine", events.size(), () -> {
            long before = Memory.allocatedBytes();
            label(events, sofas, flows);
            allocated[0] = Memory.allocatedBytes() - before;
        }, () -> checksum(flows));
        Rates helped = timeHelped(events, sofas, flows);
        if (!helped.checksum().equals(engine.checksum())) {
            throw new IllegalStateException("labels must be the same with a helper as without but their checksums were "
                + helped.checksum() + " and " + engine.checksum());
        }
        long engineBytes = Memory.usedBytes() - bytesWithout;
        Rates csv = stopwatch.time("writing CSV", events.size(),
            () -> write(events, flows, OutputStream.nullOutputStream()),
            () -> {
                ChecksumStream out = new ChecksumStream();
                write(events, flows, out);
                return out.checksum.value();
            });
        EngineFigures figures = new EngineFigures(events.sensor(), shareWithFlow(flows), eventsPerPx(events, flows),
            (double) allocated[0] / events.size(), engineBytes, PacketTimes.measure(sofas, events));
        return new InMemory(events.size(), engine, helped, csv, figures);
    }

    private Rates timeHelped(EventsInMemory events, Sofas sofas, List<FlowOutput> flows)
            throws EventSourceException, IOException {
        ExecutorService helper = Executors.newSingleThreadExecutor();
        sofas.helpedBy(helper::execute);
        try {
            return stopwatch.time("the engine with a helper", events.size(), () -> label(events, sofas, flows),
                () -> checksum(flows));
        } finally {
            sofas.helpedBy(null);
            helper.shutdownNow();
        }
    }

    private static void label(EventsInMemory events, Sofas sofas, List<FlowOutput> flows) {
        sofas.reset();
        for (int i = 0; i < flows.size(); i++) {
            sofas.process(events.batches().get(i), flows.get(i));
        }
    }

    private static double shareWithFlow(List<FlowOutput> flows) {
        long events = 0;
        long withFlow = 0;
        for (FlowOutput flow : flows) {
            for (int segment : flow.segment) {
                events++;
                withFlow += segment != 0 ? 1 : 0;
            }
        }
        return (double) withFlow / events;
    }

    /** Number of events with flow, divided by the travel in px at their mean speed over the recording's duration. */
    static double eventsPerPx(EventsInMemory events, List<FlowOutput> flows) {
        long withFlow = 0;
        double speeds = 0;
        for (FlowOutput flow : flows) {
            for (int i = 0; i < flow.capacity(); i++) {
                if (flow.segment[i] != 0) {
                    withFlow++;
                    speeds += Math.hypot(flow.vxPxPerS[i], flow.vyPxPerS[i]);
                }
            }
        }
        double travelPx = speeds / Math.max(1, withFlow) * events.durationUs() * 1e-6;
        return travelPx > 0 ? withFlow / travelPx : 0;
    }

    private static long checksum(List<FlowOutput> flows) {
        Checksum checksum = new Checksum();
        flows.forEach(flow -> checksum.add(flow, flow.capacity()));
        return checksum.value();
    }

    private static void write(EventsInMemory events, List<FlowOutput> flows, OutputStream out) throws IOException {
        try (FlowCsvWriter csv = new FlowCsvWriter(out)) {
            for (int i = 0; i < flows.size(); i++) {
                csv.write(events.batches().get(i), flows.get(i));
            }
        }
    }

    /** Takes rows only to compute their checksum. */
    private static final class ChecksumStream extends OutputStream {
        private final Checksum checksum = new Checksum();

        @Override
        public void write(int value) {
            write(new byte[] {(byte) value}, 0, 1);
        }

        @Override
        public void write(byte[] bytes, int from, int length) {
            checksum.add(bytes, from, length);
        }
    }

    private Rates measureDecode(long events) throws EventSourceException, IOException {
        EventBatch batch = new EventBatch(BATCH);
        return stopwatch.time("decoding", events, () -> {
            try (EventSource source = recording.open(options.mostEvents())) {
                while (source.next(batch)) {
                    // the events are not used: only decoding is timed here
                    batch.clear();
                }
            }
        }, () -> {
            Checksum checksum = new Checksum();
            try (EventSource source = recording.open(options.mostEvents())) {
                while (source.next(batch)) {
                    checksum.add(batch);
                }
            }
            return checksum.value();
        });
    }

    /** Labels the recording from file to file, as the command line does. */
    private void run(Path rows) throws EventSourceException, IOException {
        try (EventSource source = recording.open(options.mostEvents());
             FlowCsvWriter csv = new FlowCsvWriter(Files.newOutputStream(rows))) {
            Sofas sofas = new Sofas(source.sensor(), options.parameters());
            EventBatch batch = new EventBatch(BATCH);
            FlowOutput flow = new FlowOutput(BATCH);
            while (source.next(batch)) {
                sofas.process(batch, flow);
                csv.write(batch, flow);
            }
        }
    }

    private static long checksum(Path rows) throws IOException {
        Checksum checksum = new Checksum();
        byte[] bytes = new byte[1 << 16];
        try (InputStream in = Files.newInputStream(rows)) {
            for (int length = in.read(bytes); length >= 0; length = in.read(bytes)) {
                checksum.add(bytes, 0, length);
            }
        }
        return checksum.value();
    }
}
