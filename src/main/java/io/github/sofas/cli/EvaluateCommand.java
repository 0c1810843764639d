package io.github.sofas.cli;

import io.github.sofas.evaluate.EvaluationOptions;
import io.github.sofas.evaluate.EvaluationReport;
import io.github.sofas.evaluate.EvaluationRun;
import io.github.sofas.evaluate.TruthCsvReader;
import io.github.sofas.evaluate.TruthException;
import io.github.sofas.event.EventSourceException;
import io.github.sofas.export.ResultFiles;
import io.github.sofas.recording.RecordingReader;
import io.github.sofas.recording.Recordings;
import java.io.IOException;
import java.io.OutputStream;
import java.io.PrintWriter;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.List;
import java.util.Objects;
import java.util.concurrent.Callable;
import java.util.stream.Stream;
import picocli.CommandLine.Command;
import picocli.CommandLine.Mixin;
import picocli.CommandLine.Model.CommandSpec;
import picocli.CommandLine.Option;
import picocli.CommandLine.ParameterException;
import picocli.CommandLine.Parameters;
import picocli.CommandLine.Spec;

/** Holds a method's flow and segments against the truth of every event. */
@Command(name = "evaluate", sortOptions = false,
    customSynopsis = "sofas evaluate [OPTION]... --truth FILE RECORDING",
    description = {"Say how right flow and segments of a recording are, against the truth of every event.",
        "The truth is a CSV file with the columns " + TruthCsvReader.HEADER + ", one line for each event of the "
        + "recording; object 0 is noise. Figures are printed; --json and --csv write them for programs."},
    exitCodeListHeading = "%nExit codes:%n",
    exitCodeList = {"0:evaluated", "1:the recording is damaged, or it or its truth cannot be used", "2:wrong usage"})
final class EvaluateCommand implements Callable<Integer> {
    @Spec
    private CommandSpec spec;

    @Parameters(paramLabel = "RECORDING", description = "A recording.")
    private String argument;

    @Option(names = "--truth", paramLabel = "FILE", required = true, description = "Truth of its events.")
    private Path truth;

    @Option(names = "--skip-first-share", paramLabel = "SHARE", defaultValue = "0.15",
        description = "Share of the recording's time, at its beginning, that does not count; 0 to below 1; default: "
            + "${DEFAULT-VALUE}.")
    private double skipFirstShare;

    @Option(names = "--json", paramLabel = "FILE", description = "Write the figures as JSON.")
    private Path json;

    @Option(names = "--csv", paramLabel = "FILE",
        description = "Write the figures as CSV: " + EvaluationReport.CSV_HEADER + ".")
    private Path csv;

    @Option(names = {"-f", "--force"}, description = "Replace results that exist; without it they are an error.")
    private boolean force;

    @Mixin
    private ReadingOptions reading;

    @Mixin
    private MethodOptions methodOptions;

    @Mixin
    private ParameterOptions parameterOptions;

    @Override
    public Integer call() {
        PrintWriter err = spec.commandLine().getErr();
        MethodChoice method = methodOptions.choice(parameterOptions);
        EvaluationOptions options = options();
        Path recording = recording();
        checkFiles();
        try (RecordingReader reader = Recordings.open(recording, reading.recordingOptions());
             TruthCsvReader truthReader = TruthCsvReader.open(truth)) {
            EvaluationRun run = EvaluationRun.of(reader, truthReader, method.make(reader.sensor(), ended -> { }),
                options);
            EvaluationReport report = new EvaluationReport(Version.text(), recording.toString(), truth.toString(),
                method.method(), method.preset(), method.parameters(), run);
            write(report);
            spec.commandLine().getOut().print(report.text());
            reader.faults().forEach(err::println);
            if (run.damage() != null) {
                err.println(run.damage().getMessage());
                return Main.FAILED;
            }
            return Main.OK;
        } catch (EventSourceException | TruthException e) {
            err.println(e.getMessage());
        } catch (IOException e) {
            err.println("[" + truth.getFileName() + "] truth cannot be read or results cannot be written: " + e);
        }
        return Main.FAILED;
    }

    private EvaluationOptions options() {
        try {
            return EvaluationOptions.defaults().withSkipFirstShare(skipFirstShare);
        } catch (IllegalArgumentException e) {
            throw usage("--skip-first-share must be at least 0 and below 1 but was " + skipFirstShare);
        }
    }

    private Path recording() {
        try {
            List<Path> recordings = RecordingArguments.expand(List.of(argument));
            if (recordings.size() == 1) {
                return recordings.get(0);
            }
            throw usage("evaluate takes one recording but " + argument + " means " + recordings.size());
        } catch (IllegalArgumentException e) {
            throw usage(e.getMessage());
        }
    }

    private void checkFiles() {
        if (!Files.exists(truth)) {
            throw usage("[" + truth + "] no such file");
        }
        if (!force) {
            Stream.of(json, csv).filter(Objects::nonNull).filter(Files::exists).forEach(existing -> {
                throw usage("[" + existing + "] exists already; --force replaces it");
            });
        }
    }

    private ParameterException usage(String message) {
        return new ParameterException(spec.commandLine(), message);
    }

    private void write(EvaluationReport report) throws IOException {
        try (ResultFiles results = new ResultFiles()) {
            if (json != null) {
                try (OutputStream file = results.create(json)) {
                    report.writeJson(file);
                }
            }
            if (csv != null) {
                try (OutputStream file = results.create(csv)) {
                    report.writeCsv(file);
                }
            }
            results.commit();
        }
    }
}
