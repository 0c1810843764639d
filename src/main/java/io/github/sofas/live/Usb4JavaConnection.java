package io.github.sofas.live;

import io.github.sofas.live.UsbException.Fault;
import java.nio.ByteBuffer;
import java.util.ArrayDeque;
import java.util.ArrayList;
import java.util.Deque;
import java.util.List;
import org.usb4java.Context;
import org.usb4java.DeviceDescriptor;
import org.usb4java.DeviceHandle;
import org.usb4java.LibUsb;
import org.usb4java.Transfer;

/**
 * A device opened by libusb. One thread of its own, the pump, waits for its transfers, passes their data to the
 * receiver and submits them again.
 */
final class Usb4JavaConnection implements UsbConnection {
    private static final int INTERFACE = 0;
    private static final byte VENDOR_IN = (byte) (LibUsb.REQUEST_TYPE_VENDOR | LibUsb.ENDPOINT_IN);
    private static final byte VENDOR_OUT = LibUsb.REQUEST_TYPE_VENDOR;
    private static final long CONTROL_TIMEOUT_MS = 1000;
    private static final long EVENT_WAIT_US = 100_000;

    private final Context context;
    private final DeviceHandle handle;
    private boolean claimed;
    private boolean closed;

    private final List<Transfer> transfers = new ArrayList<>();
    private Thread thread;

    // These belong to the thread of the transfers once it runs.
    private final Deque<Transfer> stalled = new ArrayDeque<>();
    private byte[] data;
    private int endpoint;
    private Receiver receiver;
    private int pending;
    private UsbException end;
    private volatile boolean stopping;

    Usb4JavaConnection(Context context, DeviceHandle handle) {
        this.context = context;
        this.handle = handle;
    }

    @Override
    public String serial() throws UsbException {
        DeviceDescriptor descriptor = new DeviceDescriptor();
        Usb4JavaTransport.check(LibUsb.getDeviceDescriptor(LibUsb.getDevice(handle), descriptor), "no descriptor");
        if (descriptor.iSerialNumber() == 0) {
            return "";
        }
        StringBuffer text = new StringBuffer();
        Usb4JavaTransport.check(LibUsb.getStringDescriptorAscii(handle, descriptor.iSerialNumber(), text),
            "no serial number");
        return text.toString();
    }

    @Override
    public void claim() throws UsbException {
        Usb4JavaTransport.check(LibUsb.claimInterface(handle, INTERFACE), "its interface cannot be claimed");
        claimed = true;
    }

    @Override
    public byte[] read(int request, int value, int index, int length) throws UsbException {
        ByteBuffer buffer = ByteBuffer.allocateDirect(length);
        int read = Usb4JavaTransport.check(LibUsb.controlTransfer(handle, VENDOR_IN, (byte) request, (short) value,
            (short) index, buffer, CONTROL_TIMEOUT_MS), describe("read", request, value, index));
        if (read < length) {
            throw new UsbException(Fault.OTHER, describe("read", request, value, index) + " (" + read + " of "
                + length + " bytes)");
        }
        byte[] bytes = new byte[length];
        buffer.get(bytes);
        return bytes;
    }

    @Override
    public void write(int request, int value, int index, byte... bytes) throws UsbException {
        ByteBuffer buffer = ByteBuffer.allocateDirect(bytes.length);
        buffer.put(bytes).rewind();
        Usb4JavaTransport.check(LibUsb.controlTransfer(handle, VENDOR_OUT, (byte) request, (short) value,
            (short) index, buffer, CONTROL_TIMEOUT_MS), describe("write", request, value, index));
    }

    private static String describe(String what, int request, int value, int index) {
        return String.format("%s of %d/%d by request 0x%02X failed", what, value, index, request);
    }

    @Override
    public void clearHalt(int halted) throws UsbException {
        Usb4JavaTransport.check(LibUsb.clearHalt(handle, (byte) halted), "the endpoint cannot be cleared");
    }

