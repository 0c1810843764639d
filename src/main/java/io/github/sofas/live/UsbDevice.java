package io.github.sofas.live;

/**
 * A device on the USB: its descriptor and its place on the bus.
 *
 * @param vendorId id of the manufacturer (idVendor)
 * @param productId id of the product (idProduct)
 * @param release version of the device (bcdDevice); the low byte is a camera's firmware version
 * @param bus number of the bus
 * @param address number of the device on the bus, new each time the device is plugged in
 */
public record UsbDevice(int vendorId, int productId, int release, int bus, int address) {
}
