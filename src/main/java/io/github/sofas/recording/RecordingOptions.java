package io.github.sofas.recording;

import io.github.sofas.event.SensorSize;
import java.util.List;

/**
 * What the caller states about a recording: facts that the recording itself lacks, and how its faults are treated.
 *
 * @param chip the sensor, for recordings that name no known one: a name that {@link Chip#named} knows or, for formats
 *     whose events hold plain coordinates (all but AEDAT 1 and 2), a size such as {@code 240x180}; null for none. A
 *     chip that the recording names itself wins, and the difference is one of {@link RecordingReader#notes()}.
 * @param strict whether a step back in time is an error; otherwise it is counted and the event gets the greatest time
 *     seen before it
 * @param forceChip whether the chip is used even where the recording names another, or its addresses contradict it
 * @param columns meaning of the fields of a text recording's lines; null for that of its header, or the usual order
 * @param timeUnit unit of a text recording's times; null for what its header or its numbers indicate
 */
public record RecordingOptions(String chip, boolean strict, boolean forceChip, TextColumns columns,
                               TextTimeUnit timeUnit) {
    private static final RecordingOptions DEFAULTS = new RecordingOptions(null, false, false, null, null);

    /**
     * Makes options.
     *
     * @param chip name of a chip or size of a sensor; null for none
     * @param strict whether a step back in time is an error
     * @param forceChip whether the chip is used whatever the recording says
     * @param columns columns of text recordings; null for those that the recording names
     * @param timeUnit time unit of text recordings; null for the one that the recording indicates
     * @throws IllegalArgumentException where the chip is neither a known name nor a size in the range of
     *     {@link SensorSize}
     */
    public RecordingOptions {
        if (chip != null) {
            ChipChoice.named(chip);
        }
    }

    /** {@return the default options: no chip, not strict, text by its header or in the usual order} */
    public static RecordingOptions defaults() {
        return DEFAULTS;
    }

    /**
     * {@return these options with another chip, or null for none}
     *
     * @param newChip name of a chip, or a size such as {@code 240x180}
     * @throws IllegalArgumentException where it is neither
     */
    public RecordingOptions withChip(String newChip) {
        return new RecordingOptions(newChip, strict, forceChip, columns, timeUnit);
    }

    /**
     * {@return these options with another strictness}
     *
     * @param newStrict whether a step back in time is an error
     */
    public RecordingOptions withStrict(boolean newStrict) {
        return new RecordingOptions(chip, newStrict, forceChip, columns, timeUnit);
    }

    /**
     * {@return these options, with the chip forced or not}
     *
     * @param newForceChip whether the chip is used whatever the recording says
     */
    public RecordingOptions withForceChip(boolean newForceChip) {
        return new RecordingOptions(chip, strict, newForceChip, columns, timeUnit);
    }

    /**
     * {@return these options with other columns for text recordings}
     *
     * @param names names in the order of the fields, such as t, x, y, p; a field with any other name is skipped
     * @throws IllegalArgumentException where one of the four is missing or comes twice
     */
    public RecordingOptions withColumns(List<String> names) {
        TextColumns newColumns = TextColumns.named(names).orElseThrow(() -> new IllegalArgumentException(
                "columns must name t, x, y and p once each but were " + String.join(",", names)));
        return new RecordingOptions(chip, strict, forceChip, newColumns, timeUnit);
    }

    /**
     * {@return these options with another unit of time for text recordings}
     *
     * @param newTimeUnit the unit; null to take it from the recording
     */
    public RecordingOptions withTimeUnit(TextTimeUnit newTimeUnit) {
        return new RecordingOptions(chip, strict, forceChip, columns, newTimeUnit);
    }
}
