package io.github.sofas.evaluate;

import io.github.sofas.event.EventBatch;
import io.github.sofas.event.EventSource;
import io.github.sofas.event.EventSourceException;
import io.github.sofas.flow.FlowOutput;
import io.github.sofas.flow.LabelledSource;
import io.github.sofas.flow.Labelling;

/**
 * One recording, labelled by a method and measured without truth.
 *
 * @param sharpness the figures; if the recording is damaged, of the events before the damage
 * @param damage why the recording could not be read to its end; null if it was read to its end
 * @param methodSeconds time that the method took, in s
 */
public record SharpnessRun(Sharpness sharpness, EventSourceException damage, double methodSeconds) {
    private static final int BATCH = 4096;

    /**
     * Reads a recording, labels its events and measures the sharpness.
     *
     * @param source the recording, which is read to its end or its damage and not closed
     * @param method a method made for the source's sensor
     * @return the figures and how the run went
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

    /** {@return events per second of the method's own time; 0 if the method took no time} */
    public double eventsPerSecond() {
        return methodSeconds > 0 ? sharpness.events() / methodSeconds : 0;
    }
}
