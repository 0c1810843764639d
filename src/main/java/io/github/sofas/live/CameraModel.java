package io.github.sofas.live;

import java.util.Arrays;
import java.util.List;
import java.util.Optional;

/** The supported kinds of cameras: how each is recognised on the USB, and what its transfers need. */
public enum CameraModel {
    /** DAVIS with an FX2: 240 x 180 pixels. */
    DAVIS240C(0x841B, 4, 0x82, 8192),
    /** DAVIS with an FX3: 346 x 260 pixels. */
    DAVIS346(0x841A, 6, 0x82, 8192),
    /** DVS with an FX2: 128 x 128 pixels. */
    DVS128(0x8400, 14, 0x86, 4096);

    /** Vendor id, the same for all models. */
    static final int VENDOR_ID = 0x152A;
    /** Transfers that wait for data at any time. */
    static final int TRANSFERS = 8;

    private static final int CYPRESS = 0x04B4;
    private static final int BLANK_FX2 = 0x8613;
    private static final int BLANK_FX3 = 0x00F3;

    final int productId;
    /** Oldest supported firmware version. */
    final int firmware;
    /** Address of the bulk endpoint that delivers the events. */
    final int endpoint;
    final int transferBytes;

    CameraModel(int productId, int firmware, int endpoint, int transferBytes) {
        this.productId = productId;
        this.firmware = firmware;
        this.endpoint = endpoint;
        this.transferBytes = transferBytes;
    }

    /** The model of a device; empty if the device is not a supported camera. */
    static Optional<CameraModel> of(UsbDevice device) {
        return Arrays.stream(values())
            .filter(model -> device.vendorId() == VENDOR_ID && device.productId() == model.productId).findFirst();
    }

    /** Whether a device is the bare USB chip of such a camera, without the camera's firmware. */
    static boolean isBlank(UsbDevice device) {
        return device.vendorId() == CYPRESS && List.of(BLANK_FX2, BLANK_FX3).contains(device.productId());
    }

    /** Describes to the user what is wrong with a device that {@link #isBlank}. */
    static String blankFault(UsbDevice device) {
        return String.format("firmware missing: bus %d, address %d is a bare %s (%04x:%04x); flash the camera's "
            + "firmware with jAER or the maker's tool", device.bus(), device.address(),
            device.productId() == BLANK_FX2 ? "FX2" : "FX3", device.vendorId(), device.productId());
    }
}
