package io.github.sofas.cli;

import io.github.sofas.event.EventBatch;
import io.github.sofas.event.SensorSize;
import io.github.sofas.export.FlowCsvWriter;
import io.github.sofas.flow.EventLabeller;
import io.github.sofas.flow.FlowOutput;
import io.github.sofas.simulate.DvsModel;
import io.github.sofas.simulate.Scene;
import io.github.sofas.simulate.SimulatedSource;
import io.github.sofas.simulate.SimulationOptions;
import java.io.IOException;
import java.io.OutputStream;
import java.lang.management.CompilationMXBean;
import java.lang.management.ManagementFactory;
import java.util.List;
import java.util.concurrent.locks.LockSupport;

/**
 * Warms up the engine before a live stream: labels simulated scenes with as many events as a camera has at its busiest,
 * and forgets them. A Java that has just started is ten times slower, and a camera does not wait until the code is
 * compiled. Each scene begins with an engine that has seen nothing, as the camera's does. Code that was compiled only
 * for tracked structures would be discarded at the first events of a stream.
 */
final class WarmUp {
    /**
     * Number of scenes. After fewer, parts of the engine are not compiled yet, and finding a first structure takes four
     * times as long.
     */
    private static final int ROUNDS = 12;
    private static final long EVENTS = 150_000;
    private static final List<Scene> SCENES = List.of(Scene.FOUR_BARS, Scene.HEXAGON, Scene.THREE_CROSSING);
    private static final double SPEED_PX_PER_S = 300;
    private static final double THRESHOLD = 0.05;
    /** Longest warm-up, for methods that need far longer for so many events. */
    private static final long MOST_NS = 4_000_000_000L;
    private static final int BATCH = 2048;
    private static final long COMPILER_PAUSE_NS = 150_000_000;
    private static final int COMPILER_LOOKS = 10;

    private WarmUp() {
    }

    /**
     * Warms up for events of a sensor.
     *
     * @throws IOException never: nothing is written
     */
    static void run(SensorSize sensor, MethodChoice method) throws IOException {
        long startNs = System.nanoTime();
        SimulationOptions options = SimulationOptions.defaults().withSensor(sensor).withSpeedPxPerS(SPEED_PX_PER_S)
            .withDvs(DvsModel.davis().withThresholds(THRESHOLD, THRESHOLD));
        EventBatch batch = new EventBatch(BATCH);
        FlowOutput flow = new FlowOutput(BATCH);
        for (int round = 0; round < ROUNDS && System.nanoTime() - startNs < MOST_NS; round++) {
            EventLabeller other = method.make(sensor, ended -> { });
            long labelled = 0;
            try (SimulatedSource scene = new SimulatedSource(SCENES.get(round % SCENES.size()), options);
                    FlowCsvWriter nowhere = new FlowCsvWriter(OutputStream.nullOutputStream())) {
                while (labelled < EVENTS && System.nanoTime() - startNs < MOST_NS && scene.next(batch)) {
                    other.process(batch, flow);
                    nowhere.write(batch, flow);
                    labelled += batch.size();
                }
            }
        }
        awaitCompiler();
        // Now, not during the first events; from here on, next to nothing is allocated.
        System.gc();
    }

    /** Waits until nothing is compiled for a while. */
    private static void awaitCompiler() {
        CompilationMXBean compiler = ManagementFactory.getCompilationMXBean();
        if (compiler == null || !compiler.isCompilationTimeMonitoringSupported()) {
            return;
        }
        long before = -1;
        for (int i = 0; i < COMPILER_LOOKS && before != compiler.getTotalCompilationTime(); i++) {
            before = compiler.getTotalCompilationTime();
            LockSupport.parkNanos(COMPILER_PAUSE_NS);
        }
    }
}
