package io.github.sofas.live;

import io.github.sofas.event.EventBatch;
import java.util.Map;

/** Turns the bytes of a camera's transfers into events. Used by one thread. */
interface CameraDecoder {
    /**
     * Appends the events of a transfer.
     *
     * @param batch has room for {@link #mostEvents} of the length
     */
    void decode(byte[] data, int length, EventBatch batch);

    /** The most events that so many bytes can hold. */
    int mostEvents(int bytes);

    /** Says that a transfer before the next one was lost. */
    void lose();

    /** How many of each kind were met, by name. */
    Map<String, Long> counts();

    /** Events that were not delivered, by reason. */
    Map<String, Long> dropped();
}
