package io.github.sofas.cli;

import io.github.sofas.export.TableFormat;
import io.github.sofas.recording.Printable;
import io.github.sofas.recording.RecordingOptions;
import java.io.IOException;
import java.io.PrintWriter;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.List;
import java.util.Map;
import java.util.concurrent.Callable;
import java.util.concurrent.ConcurrentSkipListMap;
import java.util.concurrent.ExecutionException;
import java.util.concurrent.ExecutorService;
import java.util.concurrent.Executors;
import java.util.concurrent.Future;
import java.util.stream.Collectors;
import picocli.CommandLine;
import picocli.CommandLine.Command;
import picocli.CommandLine.Mixin;
import picocli.CommandLine.Model.CommandSpec;
import picocli.CommandLine.Option;
import picocli.CommandLine.ParameterException;
import picocli.CommandLine.Parameters;
import picocli.CommandLine.ParentCommand;
import picocli.CommandLine.Spec;

/**
 * Labels every event of recordings with flow and segment. This class checks the arguments and starts the runs, several
 * at a time if asked to. {@link RecordingRun} does the work.
 */
@Command(name = "run", sortOptions = false,
    customSynopsis = "sofas run [OPTION]... --out DIR RECORDING...",
    description = {"Label each event of recordings with flow and segment.",
        "Writes NAME.flow.csv, NAME.tracks.csv, NAME.segments.csv and NAME.summary.json per recording; NAME is its "
        + "file name without the last extension."},
    exitCodeListHeading = "%nExit codes:%n",
    exitCodeList = {"0:every recording was read to its end", "1:a recording failed or is doubtful; the others were run",
        "2:wrong usage; nothing was run"})
final class RunCommand implements Callable<Integer> {
    @Spec
    private CommandSpec spec;

    @ParentCommand
    private SofasCommand sofas;

    @Parameters(paramLabel = "RECORDING", arity = "1..*",
        description = "Recordings, directories of recordings, or quoted patterns such as 'day*/*.aedat4'.")
    private List<String> arguments;

    @Option(names = {"-o", "--out"}, paramLabel = "DIR", required = true,
        description = "Output folder; created if it does not exist.")
    private Path out;

    @Mixin
    private ResultOptions results;

    @Option(names = "--report",
        description = "Also write NAME.report.html, a self-contained page with curves, pictures and a clip.")
    private boolean report;

    @Option(names = {"-j", "--jobs"}, paramLabel = "N", defaultValue = "1",
        description = "Number of recordings at a time; default: ${DEFAULT-VALUE}.")
    private int jobs;

    @Option(names = "--threads", paramLabel = "N", defaultValue = "2",
        description = "Threads per recording: 1, 2 (write, look ahead and help the search, while labelling) or 3 "
        + "(read, too); default: ${DEFAULT-VALUE}. Results do not depend on it.")
    private int threads;

    @Mixin
    private ReadingOptions reading;

    @Option(names = {"-q", "--quiet"}, description = "Print only errors and warnings, no progress and no summaries.")
    private boolean quiet;

    @Mixin
    private LookAheadOptions lookAhead;

    @Mixin
    private MethodOptions methodOptions;

    @Mixin
    private ParameterOptions parameterOptions;

    /** Recordings with doubtful results, and the reasons. */
    private final Map<Path, String> doubts = new ConcurrentSkipListMap<>();

    /** A run that was started, and whether it will succeed. */
    private record Started(RecordingRun run, Future<Boolean> succeeds) {
    }

    @Override
    public Integer call() throws InterruptedException {
        List<RecordingRun> runs = check();
        if (runs.isEmpty()) {
            sayDoubts();
            return doubts.isEmpty() ? Main.OK : Main.FAILED;
        }
        PrintWriter err = spec.commandLine().getErr();
        List<String> failed = new ArrayList<>();
        ExecutorService pool = Executors.newFixedThreadPool(Math.min(jobs, runs.size()));
        try (RunProgress progress = RunProgress.start(err, quiet, bytes(runs))) {
            List<Started> started = new ArrayList<>();
            for (RecordingRun run : runs) {
                started.add(new Started(run, pool.submit(() -> succeeds(run, progress))));
            }
            for (Started each : started) {
                if (!succeeded(each, progress)) {
                    failed.add(each.run.recording().toString());
                }
            }
        } finally {
            pool.shutdownNow();
        }
        if (!failed.isEmpty()) {
            err.println(failed.size() + " of " + runs.size() + (runs.size() == 1 ? " recording" : " recordings")
                + " failed: " + Printable.of(String.join(", ", failed)));
        }
        sayDoubts();
        return failed.isEmpty() && doubts.isEmpty() ? Main.OK : Main.FAILED;
    }

    private void addDoubt(RecordingRun run, double share) {
        String doubt = reading.doubt(run.recording(), share);
        if (doubt != null) {
            doubts.put(run.recording(), doubt);
        }
    }

    /**
     * Prints the doubts at the very end, even if all else went well, in the order of names and not in that of
     * completion.
     */
    private void sayDoubts() {
        doubts.values().forEach(doubt -> spec.commandLine().getErr().println(Printable.of(doubt)));
    }

    /**
     * Returns the command with options and a single recording, which need not exist.
     *
     * @param options without recording and output folder
     */
    static RunCommand parsed(List<String> options, Path recording, Path out) {
        List<String> arguments = new ArrayList<>(List.of("run"));
        arguments.addAll(options);
        arguments.addAll(List.of("--out", out.toString(), "--", recording.toString()));
        CommandLine line = new SofasCommand().commandLine("run");
        line.parseArgs(arguments.toArray(String[]::new));
        return line.getSubcommands().get("run").getCommand();
    }

