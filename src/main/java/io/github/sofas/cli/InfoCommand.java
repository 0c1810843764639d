package io.github.sofas.cli;

import com.fasterxml.jackson.core.JsonGenerator;
import io.github.sofas.event.EventBatch;
import io.github.sofas.event.EventSourceException;
import io.github.sofas.event.SensorSize;
import io.github.sofas.export.Json;
import io.github.sofas.export.RecordingSummary;
import io.github.sofas.recording.Printable;
import io.github.sofas.recording.RecordingOptions;
import io.github.sofas.recording.RecordingReader;
import io.github.sofas.recording.Recordings;
import io.github.sofas.recording.SensorNotNamedException;
import java.io.ByteArrayOutputStream;
import java.io.IOException;
import java.io.PrintWriter;
import java.nio.charset.StandardCharsets;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.List;
import java.util.Locale;
import java.util.Map;
import java.util.concurrent.Callable;
import picocli.CommandLine.Command;
import picocli.CommandLine.Mixin;
import picocli.CommandLine.Model.CommandSpec;
import picocli.CommandLine.Option;
import picocli.CommandLine.ParameterException;
import picocli.CommandLine.Parameters;
import picocli.CommandLine.Spec;

/** Reads recordings to their end and shows their format, sensor, counts, times and faults. */
@Command(name = "info", sortOptions = false,
    description = "Show the contents of recordings: format, sensor, events by type, times, faults.",
    exitCodeListHeading = "%nExit codes:%n",
    exitCodeList = {"0:every recording was read to its end", "1:a recording is damaged, doubtful or cannot be read",
        "2:wrong usage"})
final class InfoCommand implements Callable<Integer> {
    private static final int BATCH = 4096;

    @Spec
    private CommandSpec spec;

    @Parameters(paramLabel = "RECORDING", arity = "1..*",
        description = "Recordings, directories of recordings, or quoted patterns such as 'day*/*.aedat4'.")
    private List<String> arguments;

    @Option(names = "--json", description = "Write a JSON array with one object per recording.")
    private boolean asJson;

    @Mixin
    private ReadingOptions reading;

    /** Writes the summary of a recording. */
    @FunctionalInterface
    private interface Output {
        void write(RecordingSummary recording) throws IOException;
    }

    @Override
    public Integer call() throws IOException {
        reading.check();
        List<Path> recordings;
        try {
            recordings = RecordingArguments.expand(arguments);
        } catch (IllegalArgumentException e) {
            throw new ParameterException(spec.commandLine(), e.getMessage(), e);
        }
        PrintWriter out = spec.commandLine().getOut();
        if (!asJson) {
            return readAll(recordings, recording -> print(recording, out));
        }
        ByteArrayOutputStream bytes = new ByteArrayOutputStream();
        int exitCode;
        try (JsonGenerator json = Json.open(bytes)) {
            json.writeStartArray();
            exitCode = readAll(recordings, recording -> recording.write(json));
            json.writeEndArray();
        }
        out.print(bytes.toString(StandardCharsets.UTF_8));
        return exitCode;
    }

    private int readAll(List<Path> recordings, Output output) throws IOException {
        int exitCode = Main.OK;
        List<String> doubts = new ArrayList<>();
        for (Path recording : recordings) {
            try {
                RecordingSummary summary = read(recording);
                output.write(summary);
                String doubt = reading.doubt(recording, summary.doubtfulShare());
                if (doubt != null) {
                    doubts.add(doubt);
                }
                if (!summary.complete()) {
                    exitCode = Main.FAILED;
                }
            } catch (EventSourceException e) {
                spec.commandLine().getErr().println(e.getMessage());
                exitCode = Main.FAILED;
            }
        }
        doubts.forEach(spec.commandLine().getErr()::println);
        return doubts.isEmpty() ? exitCode : Main.FAILED;
    }

    private RecordingSummary read(Path recording) throws EventSourceException {
        RecordingOptions options = reading.recordingOptions();
        try {
            return read(recording, options, List.of());
        } catch (SensorNotNamedException e) {
            if (!e.takesSize()) {
                throw e;
            }
            SensorSize guess = Recordings.smallestSensor(recording, options);
            return read(recording, options.withChip(guess.toString()), List.of("[" + recording.getFileName()
                + "] nothing names the sensor; " + guess + " is a guess, the smallest usual one that holds all "
                + "events"));
        }
    }

    private RecordingSummary read(Path recording, RecordingOptions options, List<String> notes)
            throws EventSourceException {
        ReadingOptions.sayIfWaiting(recording, spec.commandLine().getErr());
        try (RecordingReader reader = Recordings.open(recording, options)) {
            EventBatch batch = new EventBatch(BATCH);
            EventSourceException damage = null;
            try {
                while (reader.next(batch)) {
                    // The reader counts the events.
                    batch.clear();
                }
            } catch (EventSourceException e) {
                damage = e;
            }
            return Summaries.of(recording.toString(), reader, damage, notes);
        }
    }

    private static void print(RecordingSummary recording, PrintWriter out) {
        out.println(Printable.of(recording.file()));
        line(out, "format", recording.format());
        line(out, "chip", recording.chip().isEmpty() ? "not named" : recording.chip());
        line(out, "sensor", recording.sensor() + " px");
        line(out, "duration", String.format(Locale.ROOT, "%.6f s", recording.durationS()));
        line(out, "first event", recording.firstTimeUs() + " us");
        line(out, "last event", recording.lastTimeUs() + " us");
        line(out, "event rate", String.format(Locale.ROOT, "%.0f events/s", recording.eventsPerS()));
        for (Map.Entry<String, Long> count : recording.counts().entrySet()) {
            line(out, count.getKey().replace('_', ' '), count.getValue().toString());
        }
        if (recording.faults().isEmpty()) {
            line(out, "faults", "none");
        }
        for (String fault : recording.faults()) {
            line(out, "fault", fault);
        }
        for (String note : recording.notes()) {
            line(out, "note", note);
        }
    }

    private static void line(PrintWriter out, String name, String value) {
        out.println(String.format(Locale.ROOT, "  %-20s %s", name + ":", value));
    }
}
