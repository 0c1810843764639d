package io.github.sofas.live;

import io.github.sofas.event.EventSourceException;
import io.github.sofas.event.SensorSize;
import io.github.sofas.recording.Chip;
import java.nio.ByteBuffer;
import java.util.Map;
import java.util.TreeMap;
import java.util.function.IntConsumer;

/**
 * Configures, starts and stops a DAVIS with an FX2 or FX3. The camera has parameters of 32 bits, addressed by module
 * and number, and big-endian on the wire. The constants name these modules and numbers. The order of the writes is
 * libcaer's.
 */
final class DavisProtocol implements CameraProtocol {
    private static final int REQUEST = 0xBF;

    private static final int MUX = 0;
    private static final int MUX_RUN = 0;
    private static final int MUX_TIME_RUN = 1;
    private static final int MUX_TIME_RESET = 2;
    private static final int MUX_RUN_CHIP = 3;
    private static final int MUX_DROP_EXTERNAL = 4;
    private static final int MUX_DROP_DVS = 5;

    private static final int DVS = 1;
    private static final int DVS_COLUMNS = 0;
    private static final int DVS_ROWS = 1;
    private static final int DVS_ORIENTATION = 2;
    private static final int DVS_RUN = 3;
    private static final int DVS_WAIT_ON_STALL = 4;
    private static final int DVS_EXTERNAL_AER = 5;
    private static final int SWAPPED = 4;
    /** Numbers of the parameters that show whether the camera has a filter; the filter's settings follow each. */
    private static final int HAS_PIXEL_FILTER = 10;
    private static final int PIXELS_FILTERED = 8;
    private static final int HAS_ACTIVITY_FILTER = 30;
    private static final int HAS_ROI = 40;
    private static final int HAS_SKIP = 50;
    private static final int HAS_POLARITY_FILTER = 60;

    private static final int APS = 2;
    private static final int APS_RUN = 4;
    private static final int IMU = 3;
    private static final int IMU_ACCELEROMETER = 2;
    private static final int IMU_GYRO = 3;
    private static final int IMU_TEMPERATURE = 4;
    private static final int EXTERNAL = 4;
    private static final int EXTERNAL_RUN = 0;
    private static final int BIAS = 5;

    private static final int SYSTEM = 6;
    private static final int SYSTEM_LOGIC = 0;
    private static final int SYSTEM_CHIP = 1;
    private static final int SYSTEM_USB_CLOCK = 5;
    private static final int SYSTEM_DEVIATION = 6;
    private static final int SYSTEM_PATCH = 7;
    private static final int LOGIC_VERSION = 18;
    private static final int LOGIC_PATCH = 1;

    private static final int USB = 9;
    private static final int USB_RUN = 0;
    private static final int USB_EARLY_DELAY = 1;
    /**
     * Time after which the camera sends the waiting data, even if they fill no packet: 1 ms, as 8 times 125 µs. Written
     * in cycles of the USB clock, whose rate the camera reports in MHz.
     */
    private static final double EARLY_US = 8 * 125;
    private static final double DEVIATION_UNIT = 1000;

    /** Name of the chip by its number, for each kind of camera. */
    private static final Map<CameraModel, Map<Integer, String>> CHIPS = Map.of(
        CameraModel.DAVIS240C, new TreeMap<>(Map.of(0, "DAVIS240A", 1, "DAVIS240B", 2, "DAVIS240C")),
        CameraModel.DAVIS346, new TreeMap<>(Map.of(4, "DAVIS346", 5, "Davis346B", 9, "Davis346cBSI")));

    private final String name;
    private final CameraModel model;
    private final UsbConnection usb;
    private final IntConsumer pauseMs;
    private Chip chip;
    private int columns;
    private int rows;
    private boolean swapped;
    private int earlyDelay;

    /**
     * For a camera that is claimed.
     *
     * @param name name of the camera in messages
     * @param pauseMs waits for so many ms
     */
    DavisProtocol(String name, CameraModel model, UsbConnection usb, IntConsumer pauseMs) {
        this.name = name;
        this.model = model;
        this.usb = usb;
        this.pauseMs = pauseMs;
    }

