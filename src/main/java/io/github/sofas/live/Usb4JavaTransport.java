package io.github.sofas.live;

import java.util.ArrayList;
import java.util.List;
import org.usb4java.Context;
import org.usb4java.Device;
import org.usb4java.DeviceDescriptor;
import org.usb4java.DeviceHandle;
import org.usb4java.DeviceList;
import org.usb4java.LibUsb;
import org.usb4java.LoaderException;

/** The real USB, through usb4java, Java's binding of libusb. */
public final class Usb4JavaTransport implements UsbTransport {
    private final Context context = new Context();
    private boolean closed;

    /**
     * Starts the use of the USB.
     *
     * @throws UsbException if this system has no USB, or if usb4java has no library for this system
     */
    public Usb4JavaTransport() throws UsbException {
        try {
            check(LibUsb.init(context), "libusb cannot be started");
        } catch (LoaderException | UnsatisfiedLinkError e) {
            throw new UsbException(UsbException.Fault.OTHER, "usb4java has no library for this system: "
                + e.getMessage(), e);
        }
    }

    /** Returns a result of libusb that is not negative, and throws any other as an exception. */
    static int check(int code, String what) throws UsbException {
        if (code >= 0) {
            return code;
        }
        UsbException.Fault fault = switch (code) {
            case LibUsb.ERROR_ACCESS -> UsbException.Fault.NO_PERMISSION;
            case LibUsb.ERROR_BUSY -> UsbException.Fault.BUSY;
            case LibUsb.ERROR_NO_DEVICE -> UsbException.Fault.GONE;
            default -> UsbException.Fault.OTHER;
        };
        throw new UsbException(fault, what + " (" + LibUsb.errorName(code) + ")");
    }

    /** Action on each device of a list. */
    @FunctionalInterface
    private interface Visitor {
        /** Returns whether to continue with the next device. */
        boolean visit(Device handle, UsbDevice device) throws UsbException;
    }

    private void visit(Visitor visitor) throws UsbException {
        DeviceList list = new DeviceList();
        check(LibUsb.getDeviceList(context, list), "no list of devices");
        try {
            for (Device each : list) {
                DeviceDescriptor descriptor = new DeviceDescriptor();
                check(LibUsb.getDeviceDescriptor(each, descriptor), "a device has no descriptor");
                UsbDevice device = new UsbDevice(descriptor.idVendor() & 0xFFFF, descriptor.idProduct() & 0xFFFF,
                    descriptor.bcdDevice() & 0xFFFF, LibUsb.getBusNumber(each), LibUsb.getDeviceAddress(each));
                if (!visitor.visit(each, device)) {
                    break;
                }
            }
        } finally {
            LibUsb.freeDeviceList(list, true);
        }
    }

    @Override
    public List<UsbDevice> devices() throws UsbException {
        List<UsbDevice> devices = new ArrayList<>();
        visit((handle, device) -> devices.add(device));
        return devices;
    }

    @Override
    public UsbConnection open(UsbDevice wanted) throws UsbException {
        DeviceHandle opened = new DeviceHandle();
        boolean[] found = new boolean[1];
        visit((handle, device) -> {
            found[0] = device.equals(wanted);
            if (found[0]) {
                check(LibUsb.open(handle, opened), "it cannot be opened");
            }
            return !found[0];
        });
        if (!found[0]) {
            throw new UsbException(UsbException.Fault.GONE, "it is no longer there");
        }
        return new Usb4JavaConnection(context, opened);
    }

    @Override
    public void close() {
        if (!closed) {
            closed = true;
            LibUsb.exit(context);
        }
    }
}
