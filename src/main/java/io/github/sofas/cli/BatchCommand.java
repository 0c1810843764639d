package io.github.sofas.cli;

import io.github.sofas.batch.BatchColumn;
import io.github.sofas.batch.BatchOrder;
import io.github.sofas.batch.BatchRow;
import io.github.sofas.batch.BatchTask;
import io.github.sofas.batch.Cluster;
import io.github.sofas.batch.StoredFile;
import io.github.sofas.export.TableFormat;
import io.github.sofas.recording.Printable;
import java.io.IOException;
import java.io.PrintWriter;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.Comparator;
import java.util.HashSet;
import java.util.List;
import java.util.Locale;
import java.util.Map;
import java.util.Set;
import java.util.TreeMap;
import java.util.concurrent.Callable;
import picocli.CommandLine.Command;
import picocli.CommandLine.Mixin;
import picocli.CommandLine.Model.CommandSpec;
import picocli.CommandLine.Model.OptionSpec;
import picocli.CommandLine.Option;
import picocli.CommandLine.ParameterException;
import picocli.CommandLine.Parameters;
import picocli.CommandLine.ParentCommand;
import picocli.CommandLine.Spec;

/**
 * Labels every event of many recordings with flow and segment, one task per recording, on the machines of a cluster.
 * This class checks the arguments, lists the recordings and hands them to the {@link Cluster}, largest first. It then
 * writes one table of all recordings and prints totals. {@link BatchLabelling} does the work of a task.
 */
@Command(name = "batch", sortOptions = false,
    customSynopsis = "sofas batch [OPTION]... --out DIR INPUT...",
    description = {"Label many recordings on Apache Spark, here or on a cluster.",
        "Writes what run writes of each, and batch.parquet with one row per recording. Places are on this machine or "
        + "URIs (hdfs, s3a)."},
    exitCodeListHeading = "%nExit codes:%n",
    exitCodeList = {"0:every recording was read to its end", "1:a recording failed or is doubtful; the others were run",
        "2:wrong usage; nothing was run", "69:there is no Spark"})
final class BatchCommand implements Callable<Integer> {
    static final String TABLE = "batch.parquet";
    private static final String STAGING = ".batch-";
    /** Options that tasks do not get: tasks have other folders, replace outdated results, and print nothing. */
    private static final Set<String> NOT_OF_TASKS = Set.of("--out", "--config", "--force", "--resume", "--quiet",
        "--verbose");
    private static final Comparator<BatchTask> LONGEST_FIRST =
        Comparator.comparingLong((BatchTask task) -> -task.recording().bytes()).thenComparing(BatchTask::name);

    @Spec
    private CommandSpec spec;

    @ParentCommand
    private SofasCommand sofas;

    @Parameters(paramLabel = "INPUT", arity = "0..*",
        description = "Recordings, directories of recordings, or quoted patterns such as 'day*/*.aedat4'.")
    private List<String> arguments = new ArrayList<>();

    @Option(names = "--list", paramLabel = "FILE",
        description = "Text file with one more INPUT per line.")
    private String list;

    @Option(names = {"-o", "--out"}, paramLabel = "DIR", required = true,
        description = "Output folder; created if it does not exist.")
    private String out;

    @Option(names = "--events", paramLabel = "DIR",
        description = "Also make one Parquet data set of all events there, partitioned by recording.")
    private String events;

    @Option(names = "--master", paramLabel = "MASTER",
        description = "Spark's master: local[N] for N recordings at a time on this machine, or spark://HOST:PORT; "
        + "default: as spark-submit says, else local[*].")
    private String master;

    @Mixin
    private ResultOptions results;

    @Option(names = "--threads", paramLabel = "N", defaultValue = "1",
        description = "Threads per recording: 1, 2 (write, and help the search, while labelling) or 3 (read, too); "
        + "default: ${DEFAULT-VALUE}. Results do not depend on it.")
    private int threads;

    @Mixin
    private ReadingOptions reading;

    @Option(names = {"-q", "--quiet"}, description = "Print only errors and warnings, no progress and no summaries.")
    private boolean quiet;

    @Mixin
    private MethodOptions methodOptions;

    @Mixin
    private ParameterOptions parameterOptions;

    @Mixin
    private LookAheadOptions lookAhead;

