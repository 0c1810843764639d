package io.github.sofas.cli;

import io.github.sofas.event.EventBatch;
import io.github.sofas.event.EventSourceException;
import io.github.sofas.flow.FlowOutput;

/** Supplies events with their labels, in order, wherever the labels come from. */
@FunctionalInterface
interface LabelledEvents {
    /**
     * Clears a batch, and fills it with the events that follow.
     *
     * @param batch gets the events
     * @param flow takes entry i for event i of the batch; holds at least as many
     * @return false at the end, with the batch left empty; true with at least one event otherwise
     * @throws EventSourceException if no further event can be read
     */
    boolean next(EventBatch batch, FlowOutput flow) throws EventSourceException;
}