    @Override
    public void startTransfers(int from, int count, int bytes, Receiver to) {
        endpoint = from;
        receiver = to;
        data = new byte[bytes];
        for (int i = 0; i < count; i++) {
            Transfer transfer = LibUsb.allocTransfer();
            LibUsb.fillBulkTransfer(transfer, handle, (byte) endpoint, ByteBuffer.allocateDirect(bytes), this::taken,
                null, 0);
            transfers.add(transfer);
        }
        transfers.forEach(this::submit);
        thread = new Thread(this::pump, "camera transfers");
        // Data of the camera is lost unless it is requested in time; the engine can wait.
        thread.setPriority(Thread.MAX_PRIORITY);
        thread.setDaemon(true);
        thread.start();
    }

    /** Waits for transfers until none is pending; cancels them all on a stop or a fault. */
    private void pump() {
        boolean cancelled = false;
        while (pending > 0) {
            int code = LibUsb.handleEventsTimeout(context, EVENT_WAIT_US);
            if (code < 0 && code != LibUsb.ERROR_INTERRUPTED && code != LibUsb.ERROR_TIMEOUT) {
                end("waiting for transfers failed", code);
            }
            resumeStalled();
            if ((stopping || end != null) && !cancelled) {
                cancelled = true;
                // A transfer that is back already cannot be cancelled, which does no harm.
                transfers.forEach(LibUsb::cancelTransfer);
            }
        }
        if (end != null && !stopping) {
            receiver.ended(end);
        }
    }

    /** Is called by libusb, on the thread that pumps, with a transfer that is back. */
    private void taken(Transfer transfer) {
        pending--;
        if (stopping || end != null) {
            return;
        }
        try {
            handOn(transfer);
        } catch (RuntimeException e) {
            // The exception must not pass through libusb: no caller above would see it.
            end = new UsbException(Fault.OTHER, "unexpected error: " + e, e);
        }
    }

    private void handOn(Transfer transfer) {
        int status = transfer.status();
        switch (status) {
            case LibUsb.TRANSFER_COMPLETED:
                int length = transfer.actualLength();
                transfer.buffer().get(0, data, 0, length);
                receiver.received(data, length);
                submit(transfer);
                break;
            case LibUsb.TRANSFER_STALL:
                receiver.lost(TransferFault.STALL);
                stalled.add(transfer);
                break;
            case LibUsb.TRANSFER_OVERFLOW:
                receiver.lost(TransferFault.OVERFLOW);
                submit(transfer);
                break;
            case LibUsb.TRANSFER_ERROR:
                receiver.lost(TransferFault.ERROR);
                submit(transfer);
                break;
            case LibUsb.TRANSFER_NO_DEVICE:
                end("the device is gone", LibUsb.ERROR_NO_DEVICE);
                break;
            default:
                end("a transfer came back with status " + status, LibUsb.ERROR_OTHER);
                break;
        }
    }

    private void submit(Transfer transfer) {
        int code = LibUsb.submitTransfer(transfer);
        if (code < 0) {
            end("a transfer cannot be started", code);
        } else {
            pending++;
        }
    }

    /** Clears the halted endpoint. Not called from within libusb's callback, because clearing waits for the device. */
    private void resumeStalled() {
        while (!stalled.isEmpty() && end == null && !stopping) {
            int code = LibUsb.clearHalt(handle, (byte) endpoint);
            if (code < 0) {
                end("the endpoint cannot be cleared", code);
            } else {
                submit(stalled.poll());
            }
        }
    }

    private void end(String what, int code) {
        if (end == null) {
            try {
                Usb4JavaTransport.check(code, what);
            } catch (UsbException e) {
                end = e;
            }
        }
    }

    @Override
    public void stopTransfers() {
        if (thread == null) {
            return;
        }
        stopping = true;
        ThreadEnd.await(thread);
        thread = null;
        transfers.forEach(LibUsb::freeTransfer);
        transfers.clear();
    }

    @Override
    public void close() {
        if (closed) {
            return;
        }
        closed = true;
        stopTransfers();
        if (claimed) {
            LibUsb.releaseInterface(handle, INTERFACE);
        }
        LibUsb.close(handle);
    }
}
