package io.github.sofas.flow;

import io.github.sofas.event.EventBatch;
import io.github.sofas.flow.search.FlowPlane;
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

/** Time of an event that no track plane takes, in the default preset's flow plane, without the search. */
@State(Scope.Thread)
@BenchmarkMode(Mode.AverageTime)
@OutputTimeUnit(TimeUnit.NANOSECONDS)
@Warmup(iterations = 3, time = 2)
@Measurement(iterations = 5, time = 2)
@Fork(1)
public class FlowPlaneBenchmark {
    private FilmedEvents events;
    private FlowPlane plane;

    /** Films an object, none of whose events is taken out. */
    @Setup
    public void film() throws Exception {
        events = new FilmedEvents("hexagon");
        plane = new FlowPlane(events.sensor.width(), events.sensor.height(), SofasParameters.defaults().search());
    }

    /** Adds one batch, and settles it block by block. */
    @Benchmark
    @OperationsPerInvocation(FilmedEvents.BATCH)
    public long addAndSettle() {
        if (events.startsAgain()) {
            plane.reset();
        }
        EventBatch batch = events.next();
        for (int i = 0; i < batch.size(); i++) {
            plane.add(batch.x[i], batch.y[i], batch.timeUs[i], batch.polarity[i]);
            if (plane.mustSettle(batch.timeUs[i])) {
                plane.settle(batch.timeUs[i]);
            }
        }
        return plane.total();
    }
}
