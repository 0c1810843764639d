package io.github.sofas.cli;

import io.github.sofas.recording.RecordingOptions;
import java.nio.file.Path;
import java.util.Locale;
import picocli.CommandLine.Option;

/** What a recording does not say itself, for all commands that read recordings. */
final class ReadingOptions {
    @Option(names = "--chip", paramLabel = "CHIP",
        description = "Sensor of recordings that name none, such as DVS128 or DAVIS240C; for text and AEDAT 3 and 4 "
            + "also a size such as 640x480.")
    private String chip;

    @Option(names = "--force-chip",
        description = "Take --chip even where the recording names another, or where its addresses speak against it.")
    private boolean forceChip;

    @Option(names = "--strict",
        description = "Take a step back in time for damage; without it the event gets the time of the one before.")
    private boolean strict;

    @Option(names = "--doubtful-share", paramLabel = "SHARE", defaultValue = "0.01",
        description = "Share of events that may be corrected, dropped or malformed, 0 to 1; over it the exit code is "
            + "1; default: ${DEFAULT-VALUE}.")
    private double doubtfulShare;

    /**
     * Checks the values.
     *
     * @throws IllegalArgumentException where one is out of range, with a message for the user
     */
    void check() {
        if (!(doubtfulShare >= 0 && doubtfulShare <= 1)) {
            throw new IllegalArgumentException("--doubtful-share must be 0 to 1 but was " + doubtfulShare);
        }
    }

    /**
     * Why what came of a recording is doubtful; null where it is not.
     *
     * @param share of its events that were corrected, dropped or malformed
     */
    String doubt(Path recording, double share) {
        return share <= doubtfulShare ? null : String.format(Locale.ROOT, "doubtful: %s, %s %% of whose events were "
            + "corrected, dropped or malformed", recording.getFileName(), percent(share));
    }

    /** Rounded, but never to the limit that it is over. */
    private String percent(double share) {
        double percent = 100 * share;
        double rounded = Math.round(10 * percent) / 10.0;
        return rounded > 100 * doubtfulShare ? String.format(Locale.ROOT, "%.1f", rounded) : String.valueOf(percent);
    }

    RecordingOptions recordingOptions() {
        return RecordingOptions.defaults().withChip(chip).withStrict(strict).withForceChip(forceChip);
    }
}
