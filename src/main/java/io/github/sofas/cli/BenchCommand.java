package io.github.sofas.cli;

import io.github.sofas.benchmark.Benchmark;
import io.github.sofas.benchmark.BenchmarkOptions;
import io.github.sofas.benchmark.BenchmarkReport;
import io.github.sofas.benchmark.BuiltInScenes;
import io.github.sofas.benchmark.Machine;
import io.github.sofas.benchmark.RecordingFigures;
import io.github.sofas.benchmark.RecordingUnderTest;
import io.github.sofas.event.EventSourceException;
import java.io.ByteArrayOutputStream;
import java.io.IOException;
import java.io.OutputStream;
import java.io.PrintWriter;
import java.nio.charset.StandardCharsets;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.Collections;
import java.util.Comparator;
import java.util.List;
import java.util.concurrent.Callable;
import java.util.stream.Stream;
import picocli.CommandLine.Command;
import picocli.CommandLine.Mixin;
import picocli.CommandLine.Model.CommandSpec;
import picocli.CommandLine.Option;
import picocli.CommandLine.ParameterException;
import picocli.CommandLine.Parameters;
import picocli.CommandLine.Spec;

/**
 * Measures how fast recordings are decoded, labelled and written. Without a recording, simulated scenes are measured.
 */
@Command(name = "bench", sortOptions = false,
    customSynopsis = "sofas bench [OPTION]... [RECORDING]...",
    description = {"Measure the speed of decoding, labelling and writing in one thread, and of labelling",
        "with a helper.",
        "Without a recording, simulated scenes are measured; they are the same on every machine."},
    exitCodeListHeading = "%nExit codes:%n",
    exitCodeList = {"0:everything was measured", "1:a recording failed; the others were measured", "2:wrong usage"})
final class BenchCommand implements Callable<Integer> {
    @Spec
    private CommandSpec spec;

    @Parameters(paramLabel = "RECORDING", arity = "0..*",
        description = "Recordings, directories of recordings, or quoted patterns such as 'day*/*.aedat4'.")
    private List<String> arguments = List.of();

    @Option(names = "--json", description = "Write one JSON object: the machine and an array of recordings.")
    private boolean asJson;

    @Option(names = "--runs", paramLabel = "N", defaultValue = "5",
        description = "Counted runs of each part, at least 5; default: ${DEFAULT-VALUE}.")
    private int runs;

    @Option(names = "--warm-up", paramLabel = "N", defaultValue = "3",
        description = "Warm-up runs of each part, at least 1; default: ${DEFAULT-VALUE}.")
    private int warmUps;

    @Option(names = "--warm-up-ms", paramLabel = "MS", defaultValue = "1000",
        description = "Least duration of the warm-up of each part; default: ${DEFAULT-VALUE}.")
    private int warmUpMs;

    @Option(names = "--events", paramLabel = "N", defaultValue = "10000000",
        description = "Use at most the first N events of a recording; they are held in memory, 30 bytes each; "
        + "default: ${DEFAULT-VALUE}.")
    private int mostEvents;

    @Option(names = "--sample-ms", paramLabel = "MS", defaultValue = "3000",
        description = "Duration of the sampling that gives each stage's share of the time; default: ${DEFAULT-VALUE}.")
    private int sampledMs;

    @Option(names = "--plot", paramLabel = "FILE",
        description = "Draw the cost per event over the density, a point for each recording, as PNG.")
    private Path plot;

    @Mixin
    private ReadingOptions reading;

    @Mixin
    private ParameterOptions parameterOptions;

    /** Provides a recording, which may have to be simulated first, in the given folder. */
    @FunctionalInterface
    private interface Making {
        RecordingUnderTest in(Path folder) throws IOException;
    }

    @Override
    public Integer call() throws IOException {
        reading.check();
        BenchmarkOptions options;
        List<Making> all = new ArrayList<>();
        try {
            options = new BenchmarkOptions(parameterOptions.parameters(), runs, warmUps, warmUpMs, mostEvents,
                sampledMs);
            for (Path file : RecordingArguments.expand(arguments)) {
                all.add(folder -> new RecordingUnderTest(file.toString(), file, reading.recordingOptions()));
            }
        } catch (IllegalArgumentException e) {
            throw new ParameterException(spec.commandLine(), inUsersWords(e.getMessage()), e);
        }
        if (arguments.isEmpty()) {
            for (String name : BuiltInScenes.names()) {
                all.add(folder -> BuiltInScenes.film(name, folder));
            }
        }
        OutputFiles outputs = new OutputFiles(spec.commandLine());
        outputs.check(arguments.stream().map(Path::of).toList(), Collections.singletonList(plot));
        outputs.checkPlaces(Collections.singletonList(plot));
        PrintWriter out = spec.commandLine().getOut();
        Machine machine = Machine.here();
        if (!asJson) {
            out.print(BenchmarkReport.text(machine));
            out.flush();
        }
        List<RecordingFigures> measured = new ArrayList<>();
        for (Making each : all) {
            measure(each, options, measured);
        }
        BenchmarkReport report = new BenchmarkReport(machine, measured);
        if (plot != null) {
            try (OutputStream file = Files.newOutputStream(plot)) {
                report.plot(file);
            } catch (IOException e) {
                throw new FailureException("[" + plot + "] cannot be written: " + FileFailure.text(e), e);
            }
        }
        if (asJson) {
            ByteArrayOutputStream bytes = new ByteArrayOutputStream();
            report.write(bytes);
            out.print(bytes.toString(StandardCharsets.UTF_8));
        }
        return measured.size() == all.size() ? Main.OK : Main.FAILED;
    }

    /** Replaces the record's component, with which the message begins, by the option that the user wrote. */
    private static String inUsersWords(String message) {
        return message.replaceFirst("^runs ", "--runs ").replaceFirst("^warmUps ", "--warm-up ")
            .replaceFirst("^warmUpMs ", "--warm-up-ms ")
            .replaceFirst("^mostEvents ", "--events ").replaceFirst("^sampledMs ", "--sample-ms ");
    }

    private void measure(Making making, BenchmarkOptions options, List<RecordingFigures> measured)
            throws IOException {
        Path folder = Files.createTempDirectory("sofas-bench");
        try {
            RecordingFigures figures = Benchmark.measure(making.in(folder), options, folder);
            measured.add(figures);
            if (!asJson) {
                spec.commandLine().getOut().print("\n" + BenchmarkReport.text(figures));
                spec.commandLine().getOut().flush();
            }
        } catch (EventSourceException e) {
            spec.commandLine().getErr().println(e.getMessage());
        } finally {
            delete(folder);
        }
    }

    private static void delete(Path folder) throws IOException {
        try (Stream<Path> files = Files.walk(folder)) {
            for (Path file : files.sorted(Comparator.reverseOrder()).toList()) {
                Files.delete(file);
            }
        }
    }
}
