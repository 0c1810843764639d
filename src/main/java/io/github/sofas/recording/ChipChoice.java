package io.github.sofas.recording;

import io.github.sofas.event.EventSourceException;
import io.github.sofas.event.SensorSize;
import java.util.Optional;
import java.util.regex.Matcher;
import java.util.regex.Pattern;

/**
 * The sensor of a recording, chosen from its header and the caller's option. The header wins where its chip is known
 * and the option is not forced: one option then works for a batch of recordings of which some name their sensor.
 * Nothing is ever guessed.
 *
 * @param name its name in the header or the option; null where only a size is known
 * @param chip the chip, null where only its size is known
 * @param sensor its size
 * @param note message to the user about the choice, or null
 * @param asked whether the caller named the sensor, not the header
 */
record ChipChoice(String name, Chip chip, SensorSize sensor, String note, boolean asked) {
    private static final String OR_SIZE = " or a size such as 240x180";
    private static final Pattern SIZE = Pattern.compile("(\\d{1,5})[xX](\\d{1,5})");

    /** Chooses for a format whose addresses can only be decoded with the chip's layout. */
    static ChipChoice withLayout(String fileName, String headerChip, RecordingOptions options)
            throws EventSourceException {
        ChipChoice choice = choose(fileName, headerChip, options, "");
        if (choice.chip == null) {
            throw new EventSourceException("[" + fileName + "] --chip must name one of " + Chip.knownNames()
                    + ", because a size does not say how addresses are packed, but was " + options.chip());
        }
        return choice;
    }

    /** Chooses for a format that holds plain coordinates but no size: a size such as 240x180 is allowed too. */
    static ChipChoice withSize(String fileName, String headerChip, RecordingOptions options)
            throws EventSourceException {
        return choose(fileName, headerChip, options, OR_SIZE);
    }

    /**
     * Chooses for a format that may state the size itself. Its chip name need not be a known one then.
     *
     * @param headerOffset byte of the header that states the size
     * @param width columns as the header writes them, or null
     * @param height rows likewise
     */
    static ChipChoice withOwnSize(String fileName, long headerOffset, String headerChip, String width, String height,
                                  RecordingOptions options) throws EventSourceException {
        String optionChip = options.chip();
        if (width == null || height == null || options.forceChip() && optionChip != null) {
            return choose(fileName, headerChip, options, OR_SIZE);
        }
        SensorSize sensor;
        try {
            sensor = new SensorSize(Integer.parseInt(width), Integer.parseInt(height));
        } catch (IllegalArgumentException e) {
            throw new MalformedRecordingException("[" + fileName + "] header at byte " + headerOffset
                    + ": unsupported, the sensor must measure "
                    + "1x1 to " + SensorSize.MAX_WIDTH + "x" + SensorSize.MAX_HEIGHT + " but was " + width + "x"
                    + height, e);
        }
        boolean differs = optionChip != null && !named(optionChip).sensor.equals(sensor);
        return new ChipChoice(headerChip, null, sensor, !differs ? null
                : "[" + fileName + "] the header names a sensor of " + sensor + ", so --chip " + optionChip
                + " was not used; --force-chip uses it", false);
    }

    private static ChipChoice choose(String fileName, String headerChip, RecordingOptions options, String orSize)
            throws EventSourceException {
        String optionChip = options.chip();
        ChipChoice option = optionChip == null ? null : named(optionChip);
        Optional<Chip> header = headerChip == null ? Optional.empty() : Chip.named(headerChip);
        if (header.isPresent() && !(options.forceChip() && option != null)) {
            Chip chip = header.get();
            boolean differs = option != null && !(option.sensor.equals(chip.sensor())
                    && (option.chip == null || option.chip.layout() == chip.layout()));
            return new ChipChoice(chip.name(), chip, chip.sensor(), !differs ? null
                    : "[" + fileName + "] the header names " + chip.name() + ", so --chip " + optionChip
                    + " was not used; --force-chip uses it", false);
        }
        if (option == null) {
            throw new SensorNotNamedException("[" + fileName + "] " + (headerChip == null
                    ? "the recording names no chip" : "the recording's chip " + headerChip + " is not known")
                    + ": --chip must name one of " + Chip.knownNames() + orSize, !orSize.isEmpty());
        }
        return headerChip == null ? option : new ChipChoice(option.name, option.chip, option.sensor,
                "[" + fileName + "] the header's chip " + headerChip
                + (header.isPresent() ? " is set aside" : " is not known") + ", so --chip " + optionChip
                + " was used", true);
    }

    /**
     * The choice of a caller who names a chip or a size.
     *
     * @throws IllegalArgumentException where the name is neither
     */
    static ChipChoice named(String name) {
        Optional<Chip> chip = Chip.named(name);
        if (chip.isPresent()) {
            return new ChipChoice(chip.get().name(), chip.get(), chip.get().sensor(), null, true);
        }
        Matcher size = SIZE.matcher(name);
        if (!size.matches()) {
            throw new IllegalArgumentException("chip must name one of " + Chip.knownNames() + OR_SIZE + " but was "
                    + name);
        }
        try {
            return new ChipChoice(null, null,
                    new SensorSize(Integer.parseInt(size.group(1)), Integer.parseInt(size.group(2))), null, true);
        } catch (IllegalArgumentException e) {
            throw new IllegalArgumentException("chip " + name + ": " + e.getMessage(), e);
        }
    }

    /** Reports the choice and its note to the reader. Every reader gets its choice by this method. */
    void reportTo(RecordingReader reader) {
        if (asked) {
            reader.chipIsAsked();
        }
        if (note != null) {
            reader.addNote(note);
        }
    }
}