    /** Number of threads per recording. */
    int threads() {
        return threads;
    }

    /** Checks everything that can be wrong before the first recording is opened, and returns the runs. */
    private List<RecordingRun> check() {
        if (jobs < 1) {
            throw usage("--jobs must be at least 1 but was " + jobs);
        }
        checkOptions();
        Map<String, Path> named;
        try {
            named = RecordingArguments.byName(RecordingArguments.expand(arguments), results.keepsExtension());
        } catch (IllegalArgumentException e) {
            throw usage(e.getMessage());
        }
        List<RecordingRun> runs = runs(named);
        OutputFiles outputs = new OutputFiles(spec.commandLine());
        List<Path> inputs = new ArrayList<>(named.values());
        inputs.add(parameterOptions.config());
        List<Path> files = runs.stream().flatMap(run -> run.files().stream()).toList();
        outputs.check(inputs, files);
        outputs.makeFolder(out);
        outputs.checkPlaces(files);
        if (results.resumes()) {
            return toResume(runs);
        }
        if (!results.replaces()) {
            outputs.refuseExisting(files);
        }
        return runs;
    }

    private void checkOptions() {
        if (threads < 1 || threads > BatchPipeline.MOST_THREADS) {
            throw usage("--threads must be 1 to " + BatchPipeline.MOST_THREADS + " but was " + threads);
        }
        reading.check();
        List<TableFormat> formats;
        try {
            formats = results.formats();
        } catch (IllegalArgumentException e) {
            throw usage(e.getMessage());
        }
        if (report && !formats.contains(TableFormat.CSV)) {
            throw usage("--report is drawn from the CSV, so --format must have csv too");
        }
    }

    /** Creates the runs of recordings, which are given by the names of their results. */
    List<RecordingRun> runs(Map<String, Path> named) {
        RecordingOptions options = reading.recordingOptions();
        MethodChoice method = lookAhead.ofRecording(methodOptions.choice(parameterOptions),
            parameterOptions.parameters());
        String reported = report ? typed() : null;
        List<RecordingRun> runs = new ArrayList<>();
        named.forEach((name, recording) ->
            runs.add(new RecordingRun(recording, recording.toString(), options, method, new ResultNames(out, name),
                reported, results.replaces(), results.formats())));
        return runs;
    }

    /** Returns the runs whose results are missing or outdated. Reports each recording that is skipped or run again. */
    private List<RecordingRun> toResume(List<RecordingRun> runs) {
        PrintWriter err = spec.commandLine().getErr();
        List<RecordingRun> rest = new ArrayList<>();
        for (RecordingRun run : runs) {
            String outdated = run.whyNotDone();
            if (outdated == null) {
                addDoubt(run, EarlierRun.of(run.names().summary()).doubtfulShare());
                if (!quiet) {
                    err.println(Printable.of(run.names().name() + ": results are complete, skipped"));
                }
            } else {
                if (!run.existing().isEmpty() && !quiet) {
                    err.println(Printable.of(run.names().name() + ": run again, because " + outdated));
                }
                rest.add(run.replacing());
            }
        }
        return rest;
    }

    /** The command as it was typed, quoted for a shell. */
    private String typed() {
        return spec.commandLine().getParent().getParseResult().originalArgs().stream()
            .map(each -> each.matches("[\\w./=:,+-]+") ? each : "'" + each.replace("'", "'\\''") + "'")
            .collect(Collectors.joining(" ", "./sofas ", ""));
    }

    private ParameterException usage(String message) {
        return new ParameterException(spec.commandLine(), message);
    }

    /** Total size of the recordings. One that cannot be accessed counts as 0, and fails when it is opened. */
    private static long bytes(List<RecordingRun> runs) {
        return runs.stream().mapToLong(run -> run.recording().toFile().length()).sum();
    }

    /** Runs one recording, reports what came of it, and returns whether it succeeded. */
    private boolean succeeds(RecordingRun run, RunProgress progress) throws Exception {
        ReadingOptions.sayIfWaiting(run.recording(), spec.commandLine().getErr());
        RunOutcome outcome = run.run(progress, threads);
        // The last fault is the damage, if there is one.
        outcome.summary().recording().notes().forEach(progress::say);
        outcome.summary().recording().faults().forEach(progress::say);
        addDoubt(run, outcome.summary().recording().doubtfulShare());
        progress.finished(run.names().name(), outcome.summary());
        if (outcome.reportFailure() != null) {
            sayNoReport(run, outcome.reportFailure(), progress);
        }
        return outcome.damage() == null && outcome.reportFailure() == null;
    }

    private void sayNoReport(RecordingRun run, Exception failure, RunProgress progress) {
        String place = "[" + run.recording().getFileName() + "] all results are there but the report, ";
        if (failure instanceof IOException) {
            progress.say(place + "which cannot be written: " + FileFailure.text((IOException) failure));
        } else {
            progress.clear();
            sofas.printUnexpected(spec.commandLine().getErr(), place, failure);
        }
    }

    private boolean succeeded(Started started, RunProgress progress) throws InterruptedException {
        String place = "[" + started.run.recording().getFileName() + "] ";
        try {
            return started.succeeds.get();
        } catch (ExecutionException e) {
            Throwable cause = e.getCause();
            String known = RunFailure.text(started.run.recording(), cause);
            if (known != null) {
                progress.say(known);
            } else {
                progress.clear();
                sofas.printUnexpected(spec.commandLine().getErr(), place, cause);
            }
            return false;
        }
    }
}