    @Override
    public Chip identify() throws UsbException, EventSourceException {
        int logic = read(SYSTEM, SYSTEM_LOGIC);
        int patch = read(SYSTEM, SYSTEM_PATCH);
        if (logic < LOGIC_VERSION || logic == LOGIC_VERSION && patch < LOGIC_PATCH) {
            throw new EventSourceException("[" + name + "] the camera's logic must be version " + LOGIC_VERSION + "."
                + LOGIC_PATCH + " or newer but was " + logic + "." + patch + "; update it with the maker's tool");
        }
        int chipId = read(SYSTEM, SYSTEM_CHIP);
        Map<Integer, String> chips = CHIPS.get(model);
        if (!chips.containsKey(chipId)) {
            throw new EventSourceException("[" + name + "] unknown chip: its number must be one of " + chips
                + " but was " + chipId);
        }
        chip = Chip.named(chips.get(chipId)).orElseThrow();
        earlyDelay = (int) Math.round(EARLY_US * read(SYSTEM, SYSTEM_USB_CLOCK)
            * read(SYSTEM, SYSTEM_DEVIATION) / DEVIATION_UNIT);
        columns = read(DVS, DVS_COLUMNS);
        rows = read(DVS, DVS_ROWS);
        swapped = (read(DVS, DVS_ORIENTATION) & SWAPPED) != 0;
        SensorSize sensor = chip.sensor();
        if ((swapped ? rows : columns) != sensor.width() || (swapped ? columns : rows) != sensor.height()) {
            throw new EventSourceException("[" + name + "] a " + chip.name() + " must have " + sensor
                + " pixels but the camera reports " + columns + " columns and " + rows + " rows"
                + (swapped ? ", swapped" : ""));
        }
        return chip;
    }

    @Override
    public CameraDecoder decoder() {
        return new DavisDecoder(chip.sensor(), swapped);
    }

    @Override
    public void configure(Biases biases) throws UsbException {
        stopParts();
        pauseMs.accept(10);
        usb.clearHalt(model.endpoint);

        write(MUX, MUX_TIME_RESET, 0);
        write(MUX, MUX_DROP_EXTERNAL, 1);
        write(MUX, MUX_DROP_DVS, 1);
        write(DVS, DVS_WAIT_ON_STALL, 0);
        write(DVS, DVS_EXTERNAL_AER, 0);
        switchFiltersOff();
        write(USB, USB_EARLY_DELAY, earlyDelay);
        for (Biases.Bias bias : biases.all()) {
            write(BIAS, bias.address(), bias.value());
        }
        for (int number = 128; number <= 135; number++) {
            write(BIAS, number, 0);
        }
        write(BIAS, 136, 1);
        write(BIAS, 137, 0);
        write(BIAS, 138, 1);
        write(BIAS, 140, 0);
        write(BIAS, 141, 0);
        write(BIAS, 142, 1);
        if (model == CameraModel.DAVIS346) {
            write(BIAS, 143, 1);
            write(BIAS, 144, 0);
        }
    }

    private void switchFiltersOff() throws UsbException {
        if (read(DVS, HAS_PIXEL_FILTER) != 0) {
            // The address of a pixel that does not exist: no pixel of the sensor is filtered.
            for (int i = 0; i < PIXELS_FILTERED; i++) {
                write(DVS, HAS_PIXEL_FILTER + 1 + 2 * i, rows);
                write(DVS, HAS_PIXEL_FILTER + 2 + 2 * i, columns);
            }
        }
        if (read(DVS, HAS_ACTIVITY_FILTER) != 0) {
            write(DVS, HAS_ACTIVITY_FILTER + 1, 0);
            // The refractory period.
            write(DVS, HAS_ACTIVITY_FILTER + 3, 0);
        }
        if (read(DVS, HAS_ROI) != 0) {
            write(DVS, HAS_ROI + 1, 0);
            write(DVS, HAS_ROI + 2, 0);
            write(DVS, HAS_ROI + 3, columns - 1);
            write(DVS, HAS_ROI + 4, rows - 1);
        }
        if (read(DVS, HAS_SKIP) != 0) {
            write(DVS, HAS_SKIP + 1, 0);
        }
        if (read(DVS, HAS_POLARITY_FILTER) != 0) {
            write(DVS, HAS_POLARITY_FILTER + 1, 0);
            write(DVS, HAS_POLARITY_FILTER + 2, 0);
        }
    }

    @Override
    public void start() throws UsbException {
        write(MUX, MUX_RUN_CHIP, 1);
        pauseMs.accept(200);
        write(USB, USB_RUN, 1);
        write(MUX, MUX_TIME_RUN, 1);
        write(MUX, MUX_RUN, 1);
        pauseMs.accept(50);
        write(DVS, DVS_RUN, 1);
    }

    @Override
    public void stop() throws UsbException {
        stopParts();
    }

    private void stopParts() throws UsbException {
        write(DVS, DVS_RUN, 0);
        write(APS, APS_RUN, 0);
        write(IMU, IMU_ACCELEROMETER, 0);
        write(IMU, IMU_GYRO, 0);
        write(IMU, IMU_TEMPERATURE, 0);
        write(EXTERNAL, EXTERNAL_RUN, 0);
        write(MUX, MUX_RUN, 0);
        write(MUX, MUX_TIME_RUN, 0);
        write(USB, USB_RUN, 0);
        write(MUX, MUX_RUN_CHIP, 0);
    }

    private int read(int module, int number) throws UsbException {
        return ByteBuffer.wrap(usb.read(REQUEST, module, number, Integer.BYTES)).getInt();
    }

    private void write(int module, int number, int value) throws UsbException {
        usb.write(REQUEST, module, number, ByteBuffer.allocate(Integer.BYTES).putInt(value).array());
    }
}
