package io.github.sofas.live;

import io.github.sofas.event.EventSourceException;
import io.github.sofas.recording.Chip;

/**
 * The requests that identify, configure, start and stop one kind of camera. {@link Cameras} identifies a camera when it
 * is opened; {@link CameraSource} does the rest.
 */
interface CameraProtocol {
    /**
     * Asks the camera for its chip.
     *
     * @throws EventSourceException if this camera is not supported
     */
    Chip identify() throws UsbException, EventSourceException;

    /** A new decoder for the camera's transfers; only after {@link #identify}. */
    CameraDecoder decoder();

    /** Brings the camera from any state into one in which it waits to be started. */
    void configure(Biases biases) throws UsbException;

    /** Starts the camera's stream. The transfers that receive the stream were started before. */
    void start() throws UsbException;

    /** Stops the camera's stream. */
    void stop() throws UsbException;
}
