package io.github.sofas.live;

/**
 * An open USB device: control requests to configure the device, and bulk transfers that deliver its data. One thread at
 * a time calls the methods of the connection. The {@link Receiver} is called on the thread of the transfers.
 */
public interface UsbConnection extends AutoCloseable {
    /** Receives the data of the bulk transfers, on a thread that belongs to the connection. */
    interface Receiver {
        /**
         * A transfer has delivered data.
         *
         * @param data buffer with the data, reused after this method returns
         * @param length number of valid bytes in the buffer
         */
        void received(byte[] data, int length);

        /**
         * One transfer was lost; more follow.
         *
         * @param fault what went wrong
         */
        void lost(TransferFault fault);

        /**
         * The transfers have ended by themselves. The receiver is not called again.
         *
         * @param cause what went wrong
         */
        void ended(UsbException cause);
    }

    /** Why a transfer was lost. */
    enum TransferFault {
        /** The endpoint was halted. The connection clears the halt by itself. */
        STALL,
        /** A protocol error on the wire. */
        ERROR,
        /** The device sent more data than was requested. */
        OVERFLOW
    }

    /**
     * {@return the device's serial number; empty if the device has none}
     *
     * @throws UsbException if the serial number cannot be read
     */
    String serial() throws UsbException;

    /**
     * Claims interface 0 for this program alone.
     *
     * @throws UsbException if another program has claimed the interface
     */
    void claim() throws UsbException;

    /**
     * Reads data from the device by a vendor request.
     *
     * @param request number of the vendor request
     * @param value the request's wValue
     * @param index the request's wIndex
     * @param length number of bytes to read
     * @return exactly that many bytes
     * @throws UsbException if they cannot be read
     */
    byte[] read(int request, int value, int index, int length) throws UsbException;

    /**
     * Writes data to the device by a vendor request.
     *
     * @param request number of the vendor request
     * @param value the request's wValue
     * @param index the request's wIndex
     * @param data bytes to write
     * @throws UsbException if they cannot be written
     */
    void write(int request, int value, int index, byte... data) throws UsbException;

    /**
     * Clears a halted endpoint.
     *
     * @param endpoint address of the endpoint
     * @throws UsbException if the halt cannot be cleared
     */
    void clearHalt(int endpoint) throws UsbException;

    /**
     * Starts to read from a bulk endpoint, with several transfers waiting for data at any time. If the transfers cannot
     * be started, {@link Receiver#ended} reports the reason.
     *
     * @param endpoint address of the endpoint
     * @param transfers number of transfers that wait at a time
     * @param bytes size of each transfer
     * @param receiver is called from the thread of the transfers
     */
    void startTransfers(int endpoint, int transfers, int bytes, Receiver receiver);

    /** Cancels the transfers and returns when all have come back. The receiver is not called again. */
    void stopTransfers();

    /** Releases the device. */
    @Override
    void close();
}
