package io.github.sofas.live;

import io.github.sofas.event.EventSourceException;
import io.github.sofas.recording.Chip;

/** How a kind of camera is asked what it is, started and stopped. */
interface CameraProtocol {
    /**
     * Asks the camera what it is.
     *
     * @throws EventSourceException where it is not served
     */
    Chip identify() throws UsbException, EventSourceException;

    /** A new decoder of its transfers, once it is identified. */
    CameraDecoder decoder();

    /** Brings it from any state to one in which it waits to be started. */
    void configure(Biases biases) throws UsbException;

    /** Lets it send; the transfers that take what it sends were started before. */
    void start() throws UsbException;

    /** Lets it send no more. */
    void stop() throws UsbException;
}
