package io.github.sofas.flow;

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

/** Time of an event in the whole engine. */
@State(Scope.Thread)
@BenchmarkMode(Mode.AverageTime)
@OutputTimeUnit(TimeUnit.NANOSECONDS)
@Warmup(iterations = 3, time = 2)
@Measurement(iterations = 5, time = 2)
@Fork(1)
public class SofasBenchmark {
    /** Name of the scene. */
    @Param({"hexagon", "four-bars", "sixteen", "noise"})
    public String scene;

    /** Base of the parameters. */
    @Param({"DEFAULT", "PAPER"})
    public SofasParameters.Preset preset;

    private FilmedEvents events;
    private Sofas sofas;
    private FlowOutput flow;

    /** Films the scene. */
    @Setup
    public void film() throws Exception {
        events = new FilmedEvents(scene);
        sofas = new Sofas(events.sensor,
            preset == SofasParameters.Preset.PAPER ? SofasParameters.paper() : SofasParameters.defaults());
        flow = new FlowOutput(FilmedEvents.BATCH);
    }

    /** Labels one batch. */
    @Benchmark
    @OperationsPerInvocation(FilmedEvents.BATCH)
    public FlowOutput process() {
        if (events.startsAgain()) {
            sofas.reset();
        }
        sofas.process(events.next(), flow);
        return flow;
    }
}
