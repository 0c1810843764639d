package io.github.sofas.cli;

import io.github.sofas.recording.RecordingOptions;
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

    RecordingOptions recordingOptions() {
        return RecordingOptions.defaults().withChip(chip).withStrict(strict).withForceChip(forceChip);
    }
}
