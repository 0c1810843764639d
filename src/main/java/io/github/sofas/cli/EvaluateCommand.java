package io.github.sofas.cli;

import io.github.sofas.evaluate.EvaluationOptions;
import io.github.sofas.evaluate.EvaluationReport;
import io.github.sofas.evaluate.EvaluationRun;
import io.github.sofas.evaluate.SharpnessReport;
import io.github.sofas.evaluate.SharpnessRun;
import io.github.sofas.evaluate.TruthCsvReader;
import io.github.sofas.evaluate.TruthException;
import io.github.sofas.event.EventSourceException;
import io.github.sofas.export.ResultFiles;
import io.github.sofas.flow.Labelling;
import io.github.sofas.recording.RecordingReader;
import io.github.sofas.recording.Recordings;
import java.io.IOException;
import java.io.OutputStream;
import java.io.PrintWriter;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.Arrays;
import java.util.List;
import java.util.Map;
import java.util.concurrent.Callable;
import picocli.CommandLine.Command;
import picocli.CommandLine.Mixin;
import picocli.CommandLine.Model.CommandSpec;
import picocli.CommandLine.Option;
import picocli.CommandLine.ParameterException;
import picocli.CommandLine.Parameters;
import picocli.CommandLine.Spec;

/**
 * Compares a method's flow and segments, or those in a file, with the truth of each event. Without a truth, measures
 * how much sharper the flow makes the picture.
 */
@Command(name = "evaluate", sortOptions = false,
    customSynopsis = "sofas evaluate [OPTION]... [--truth FILE] RECORDING",
    description = {"Compare flow and segments of a recording with the truth of each event.",
        "The truth is a CSV file with the columns " + TruthCsvReader.HEADER + " in any order, a line for each event "
        + "whose truth is known; object 0 is noise. The figures are printed; --json and --csv write them to files.",
        "Without a truth, measure how much sharper the flow makes the picture: variance of the events moved along "
        + "their flow over variance of the events as they are, compared with the best single translation of each "
        + "window. A gain of 1 is as good as that translation; below 0 the flow blurs the picture."},
    exitCodeListHeading = "%nExit codes:%n",
    exitCodeList = {"0:evaluated", "1:the recording is damaged, or it or its truth cannot be used", "2:wrong usage"})
final class EvaluateCommand implements Callable<Integer> {
    @Spec
    private CommandSpec spec;

    @Parameters(paramLabel = "RECORDING", description = "A recording.")
    private String argument;

    @Option(names = "--truth", paramLabel = "FILE",
        description = "CSV file with the truth of its events; without it, sharpness is measured.")
    private Path truth;

    @Option(names = "--results", paramLabel = "FILE",
        description = "Evaluate flow and segments that exist, a NAME.flow.csv of this or another program, instead of "
            + "labelling the events.")
    private Path results;

    @Option(names = "--skip-first-share", paramLabel = "SHARE",
        description = "With --truth: share of the recording's time that is left out at its beginning, 0 to below 1; "
        + "default: " + EvaluationOptions.DEFAULT_SKIP_FIRST_SHARE + ".")
    private Double skipFirstShare;

    @Option(names = "--json", paramLabel = "FILE", description = "Write the figures as JSON.")
    private Path json;

    @Option(names = "--csv", paramLabel = "FILE",
        description = "Write the figures as CSV: " + EvaluationReport.CSV_HEADER + ".")
    private Path csv;

    @Option(names = {"-f", "--force"}, description = "Replace existing results; otherwise they are an error.")
    private boolean force;

    @Mixin
    private ReadingOptions reading;

    @Mixin
    private LookAheadOptions lookAhead;

    @Mixin
    private MethodOptions methodOptions;

    @Mixin
    private ParameterOptions parameterOptions;

