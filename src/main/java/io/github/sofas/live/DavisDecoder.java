package io.github.sofas.live;

import io.github.sofas.event.EventBatch;
import io.github.sofas.event.SensorSize;
import java.lang.invoke.MethodHandles;
import java.lang.invoke.VarHandle;
import java.nio.ByteOrder;
import java.util.LinkedHashMap;
import java.util.Map;

/**
 * Decodes the stream of a DAVIS into events. The stream consists of little-endian words of 16 bits. A word with bit 15
 * set holds the time of the words that follow. Any other word has a code in bits 14 to 12 and data in the bits below. A
 * row address is valid for the column addresses that follow, each of which is an event. Rows count from the top,
 * columns from the left.
 */
final class DavisDecoder implements CameraDecoder {
    private static final VarHandle SHORT = MethodHandles.byteArrayViewVarHandle(short[].class,
        ByteOrder.LITTLE_ENDIAN);
    private static final int IS_TIME = 0x8000;
    private static final int TIME_MASK = 0x7FFF;
    private static final long WRAP_US = 0x8000;
    private static final int CODE_SHIFT = 12;
    private static final int DATA_MASK = 0xFFF;

    private static final int SPECIAL = 0;
    private static final int ROW = 1;
    private static final int COLUMN_OFF = 2;
    private static final int COLUMN_ON = 3;
    private static final int ADC_SAMPLE = 4;
    private static final int WRAP = 7;

    private static final int TIME_RESET = 1;
    private static final int FIRST_EXTERNAL = 2;
    private static final int LAST_EXTERNAL = 4;
    private static final int IMU_END = 7;

    private static final int NO_ROW = -1;
    private static final int ROW_OUTSIDE = -2;

    private final int columns;
    private final int rows;
    private final boolean swapped;
    private final CameraClock clock = new CameraClock(WRAP_US);
    private int row = NO_ROW;

    private long apsSamples;
    private long imuSamples;
    private long triggers;
    private long otherWords;
    private long oddBytes;
    private long outside;
    private long withoutRow;

    /**
     * Makes a decoder.
     *
     * @param sensor size of the sensor as events see it
     * @param swapped whether the rows that the camera sends are the sensor's columns
     */
    DavisDecoder(SensorSize sensor, boolean swapped) {
        this.columns = swapped ? sensor.height() : sensor.width();
        this.rows = swapped ? sensor.width() : sensor.height();
        this.swapped = swapped;
    }

    @Override
    public int mostEvents(int bytes) {
        return bytes / Short.BYTES;
    }

    @Override
    public void decode(byte[] data, int length, EventBatch batch) {
        oddBytes += length & 1;
        for (int p = 0; p + 1 < length; p += Short.BYTES) {
            int word = (short) SHORT.get(data, p);
            if ((word & IS_TIME) != 0) {
                clock.extend(word & TIME_MASK);
                continue;
            }
            int code = word >> CODE_SHIFT;
            int value = word & DATA_MASK;
            if (code == COLUMN_OFF || code == COLUMN_ON) {
                if (value < columns && row >= 0) {
                    int polarity = code == COLUMN_ON ? 1 : -1;
                    batch.add(clock.newestUs(), swapped ? row : value, swapped ? value : row, polarity);
                } else if (value < columns && row == NO_ROW) {
                    withoutRow++;
                } else {
                    outside++;
                }
            } else if (code == ROW) {
                row = value < rows ? value : ROW_OUTSIDE;
            } else {
                decodeOther(code, value);
            }
        }
    }

    private void decodeOther(int code, int value) {
        switch (code) {
            case WRAP:
                clock.wrap(value);
                break;
            case SPECIAL:
                decodeSpecial(value);
                break;
            case ADC_SAMPLE:
                apsSamples++;
                break;
            default:
                // The bytes of IMU samples, and exposure times.
                otherWords++;
                break;
        }
    }

    private void decodeSpecial(int value) {
        if (value == TIME_RESET) {
            clock.reset();
        } else if (value >= FIRST_EXTERNAL && value <= LAST_EXTERNAL) {
            triggers++;
        } else if (value == IMU_END) {
            imuSamples++;
        } else {
            otherWords++;
        }
    }

    @Override
    public void lose() {
        clock.lose();
        row = NO_ROW;
    }

    @Override
    public Map<String, Long> counts() {
        Map<String, Long> counts = new LinkedHashMap<>();
        counts.put("aps_samples", apsSamples);
        counts.put("imu_samples", imuSamples);
        counts.put("triggers", triggers);
        counts.put("steps_back_in_time", clock.stepsBack);
        counts.put("time_wraps", clock.wraps);
        counts.put("time_resets", clock.resets);
        counts.put("other_words", otherWords);
        counts.put("odd_bytes", oddBytes);
        return counts;
    }

    @Override
    public Map<String, Long> dropped() {
        Map<String, Long> dropped = new LinkedHashMap<>();
        dropped.put("outside_sensor", outside);
        dropped.put("without_row", withoutRow);
        return dropped;
    }
}
