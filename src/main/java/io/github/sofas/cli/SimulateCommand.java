package io.github.sofas.cli;

import io.github.sofas.event.EventBatch;
import io.github.sofas.event.SensorSize;
import io.github.sofas.export.ResultFiles;
import io.github.sofas.recording.Aedat2Writer;
import io.github.sofas.recording.Chip;
import io.github.sofas.simulate.DvsModel;
import io.github.sofas.simulate.Scene;
import io.github.sofas.simulate.SimulatedSource;
import io.github.sofas.simulate.SimulationOptions;
import io.github.sofas.simulate.Surface;
import io.github.sofas.simulate.Truth;
import io.github.sofas.simulate.TruthCsv;
import java.io.IOException;
import java.io.PrintWriter;
import java.nio.file.Path;
import java.util.List;
import java.util.Locale;
import java.util.Map;
import java.util.Set;
import java.util.concurrent.Callable;
import java.util.stream.Collectors;
import picocli.CommandLine.ArgGroup;
import picocli.CommandLine.Command;
import picocli.CommandLine.Model.CommandSpec;
import picocli.CommandLine.Option;
import picocli.CommandLine.ParameterException;
import picocli.CommandLine.Parameters;
import picocli.CommandLine.ParseResult;
import picocli.CommandLine.Spec;

/** Films a scene with a model of a sensor, and writes the recording and the truth of every event. */
@Command(name = "simulate", sortOptions = false,
    customSynopsis = {"sofas simulate SCENE --out DIR [OPTION]...", "       sofas simulate --list"},
    description = {"Film a scene with a simulated event camera.",
        "Writes SCENE.aedat (AEDAT 2.0) and SCENE.truth.csv (" + TruthCsv.HEADER + "; object 0 is noise)."},
    exitCodeListHeading = "%nExit codes:%n",
    exitCodeList = {"0:written", "1:the files cannot be written", "2:wrong usage; nothing was written"})
final class SimulateCommand implements Callable<Integer> {
    private static final int BATCH = 4096;
    /** Separates a scene's name from its seed. */
    private static final String SEED_MARK = ":";
    /**
     * Option of each record component with which a message of {@link SimulationOptions} or {@link DvsModel} may begin.
     */
    private static final Map<String, String> OPTIONS = Map.ofEntries(Map.entry("speedPxPerS", "--speed"),
        Map.entry("directionDeg", "--direction"), Map.entry("turnsPerS", "--turns"), Map.entry("scale", "--scale"),
        Map.entry("contrast", "--contrast"), Map.entry("texture", "--texture"), Map.entry("blurPx", "--blur"),
        Map.entry("fieldOfViewM", "--field-of-view"), Map.entry("onThreshold", "--threshold-on"),
        Map.entry("offThreshold", "--threshold-off"), Map.entry("mismatchSd", "--mismatch"),
        Map.entry("jitterSdUs", "--jitter"), Map.entry("refractoryUs", "--refractory"),
        Map.entry("noiseHzPerPx", "--noise"), Map.entry("hotPixels", "--hot-pixels"),
        Map.entry("hotPixelHz", "--hot-pixel-rate"));

    /** Shortest film. Shorter ones could round to a duration of 0, which stands for the scene's own duration. */
    private static final double SHORTEST_S = 0.001;
    /** Options that affect only some scenes. */
    private static final Map<String, Set<Scene>> ONLY_OF = Map.of("--turns", Set.of(Scene.SHORT_BAR, Scene.LONG_BAR),
        "--turn-round", Set.of(Scene.FOUR_BARS), "--field-of-view", Set.of(Scene.PENDULUM),
        "--surface", Set.of(Scene.TEXTURED_PAN, Scene.TEXTURED_ROLL, Scene.TEXTURED_ZOOM, Scene.TEXTURED_HAND,
            Scene.TEXTURED_TURN, Scene.TEXTURED_SLANT, Scene.TEXTURED_MOVERS, Scene.SIDE_BY_SIDE, Scene.RANDOM));

    @Spec
    private CommandSpec spec;

    @Parameters(paramLabel = "SCENE", arity = "0..1",
        description = "The scene; --list shows all. random:7 is the scene random with seed 7.")
    private String sceneName;

    @Option(names = "--list", description = "List the scenes.")
    private boolean list;

    @Option(names = {"-o", "--out"}, paramLabel = "DIR", description = "Output folder; created if it does not exist.")
    private Path out;

    @Option(names = {"-f", "--force"}, description = "Replace existing files; otherwise they are an error.")
    private boolean force;

    @Option(names = {"-q", "--quiet"}, description = "Print no summary.")
    private boolean quiet;

    @ArgGroup(validate = false, heading = "%nThe scene:%n")
    private final SceneChoices scene = new SceneChoices();

    @ArgGroup(validate = false, heading = "%nThe sensor:%n")
    private final SensorChoices sensor = new SensorChoices();

    /** Options of the scene before the sensor. */
    private static final class SceneChoices {
        @Option(names = "--duration", paramLabel = "SECONDS",
            description = "Length of the film; 0 for the scene's own.")
        private double durationS;

