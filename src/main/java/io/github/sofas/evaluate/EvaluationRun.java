package io.github.sofas.evaluate;

import io.github.sofas.event.EventBatch;
import io.github.sofas.event.EventSource;
import io.github.sofas.event.EventSourceException;
import io.github.sofas.flow.FlowOutput;
import io.github.sofas.flow.LabelledSource;
import io.github.sofas.flow.Labelling;
import java.io.IOException;

/**
 * One recording, labelled by a method and compared with its truth.
 *
 * @param evaluation the figures; if the recording is damaged, of the events before the damage
 * @param damage why the recording could not be read to its end; null if it was read to its end
 * @param methodSeconds time that the method took, in s
 * @param labelled number of events that the method labelled; more than the evaluation has if the truth covers only a
 *     part of the events
 */
public record EvaluationRun(Evaluation evaluation, EventSourceException damage, double methodSeconds,
                            long labelled) {
    private static final int BATCH = 4096;

    /**
     * Reads a recording, labels its events and evaluates the labels.
     *
     * @param source the recording, which is read to its end or its damage and not closed
     * @param truth reader of the truth, just opened; it is not closed
     * @param method a method made for the source's sensor
     * @param options options that determine which events count
     * @return the evaluation and how the run went
     * @throws TruthException if the truth is malformed or belongs to another recording
     * @throws IOException if the truth cannot be read
     */
    public static EvaluationRun of(EventSource source, TruthCsvReader truth, Labelling method,
                                   EvaluationOptions options) throws TruthException, IOException {
        EventBatch batch = new EventBatch(BATCH);
        FlowOutput output = new FlowOutput(BATCH);
        FlowEstimate estimate = new FlowEstimate();
        EventSourceException damage = null;
        boolean[] known = new boolean[BATCH];
        long events = 0;
        LabelledSource labelled = new LabelledSource(source, method);
        try {
            while (labelled.next(batch, output)) {
                truth.read(batch, known);
                events += batch.size();
                estimate.append(output, keep(output, known, batch.size()));
            }
        } catch (EventSourceException e) {
            damage = e;
        }
        // For a damaged recording, the truth of the lost events is left unread.
        if (damage == null) {
            truth.end();
        }
        return new EvaluationRun(Evaluation.of(truth.truth(), estimate, options), damage, labelled.labellingNs() * 1e-9,
            events);
    }

    /** Moves the labels of the events with known truth to the front, and returns the number of those events. */
    private static int keep(FlowOutput output, boolean[] known, int count) {
        int kept = 0;
        for (int i = 0; i < count; i++) {
            if (known[i]) {
                output.vxPxPerS[kept] = output.vxPxPerS[i];
                output.vyPxPerS[kept] = output.vyPxPerS[i];
                output.segment[kept] = output.segment[i];
                kept++;
            }
        }
        return kept;
    }

    /** {@return events per second of the method's own time; 0 if the method took no time} */
    public double eventsPerSecond() {
        return methodSeconds > 0 ? labelled / methodSeconds : 0;
    }
}
