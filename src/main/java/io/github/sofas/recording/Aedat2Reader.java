package io.github.sofas.recording;

import static io.github.sofas.recording.Aedat2Format.DAVIS_IMU;
import static io.github.sofas.recording.Aedat2Format.DAVIS_NOT_DVS;
import static io.github.sofas.recording.Aedat2Format.DAVIS_ON_SHIFT;
import static io.github.sofas.recording.Aedat2Format.DAVIS_SPECIAL;
import static io.github.sofas.recording.Aedat2Format.DAVIS_X_MASK;
import static io.github.sofas.recording.Aedat2Format.DAVIS_X_SHIFT;
import static io.github.sofas.recording.Aedat2Format.DAVIS_Y_MASK;
import static io.github.sofas.recording.Aedat2Format.DAVIS_Y_SHIFT;
import static io.github.sofas.recording.Aedat2Format.DVS128_MASK;
import static io.github.sofas.recording.Aedat2Format.DVS128_OFF;
import static io.github.sofas.recording.Aedat2Format.DVS128_SPECIAL;
import static io.github.sofas.recording.Aedat2Format.DVS128_UNUSED;
import static io.github.sofas.recording.Aedat2Format.DVS128_X_SHIFT;
import static io.github.sofas.recording.Aedat2Format.DVS128_Y_SHIFT;
import static io.github.sofas.recording.Aedat2Format.IMU_CODE_MASK;
import static io.github.sofas.recording.Aedat2Format.IMU_CODE_SHIFT;
import static io.github.sofas.recording.Aedat2Format.IMU_GYRO_X;
import static io.github.sofas.recording.Aedat2Format.IMU_VALUE_SHIFT;
import static io.github.sofas.recording.Aedat2Format.IMU_WORDS;
import static io.github.sofas.recording.Aedat2Format.INT;
import static io.github.sofas.recording.Aedat2Format.RECORD_BYTES_1;
import static io.github.sofas.recording.Aedat2Format.RECORD_BYTES_2;
import static io.github.sofas.recording.Aedat2Format.SHORT;
import static io.github.sofas.recording.Aedat2Format.WRAP_US;

import io.github.sofas.event.EventBatch;
import java.io.IOException;

/**
 * Reads AEDAT 2.0 and AEDAT 1.0, which differs only by its 16-bit addresses. Delivers change events; counts triggers,
 * intensity samples and IMU samples, and passes frames and IMU samples to their receivers. Holds one file buffer.
 *
 * <p>Time: a step from a positive to a zero or negative time is an overflow, as in jAER. Any other step back is a true
 * step back. Recordings that lie wholly in negative time stay there.
 */
final class Aedat2Reader extends RecordingReader {
    /** Value of {@link #nextImuCode} after a damaged IMU sample, whose remaining words are skipped. */
    private static final int SKIP_TO_NEXT_IMU = -1;
    /** Greatest delay, in µs, at which an event from before an overflow is still recognised after the overflow. */
    private static final long STRAGGLER_US = 1_000_000;

    private final int recordBytes;
    private final Chip.AddressLayout layout;
    /** Code that the next word of an IMU sample must have; 0 between samples. */
    private int nextImuCode;
    /** The words of the IMU sample so far. */
    private final short[] imuWords = new short[IMU_WORDS];
    /** Created at the first intensity sample for which there is a receiver of frames. */
    private ApsFrames apsFrames;

    Aedat2Reader(RecordingFile file, RecordingOptions options, String formatName, int recordBytes, String chipName,
                 Chip chip) {
        super(file, options, formatName, chipName, chip.sensor());
        this.recordBytes = recordBytes;
        this.layout = chip.layout();
    }

    @Override
    boolean decode(EventBatch batch) throws IOException, MalformedRecordingException {
        if (!file.require(recordBytes)) {
            if (nextImuCode > 0) {
                int words = nextImuCode;
                addFault("imu", () -> at(eventNumber(0), file.offset()) + "truncated, an IMU sample must have "
                        + IMU_WORDS + " words but had " + words);
                nextImuCode = 0;
            }
            if (file.available() > 0) {
                throw malformed(eventNumber(0), file.offset(), "truncated, a record must have " + recordBytes
                        + " bytes but had " + file.available());
            }
            return false;
        }
        if (layout == Chip.AddressLayout.DVS128) {
            decodeDvs128(batch);
        } else {
            decodeDavis(batch);
        }
        return true;
    }

