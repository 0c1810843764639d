package io.github.sofas.flow;

import io.github.sofas.event.EventBatch;
import java.util.List;
import java.util.function.Consumer;

/**
 * A method that gives events a velocity and a segment: SOFAS itself, or a method that SOFAS is compared with. One
 * thread uses it, and hands it the batches of a recording in order.
 */
public interface EventLabeller {
    /**
     * Labels the events of a batch, as if each event were handed over alone: how a recording is cut into batches makes
     * no difference.
     *
     * @param batch events that are not earlier than those before; an event outside the sensor gets no flow
     * @param output takes entry i for event i; overwritten
     * @throws IllegalArgumentException if the batch holds more events than the output
     */
    void process(EventBatch batch, FlowOutput output);

    /**
     * Has a helper do a part of the work beside the calling thread, if the method has such a part. Labels do not depend
     * on the helper, nor on whether and when it does the work.
     *
     * @param helper runs the tasks that it is given in another thread, as an executor's {@code execute} does; null for
     *     none
     */
    default void helpedBy(Consumer<Runnable> helper) {
        // most methods are too fast for a helper to be worth it
    }

    /** {@return the segments that live now; none if the method finds no segments} */
    default List<Segment> segments() {
        return List.of();
    }

    /** Forgets all events, as if newly made. */
    void reset();
}
