package io.github.sofas.event;

/**
 * Where events come from: a recording, a simulated scene, a camera.
 *
 * <p>A source is read by one thread, from first to last.
 */
public interface EventSource extends AutoCloseable {
    /** {@return the pixel array that the events come from} */
    SensorSize sensor();

    /**
     * Clears the batch and fills it with the events that follow.
     *
     * @param batch is filled; what it held is forgotten
     * @return false at the end, with the batch left empty; true with at least one event otherwise
     * @throws EventSourceException where no further event can be had; every event before the fault was delivered by
     *     earlier calls
     */
    boolean next(EventBatch batch) throws EventSourceException;

    /** Releases files and buffers; may be called more than once. */
    @Override
    void close();
}
