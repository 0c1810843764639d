/**
 * Cameras without a viewer, and the network stream of jAER. Open {@link io.github.sofas.live.LiveSource} first: it is
 * an event source like any other, so that the engine does not know where its events come from.
 *
 * <pre>
 * UsbTransport      finds and opens USB devices; Usb4JavaTransport is the real one
 * Cameras           knows which of them are cameras, and opens one as a CameraSource
 * CameraModel       what there is to know of each kind of camera; DavisProtocol and Dvs128Protocol start and stop it
 * DavisDecoder, Dvs128Decoder    bytes of a transfer to events
 * PacketQueue       from the thread that the transfers come in on to the one that takes the events; bounded
 * JaerUdpSource     jAER's AEUnicast datagrams instead of a camera
 * </pre>
 *
 * <p>Protocol, start order and default biases are facts from jAER (SensorsINI/jaer a1db449) and libcaer (f85411a).
 * All of it was proven against a software model of the cameras, none on a physical one.
 */
package io.github.sofas.live;
