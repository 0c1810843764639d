package io.github.sofas.recording;

import static io.github.sofas.recording.Aedat2Format.DAVIS_IMU;
import static io.github.sofas.recording.Aedat2Format.DAVIS_NOT_DVS;
import static io.github.sofas.recording.Aedat2Format.DAVIS_ON_SHIFT;
import static io.github.sofas.recording.Aedat2Format.DAVIS_SPECIAL;
import static io.github.sofas.recording.Aedat2Format.DAVIS_X_MASK;
import static io.github.sofas.recording.Aedat2Format.DAVIS_X_SHIFT;
import static io.github.sofas.recording.Aedat2Format.DAVIS_Y_MASK;
import static io.github.sofas.recording.Aedat2Format.DAVIS_Y_SHIFT;
import static io.github.sofas.recording.Aedat2Format.DVS128_OFF;
import static io.github.sofas.recording.Aedat2Format.DVS128_SPECIAL;
import static io.github.sofas.recording.Aedat2Format.DVS128_UNUSED;
import static io.github.sofas.recording.Aedat2Format.IMU_CODE_MASK;
import static io.github.sofas.recording.Aedat2Format.IMU_CODE_SHIFT;
import static io.github.sofas.recording.Aedat2Format.IMU_WORDS;
import static io.github.sofas.recording.Aedat2Format.INT;
import static io.github.sofas.recording.Aedat2Format.RECORD_BYTES_1;
import static io.github.sofas.recording.Aedat2Format.SHORT;

import java.io.IOException;
import java.util.Arrays;
import java.util.List;

/**
 * Checks whether the addresses of an AEDAT 1.0 or 2.0 recording can be those of a chip. Such a file does not state how
 * its addresses are packed, and a wrong chip still decodes half of them as events somewhere. Signs of a wrong chip are
 * thousands of special events, words of IMU samples in an order that no camera sends, pixels outside the sensor or all
 * in one row, and a polarity that never occurs.
 */
final class AddressCheck {
    private static final int BLOCKS = 64;
    private static final int BLOCK_RECORDS = 1024;
    /** Fewer records than this prove nothing. */
    private static final int FEWEST = 20;
    /** From this number of events on, a single polarity or an unused part of the sensor is no coincidence. */
    private static final int MANY = 1000;
    private static final double MOST_STRANGE = 0.1;
    private static final double MOST_SPECIAL = 0.25;
    /** One chip for each layout and size: the most common one. */
    private static final List<String> CANDIDATES = List.of("DVS128", "DAVIS240C", "Davis346red", "Davis128",
        "Davis640");

    private final int[] addresses;
    /** Marks the first record of each block, which need not follow on the record before it. */
    private final boolean[] begins;
    private final int count;
    private final int stepsBack;
    private final int recordBytes;

    private AddressCheck(int[] addresses, boolean[] begins, int count, int stepsBack, int recordBytes) {
        this.addresses = addresses;
        this.begins = begins;
        this.count = count;
        this.stepsBack = stepsBack;
        this.recordBytes = recordBytes;
    }

    /**
     * Samples records from the whole file and checks them. The file must be at its first record and is left there.
     *
     * @throws MalformedRecordingException where the records cannot be those of the chip; the message names the chip
     *     that they look like, if there is one
     */
    static void check(RecordingFile file, int recordBytes, Chip chip) throws IOException, MalformedRecordingException {
        AddressCheck sample = sample(file, recordBytes);
        if (sample.count < FEWEST) {
            return;
        }
        if (recordBytes == RECORD_BYTES_1 && sample.stepsBack > MOST_STRANGE * sample.count) {
            throw new MalformedRecordingException("[" + file.name + "] header at byte 0: unsupported, the times of an "
                + "AEDAT 1.0 recording must not fall but " + percent(sample.stepsBack, sample.count) + " of "
                + sample.count + " looked at do: this is another format; --force-chip takes it for AEDAT 1.0");
        }
        String against = sample.strongReason(chip);
        String likely = sample.likely();
        if (against == null && likely != null) {
            against = sample.weakReason(chip);
        }
        if (against != null) {
            throw new MalformedRecordingException("[" + file.name + "] --chip " + chip.name() + " must fit the "
                + "addresses but of " + sample.count + " looked at " + against + "; "
                + (likely == null ? "no chip that is known fits" : "they look like those of a " + likely)
                + "; --force-chip takes them for those of a " + chip.name());
        }
    }

    private static AddressCheck sample(RecordingFile file, int recordBytes) throws IOException {
        long first = file.offset();
        long records = (file.size() - first) / recordBytes;
        int blockRecords = (int) Math.min(BLOCK_RECORDS, records);
        long blocks = records <= (long) BLOCKS * BLOCK_RECORDS ? (records + BLOCK_RECORDS - 1) / BLOCK_RECORDS : BLOCKS;
        int[] addresses = new int[(int) blocks * blockRecords];
        boolean[] begins = new boolean[addresses.length];
        int count = 0;
        int stepsBack = 0;
        byte[] block = new byte[blockRecords * recordBytes];
        for (int b = 0; b < blocks; b++) {
            long from = blocks < BLOCKS ? (long) b * blockRecords : (records - blockRecords) * b / (BLOCKS - 1);
            file.seek(first + from * recordBytes);
            int read = file.read(block, 0, block.length) / recordBytes;
            int last = 0;
            for (int i = 0; i < read; i++) {
                int at = i * recordBytes;
                addresses[count] = recordBytes == RECORD_BYTES_1 ? (short) SHORT.get(block, at) & 0xFFFF
                    : (int) INT.get(block, at);
                begins[count] = i == 0;
                int time = (int) INT.get(block, at + recordBytes - Integer.BYTES);
                // a step from positive to negative is an overflow
                stepsBack += i > 0 && time < last && !(last > 0 && time <= 0 && last - (long) time > 1L << 31) ? 1 : 0;
                last = time;
                count++;
            }
        }
        file.seek(first);
        return new AddressCheck(Arrays.copyOf(addresses, count), begins, count, stepsBack, recordBytes);
    }

