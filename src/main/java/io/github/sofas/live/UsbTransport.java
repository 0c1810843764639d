package io.github.sofas.live;

import java.util.List;

/** Access to the USB, as far as cameras need it: lists the devices and opens one. */
public interface UsbTransport extends AutoCloseable {
    /**
     * {@return all devices that are plugged in}
     *
     * @throws UsbException if the devices cannot be listed
     */
    List<UsbDevice> devices() throws UsbException;

    /**
     * Opens a device.
     *
     * @param device one of {@link #devices()}
     * @return the open device
     * @throws UsbException if the device cannot be opened
     */
    UsbConnection open(UsbDevice device) throws UsbException;

    /** Ends the use of the USB. The caller has closed all connections before. */
    @Override
    void close();
}
