package io.github.sofas.live;

/** An open USB device. All methods but those of the receiver are called by one thread at a time. */
public interface UsbConnection extends AutoCloseable {
    /** Takes what comes in, on a thread of the connection's own. */
    interface Receiver {
        /**
         * Data has come in.
         *
         * @param data reused after the return
         * @param length how many bytes of it are valid
         */
        void received(byte[] data, int length);

        /**
         * One transfer was lost; more follow.
         *
         * @param fault what went wrong
         */
        void lost(TransferFault fault);

        /**
         * The transfers have ended by themselves; the receiver is not called again.
         *
         * @param cause what went wrong
         */
        void ended(UsbException cause);
    }

    /** Why a transfer was lost. */
    enum TransferFault {
        /** The endpoint was halted; it was cleared. */
        STALL,
        /** A protocol error on the wire. */
        ERROR,
        /** The device sent more than was asked for. */
        OVERFLOW
    }

    /**
     * {@return the device's serial number; empty where it has none}
     *
     * @throws UsbException where it cannot be read
     */
    String serial() throws UsbException;

    /**
     * Takes interface 0 for this program alone.
     *
     * @throws UsbException where another program has it
     */
    void claim() throws UsbException;

    /**
     * Reads by a vendor request to the device.
     *
     * @param request number of the vendor request
     * @param value the request's wValue
     * @param index the request's wIndex
     * @param length how many bytes are read
     * @return as many bytes as asked for
     * @throws UsbException where they cannot be read
     */
    byte[] read(int request, int value, int index, int length) throws UsbException;

    /**
     * Writes by a vendor request to the device.
     *
     * @param request number of the vendor request
     * @param value the request's wValue
     * @param index the request's wIndex
     * @param data what is written
     * @throws UsbException where it cannot be written
     */
    void write(int request, int value, int index, byte... data) throws UsbException;

    /**
     * Clears a halted endpoint.
     *
     * @param endpoint its address
     * @throws UsbException where it cannot be cleared
     */
    void clearHalt(int endpoint) throws UsbException;

    /**
     * Starts to read from a bulk endpoint, with several transfers waiting at any time. The receiver hears where they
     * cannot be started.
     *
     * @param endpoint its address
     * @param transfers how many are under way at a time
     * @param bytes size of each
     * @param receiver is called from the thread of the transfers
     */
    void startTransfers(int endpoint, int transfers, int bytes, Receiver receiver);

    /** Cancels the transfers and returns when all are back; the receiver is not called again. */
    void stopTransfers();

    /** Gives the device back. */
    @Override
    void close();
}
