package io.github.sofas.flow;

import io.github.sofas.event.EventBatch;
import java.util.List;

/**
 * Labels events and gives them back in order, at once or later: {@link SmoothedSofas} waits for the events that follow,
 * {@link #atOnce} does not. Every event is given back once, with the values that it was handed in with. For one thread.
 */
public interface Labelling {
    /**
     * Takes the events that follow. How a recording is cut into batches makes no difference.
     *
     * @param batch events that are not earlier than those before; an event outside the sensor gets no flow
     */
    void add(EventBatch batch);

    /** Declares that no event follows, so that all events can be given back. */
    void finish();

    /**
     * Clears a batch, and fills it with the next labelled events, in order.
     *
     * @param batch gets the events
     * @param flow takes entry i for event i of the batch; holds at least as many
     * @return false if no further event is labelled yet, with the batch left empty
     */
    boolean next(EventBatch batch, FlowOutput flow);

    /** {@return the segments that live now; none if the method finds no segments} */
    List<Segment> segments();

    /**
     * {@return a labelling by a method whose labels are known at once}
     *
     * @param method made for the events' sensor
     */
    static Labelling atOnce(EventLabeller method) {
        return new LabellingAtOnce(method);
    }
}
