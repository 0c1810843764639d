/**
 * Cameras without a viewer, and the network stream of jAER. Open {@link io.github.sofas.live.LiveSource} first: it is
 * an event source like any other, so that the engine does not know where its events come from.
 *
 * <pre>
 * UsbTransport      finds and opens USB devices; Usb4JavaTransport is the real one
 * Cameras           finds the cameras among them and opens one as a CameraSource
 * CameraModel       constants of each kind of camera; DavisProtocol and Dvs128Protocol start and stop it
 * DavisDecoder, Dvs128Decoder    bytes of a transfer to events
 * PacketQueue       hands events from the thread of the transfers to the thread that takes them; bounded
 * JaerUdpSource     jAER's AEUnicast datagrams instead of a camera
 * </pre>
 *
 * <p>Protocol, start order and default biases are facts from jAER (SensorsINI/jaer a1db449) and libcaer (f85411a).
 * Tested with software models of the cameras, not with real ones.
 */
package io.github.sofas.live;
