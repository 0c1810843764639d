package io.github.sofas.flow;

import io.github.sofas.event.EventBatch;
import io.github.sofas.flow.fit.MetricFit;
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

/** Time of an event in one step to the top of the metric: nine projections, 1,500 events. */
@State(Scope.Thread)
@BenchmarkMode(Mode.AverageTime)
@OutputTimeUnit(TimeUnit.NANOSECONDS)
@Warmup(iterations = 3, time = 2)
@Measurement(iterations = 5, time = 2)
@Fork(1)
public class MetricFitBenchmark {
    private static final int EVENTS = 1500;
    private static final double SPEED_PX_PER_S = 58;
    private static final double SPACING_PX_PER_S = 8;

    private MetricFit fit;

    /** Loads the events of a hexagon on its way. */
    @Setup
    public void load() throws Exception {
        FilmedEvents events = new FilmedEvents("hexagon");
        fit = new MetricFit(events.sensor.width(), events.sensor.height(), MetricFit.CELL_PX, EVENTS, 1900);
        EventBatch batch = events.next();
        long referenceUs = batch.timeUs[EVENTS / 2];
        for (int i = 0; i < EVENTS; i++) {
            double tauS = (batch.timeUs[i] - referenceUs) * 1e-6;
            float x = (float) (batch.x[i] - SPEED_PX_PER_S * tauS);
            fit.add(x, batch.y[i], (float) tauS, 0, 0, batch.polarity[i]);
        }
    }

    /** Fits from the true velocity. */
    @Benchmark
    @OperationsPerInvocation(EVENTS)
    public double fit() {
        fit.frame(SPACING_PX_PER_S);
        return fit.fit(SPEED_PX_PER_S, 0, MetricFit.FLAT_SIGMAS).stepX();
    }
}
