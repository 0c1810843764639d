package io.github.sofas.cli;

import io.github.sofas.experiments.ExperimentFiles;
import io.github.sofas.experiments.Experiments;
import io.github.sofas.export.ResultFiles;
import java.io.BufferedOutputStream;
import java.io.IOException;
import java.io.OutputStream;
import java.io.PrintWriter;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.Locale;
import java.util.concurrent.Callable;
import java.util.function.Consumer;
import picocli.CommandLine.Command;
import picocli.CommandLine.Model.CommandSpec;
import picocli.CommandLine.Option;
import picocli.CommandLine.ParameterException;
import picocli.CommandLine.Spec;

/** Runs the paper's experiments and writes them as a page and as CSV. */
@Command(name = "experiments", sortOptions = false, customSynopsis = "sofas experiments --out DIR [OPTION]...",
    description = {"Run the paper's experiments on simulated scenes: both presets, Lucas-Kanade and local planes.",
        "Writes experiments.html, which needs no network, and figures.csv, goals.csv, histograms.csv, curves.csv and "
        + "metric-maps.csv. It takes a minute or two."},
    exitCodeListHeading = "%nExit codes:%n",
    exitCodeList = {"0:written", "1:a recording cannot be read (the rest is written), or the files cannot be written",
        "2:wrong usage; nothing was run"})
final class ExperimentsCommand implements Callable<Integer> {
    @Spec
    private CommandSpec spec;

    @Option(names = {"-o", "--out"}, paramLabel = "DIR", required = true,
        description = "Where the files go; made if it does not exist.")
    private Path out;

    @Option(names = "--recordings", paramLabel = "DIR",
        description = "Folder of the recordings of real cameras that something is known of; without it they are left "
            + "out.")
    private Path recordings;

    @Option(names = {"-j", "--jobs"}, paramLabel = "N",
        description = "How many run at a time; default: one a processor.")
    private int jobs = Runtime.getRuntime().availableProcessors();

    @Option(names = {"-f", "--force"}, description = "Replace files that exist; without it they are an error.")
    private boolean force;

    @Option(names = {"-q", "--quiet"}, description = "Print no progress.")
    private boolean quiet;

    @Override
    public Integer call() throws InterruptedException {
        if (jobs < 1) {
            throw usage("--jobs must be at least 1 but was " + jobs);
        }
        if (recordings != null && !Files.isDirectory(recordings)) {
            throw usage("--recordings must be a directory but was \"" + recordings + "\"");
        }
        for (ExperimentFiles file : ExperimentFiles.values()) {
            Path path = out.resolve(file.fileName());
            if (!force && Files.exists(path)) {
                throw usage("[" + path + "] exists already; --force replaces it");
            }
        }
        PrintWriter err = spec.commandLine().getErr();
        try {
            // before a minute of work, not after it
            Files.createDirectories(out);
            Consumer<String> progress = quiet ? part -> { } : err::println;
            Experiments experiments = Experiments.run(recordings, jobs, progress);
            write(experiments);
            experiments.failures().forEach(err::println);
            if (!quiet) {
                err.println(String.format(Locale.ROOT, "%.0f s; see %s", experiments.seconds(),
                    out.resolve(ExperimentFiles.REPORT.fileName())));
            }
            return experiments.failures().isEmpty() ? Main.OK : Main.FAILED;
        } catch (IOException e) {
            err.println("[" + out + "] cannot be written: " + FileFailure.text(e));
            return Main.FAILED;
        }
    }

    private void write(Experiments experiments) throws IOException {
        try (ResultFiles files = new ResultFiles()) {
            for (ExperimentFiles file : ExperimentFiles.values()) {
                try (OutputStream stream = new BufferedOutputStream(files.create(out.resolve(file.fileName())))) {
                    file.write(experiments, Version.text(), stream);
                }
            }
            files.commit();
        }
    }

    private ParameterException usage(String message) {
        return new ParameterException(spec.commandLine(), message);
    }
}
