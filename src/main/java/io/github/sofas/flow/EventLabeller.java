package io.github.sofas.flow;

import io.github.sofas.event.EventBatch;
import java.util.List;
import java.util.function.Consumer;

/**
 * A method that gives events a velocity and a segment: SOFAS itself, or one that it is compared with. It is used by one
 * thread, and sees a recording's batches in order.
 */
public interface EventLabeller {
    /**
     * Labels the events of a batch, as if every event were handed over alone: how a recording is cut into batches makes
     * no difference.
     *
     * @param batch events that are not earlier than those before; one outside the sensor gets no flow
     * @param output takes entry i for event i; overwritten
     * @throws IllegalArgumentException where the batch holds more events than the output
     */
    void process(EventBatch batch, FlowOutput output);

    /**
     * Has a part of the work done beside the thread that calls, if the method has such a part. Labels do not depend on
     * it, nor on when and whether the helper comes to it.
     *
     * @param helper runs what it is given, in another thread, as an executor's {@code execute} does; null for none
     */
    default void helpedBy(Consumer<Runnable> helper) {
        // most methods are too fast to be worth it
    }

    /** {@return what is known of the segments that live now; none where the method finds no segments} */
    default List<Segment> segments() {
        return List.of();
    }

    /** Forgets all events, as if made anew. */
    void reset();
}
