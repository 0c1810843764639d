package io.github.sofas.recording;

import io.github.sofas.event.SensorSize;
import java.util.List;

/**
 * What a recording does not say itself, and how its faults are taken.
 *
 * @param chip the sensor where the recording names none that is known: a name that {@link Chip#named} knows or, for
 *     formats whose events hold plain coordinates (all but AEDAT 1 and 2), a size such as {@code 240x180}; null for
 *     none. A chip that the recording names itself wins, and the difference is one of {@link RecordingReader#notes()}.
 * @param strict whether a step back in time is an error; otherwise it is counted and the event gets the greatest time
 *     seen before it
 * @param forceChip whether the chip is taken even where the recording names another, or its addresses speak against it
 * @param columns which field of a text recording's lines is what; null for what its header says, or the usual order
 * @param timeUnit unit of a text recording's times; null for what its header or its numbers say
 */
public record RecordingOptions(String chip, boolean strict, boolean forceChip, TextColumns columns,
                               TextTimeUnit timeUnit) {
    private static final RecordingOptions DEFAULTS = new RecordingOptions(null, false, false, null, null);

    /**
     * Makes options.
     *
     * @param chip name of a chip or size of a sensor; null for none
     * @param strict whether a step back in time is an error
     * @param forceChip whether the chip is taken whatever the recording says
     * @param columns of text recordings; null for those that the recording says
     * @param timeUnit of text recordings; null for the one that the recording says
     * @throws IllegalArgumentException where the chip is neither a known name nor a size of {@link SensorSize}'s range
     */
    public RecordingOptions {
        if (chip != null) {
            ChipChoice.named(chip);
        }
    }

    /** {@return no chip, not strict, text by its header or the usual order} */
    public static RecordingOptions defaults() {
        return DEFAULTS;
    }

    /**
     * {@return the same with another chip, or null for none}
     *
     * @param newChip name of a chip, or a size such as {@code 240x180}
     * @throws IllegalArgumentException where it is neither
     */
    public RecordingOptions withChip(String newChip) {
        return new RecordingOptions(newChip, strict, forceChip, columns, timeUnit);
    }

    /**
     * {@return the same with another strictness}
     *
     * @param newStrict whether a step back in time is an error
     */
    public RecordingOptions withStrict(boolean newStrict) {
        return new RecordingOptions(chip, newStrict, forceChip, columns, timeUnit);
    }

    /**
     * {@return the same, with or without obeying the chip whatever the recording says}
     *
     * @param newForceChip whether it is
     */
    public RecordingOptions withForceChip(boolean newForceChip) {
        return new RecordingOptions(chip, strict, newForceChip, columns, timeUnit);
    }

    /**
     * {@return the same with other columns for text recordings}
     *
     * @param names in the order of the fields, such as t, x, y, p; any other name passes over a field
     * @throws IllegalArgumentException where one of the four is missing or comes twice
     */
    public RecordingOptions withColumns(List<String> names) {
        TextColumns newColumns = TextColumns.named(names).orElseThrow(() -> new IllegalArgumentException(
                "columns must name t, x, y and p once each but were " + String.join(",", names)));
        return new RecordingOptions(chip, strict, forceChip, newColumns, timeUnit);
    }

    /**
     * {@return the same with another unit of time for text recordings}
     *
     * @param newTimeUnit null for what the recording says
     */
    public RecordingOptions withTimeUnit(TextTimeUnit newTimeUnit) {
        return new RecordingOptions(chip, strict, forceChip, columns, newTimeUnit);
    }
}
