package io.github.sofas.live;

/**
 * A device on the USB.
 *
 * @param vendorId who made it
 * @param productId what it is
 * @param release its own version, bcdDevice; the low byte is the version of a camera's firmware
 * @param bus number of its bus
 * @param address its number on the bus, new each time it is plugged in
 */
public record UsbDevice(int vendorId, int productId, int release, int bus, int address) {
}
