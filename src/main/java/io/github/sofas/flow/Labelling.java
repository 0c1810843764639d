package io.github.sofas.flow;

import io.github.sofas.event.EventBatch;
import java.util.List;

/**
 * Labels events and gives them back in order, at once or later: {@link SmoothedSofas} waits for what comes after an
 * event, {@link #atOnce} does not. Every event is given back once, with what it was handed in with. For one thread.
 */
public interface Labelling {
    /**
     * Takes the events that follow; how a recording is cut into batches makes no difference.
     *
     * @param batch events that are not earlier than those before; one outside the sensor gets no flow
     */
    void add(EventBatch batch);

    /** Says that no event follows, so that all can be given back. */
    void finish();

    /**
     * Clears a batch, and fills it with the events that follow in order and are labelled.
     *
     * @param batch gets the events
     * @param flow takes entry i for event i of the batch; holds at least as many
     * @return false where no further event is labelled yet, with the batch left empty
     */
    boolean next(EventBatch batch, FlowOutput flow);

    /** {@return what is known of the segments that live now; none where the method finds no segments} */
    List<Segment> segments();

    /**
     * {@return a method as it is, whose labels are known at once}
     *
     * @param method made for the events' sensor
     */
    static Labelling atOnce(EventLabeller method) {
        return new LabellingAtOnce(method);
    }
}
