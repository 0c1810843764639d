package io.github.sofas.cli;

import io.github.sofas.event.EventBatch;
import io.github.sofas.event.EventSourceException;
import io.github.sofas.event.SensorSize;
import io.github.sofas.export.EventTable;
import io.github.sofas.export.ResultFiles;
import io.github.sofas.export.TableFormat;
import io.github.sofas.recording.Aedat2Writer;
import io.github.sofas.recording.Chip;
import io.github.sofas.recording.RecordingReader;
import io.github.sofas.recording.Recordings;
import java.io.IOException;
import java.io.PrintWriter;
import java.nio.file.Path;
import java.util.Comparator;
import java.util.List;
import java.util.Locale;
import java.util.Map;
import java.util.Optional;
import java.util.TreeMap;
import java.util.concurrent.Callable;
import picocli.CommandLine.Command;
import picocli.CommandLine.Mixin;
import picocli.CommandLine.Model.CommandSpec;
import picocli.CommandLine.Option;
import picocli.CommandLine.ParameterException;
import picocli.CommandLine.Parameters;
import picocli.CommandLine.Spec;

/** Writes the events of recordings in another format: as AEDAT 2.0, or as a table in CSV, NPZ or Parquet. */
@Command(name = "convert", sortOptions = false,
    customSynopsis = "sofas convert [OPTION]... --to FORMAT RECORDING...",
    description = {"Write the change events of recordings in another format.",
        "Writes NAME.aedat, NAME.csv, NAME.npz or NAME.parquet; NAME is the recording's file name without the last "
        + "extension. Tables have the columns t_us, x, y, polarity (1 or -1), x to the right, y down. Frames, IMU "
        + "samples and triggers are left out."},
    exitCodeListHeading = "%nExit codes:%n",
    exitCodeList = {"0:every recording was converted to its end", "1:a recording failed or is doubtful",
        "2:wrong usage; nothing was converted"})
final class ConvertCommand implements Callable<Integer> {
    private static final int BATCH = 4096;
    private static final String AEDAT2 = "aedat2";

    @Spec
    private CommandSpec spec;

    @Parameters(paramLabel = "RECORDING", arity = "1..*",
        description = "Recordings, directories of recordings, or quoted patterns such as 'day*/*.raw'.")
    private List<String> arguments;

    @Option(names = "--to", paramLabel = "FORMAT", required = true,
        description = "aedat2 (for jAER), csv, npz or parquet.")
    private String to;

    @Option(names = {"-o", "--out"}, paramLabel = "DIR", defaultValue = ".",
        description = "Output folder; created if it does not exist; default: this one.")
    private Path out;

    @Option(names = {"-f", "--force"}, description = "Replace existing files; otherwise they are an error.")
    private boolean force;

    @Option(names = "--name-with-extension",
        description = "Keep the extension in NAME, for recordings that differ in nothing else.")
    private boolean nameWithExtension;

    @Mixin
    private ReadingOptions reading;

    /** Takes the events of a recording. */
    @FunctionalInterface
    private interface Sink {
        void write(EventBatch batch) throws IOException;
    }

    @Override
    public Integer call() {
        Optional<TableFormat> table = TableFormat.named(to);
        if (table.isEmpty() && !to.equalsIgnoreCase(AEDAT2)) {
            throw usage("--to must be aedat2, csv, npz or parquet but was " + to);
        }
        reading.check();
        Map<String, Path> named;
        try {
            named = RecordingArguments.byName(RecordingArguments.expand(arguments), nameWithExtension);
        } catch (IllegalArgumentException e) {
            throw usage(e.getMessage());
        }
        String extension = table.map(TableFormat::extension).orElse("aedat");
        List<Path> files = named.keySet().stream().map(name -> out.resolve(name + "." + extension)).toList();
        OutputFiles outputs = new OutputFiles(spec.commandLine());
        outputs.check(List.copyOf(named.values()), files);
        if (!force) {
            outputs.refuseExisting(files);
        }
        outputs.makeFolder(out);
        int exitCode = Main.OK;
        int next = 0;
        for (Path recording : named.values()) {
            if (!converts(recording, files.get(next++), table)) {
                exitCode = Main.FAILED;
            }
        }
        return exitCode;
    }

    private boolean converts(Path recording, Path file, Optional<TableFormat> table) {
        PrintWriter err = spec.commandLine().getErr();
        try (RecordingReader reader = Recordings.open(recording, reading.recordingOptions());
                ResultFiles results = new ResultFiles(force)) {
            EventSourceException damage = table.isEmpty() ? toAedat2(recording, reader, results, file)
                : toTable(recording, reader, results, file, table.get());
            results.commit();
            reader.notes().forEach(err::println);
            reader.faults().forEach(err::println);
            String doubt = reading.doubt(recording, reader.counts().doubtfulShare());
            if (damage != null || doubt != null) {
                err.println(damage == null ? doubt : damage.getMessage());
            }
            err.println(String.format(Locale.ROOT, "%s: %d events", file.getFileName(), reader.counts().events()));
            return damage == null && doubt == null;
        } catch (EventSourceException e) {
            err.println(e.getMessage());
        } catch (IOException e) {
            err.println("[" + file.getFileName() + "] cannot be written: " + FileFailure.text(e));
        }
        return false;
    }

    private EventSourceException toAedat2(Path recording, RecordingReader reader, ResultFiles results, Path file)
            throws EventSourceException, IOException {
        Chip chip = chip(recording, reader);
        try (Aedat2Writer writer = new Aedat2Writer(results.create(file), chip)) {
            return copy(reader, writer::write);
        }
    }

    private static EventSourceException toTable(Path recording, RecordingReader reader, ResultFiles results, Path file,
                                                TableFormat format) throws IOException {
        Map<String, String> metadata = new TreeMap<>(Map.of("sofas_version", Version.text(), "recording",
            recording.getFileName().toString(), "sensor", reader.sensor().toString()));
        try (EventTable events = EventTable.open(format, results, file, metadata)) {
            return copy(reader, events::write);
        }
    }

    /** Copies all events, and returns the damage that ended the recording; null if there was none. */
    private static EventSourceException copy(RecordingReader reader, Sink sink) throws IOException {
        EventBatch batch = new EventBatch(BATCH);
        try {
            while (reader.next(batch)) {
                sink.write(batch);
            }
            return null;
        } catch (EventSourceException e) {
            return e;
        }
    }

    /**
     * The recording's own chip, else the smallest one that holds its sensor. AEDAT 2.0 needs a chip for its addresses.
     */
    private Chip chip(Path recording, RecordingReader reader) throws EventSourceException {
        Optional<Chip> own = reader.chip().flatMap(Chip::named);
        if (own.isPresent() && own.get().sensor().equals(reader.sensor())) {
            return own.get();
        }
        SensorSize sensor = reader.sensor();
        Chip chip = Chip.known().stream()
            .filter(each -> each.sensor().contains(sensor.width() - 1, sensor.height() - 1))
            .min(Comparator.comparingInt(each -> each.sensor().width() * each.sensor().height()))
            .orElseThrow(() -> new EventSourceException("[" + recording.getFileName() + "] unsupported, AEDAT 2.0 has "
                + "no chip of " + sensor + "; --to csv, npz or parquet take any"));
        if (!chip.sensor().equals(sensor)) {
            spec.commandLine().getErr().println("[" + recording.getFileName() + "] AEDAT 2.0 has no chip of " + sensor
                + "; written as of a " + chip.name() + ", " + chip.sensor() + ", at its upper left");
        }
        return chip;
    }

    private ParameterException usage(String message) {
        return new ParameterException(spec.commandLine(), message);
    }
}
