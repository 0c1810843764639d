package io.github.sofas.export;

import io.github.sofas.event.EventBatch;
import io.github.sofas.flow.FlowOutput;
import java.io.Closeable;
import java.io.IOException;

/** Writes one row for every event, with its flow and segment, whatever the format of the file. */
public interface FlowWriter extends Closeable {
    /**
     * Writes the rows of a batch.
     *
     * @param batch the events
     * @param flow labels of the same events
     * @throws IOException if the rows cannot be written
     */
    void write(EventBatch batch, FlowOutput flow) throws IOException;
}
