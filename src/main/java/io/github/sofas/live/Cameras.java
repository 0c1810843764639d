package io.github.sofas.live;

import io.github.sofas.event.EventSourceException;
import io.github.sofas.recording.Chip;
import java.util.ArrayList;
import java.util.List;
import java.util.function.IntConsumer;

/** Lists the cameras that are plugged in, with the reason why one cannot be used, and opens one. */
public final class Cameras {
    /** Path, within the project, of the udev rule that allows users to open cameras on Linux. */
    public static final String UDEV_RULE = "udev/65-event-cameras.rules";

    private final UsbTransport usb;
    private final IntConsumer pauseMs;

    /**
     * One camera.
     *
     * @param model kind of camera; null if the firmware is missing
     * @param device the camera on the USB
     * @param serial serial number; empty if the camera has none or cannot be opened
     * @param fault why the camera cannot be used; null if no reason is known
     */
    public record Camera(CameraModel model, UsbDevice device, String serial, String fault) {
        /** {@return the kind and serial number} */
        public String name() {
            return (model == null ? "camera" : model.name()) + (serial.isEmpty() ? "" : " " + serial);
        }
    }

    /**
     * Looks for cameras on a transport.
     *
     * @param usb the transport to the devices
     */
    public Cameras(UsbTransport usb) {
        this(usb, Cameras::pause);
    }

    /** The same with another way to pause, for tests. */
    Cameras(UsbTransport usb, IntConsumer pauseMs) {
        this.usb = usb;
        this.pauseMs = pauseMs;
    }

    private static void pause(int ms) {
        try {
            Thread.sleep(ms);
        } catch (InterruptedException e) {
            // The caller waits or writes next, and meets the interrupt there.
            Thread.currentThread().interrupt();
        }
    }

    /**
     * {@return all cameras, including those that cannot be used}
     *
     * @throws EventSourceException if the devices cannot be listed
     */
    public List<Camera> list() throws EventSourceException {
        List<Camera> cameras = new ArrayList<>();
        for (UsbDevice device : devices()) {
            CameraModel model = CameraModel.of(device).orElse(null);
            if (model != null) {
                cameras.add(look(device, model));
            } else if (CameraModel.isBlank(device)) {
                cameras.add(new Camera(null, device, "", CameraModel.blankFault(device)));
            }
        }
        return cameras;
    }

    private List<UsbDevice> devices() throws EventSourceException {
        try {
            return usb.devices();
        } catch (UsbException e) {
            throw new EventSourceException("USB devices cannot be listed: " + e.getMessage(), e);
        }
    }

    private Camera look(UsbDevice device, CameraModel model) {
        try (UsbConnection connection = usb.open(device)) {
            return new Camera(model, device, connection.serial(), firmwareFault(device, model));
        } catch (UsbException e) {
            return new Camera(model, device, "", fault(device, e));
        }
    }

    private static String firmwareFault(UsbDevice device, CameraModel model) {
        int firmware = device.release() & 0xFF;
        return firmware >= model.firmware ? null : "the camera's firmware must be version " + model.firmware
            + " or newer but was " + firmware + "; update it with the maker's tool";
    }

    private static String fault(UsbDevice device, UsbException e) {
        return switch (e.fault()) {
            case NO_PERMISSION -> String.format("no permission to open bus %d, address %d: on Linux, copy %s to "
                + "/etc/udev/rules.d, run \"udevadm control --reload\" and plug the camera in again", device.bus(),
                device.address(), UDEV_RULE);
            case BUSY -> "another program uses the camera; close it first";
            case GONE -> "the camera was unplugged";
            case OTHER -> "the camera cannot be opened: " + e.getMessage();
        };
    }

    /**
     * Opens a camera, which can then be started.
     *
     * @param serial serial number of the camera; null for the first that can be used
     * @return the camera
     * @throws EventSourceException if there is no such camera, or if it cannot be used
     */
    public CameraSource open(String serial) throws EventSourceException {
        List<Camera> cameras = list();
        if (cameras.isEmpty()) {
            throw new EventSourceException("no camera is plugged in; supported are DAVIS240C, DAVIS346 and DVS128");
        }
        Camera firstUnusable = null;
        for (Camera camera : cameras) {
            boolean asked = serial == null || serial.equals(camera.serial);
            if (asked && camera.fault == null) {
                return open(camera);
            }
            // A camera that cannot be opened has no serial number here, and may be the one that was asked for.
            if (firstUnusable == null && camera.fault != null && (asked || camera.serial.isEmpty())) {
                firstUnusable = camera;
            }
        }
        if (firstUnusable != null) {
            throw new EventSourceException("[" + firstUnusable.name() + "] " + firstUnusable.fault);
        }
        throw new EventSourceException("no camera has the serial number \"" + serial + "\"; there are "
            + String.join(", ", cameras.stream().map(Camera::name).toList()));
    }

    private CameraSource open(Camera camera) throws EventSourceException {
        UsbConnection connection = null;
        boolean opened = false;
        try {
            connection = usb.open(camera.device);
            connection.claim();
            CameraProtocol protocol = camera.model == CameraModel.DVS128 ? new Dvs128Protocol(connection)
                : new DavisProtocol(camera.name(), camera.model, connection, pauseMs);
            Chip chip = protocol.identify();
            CameraSource source = new CameraSource(camera.name(), chip, camera.model, connection, protocol,
                protocol.decoder());
            opened = true;
            return source;
        } catch (UsbException e) {
            throw new EventSourceException("[" + camera.name() + "] " + fault(camera.device, e), e);
        } finally {
            if (connection != null && !opened) {
                connection.close();
            }
        }
    }
}
