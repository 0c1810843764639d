package io.github.sofas.cli;

import io.github.sofas.evaluate.KnownTranslations;
import io.github.sofas.experiments.Ablation;
import io.github.sofas.experiments.ExperimentFiles;
import io.github.sofas.experiments.Experiments;
import io.github.sofas.experiments.Tables;
import io.github.sofas.export.ResultFiles;
import java.io.BufferedOutputStream;
import java.io.IOException;
import java.io.OutputStream;
import java.io.PrintWriter;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.Arrays;
import java.util.List;
import java.util.Locale;
import java.util.concurrent.Callable;
import java.util.function.Consumer;
import picocli.CommandLine.Command;
import picocli.CommandLine.Mixin;
import picocli.CommandLine.Model.CommandSpec;
import picocli.CommandLine.Option;
import picocli.CommandLine.ParameterException;
import picocli.CommandLine.Spec;

/**
 * Runs the paper's experiments and writes them as a page and as CSV. Without an output folder, prints tables instead:
 * of one method, or of the effect of each of its extensions.
 */
@Command(name = "experiments", sortOptions = false, customSynopsis = {"sofas experiments --out DIR [OPTION]...",
        "       sofas experiments [--random N] [--scenes] [--recordings DIR] [OPTION]...",
        "       sofas experiments --ablation [--random N] [--recordings DIR] [OPTION]..."},
    description = {"Run the paper's experiments on simulated scenes: both presets, Lucas-Kanade and local planes.",
        "Writes experiments.html (self-contained), method.png, figures.csv, goals.csv, histograms.csv, curves.csv and "
        + "metric-maps.csv. Takes a few minutes.",
        "Without --out, prints tables of one method, one line per scene or recording. Scenes: IoU, parts per object, "
        + "relative endpoint error, events with flow, events faster than twice the fastest true one, noise with flow. "
        + "Recordings: sharpness, sharpness of the best single translation, gain, segments with 1 %% of the flow."},
    exitCodeListHeading = "%nExit codes:%n",
    exitCodeList = {"0:written", "1:a recording cannot be read (the rest is written), or the files cannot be written",
        "2:wrong usage; nothing was run"})
final class ExperimentsCommand implements Callable<Integer> {
    private static final int ABLATION_SCENES = 24;
    private static final int REPORTED_SCENES = 100;

    @Spec
    private CommandSpec spec;

    @Option(names = {"-o", "--out"}, paramLabel = "DIR",
        description = "Output folder; created if it does not exist.")
    private Path out;

    @Option(names = "--random", paramLabel = "N", description = "Print a table of N random scenes with consecutive "
        + "seeds. With --out: how many scenes the page covers; default: " + REPORTED_SCENES + ".")
    private Integer random;

    @Option(names = "--from-seed", paramLabel = "SEED", defaultValue = "1",
        description = "Seed of the first random scene; default: ${DEFAULT-VALUE}.")
    private long fromSeed;

    @Option(names = "--scenes", description = "Print a table of the textured scenes and those of the experiments.")
    private boolean scenes;

    @Option(names = "--ablation",
        description = "Table of what each extension of the method buys: each switched off alone, over random scenes "
            + "(--random; default: " + ABLATION_SCENES + ") and --recordings.")
    private boolean ablation;

    @Option(names = "--recordings", paramLabel = "DIR",
        description = "Folder of the real recordings for which some truth is known; without it they are left out. For "
        + "a table: any folder of recordings.")
    private Path recordings;

    @Option(names = "--translations", paramLabel = "FILE",
        description = "File that keeps the best single translations of the recordings' windows, whose search takes "
        + "most of the time; created or extended.")
    private Path translations;

    @Option(names = {"-j", "--jobs"}, paramLabel = "N",
        description = "Number of runs at a time; default: one per processor.")
    private int jobs = Runtime.getRuntime().availableProcessors();

    @Option(names = {"-f", "--force"}, description = "Replace existing files; otherwise they are an error.")
    private boolean force;

    @Option(names = {"-q", "--quiet"}, description = "Print no progress.")
    private boolean quiet;

    @Mixin
    private LookAheadOptions lookAhead;

    @Mixin
    private MethodOptions methodOptions;

    @Mixin
    private ParameterOptions parameterOptions;

    @Override
    public Integer call() throws InterruptedException {
        if (jobs < 1) {
            throw usage("--jobs must be at least 1 but was " + jobs);
        }
        if (random != null && random < 1) {
            throw usage("--random must be at least 1 but was " + random);
        }
        if (recordings != null && !Files.isDirectory(recordings)) {
            throw usage("--recordings must be a directory but was \"" + recordings + "\"");
        }
        if (lookAhead.isGiven() && (out != null || ablation)) {
            throw usage("--look-ahead needs a table of one method: --random, --scenes or --recordings without "
                + (out != null ? "--out" : "--ablation"));
        }
        if (out == null) {
            return tables();
        }
        List<Path> files = Arrays.stream(ExperimentFiles.values()).map(file -> out.resolve(file.fileName())).toList();
        OutputFiles outputs = new OutputFiles(spec.commandLine());
        outputs.check(List.of(), files);
        if (!force) {
            outputs.refuseExisting(files);
        }
        // a folder that cannot be made is reported before a minute of work, not after it
        outputs.makeFolder(out);
        PrintWriter err = spec.commandLine().getErr();
        try {
            Consumer<String> progress = quiet ? part -> { } : err::println;
            Experiments experiments = Experiments.run(recordings, random == null ? REPORTED_SCENES : random,
                jobs, progress);
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

    private Integer tables() throws InterruptedException {
        if (random == null && !scenes && !ablation && recordings == null) {
            throw usage("Missing required option: '--out=DIR', or for tables --random, --scenes, --recordings or "
                + "--ablation");
        }
        MethodChoice method = lookAhead.applyTo(methodOptions.choice(parameterOptions), parameterOptions.parameters());
        PrintWriter err = spec.commandLine().getErr();
        PrintWriter to = spec.commandLine().getOut();
        try {
            KnownTranslations known = translations == null ? new KnownTranslations()
                : KnownTranslations.read(translations);
            List<String> failures = ablation ? ablation(method, known, to)
                : tables(new Tables(sensor -> method.labelling(sensor, ended -> { }), jobs, to), known);
            failures.forEach(err::println);
            if (translations != null) {
                known.write(translations);
            }
            return failures.isEmpty() ? Main.OK : Main.FAILED;
        } catch (IOException e) {
            err.println("[" + (translations == null ? recordings : translations) + "] cannot be read or written: "
                + FileFailure.text(e));
            return Main.FAILED;
        }
    }

    private List<String> tables(Tables tables, KnownTranslations known) throws IOException, InterruptedException {
        if (random != null) {
            tables.random(fromSeed, random);
        }
        if (scenes) {
            tables.scenes();
        }
        return recordings == null ? List.of() : tables.recordings(recordings, known);
    }

    private List<String> ablation(MethodChoice method, KnownTranslations known, PrintWriter to)
            throws IOException, InterruptedException {
        if (!method.preset().equals("default")) {
            throw usage("--ablation needs --method sofas and --preset default");
        }
        Ablation table = new Ablation(parameterOptions.parameters(), jobs);
        table.random(fromSeed, random == null ? ABLATION_SCENES : random);
        if (recordings != null) {
            table.recordings(recordings, known);
        }
        table.print(to);
        return table.failures();
    }

    private void write(Experiments experiments) throws IOException {
        try (ResultFiles files = new ResultFiles(force)) {
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