        @Option(names = "--speed", paramLabel = "PX/S", description = "Speed of the first object; 0 for its own.")
        private double speedPxPerS;

        @Option(names = "--direction", paramLabel = "DEGREES",
            description = "Direction of the first object's motion, from right to down.")
        private double directionDeg;

        @Option(names = "--scale", paramLabel = "FACTOR", description = "Factor on all sizes, also of textures.")
        private double scale = SimulationOptions.defaults().scale();

        @Option(names = "--contrast", paramLabel = "LOG",
            description = "Logarithm of background light over an object's.")
        private double contrast = SimulationOptions.defaults().contrast();

        @Option(names = "--texture", paramLabel = "SD",
            description = "Standard deviation of the background's log intensity; 0 for the scene's own.")
        private double texture;

        @Option(names = "--surface", paramLabel = "KIND",
            description = "What walls and textured objects are made of: leaves (edges), smooth (blurred noise) or "
                + "fractal (as much of all sizes); default: leaves.")
        private String surface = SimulationOptions.defaults().surface().surfaceName();

        @Option(names = "--blur", paramLabel = "PX", description = "Standard deviation of the optical blur.")
        private double blurPx = SimulationOptions.defaults().blurPx();

        @Option(names = "--turns", paramLabel = "HZ", description = "Turns per second of rotating bars.")
        private double turnsPerS = SimulationOptions.defaults().turnsPerS();

        @Option(names = "--turn-round", description = "Make a camera pan slow down, reverse and return.")
        private boolean turnsRound;

        @Option(names = "--field-of-view", paramLabel = "M",
            description = "Width of the view at the pendulum, in m; 0 for the width of its swing.")
        private double fieldOfViewM;

        @Option(names = "--seed", paramLabel = "N", description = "Seed of all random numbers; default: 1.")
        private Long seed;
    }

    /** Options of the sensor that sees the scene. */
    private static final class SensorChoices {
        @Option(names = "--chip", paramLabel = "CHIP", description = "The sensor; default: DAVIS240C.")
        private String chip = "DAVIS240C";

        @Option(names = "--noise", paramLabel = "HZ/PX", description = "Background activity per pixel.")
        private double noiseHzPerPx = DvsModel.davis().noiseHzPerPx();

        @Option(names = "--hot-pixels", paramLabel = "N", description = "Number of hot pixels.")
        private int hotPixels;

        @Option(names = "--hot-pixel-rate", paramLabel = "HZ", description = "Rate of each hot pixel.")
        private double hotPixelHz = DvsModel.davis().hotPixelHz();

        @Option(names = "--threshold-on", paramLabel = "LOG",
            description = "Rise of log intensity that makes an event.")
        private double onThreshold = DvsModel.davis().onThreshold();

        @Option(names = "--threshold-off", paramLabel = "LOG",
            description = "Fall of log intensity that makes an event.")
        private double offThreshold = DvsModel.davis().offThreshold();

        @Option(names = "--mismatch", paramLabel = "SD", description = "Standard deviation of the thresholds.")
        private double mismatchSd = DvsModel.davis().mismatchSd();

        @Option(names = "--jitter", paramLabel = "US", description = "Standard deviation of the latency.")
        private double jitterSdUs = DvsModel.davis().jitterSdUs();

        @Option(names = "--refractory", paramLabel = "US", description = "Refractory time of a pixel after an event.")
        private double refractoryUs = DvsModel.davis().refractoryUs();
    }

    @Override
    public Integer call() throws IOException {
        if (list) {
            list(spec.commandLine().getOut());
            return Main.OK;
        }
        Scene filmed = scene();
        Chip chip = Chip.named(sensor.chip).orElseThrow(() ->
            usage("--chip must be one of " + Chip.knownNames() + " but was \"" + sensor.chip + "\""));
        SimulationOptions options = options(chip.sensor());
        if (out == null) {
            throw usage("Missing required option: '--out=DIR'");
        }
        String name = sceneName.replace(SEED_MARK, "-");
        Path recording = out.resolve(name + ".aedat");
        Path truth = out.resolve(name + ".truth.csv");
        OutputFiles outputs = new OutputFiles(spec.commandLine());
        outputs.check(List.of(), List.of(recording, truth));
        if (!force) {
            outputs.refuseExisting(List.of(recording, truth));
        }
        refuseWithoutEffect(filmed);
        outputs.makeFolder(out);
        try {
            long events = film(filmed, options, chip, recording, truth);
            if (!quiet) {
                spec.commandLine().getErr().println(String.format(Locale.ROOT, "%s: %,d events in %.3f s on %s",
                    name, events, filmed.durationUs(options) * 1e-6, chip.name()));
            }
            return Main.OK;
        } catch (IOException e) {
            spec.commandLine().getErr().println("[" + out + "] cannot be written: " + FileFailure.text(e));
            return Main.FAILED;
        }
    }

    private static void list(PrintWriter to) {
        for (Scene each : Scene.values()) {
            to.println(String.format(Locale.ROOT, "%-16s %s", each.sceneName(), each.description()));
        }
    }

