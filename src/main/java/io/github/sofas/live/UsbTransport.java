package io.github.sofas.live;

import java.util.List;

/** The USB, as far as cameras need it. */
public interface UsbTransport extends AutoCloseable {
    /**
     * {@return all devices that are plugged in}
     *
     * @throws UsbException where they cannot be listed
     */
    List<UsbDevice> devices() throws UsbException;

    /**
     * Opens a device.
     *
     * @param device one of {@link #devices()}
     * @return the open device
     * @throws UsbException where it cannot be opened
     */
    UsbConnection open(UsbDevice device) throws UsbException;

    /** Ends the use of the USB; all connections were closed before. */
    @Override
    void close();
}
