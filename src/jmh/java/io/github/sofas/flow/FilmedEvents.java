package io.github.sofas.flow;

import io.github.sofas.event.EventBatch;
import io.github.sofas.event.EventSource;
import io.github.sofas.event.EventSourceException;
import io.github.sofas.event.SensorSize;
import io.github.sofas.simulate.DvsModel;
import io.github.sofas.simulate.Scene;
import io.github.sofas.simulate.SimulatedSource;
import io.github.sofas.simulate.SimulationOptions;
import java.util.ArrayList;
import java.util.List;

/** The events of a simulated scene in full batches, given out one after the other for ever. */
final class FilmedEvents {
    /** Events of each batch. */
    static final int BATCH = 4096;

    private static final int MOST_BATCHES = 64;
    private static final double NOISE_HZ_PER_PX = 5;

    final SensorSize sensor;
    private final List<EventBatch> batches = new ArrayList<>();
    private int next;

    /** Films a scene; noise alone is of 5 Hz/px. */
    FilmedEvents(String sceneName) throws EventSourceException {
        Scene scene = Scene.named(sceneName).orElseThrow(
            () -> new IllegalArgumentException("scene must be one of " + Scene.names() + " but was " + sceneName));
        SimulationOptions options = SimulationOptions.defaults();
        if (scene == Scene.NOISE) {
            options = options.withDvs(DvsModel.davis().withNoiseHzPerPx(NOISE_HZ_PER_PX));
        }
        sensor = options.sensor();
        EventBatch full = new EventBatch(BATCH);
        EventBatch part = new EventBatch(BATCH);
        try (EventSource source = new SimulatedSource(scene, options, Long.MAX_VALUE)) {
            while (batches.size() < MOST_BATCHES && source.next(part)) {
                for (int i = 0; i < part.size(); i++) {
                    full.add(part.timeUs[i], part.x[i], part.y[i], part.polarity[i]);
                    if (full.isFull()) {
                        batches.add(full);
                        full = new EventBatch(BATCH);
                    }
                }
            }
        }
    }

    /** Whether the next batch is the first again, so that time falls. */
    boolean startsAgain() {
        return next == 0;
    }

    EventBatch next() {
        EventBatch batch = batches.get(next);
        next = (next + 1) % batches.size();
        return batch;
    }
}
