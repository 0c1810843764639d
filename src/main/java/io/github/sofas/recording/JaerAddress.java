package io.github.sofas.recording;

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
import static io.github.sofas.recording.Aedat2Format.DVS128_X_SHIFT;
import static io.github.sofas.recording.Aedat2Format.DVS128_Y_SHIFT;

/**
 * Decodes the addresses of one chip, as jAER writes them into AEDAT 2.0 or sends them over the network. This class
 * serves streams; the reader of files has the same decoding in its loop.
 */
public final class JaerAddress {
    private final boolean dvs128;
    private final int lastColumn;
    private final int lastRow;

    /**
     * Makes a decoder for the addresses of a chip.
     *
     * @param chip chip that the events come from
     */
    public JaerAddress(Chip chip) {
        dvs128 = chip.layout() == Chip.AddressLayout.DVS128;
        lastColumn = chip.sensor().width() - 1;
        lastRow = chip.sensor().height() - 1;
    }

    /**
     * {@return whether the address is that of a change event (DVS), not of an intensity sample or another record}
     *
     * @param address as the recording holds it
     */
    public boolean isEvent(int address) {
        return (address & (dvs128 ? DVS128_SPECIAL : DAVIS_NOT_DVS | DAVIS_SPECIAL)) == 0;
    }

    /**
     * {@return the column of an event, from 0 at the left; below 0 where it is outside the sensor}
     *
     * @param address as the recording holds it
     */
    public int x(int address) {
        return lastColumn - (dvs128 ? address >>> DVS128_X_SHIFT & DVS128_MASK
            : address >>> DAVIS_X_SHIFT & DAVIS_X_MASK);
    }

    /**
     * {@return the row of an event, from 0 at the top; below 0 where it is outside the sensor}
     *
     * @param address as the recording holds it
     */
    public int y(int address) {
        return lastRow - (dvs128 ? address >>> DVS128_Y_SHIFT & DVS128_MASK
            : address >>> DAVIS_Y_SHIFT & DAVIS_Y_MASK);
    }

    /**
     * {@return 1 for ON, -1 for OFF}
     *
     * @param address as the recording holds it
     */
    public int polarity(int address) {
        boolean on = dvs128 ? (address & DVS128_OFF) == 0 : (address >>> DAVIS_ON_SHIFT & 1) != 0;
        return on ? 1 : -1;
    }
}