    @Override
    public Integer call() throws IOException {
        List<String> options = optionsOfTasks();
        Cluster cluster = sofas.cluster();
        if (cluster == null) {
            spec.commandLine().getErr().println("batch runs on Apache Spark, which is not here yet");
            return Main.NO_CLUSTER;
        }
        try (cluster) {
            BatchPlaces places = new BatchPlaces(cluster.storage());
            String folder = cluster.qualified(out);
            List<BatchTask> tasks = tasks(new BatchInputs(cluster, places));
            Set<String> existing = places.at(folder).names(folder);
            refuseToHarm(tasks, folder, existing);
            sayWhatWasLeft(existing);
            if (!BatchPlaces.isRemote(folder)) {
                new OutputFiles(spec.commandLine()).makeFolder(Path.of(folder));
            }
            String staging = BatchPlaces.in(folder, STAGING + System.currentTimeMillis() + "-"
                + ProcessHandle.current().pid());
            BatchOrder order = new BatchOrder(options, results.resumes(), folder,
                events == null ? null : cluster.qualified(events), staging);
            try {
                return run(cluster, order, tasks);
            } finally {
                deleteStaging(places, staging);
            }
        }
    }

    private void deleteStaging(BatchPlaces places, String staging) {
        try {
            places.at(staging).delete(staging);
        } catch (IOException e) {
            spec.commandLine().getErr().println("[" + staging + "] cannot be deleted: " + FileFailure.text(e));
        }
    }

    private int run(Cluster cluster, BatchOrder order, List<BatchTask> tasks) {
        PrintWriter err = spec.commandLine().getErr();
        Map<String, BatchRow> rows = new TreeMap<>();
        long startNs = System.nanoTime();
        long bytes = tasks.stream().mapToLong(task -> task.recording().bytes()).sum();
        try {
            String where = cluster.start(master);
            try (RunProgress progress = RunProgress.start(err, quiet, bytes)) {
                if (!quiet) {
                    progress.say(tasks.size() + (tasks.size() == 1 ? " recording" : " recordings") + " on " + where);
                }
                cluster.label(order, tasks, row -> {
                    rows.put(row.text(BatchColumn.NAME), row);
                    ended(row, progress);
                });
            }
            writeTable(cluster, order, List.copyOf(rows.values()));
        } catch (IOException e) {
            err.println("the batch was stopped after " + rows.size() + " of " + tasks.size() + " recordings, --resume "
                + "goes on with it: " + FileFailure.text(e));
            return Main.FAILED;
        }
        return sayTotals(rows.values().stream().toList(), (System.nanoTime() - startNs) / 1e9);
    }

    private static void writeTable(Cluster cluster, BatchOrder order, List<BatchRow> rows) throws IOException {
        Path folder = BatchPlaces.isRemote(order.staging()) ? Files.createTempDirectory("sofas-batch")
            : Files.createDirectories(Path.of(order.staging()));
        Path file = folder.resolve(TABLE);
        try {
            cluster.writeTable(rows, file);
            new BatchPlaces(cluster.storage()).at(order.out())
                .put(file, BatchPlaces.in(order.out(), TABLE), order.staging());
        } finally {
            new LocalStorage().delete(folder.toString());
        }
    }

    /** Checks the options before anything has run, and returns those that every task gets. */
    private List<String> optionsOfTasks() {
        if (arguments.isEmpty() && list == null) {
            throw usage("a recording, a directory, a pattern or --list must be given");
        }
        List<String> options = new ArrayList<>();
        CommandSpec run = sofas.commandLine("run").getSubcommands().get("run").getCommandSpec();
        for (OptionSpec option : spec.commandLine().getParseResult().matchedOptions()) {
            String name = option.longestName();
            if (NOT_OF_TASKS.contains(name) || run.findOption(name) == null) {
                continue;
            }
            if (option.arity().max() == 0) {
                options.add(name);
            } else if (!name.equals("--format")) {
                option.originalStringValues().forEach(value -> options.add(name + "=" + value));
            }
        }
        reading.check();
        try {
            options.add("--format=" + String.join(",", formats().stream().map(TableFormat::extension).toList()));
            options.addAll(parameterOptions.configAsOptions());
        } catch (IllegalArgumentException e) {
            throw usage(e.getMessage());
        }
        if (spec.commandLine().getParseResult().matchedOption("--threads") == null) {
            options.add("--threads=" + threads);
        }
        if (threads < 1 || threads > BatchPipeline.MOST_THREADS) {
            throw usage("--threads must be 1 to " + BatchPipeline.MOST_THREADS + " but was " + threads);
        }
        lookAhead.ofRecording(methodOptions.choice(parameterOptions), parameterOptions.parameters());
        return List.copyOf(options);
    }

    /**
     * Formats of the tables. The data set of all events consists of the recordings' Parquet files, stored elsewhere.
     */
    private List<TableFormat> formats() {
        List<TableFormat> formats = new ArrayList<>(results.formats());
        if (events != null && !formats.contains(TableFormat.PARQUET)) {
            formats.add(TableFormat.PARQUET);
        }
        return formats;
    }

