package io.github.sofas.export;

import io.github.sofas.event.EventBatch;
import io.github.sofas.flow.FlowOutput;
import java.io.OutputStream;
import java.util.Random;
import java.util.concurrent.TimeUnit;
import org.openjdk.jmh.annotations.Benchmark;
import org.openjdk.jmh.annotations.BenchmarkMode;
import org.openjdk.jmh.annotations.Fork;
import org.openjdk.jmh.annotations.Measurement;
import org.openjdk.jmh.annotations.Mode;
import org.openjdk.jmh.annotations.OperationsPerInvocation;
import org.openjdk.jmh.annotations.OutputTimeUnit;
import org.openjdk.jmh.annotations.Param;
import org.openjdk.jmh.annotations.Scope;
import org.openjdk.jmh.annotations.Setup;
import org.openjdk.jmh.annotations.State;
import org.openjdk.jmh.annotations.Warmup;

/** Time of an event's row, written nowhere. */
@State(Scope.Thread)
@BenchmarkMode(Mode.AverageTime)
@OutputTimeUnit(TimeUnit.NANOSECONDS)
@Warmup(iterations = 3, time = 2)
@Measurement(iterations = 5, time = 2)
@Fork(1)
public class FlowCsvWriterBenchmark {
    private static final int BATCH = 4096;
    private static final int SEGMENTS = 4;
    private static final int NO_FLOW_OF = 5;

    /** After how many events a segment's velocity changes. */
    @Param({"1", "300"})
    public int eventsPerVelocity;

    private final EventBatch batch = new EventBatch(BATCH);
    private final FlowOutput flow = new FlowOutput(BATCH);
    private FlowCsvWriter csv;

    /** Makes a million events a second; one in five has no flow. */
    @Setup
    public void label() throws Exception {
        Random random = new Random(1);
        float vx = 0;
        for (int i = 0; i < BATCH; i++) {
            batch.add(1_000_000_000L + i, random.nextInt(346), random.nextInt(260), random.nextBoolean() ? 1 : -1);
            if (i % eventsPerVelocity == 0) {
                vx = 200 * random.nextFloat() - 100;
            }
            if (random.nextInt(NO_FLOW_OF) > 0) {
                flow.segment[i] = 1 + random.nextInt(SEGMENTS);
                flow.vxPxPerS[i] = vx;
                flow.vyPxPerS[i] = -vx;
            }
        }
        csv = new FlowCsvWriter(OutputStream.nullOutputStream());
    }

    /** Writes one batch. */
    @Benchmark
    @OperationsPerInvocation(BATCH)
    public void write() throws Exception {
        csv.write(batch, flow);
    }
}