    private String likely() {
        for (String name : CANDIDATES) {
            Chip chip = Chip.named(name).orElseThrow();
            boolean isPossible = recordBytes != RECORD_BYTES_1 || chip.layout() == Chip.AddressLayout.DVS128;
            if (isPossible && strongReason(chip) == null && weakReason(chip) == null) {
                return name;
            }
        }
        return null;
    }

    /** Names a property that no recording with this chip has; null where the sample shows none. */
    private String strongReason(Chip chip) {
        return chip.layout() == Chip.AddressLayout.DVS128 ? strongReasonDvs128() : strongReasonDavis(chip);
    }

    private String strongReasonDvs128() {
        int malformed = 0;
        int special = 0;
        boolean onePixel = true;
        for (int address : addresses) {
            malformed += (address & DVS128_UNUSED) != 0 ? 1 : 0;
            special += (address & DVS128_SPECIAL) != 0 ? 1 : 0;
            onePixel &= (address & ~DVS128_OFF) == (addresses[0] & ~DVS128_OFF);
        }
        if (malformed > MOST_STRANGE * count) {
            return percent(malformed, count) + " have more than 16 bits";
        }
        if (special > MOST_SPECIAL * count) {
            return percent(special, count) + " are special events";
        }
        return onePixel ? "all are of one pixel" : null;
    }

    private String strongReasonDavis(Chip chip) {
        int events = 0;
        int outside = 0;
        int special = 0;
        int imuWords = 0;
        int imuDisorder = 0;
        int inFirstRow = 0;
        int lastCode = -1;
        for (int i = 0; i < count; i++) {
            int address = addresses[i];
            lastCode = begins[i] ? -1 : lastCode;
            if ((address & DAVIS_NOT_DVS) == 0) {
                if ((address & DAVIS_SPECIAL) != 0) {
                    special++;
                    continue;
                }
                events++;
                int rawY = address >>> DAVIS_Y_SHIFT & DAVIS_Y_MASK;
                outside += (address >>> DAVIS_X_SHIFT & DAVIS_X_MASK) >= chip.sensor().width()
                    || rawY >= chip.sensor().height() ? 1 : 0;
                inFirstRow += rawY == 0 ? 1 : 0;
            } else if ((address & DAVIS_IMU) == DAVIS_IMU) {
                int code = address >>> IMU_CODE_SHIFT & IMU_CODE_MASK;
                imuWords++;
                imuDisorder += lastCode >= 0 && code != (lastCode + 1) % IMU_WORDS ? 1 : 0;
                lastCode = code;
            }
        }
        if (special > MOST_SPECIAL * count) {
            return percent(special, count) + " are special events";
        }
        if (imuWords >= FEWEST && imuDisorder > MOST_STRANGE * imuWords) {
            return percent(imuDisorder, imuWords) + " of " + imuWords + " words of IMU samples are not in their order";
        }
        if (events >= FEWEST && outside > MOST_STRANGE * events) {
            return percent(outside, events) + " of " + events + " pixels lie outside " + chip.sensor();
        }
        return events >= FEWEST && inFirstRow == events ? "all pixels are in one row" : null;
    }

    /**
     * Names a property that is unlikely with this chip; null where the sample shows none. The property counts only
     * where another chip fits without one.
     */
    private String weakReason(Chip chip) {
        boolean isDvs128 = chip.layout() == Chip.AddressLayout.DVS128;
        int events = 0;
        int on = 0;
        int mostX = 0;
        int mostY = 0;
        for (int address : addresses) {
            if ((address & (isDvs128 ? DVS128_SPECIAL : DAVIS_NOT_DVS | DAVIS_SPECIAL)) == 0) {
                events++;
                on += isDvs128 ? 1 - (address & DVS128_OFF) : address >>> DAVIS_ON_SHIFT & 1;
                mostX = Math.max(mostX, address >>> DAVIS_X_SHIFT & DAVIS_X_MASK);
                mostY = Math.max(mostY, address >>> DAVIS_Y_SHIFT & DAVIS_Y_MASK);
            }
        }
        if (events < MANY) {
            return null;
        }
        if (on == 0 || on == events) {
            return "no event is " + (on == 0 ? "ON" : "OFF");
        }
        return isDvs128 ? null : smallerChip(chip, mostX, mostY);
    }

    /**
     * Names another sensor whose size the events fill exactly; null for none. Noise comes from all over a sensor, so
     * such events come from the other one.
     */
    private static String smallerChip(Chip chip, int mostX, int mostY) {
        for (Chip other : Chip.known()) {
            if (other.layout() == chip.layout() && other.sensor().width() == mostX + 1
                    && other.sensor().height() == mostY + 1 && !other.sensor().equals(chip.sensor())) {
                return "all pixels lie within " + other.sensor() + " and reach its corners";
            }
        }
        return null;
    }

    private static String percent(int part, int all) {
        return Math.round(100.0 * part / all) + " %";
    }
}