    private List<BatchTask> tasks(BatchInputs inputs) {
        List<BatchTask> tasks = new ArrayList<>();
        try {
            List<String> all = new ArrayList<>(arguments);
            if (list != null) {
                all.addAll(inputs.lines(list));
            }
            Map<String, StoredFile> found = inputs.expand(all);
            List<Path> names = found.keySet().stream().map(Path::of).toList();
            RecordingArguments.byName(names, results.keepsExtension()).forEach((name, path) ->
                tasks.add(new BatchTask(name, found.get(path.toString()))));
        } catch (IllegalArgumentException e) {
            throw usage(e.getMessage());
        } catch (IOException e) {
            throw new FailureException("the recordings cannot be listed: " + FileFailure.text(e), e);
        }
        tasks.sort(LONGEST_FIRST);
        return tasks;
    }

    private void refuseToHarm(List<BatchTask> tasks, String folder, Set<String> existing) {
        Set<String> inputs = new HashSet<>();
        tasks.forEach(task -> inputs.add(task.recording().place()));
        boolean replaces = results.replaces() || results.resumes();
        for (BatchTask task : tasks) {
            for (Path file : new ResultNames(Path.of(""), task.name()).ofRun(formats())) {
                String place = BatchPlaces.in(folder, file.toString());
                if (inputs.contains(place)) {
                    throw usage("[" + place + "] is read and cannot be written");
                }
                if (!replaces && existing.contains(file.toString())) {
                    throw usage("[" + BatchPlaces.in(out, file.toString()) + "] exists already; --force replaces it");
                }
            }
        }
        if (!replaces && existing.contains(TABLE)) {
            throw usage("[" + BatchPlaces.in(out, TABLE) + "] exists already; --force replaces it");
        }
    }

    private void sayWhatWasLeft(Set<String> existing) {
        existing.stream().filter(name -> name.startsWith(STAGING)).forEach(name ->
            spec.commandLine().getErr().println(Printable.of("[" + BatchPlaces.in(out, name) + "] was left by a batch "
                + "that was killed, unless that is still running; it can be deleted then")));
    }

    private ParameterException usage(String message) {
        return new ParameterException(spec.commandLine(), message);
    }

    private void ended(BatchRow row, RunProgress progress) {
        progress.add((long) row.number(BatchColumn.RECORDING_BYTES), (long) row.number(BatchColumn.EVENTS),
            (long) row.number(BatchColumn.EVENTS_WITH_FLOW));
        String fault = row.text(BatchColumn.FAULT);
        if (!fault.isEmpty()) {
            progress.say(fault);
        }
    }

    /** Prints the last lines, and returns the exit code that follows from them. */
    private int sayTotals(List<BatchRow> rows, double seconds) {
        PrintWriter err = spec.commandLine().getErr();
        Map<String, Integer> outcomes = new TreeMap<>();
        List<String> failed = new ArrayList<>();
        List<String> doubts = new ArrayList<>();
        long all = 0;
        long withFlow = 0;
        int earlier = 0;
        for (BatchRow row : rows) {
            String outcome = row.text(BatchColumn.OUTCOME);
            outcomes.merge(outcome, 1, Integer::sum);
            if (!outcome.equals(BatchRow.COMPLETE)) {
                failed.add(row.text(BatchColumn.RECORDING));
            }
            String doubt = reading.doubt(Path.of(row.text(BatchColumn.RECORDING)),
                row.number(BatchColumn.DOUBTFUL_SHARE));
            if (doubt != null) {
                doubts.add(doubt);
            }
            earlier += Boolean.TRUE.equals(row.get(BatchColumn.EARLIER)) ? 1 : 0;
            all += (long) row.number(BatchColumn.EVENTS);
            withFlow += (long) row.number(BatchColumn.EVENTS_WITH_FLOW);
        }
        if (!quiet) {
            StringBuilder line = new StringBuilder();
            outcomes.forEach((outcome, count) -> line.append(count).append(' ').append(outcome).append(", "));
            err.println(String.format(Locale.ROOT, "%d %s: %s%d done before; %d events, %s, %.2f s",
                rows.size(), rows.size() == 1 ? "recording" : "recordings", line, earlier, all,
                RunProgress.speed(all, withFlow, all / seconds), seconds));
        }
        if (!failed.isEmpty()) {
            err.println(failed.size() + " of " + rows.size() + (rows.size() == 1 ? " recording" : " recordings")
                + " failed: " + Printable.of(String.join(", ", failed)));
        }
        doubts.forEach(doubt -> err.println(Printable.of(doubt)));
        return failed.isEmpty() && doubts.isEmpty() ? Main.OK : Main.FAILED;
    }
}
