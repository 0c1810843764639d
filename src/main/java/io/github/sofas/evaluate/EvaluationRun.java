package io.github.sofas.evaluate;

import io.github.sofas.event.EventBatch;
import io.github.sofas.event.EventSource;
import io.github.sofas.event.EventSourceException;
import io.github.sofas.flow.FlowOutput;
import io.github.sofas.flow.LabelledSource;
import io.github.sofas.flow.Labelling;
import java.io.IOException;

/**
 * One recording labelled by a method and held against its truth.
 *
 * @param evaluation the figures; of the events before the damage where there is any
 * @param damage why the recording could not be read to its end; null where it was
 * @param methodSeconds time that the method took
 * @param labelled events that it labelled; more than the evaluation has where the truth is of a part of them
 */
public record EvaluationRun(Evaluation evaluation, EventSourceException damage, double methodSeconds,
                            long labelled) {
    private static final int BATCH = 4096;

    /**
     * Reads, labels and evaluates.
     *
     * @param source read to its end or its damage, not closed
     * @param truth just opened; not closed
     * @param method made for the source's sensor
     * @param options what counts
     * @return what came of it
     * @throws TruthException where the truth is malformed or of another recording
     * @throws IOException where the truth cannot be read
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
        // The truth of a damaged recording's lost events is left unread.
        if (damage == null) {
            truth.end();
        }
        return new EvaluationRun(Evaluation.of(truth.truth(), estimate, options), damage, labelled.labellingNs() * 1e-9,
            events);
    }

    /** Moves the labels of the events whose truth is known to the front, and returns how many there are. */
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

    /** {@return events per second of the method's own time; 0 where none passed} */
    public double eventsPerSecond() {
        return methodSeconds > 0 ? labelled / methodSeconds : 0;
    }
}
