package io.github.sofas.evaluate;

import io.github.sofas.event.EventBatch;
import io.github.sofas.event.EventSource;
import io.github.sofas.event.EventSourceException;
import io.github.sofas.flow.FlowOutput;
import io.github.sofas.flow.LabelledSource;
import io.github.sofas.flow.Labelling;

/**
 * One recording labelled by a method and measured without truth.
 *
 * @param sharpness the figures; of the events before the damage where there is any
 * @param damage why the recording could not be read to its end; null where it was
 * @param methodSeconds time that the method took
 */
public record SharpnessRun(Sharpness sharpness, EventSourceException damage, double methodSeconds) {
    private static final int BATCH = 4096;

    /**
     * Reads, labels and measures.
     *
     * @param source read to its end or its damage, not closed
     * @param method made for the source's sensor
     * @return what came of it
     */
    public static SharpnessRun of(EventSource source, Labelling method) {
        EventBatch batch = new EventBatch(BATCH);
        FlowOutput output = new FlowOutput(BATCH);
        Sharpness.Gatherer gatherer = new Sharpness.Gatherer(source.sensor());
        EventSourceException damage = null;
        LabelledSource labelled = new LabelledSource(source, method);
        try {
            while (labelled.next(batch, output)) {
                gatherer.add(batch, output);
            }
        } catch (EventSourceException e) {
            damage = e;
        }
        return new SharpnessRun(gatherer.sharpness(), damage, labelled.labellingNs() * 1e-9);
    }

    /** {@return events per second of the method's own time; 0 where none passed} */
    public double eventsPerSecond() {
        return methodSeconds > 0 ? sharpness.events() / methodSeconds : 0;
    }
}
