package io.github.sofas.flow;

import io.github.sofas.event.EventBatch;
import io.github.sofas.flow.paper.FlowPlane;
import io.github.sofas.flow.paper.Numbers;
import java.util.concurrent.TimeUnit;
import org.openjdk.jmh.annotations.Benchmark;
import org.openjdk.jmh.annotations.BenchmarkMode;
import org.openjdk.jmh.annotations.Fork;
import org.openjdk.jmh.annotations.Measurement;
import org.openjdk.jmh.annotations.Mode;
import org.openjdk.jmh.annotations.OperationsPerInvocation;
import org.openjdk.jmh.annotations.OutputTimeUnit;
import org.openjdk.jmh.annotations.Scope;
import org.openjdk.jmh.annotations.Setup;
import org.openjdk.jmh.annotations.State;
import org.openjdk.jmh.annotations.Warmup;

/** Time of an event that no track plane takes, in the paper's flow plane: n x n votes, and structures found. */
@State(Scope.Thread)
@BenchmarkMode(Mode.AverageTime)
@OutputTimeUnit(TimeUnit.NANOSECONDS)
@Warmup(iterations = 3, time = 2)
@Measurement(iterations = 5, time = 2)
@Fork(1)
public class PaperFlowPlaneBenchmark {
    private FilmedEvents events;
    private FlowPlane plane;

    /** Films noise. */
    @Setup
    public void film() throws Exception {
        events = new FilmedEvents("noise");
        plane = new FlowPlane(events.sensor.width(), events.sensor.height(),
            Numbers.of(SofasParameters.paper()));
    }

    /** Adds one batch. */
    @Benchmark
    @OperationsPerInvocation(FilmedEvents.BATCH)
    public int add() {
        if (events.startsAgain()) {
            plane.reset();
        }
        EventBatch batch = events.next();
        int found = 0;
        for (int i = 0; i < batch.size(); i++) {
            if (plane.add(batch.x[i], batch.y[i], batch.timeUs[i], batch.polarity[i])) {
                plane.release();
                found++;
            }
        }
        return found;
    }
}
