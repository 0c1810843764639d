/**
 * Live events without a viewer, from a camera on the USB or from the network stream of jAER. Open {@link
 * io.github.sofas.live.LiveSource} first: it is an event source like any other, so that the engine does not depend on
 * where its events come from.
 *
 * <pre>
 * UsbTransport      finds and opens USB devices; Usb4JavaTransport does so on real hardware
 * Cameras           finds the cameras among these devices and opens one as a CameraSource
 * CameraModel       constants of each kind of camera; DavisProtocol and Dvs128Protocol start and stop a camera
 * DavisDecoder, Dvs128Decoder    decode the bytes of a transfer into events
 * PacketQueue       bounded; hands events from the receiving thread to the consuming thread
 * JaerUdpSource     receives jAER's AEUnicast datagrams instead of reading a camera
 * </pre>
 *
 * <p>Protocol, start order and default biases are facts from jAER (SensorsINI/jaer a1db449) and libcaer (f85411a). All
 * tests use software models of the cameras, not real ones.
 */
package io.github.sofas.live;