    private Scene scene() {
        if (sceneName == null) {
            throw usage("Missing required parameter: 'SCENE'; known are " + Scene.names());
        }
        int mark = sceneName.indexOf(SEED_MARK);
        String named = mark < 0 ? sceneName : sceneName.substring(0, mark);
        Scene known = Scene.named(named)
            .orElseThrow(() -> usage("unknown scene \"" + sceneName + "\"; known are " + Scene.names()));
        if (mark >= 0 && known != Scene.RANDOM) {
            throw usage("only random may have a seed in its name but it was \"" + sceneName + "\"");
        }
        return known;
    }

    /** Refuses an option that changes nothing in the film: it was meant for another film. */
    private void refuseWithoutEffect(Scene filmed) {
        ParseResult typed = spec.commandLine().getParseResult();
        for (Map.Entry<String, Set<Scene>> option : ONLY_OF.entrySet()) {
            if (typed.hasMatchedOption(option.getKey()) && !option.getValue().contains(filmed)) {
                throw usage(option.getKey() + " has no effect on " + filmed.sceneName() + ", only on "
                    + option.getValue().stream().map(Scene::sceneName).sorted().collect(Collectors.joining(", ")));
            }
        }
        if (typed.hasMatchedOption("--hot-pixel-rate") && sensor.hotPixels == 0) {
            throw usage("--hot-pixel-rate has no effect without --hot-pixels");
        }
        if (filmed == Scene.PENDULUM && scene.fieldOfViewM > 0 && scene.speedPxPerS > 0) {
            throw usage("--field-of-view has no effect with --speed");
        }
    }

    private long seed() {
        int mark = sceneName.indexOf(SEED_MARK);
        if (mark < 0) {
            return scene.seed == null ? SimulationOptions.defaults().seed() : scene.seed;
        }
        if (scene.seed != null) {
            throw usage("--seed cannot be combined with a seed in the scene's name but it was \"" + sceneName + "\"");
        }
        try {
            return Long.parseLong(sceneName.substring(mark + 1));
        } catch (NumberFormatException e) {
            throw usage("the seed of a random scene must be a whole number but was \"" + sceneName.substring(mark + 1)
                + "\"");
        }
    }

    private SimulationOptions options(SensorSize size) {
        if (!(scene.durationS >= 0)) {
            throw usage("--duration must not be negative but was " + scene.durationS);
        }
        if (scene.durationS > 0 && scene.durationS < SHORTEST_S) {
            throw usage("--duration must be 0 or at least " + SHORTEST_S + " s but was " + scene.durationS);
        }
        Surface surface = Surface.named(scene.surface).orElseThrow(() ->
            usage("--surface must be one of " + Surface.names() + " but was \"" + scene.surface + "\""));
        try {
            DvsModel dvs = DvsModel.davis().withThresholds(sensor.onThreshold, sensor.offThreshold)
                .withMismatchSd(sensor.mismatchSd).withJitterSdUs(sensor.jitterSdUs)
                .withRefractoryUs(sensor.refractoryUs).withNoiseHzPerPx(sensor.noiseHzPerPx)
                .withHotPixels(sensor.hotPixels, sensor.hotPixelHz);
            return SimulationOptions.defaults().withSensor(size).withDurationUs(Math.round(scene.durationS * 1e6))
                .withSpeedPxPerS(scene.speedPxPerS).withDirectionDeg(scene.directionDeg).withScale(scene.scale)
                .withContrast(scene.contrast).withTexture(scene.texture).withSurface(surface)
                .withBlurPx(scene.blurPx).withTurnsPerS(scene.turnsPerS).withTurnsRound(scene.turnsRound)
                .withFieldOfViewM(scene.fieldOfViewM).withSeed(seed()).withDvs(dvs);
        } catch (IllegalArgumentException e) {
            String component = e.getMessage().substring(0, e.getMessage().indexOf(' '));
            throw usage(OPTIONS.getOrDefault(component, component) + e.getMessage().substring(component.length()));
        }
    }

    private long film(Scene filmed, SimulationOptions options, Chip chip, Path recording, Path truth)
            throws IOException {
        long events = 0;
        try (ResultFiles files = new ResultFiles(force)) {
            EventBatch batch = new EventBatch(BATCH);
            Truth known = new Truth(BATCH);
            try (RunProgress progress = RunProgress.start(spec.commandLine().getErr(), quiet, " ms",
                        filmed.durationUs(options) / 1000);
                    SimulatedSource source = new SimulatedSource(filmed, options);
                    Aedat2Writer aedat = new Aedat2Writer(files.create(recording), chip);
                    TruthCsv csv = new TruthCsv(files.create(truth))) {
                while (source.next(batch, known)) {
                    progress.reached(batch.timeUs[batch.size() - 1] / 1000);
                    aedat.write(batch);
                    csv.write(batch, known);
                    events += batch.size();
                }
            }
            files.commit();
        }
        return events;
    }

    private ParameterException usage(String message) {
        return new ParameterException(spec.commandLine(), message);
    }
}
