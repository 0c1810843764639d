package io.github.sofas.export;

import io.github.sofas.event.EventBatch;
import io.github.sofas.flow.FlowOutput;
import java.io.Closeable;
import java.io.IOException;

/** Writes a row for every event with its flow and segment, in some format. */
public interface FlowWriter extends Closeable {
    /**
     * Writes the rows of a batch.
     *
     * @param batch the events
     * @param flow labelled by the engine for this batch
     * @throws IOException where they cannot be written
     */
    void write(EventBatch batch, FlowOutput flow) throws IOException;
}
