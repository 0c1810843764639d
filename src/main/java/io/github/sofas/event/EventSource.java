package io.github.sofas.event;

/**
 * A source of events, such as a recording, a simulated scene or a camera.
 *
 * <p>One thread reads a source, from the first event to the last.
 */
public interface EventSource extends AutoCloseable {
    /** {@return the pixel array that the events come from} */
    SensorSize sensor();

    /**
     * Clears the batch and fills it with the next events.
     *
     * @param batch the batch to fill; its previous events are forgotten
     * @return true with at least one event in the batch; false at the end of the source, with the batch left empty
     * @throws EventSourceException if a fault prevents further reading; earlier calls have delivered every event
     *     before the fault
     */
    boolean next(EventBatch batch) throws EventSourceException;

    /** Releases files and buffers. It may be called more than once. */
    @Override
    void close();
}
