package io.github.sofas.live;

import java.nio.ByteBuffer;
import java.util.ArrayList;
import java.util.HashMap;
import java.util.HexFormat;
import java.util.List;
import java.util.Map;

/** A USB on which one camera is plugged in that does as the test says, on the test's own thread. */
public final class FakeTransport implements UsbTransport {
    /** Everything that was asked of the camera, in order. */
    public final List<String> requests = new ArrayList<>();
    /** What the camera tells, by module and number. */
    public final Map<String, Integer> parameters = new HashMap<>();
    /** What is on the bus. */
    public final List<UsbDevice> devices = new ArrayList<>();
    /** Its serial number. */
    public String serial = "00000042";
    /** What opening it comes to; null for success. */
    public UsbException openFault;
    /** What claiming it comes to; null for success. */
    public UsbException claimFault;
    /** What the next request that starts with this comes to. */
    public String failingRequest = "none";
    /** Takes what the camera sends; null while no transfers are waiting. */
    public UsbConnection.Receiver receiver;

    /** Done before each time that the camera sends. */
    public Runnable beforeSending = () -> { };

    /** A DAVIS240C that is well. */
    public static FakeTransport davis240c() {
        return davis(CameraModel.DAVIS240C, 2, 240, 180);
    }

    /** A DAVIS of some kind. */
    public static FakeTransport davis(CameraModel model, int chip, int columns, int rows) {
        FakeTransport fake = plugged(model);
        fake.parameters.putAll(Map.of("6/0", 18, "6/7", 1, "6/1", chip, "6/5", 30, "6/6", 1000, "1/0", columns, "1/1",
            rows));
        return fake;
    }

    /** A camera that tells nothing. */
    public static FakeTransport plugged(CameraModel model) {
        FakeTransport fake = new FakeTransport();
        fake.devices.add(new UsbDevice(CameraModel.VENDOR_ID, model.productId, model.firmware, 1, 7));
        return fake;
    }

    @Override
    public List<UsbDevice> devices() {
        return devices;
    }

    @Override
    public UsbConnection open(UsbDevice device) throws UsbException {
        if (openFault != null) {
            throw openFault;
        }
        requests.add("open");
        return new Connection();
    }

    @Override
    public void close() {
        requests.add("end");
    }

    /** The camera sends bytes. */
    public void send(byte... data) {
        beforeSending.run();
        receiver.received(data, data.length);
    }

    /** The camera sends DAVIS words. */
    public void sendWords(int... words) {
        byte[] data = new byte[2 * words.length];
        for (int i = 0; i < words.length; i++) {
            data[2 * i] = (byte) words[i];
            data[2 * i + 1] = (byte) (words[i] >> 8);
        }
        send(data);
    }

    /** The camera is unplugged. */
    public void unplug() {
        receiver.ended(new UsbException(UsbException.Fault.GONE, "the device is gone"));
        failingRequest = "";
    }

    private final class Connection implements UsbConnection {
        private void request(String request) throws UsbException {
            requests.add(request);
            if (request.startsWith(failingRequest)) {
                throw new UsbException(UsbException.Fault.OTHER, request + " failed (LIBUSB_ERROR_IO)");
            }
        }

        @Override
        public String serial() {
            return serial;
        }

        @Override
        public void claim() throws UsbException {
            if (claimFault != null) {
                throw claimFault;
            }
            request("claim");
        }

        @Override
        public byte[] read(int request, int value, int index, int length) throws UsbException {
            request("read " + value + "/" + index);
            return ByteBuffer.allocate(length).putInt(parameters.getOrDefault(value + "/" + index, 0)).array();
        }

        @Override
        public void write(int request, int value, int index, byte... data) throws UsbException {
            if (request == 0xBF) {
                request(value + "/" + index + "=" + ByteBuffer.wrap(data).getInt());
            } else {
                request(Integer.toHexString(request) + " " + HexFormat.of().formatHex(data));
            }
        }

        @Override
        public void clearHalt(int endpoint) throws UsbException {
            request("clear " + Integer.toHexString(endpoint));
        }

        @Override
        public void startTransfers(int endpoint, int transfers, int bytes, Receiver to) {
            requests.add("transfers " + transfers + " x " + bytes + " from " + Integer.toHexString(endpoint));
            receiver = to;
        }

        @Override
        public void stopTransfers() {
            requests.add("cancel");
        }

        @Override
        public void close() {
            requests.add("close");
        }
    }
}
