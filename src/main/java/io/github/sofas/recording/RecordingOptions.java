package io.github.sofas.recording;

/**
 * What a recording does not say itself, and how its faults are taken.
 *
 * @param chip the sensor where the recording names none that is known: a name that {@link Chip#named} knows or, for
 *     formats whose events hold plain coordinates (text, AEDAT 3 and 4), a size such as {@code 240x180}; null for none.
 *     A chip that the recording names itself wins, and the difference is one of {@link RecordingReader#faults()}.
 * @param strict whether a step back in time is an error; otherwise it is counted and the event gets the greatest time
 *     seen before it
 * @param forceChip whether the chip is taken even where the recording names another, or its addresses speak against it
 */
public record RecordingOptions(String chip, boolean strict, boolean forceChip) {
    private static final RecordingOptions DEFAULTS = new RecordingOptions(null, false, false);

    /** No chip, not strict. */
    public static RecordingOptions defaults() {
        return DEFAULTS;
    }

    /** The same with another chip, or null for none. */
    public RecordingOptions withChip(String newChip) {
        return new RecordingOptions(newChip, strict, forceChip);
    }

    /** The same with another strictness. */
    public RecordingOptions withStrict(boolean newStrict) {
        return new RecordingOptions(chip, newStrict, forceChip);
    }

    /** The same with the chip obeyed whatever the recording says, or not. */
    public RecordingOptions withForceChip(boolean newForceChip) {
        return new RecordingOptions(chip, strict, newForceChip);
    }
}
