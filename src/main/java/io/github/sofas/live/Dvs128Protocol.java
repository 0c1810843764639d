package io.github.sofas.live;

import io.github.sofas.recording.Chip;
import io.github.sofas.recording.JaerAddress;

/**
 * Configures, starts and stops a DVS128. The camera takes all biases in one request, as big-endian numbers of 24 bits.
 * Once started, the camera sends events until it is stopped.
 */
final class Dvs128Protocol implements CameraProtocol {
    private static final int SEND_BIASES = 0xB8;
    private static final int START = 0xB3;
    private static final int STOP = 0xB4;
    private static final int BIAS_BYTES = 3;

    private final UsbConnection usb;
    private final Chip chip = Chip.named(CameraModel.DVS128.name()).orElseThrow();

    /** For a camera that is claimed. */
    Dvs128Protocol(UsbConnection usb) {
        this.usb = usb;
    }

    @Override
    public Chip identify() {
        return chip;
    }

    @Override
    public CameraDecoder decoder() {
        return new Dvs128Decoder(new JaerAddress(chip));
    }

    @Override
    public void configure(Biases biases) throws UsbException {
        usb.write(STOP, 0, 0);
        usb.clearHalt(CameraModel.DVS128.endpoint);
        byte[] data = new byte[BIAS_BYTES * biases.all().size()];
        int p = 0;
        for (Biases.Bias bias : biases.all()) {
            data[p++] = (byte) (bias.value() >> 16);
            data[p++] = (byte) (bias.value() >> 8);
            data[p++] = (byte) bias.value();
        }
        usb.write(SEND_BIASES, 0, 0, data);
    }

    @Override
    public void start() throws UsbException {
        usb.write(START, 0, 0);
    }

    @Override
    public void stop() throws UsbException {
        usb.write(STOP, 0, 0);
    }
}
