package io.github.sofas.cli;

import io.github.sofas.recording.Printable;
import io.github.sofas.recording.RecordingOptions;
import io.github.sofas.recording.TextTimeUnit;
import java.io.IOException;
import java.io.PrintWriter;
import java.nio.file.Files;
import java.nio.file.Path;
import java.nio.file.attribute.BasicFileAttributes;
import java.util.List;
import java.util.Locale;
import picocli.CommandLine.Model.CommandSpec;
import picocli.CommandLine.Option;
import picocli.CommandLine.ParameterException;
import picocli.CommandLine.Spec;

/**
 * Options of all commands that read recordings. They give what a recording does not say itself, and limit the faults
 * that it may have.
 */
final class ReadingOptions {
    @Spec(Spec.Target.MIXEE)
    private CommandSpec command;

    @Option(names = "--chip", paramLabel = "CHIP",
        description = "Sensor of recordings that do not name one, such as DVS128 or DAVIS240C; in all formats but "
        + "AEDAT 1 and 2 also a size such as 640x480.")
    private String chip;

    @Option(names = "--force-chip",
        description = "Use --chip even if the recording names another sensor or its addresses contradict it.")
    private boolean forceChip;

    @Option(names = "--strict",
        description = "Treat a step back in time as an error; otherwise the event gets the time of the previous one.")
    private boolean strict;

    @Option(names = "--columns", paramLabel = "NAME", split = ",",
        description = "Fields of text recordings, in order, such as t,x,y,p or x,y,_,p,t; default: as in the header, "
        + "else t,x,y,p.")
    private List<String> columns;

    @Option(names = "--time", paramLabel = "UNIT",
        description = "Time unit of text recordings: s, ms, us or ns; default: detected from header or numbers.")
    private String timeUnit;

    @Option(names = "--doubtful-share", paramLabel = "SHARE", defaultValue = "0.01",
        description = "Share of events that may be corrected, dropped or malformed, 0 to 1; above it the exit code is "
        + "1; default: ${DEFAULT-VALUE}.")
    private double doubtfulShare;

    /**
     * Checks the values.
     *
     * @throws ParameterException if one is wrong
     */
    void check() {
        if (forceChip && chip == null) {
            throw usage("--force-chip has no effect without --chip");
        }
        if (!(doubtfulShare >= 0 && doubtfulShare <= 1)) {
            throw usage("--doubtful-share must be 0 to 1 but was " + doubtfulShare);
        }
        if (timeUnit != null && TextTimeUnit.named(timeUnit).isEmpty()) {
            throw usage("--time must be s, ms, us or ns but was " + timeUnit);
        }
        try {
            recordingOptions();
        } catch (IllegalArgumentException e) {
            // the message begins with the name of the wrong value, which is that of the option
            throw usage("--" + e.getMessage());
        }
    }

    private ParameterException usage(String message) {
        return new ParameterException(command.commandLine(), message);
    }

    /**
     * Why the results of a recording are doubtful; null if they are not.
     *
     * @param share share of the recording's events that were corrected, dropped or malformed
     */
    String doubt(Path recording, double share) {
        return share <= doubtfulShare ? null : String.format(Locale.ROOT, "doubtful: %s, %s %% of whose events were "
            + "corrected, dropped or malformed", recording.getFileName(), percent(share));
    }

    /** The share in percent, rounded, but never down to the limit that it exceeds. */
    private String percent(double share) {
        double percent = 100 * share;
        double rounded = Math.round(10 * percent) / 10.0;
        return rounded > 100 * doubtfulShare ? String.format(Locale.ROOT, "%.1f", rounded) : String.valueOf(percent);
    }

    /** Says so before a pipe is opened: opening waits until someone opens the other end, which may be never. */
    static void sayIfWaiting(Path recording, PrintWriter err) {
        try {
            if (Files.readAttributes(recording, BasicFileAttributes.class).isOther()) {
                err.println(Printable.of("[" + recording.getFileName() + "] is no file but a pipe or a device: waiting "
                    + "for what is written to it"));
                err.flush();
            }
        } catch (IOException e) {
            // opening the recording will report this
            return;
        }
    }

    /** The options for reading, which {@link #check} has checked. */
    RecordingOptions recordingOptions() {
        RecordingOptions options = RecordingOptions.defaults().withChip(chip).withStrict(strict)
            .withForceChip(forceChip);
        options = columns == null ? options : options.withColumns(columns);
        return timeUnit == null ? options : options.withTimeUnit(TextTimeUnit.named(timeUnit).orElseThrow());
    }
}