    @Override
    public Integer call() {
        PrintWriter err = spec.commandLine().getErr();
        if (results != null) {
            methodOptions.refuseLabelling("--results");
        }
        MethodChoice asked = lookAhead.ofRecording(methodOptions.choice(parameterOptions),
            parameterOptions.parameters());
        EvaluationOptions options = options();
        Path recording = recording();
        checkFiles(recording);
        try (RecordingReader reader = Recordings.open(recording, reading.recordingOptions());
                ResultLabels labels = results == null ? null : ResultLabels.open(results)) {
            MethodChoice method = labels == null ? asked
                : new MethodChoice(results.toString(), "", Map.of(), (sensor, ended) -> labels);
            EventSourceException damage = truth == null ? measure(recording, reader, method)
                : holdAgainstTruth(recording, reader, method, options);
            reader.notes().forEach(err::println);
            reader.faults().forEach(err::println);
            if (damage != null) {
                err.println(damage.getMessage());
            }
            String doubt = reading.doubt(recording, reader.counts().doubtfulShare());
            if (doubt != null) {
                err.println(doubt);
            }
            return damage == null && doubt == null ? Main.OK : Main.FAILED;
        } catch (EventSourceException | TruthException | ResultLabels.MismatchException e) {
            err.println(e.getMessage());
        } catch (IOException e) {
            err.println("[" + truth + "] truth cannot be read: " + FileFailure.text(e));
        }
        return Main.FAILED;
    }

    private EventSourceException holdAgainstTruth(Path recording, RecordingReader reader, MethodChoice method,
                                                  EvaluationOptions options) throws TruthException, IOException {
        try (TruthCsvReader truthReader = TruthCsvReader.open(truth)) {
            EvaluationRun run;
            try (RunProgress progress = progress(recording); OpenLabelling open = method.open(reader.sensor())) {
                run = EvaluationRun.of(reader, truthReader, watched(open, reader, progress), options);
            }
            EvaluationReport report = new EvaluationReport(Version.text(), recording.toString(), truth.toString(),
                method.method(), method.preset(), method.parameters(), run);
            write(report::writeJson, report::writeCsv);
            spec.commandLine().getOut().print(report.text());
            return run.damage();
        }
    }

    private EventSourceException measure(Path recording, RecordingReader reader, MethodChoice method) {
        SharpnessRun run;
        try (RunProgress progress = progress(recording); OpenLabelling open = method.open(reader.sensor())) {
            run = SharpnessRun.of(reader, watched(open, reader, progress));
        }
        SharpnessReport report = new SharpnessReport(Version.text(), recording.toString(), method.method(),
            method.preset(), method.parameters(), run);
        write(report::writeJson, report::writeCsv);
        spec.commandLine().getOut().print(report.text());
        return run.damage();
    }

    private RunProgress progress(Path recording) {
        return RunProgress.start(spec.commandLine().getErr(), false, recording.toFile().length());
    }

    private static Labelling watched(OpenLabelling open, RecordingReader reader, RunProgress progress) {
        return new WatchedLabelling(open.labelling(), () -> progress.reached(reader.bytesRead()));
    }

    private EvaluationOptions options() {
        if (skipFirstShare == null) {
            return EvaluationOptions.defaults();
        }
        if (truth == null) {
            throw usage("--skip-first-share needs --truth: sharpness counts the whole recording");
        }
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

    private void checkFiles(Path recording) {
        reading.check();
        for (Path file : Arrays.asList(truth, results)) {
            if (file != null && !Files.exists(file)) {
                throw usage("[" + file + "] no such file");
            }
        }
        OutputFiles outputs = new OutputFiles(spec.commandLine());
        List<Path> files = Arrays.asList(json, csv);
        outputs.check(Arrays.asList(recording, truth, results, parameterOptions.config()), files);
        outputs.checkPlaces(files);
        if (!force) {
            outputs.refuseExisting(files);
        }
    }

    private ParameterException usage(String message) {
        return new ParameterException(spec.commandLine(), message);
    }

    /** Writes the figures in one format. */
    private interface Form {
        void writeTo(OutputStream out) throws IOException;
    }

    private void write(Form asJson, Form asCsv) {
        try (ResultFiles results = new ResultFiles(force)) {
            if (json != null) {
                try (OutputStream file = results.create(json)) {
                    asJson.writeTo(file);
                }
            }
            if (csv != null) {
                try (OutputStream file = results.create(csv)) {
                    asCsv.writeTo(file);
                }
            }
            results.commit();
        } catch (IOException e) {
            throw new FailureException("figures cannot be written: " + FileFailure.text(e), e);
        }
    }
}
