package io.github.sofas.recording;

import io.github.sofas.event.EventBatch;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.Random;
import org.openjdk.jmh.annotations.Benchmark;
import org.openjdk.jmh.annotations.BenchmarkMode;
import org.openjdk.jmh.annotations.Fork;
import org.openjdk.jmh.annotations.Measurement;
import org.openjdk.jmh.annotations.Mode;
import org.openjdk.jmh.annotations.Param;
import org.openjdk.jmh.annotations.Scope;
import org.openjdk.jmh.annotations.Setup;
import org.openjdk.jmh.annotations.State;
import org.openjdk.jmh.annotations.Warmup;
import org.openjdk.jmh.annotations.AuxCounters;
import org.openjdk.jmh.annotations.TearDown;

/** Events a second of reading and decoding a recording, whole, by this thread. */
@State(Scope.Thread)
@BenchmarkMode(Mode.Throughput)
@Warmup(iterations = 3, time = 2)
@Measurement(iterations = 5, time = 2)
@Fork(1)
public class DecodeBenchmark {
    private static final int BATCH = 4096;
    private static final int EVENTS = 1 << 20;

    /** Path of a recording: {@code -p recording=cars.aedat4}; empty for a million random events as AEDAT 2.0. */
    @Param("")
    public String recording;

    private final EventBatch batch = new EventBatch(BATCH);
    private Path made;
    private Path file;

    /** Makes JMH report the events, not only the files, a second. */
    @AuxCounters(AuxCounters.Type.OPERATIONS)
    @State(Scope.Thread)
    public static class Decoded {
        /** How many were. */
        public long events;
    }

    /** Writes the recording where none is named. */
    @Setup
    public void write() throws Exception {
        if (!recording.isEmpty()) {
            file = Path.of(recording);
            return;
        }
        made = Files.createTempFile("sofas-jmh", ".aedat");
        file = made;
        Chip chip = Chip.named("DAVIS240C").orElseThrow();
        Random random = new Random(1);
        try (Aedat2Writer writer = new Aedat2Writer(file, chip)) {
            for (int i = 0; i < EVENTS; i++) {
                batch.add(i, random.nextInt(chip.sensor().width()), random.nextInt(chip.sensor().height()),
                    random.nextBoolean() ? 1 : -1);
                if (batch.isFull()) {
                    writer.write(batch);
                    batch.clear();
                }
            }
        }
    }

    /** Deletes what was written. */
    @TearDown
    public void delete() throws Exception {
        if (made != null) {
            Files.delete(made);
        }
    }

    /** Decodes the whole recording. */
    @Benchmark
    public void decode(Decoded decoded) throws Exception {
        try (RecordingReader reader = Recordings.open(file, RecordingOptions.defaults())) {
            while (reader.next(batch)) {
                decoded.events += batch.size();
            }
        }
    }
}
