package io.github.sofas.live;

import io.github.sofas.event.EventBatch;
import java.util.Map;

/** Decodes the bytes of a camera's transfers into events, and counts what else the bytes hold. Used by one thread. */
interface CameraDecoder {
    /**
     * Appends the events of a transfer.
     *
     * @param batch receives the events; has room for {@link #mostEvents} of the length
     */
    void decode(byte[] data, int length, EventBatch batch);

    /** The greatest number of events that so many bytes can hold. */
    int mostEvents(int bytes);

    /** Notes that a transfer was lost before the one that is decoded next. */
    void lose();

    /** Numbers of all that the stream held besides events, by name. */
    Map<String, Long> counts();

    /** Numbers of events that were not delivered, by reason. */
    Map<String, Long> dropped();
}