    /** x and y have 7 bits each on a sensor of 128 x 128, so no event can lie outside. */
    private void decodeDvs128(EventBatch batch) throws MalformedRecordingException {
        byte[] buffer = file.buffer;
        int stride = recordBytes;
        int timeAt = stride - Integer.BYTES;
        int lastRecord = file.limit - stride;
        int p = file.position;
        long[] timeUs = batch.timeUs;
        short[] x = batch.x;
        short[] y = batch.y;
        byte[] polarity = batch.polarity;
        int capacity = batch.capacity();
        int n = 0;
        long start = file.offset() - p;
        try {
            for (; p <= lastRecord && n < capacity; p += stride) {
                int address = stride == RECORD_BYTES_1
                        ? (short) SHORT.get(buffer, p) & 0xFFFF : (int) INT.get(buffer, p);
                int raw = (int) INT.get(buffer, p + timeAt);
                if ((address & (DVS128_SPECIAL | DVS128_UNUSED)) != 0) {
                    if ((address & DVS128_SPECIAL) != 0) {
                        triggers++;
                        continue;
                    }
                    strangeAddress(address, n, p);
                }
                note(n, start + p);
                timeUs[n] = raw;
                x[n] = (short) (DVS128_MASK - (address >>> DVS128_X_SHIFT & DVS128_MASK));
                y[n] = (short) (DVS128_MASK - (address >>> DVS128_Y_SHIFT & DVS128_MASK));
                polarity[n] = (byte) (1 - 2 * (address & DVS128_OFF));
                n++;
            }
        } finally {
            file.position = p;
            deliver(batch, n);
        }
    }

    private void decodeDavis(EventBatch batch) throws MalformedRecordingException {
        byte[] buffer = file.buffer;
        int lastRecord = file.limit - RECORD_BYTES_2;
        int p = file.position;
        long[] timeUs = batch.timeUs;
        short[] x = batch.x;
        short[] y = batch.y;
        byte[] polarity = batch.polarity;
        int capacity = batch.capacity();
        int lastColumn = sensor().width() - 1;
        int lastRow = sensor().height() - 1;
        int n = 0;
        long start = file.offset() - p;
        try {
            for (; p <= lastRecord && n < capacity; p += RECORD_BYTES_2) {
                int address = (int) INT.get(buffer, p);
                int raw = (int) INT.get(buffer, p + Integer.BYTES);
                if ((address & (DAVIS_NOT_DVS | DAVIS_SPECIAL)) != 0) {
                    countOther(address, n, p);
                    continue;
                }
                int column = lastColumn - (address >>> DAVIS_X_SHIFT & DAVIS_X_MASK);
                int row = lastRow - (address >>> DAVIS_Y_SHIFT & DAVIS_Y_MASK);
                if ((column | row) < 0) {
                    outside(lastColumn - column, lastRow - row, eventNumber(n), offsetOf(p));
                    continue;
                }
                note(n, start + p);
                timeUs[n] = raw;
                x[n] = (short) column;
                y[n] = (short) row;
                polarity[n] = (byte) ((address >>> DAVIS_ON_SHIFT & 1) * 2 - 1);
                n++;
            }
        } finally {
            file.position = p;
            deliver(batch, n);
        }
    }

    private void countOther(int address, int n, int p) {
        if ((address & DAVIS_NOT_DVS) == 0) {
            triggers++;
        } else if ((address & DAVIS_IMU) != DAVIS_IMU) {
            apsSamples++;
            if (frameReceiver != null) {
                if (apsFrames == null) {
                    apsFrames = new ApsFrames(sensor(), frameReceiver);
                }
                apsFrames.take(address, timeOf((int) INT.get(file.buffer, p + Integer.BYTES)));
            }
        } else {
            takeImuWord(address, n, p);
        }
    }

    private void takeImuWord(int address, int n, int p) {
        int code = address >>> IMU_CODE_SHIFT & IMU_CODE_MASK;
        if (code == nextImuCode) {
            imuWords[code] = (short) (address >>> IMU_VALUE_SHIFT);
            if (code == IMU_WORDS - 1) {
                imuSamples++;
                if (imuReceiver != null) {
                    imuReceiver.accept(new ImuSample(timeOf((int) INT.get(file.buffer, p + Integer.BYTES)),
                            imuWords[IMU_GYRO_X], imuWords[IMU_GYRO_X + 1], imuWords[IMU_GYRO_X + 2]));
                }
            }
            nextImuCode = (code + 1) % IMU_WORDS;
            return;
        }
        malformedRecords++;
        if (nextImuCode != SKIP_TO_NEXT_IMU) {
            int expected = nextImuCode;
            addFault("imu", () -> at(eventNumber(n), offsetOf(p)) + "malformed, an IMU sample's word must have code "
                    + expected + " but had " + code);
        }
        imuWords[0] = (short) (address >>> IMU_VALUE_SHIFT);
        nextImuCode = code == 0 ? 1 : SKIP_TO_NEXT_IMU;
    }

    private void strangeAddress(int address, int n, int p) {
        malformedRecords++;
        addFault("address", () -> at(eventNumber(n), offsetOf(p)) + "malformed, a DVS128 address must have 16 bits "
                + String.format("but was 0x%08X", address) + "; its low 16 bits were used");
    }

    /** As in jAER, a step from a positive to a zero or negative time is an overflow. */
    @Override
    long step(long fromUs, long toUs) {
        long step = toUs - fromUs;
        if (step < 0 && fromUs > 0 && toUs <= 0) {
            return step + WRAP_US;
        }
        // an event from before the overflow that comes after it
        return step >= WRAP_US - STRAGGLER_US && timeWraps() > 0 ? step - WRAP_US : step;
    }
}
