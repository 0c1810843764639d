package io.github.sofas.cli;

import io.github.sofas.event.EventSourceException;
import io.github.sofas.export.ResultFiles;
import io.github.sofas.render.FlowColours;
import io.github.sofas.render.GifFilm;
import io.github.sofas.render.Mp4Film;
import io.github.sofas.render.Panel;
import io.github.sofas.render.PictureOptions;
import io.github.sofas.render.Theme;
import java.io.IOException;
import java.io.PrintWriter;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.Arrays;
import java.util.List;
import java.util.Locale;
import java.util.Map;
import java.util.concurrent.Callable;
import java.util.regex.Matcher;
import java.util.regex.Pattern;
import picocli.CommandLine.ArgGroup;
import picocli.CommandLine.Command;
import picocli.CommandLine.Mixin;
import picocli.CommandLine.Model.CommandSpec;
import picocli.CommandLine.Option;
import picocli.CommandLine.ParameterException;
import picocli.CommandLine.Parameters;
import picocli.CommandLine.ParentCommand;
import picocli.CommandLine.Spec;

/**
 * Makes a film or pictures of a recording's events, flow and segments. This class checks the arguments;
 * {@link RenderRun} makes the film.
 */
@Command(name = "render", sortOptions = false,
    customSynopsis = "sofas render [OPTION]... --out DIR RECORDING",
    description = {"Make a film of a recording's events, flow and segments.",
        "Writes NAME.mp4, NAME.gif or NAME.png.zip; NAME is the recording's file name without its last extension. "
        + "Labels the events, or uses the labels written by 'run' (--results)."},
    exitCodeListHeading = "%nExit codes:%n",
    exitCodeList = {"0:written", "1:the recording failed; the film up to then is written", "2:wrong usage"})
final class RenderCommand implements Callable<Integer> {
    private static final Pattern EXPOSURE = Pattern.compile("(\\d+(?:\\.\\d+)?)(ms|ev)");

    @Spec
    private CommandSpec spec;

    @ParentCommand
    private SofasCommand sofas;

    @Parameters(paramLabel = "RECORDING", description = "The recording.")
    private Path recording;

    @Option(names = {"-o", "--out"}, paramLabel = "DIR", required = true,
        description = "Output folder; created if it does not exist.")
    private Path out;

    @Option(names = "--results", paramLabel = "DIR",
        description = "Folder of NAME.flow.csv, written by 'run'; the events are not labelled again.")
    private Path results;

    @Option(names = "--format", defaultValue = "MP4", paramLabel = "FORMAT",
        description = "mp4, gif or png (a ZIP file of numbered pictures); default: mp4.")
    private RenderRun.Format format;

    @Option(names = "--encoder", defaultValue = "AUTO", paramLabel = "ENCODER",
        description = "MP4 encoder: ffmpeg (must be on PATH), jcodec (built in; slower, larger files) or auto (ffmpeg "
        + "if available); default: auto.")
    private Mp4Film.Encoder encoder;

    @Option(names = {"-f", "--force"}, description = "Replace an existing film; otherwise it is an error.")
    private boolean force;

    @Option(names = {"-q", "--quiet"}, description = "Print no summary.")
    private boolean quiet;

    @ArgGroup(validate = false, heading = "%nWhat is shown:%n")
    private final Shown shown = new Shown();

    @ArgGroup(validate = false, heading = "%nTime:%n")
    private final Times times = new Times();

    @Mixin
    private ReadingOptions reading;

    @Mixin
    private LookAheadOptions lookAhead;

    @Mixin
    private MethodOptions methodOptions;

    @Mixin
    private ParameterOptions parameterOptions;

    /** Options that determine what is shown. */
    private static final class Shown {
        @Option(names = "--panels", split = ",", paramLabel = "PANEL",
            description = "Any of ${COMPLETION-CANDIDATES}, separated by commas; default: flow,segments.")
        private List<Panel> panels = List.of(Panel.FLOW, Panel.SEGMENTS);

        @Option(names = "--theme", defaultValue = "DARK", description = "${COMPLETION-CANDIDATES}; default: dark.")
        private Theme theme;

        @Option(names = "--wheel", defaultValue = "SAFE", description = "Colours of directions: safe (also for "
            + "colour-blind people) or hue (as in most papers); default: safe.")
        private FlowColours.Wheel wheel;

        @Option(names = "--scale", paramLabel = "N", description = "Screen pixels per sensor pixel, 1 to 16; default: "
            + "such that a panel is at least 480 wide.")
        private Integer scale;

        @Option(names = "--crop", paramLabel = "X,Y,W,H", description = "Part of the sensor that is shown.")
        private String crop;

        @Option(names = "--full-speed", paramLabel = "PX/S", description = "Speed of the full colour and of the scale "
            + "bar; default: adapts to the scene.")
        private Double fullPxPerS;
    }

    /** Options that determine when it is shown. */
    private static final class Times {
        @Option(names = "--fps", defaultValue = "30", description = "Pictures per second of film, at most 240; "
            + "default: 30. GIF has steps of 0.01 s: the nearest rate is used, 33.3 for 30, at most 50.")
        private double fps;

        @Option(names = "--slow", paramLabel = "FACTOR",
            description = "Seconds of film per second of recording; 10 is ten times slower than life; default: 1.")
        private Double slow;

        @Option(names = "--every", paramLabel = "EVENTS",
            description = "One picture per so many events, instead of --slow.")
        private Long every;

        @Option(names = "--exposure", paramLabel = "TIME", description = "How long an event is shown, such as 20ms, "
            + "or 5000ev for the last 5,000 events; default: 33ms, with --every the events of one picture.")
        private String exposure;

        @Option(names = "--from", paramLabel = "SECONDS", description = "Begin of the film, in seconds from the first "
            + "event.")
        private double fromS;

        @Option(names = "--to", paramLabel = "SECONDS", description = "End of the film; default: end of the recording.")
        private double toS = Double.POSITIVE_INFINITY;

        @Option(names = "--max-pictures", defaultValue = "36000", paramLabel = "N",
            description = "Largest number of pictures; default: ${DEFAULT-VALUE}, 20 minutes at 30 fps.")
        private long maxPictures;
    }

    @Override
    public Integer call() {
        PrintWriter err = spec.commandLine().getErr();
        RenderRun run = check();
        ReadingOptions.sayIfWaiting(run.recording(), err);
        try (ResultFiles files = new ResultFiles(force)) {
            RenderRun.Outcome outcome;
            try (RunProgress progress = RunProgress.start(err, quiet, run.recording().toFile().length())) {
                outcome = run.run(files, progress);
            }
            files.commit();
            outcome.notes().forEach(err::println);
            outcome.faults().forEach(err::println);
            if (outcome.damage() != null) {
                err.println(outcome.damage().getMessage());
            }
            if (outcome.endsEarly()) {
                err.println("[" + recording.getFileName() + "] the film ends early: it has the "
                    + times.maxPictures + " pictures of --max-pictures");
            }
            if (!quiet) {
                err.println(String.format(Locale.ROOT, "%s: %,d %s of %,d events, %.3f s of recording, in %.1f s",
                    run.file(), outcome.pictures(), outcome.pictures() == 1 ? "picture" : "pictures",
                    outcome.events(), outcome.recordingS(), outcome.wallS()));
                if (outcome.encoder() == Mp4Film.Encoder.JCODEC && encoder == Mp4Film.Encoder.AUTO) {
                    err.println("encoded by jcodec; with ffmpeg on PATH, films are encoded faster and are smaller");
                }
            }
            String doubt = reading.doubt(recording, outcome.doubtfulShare());
            if (doubt != null) {
                err.println(doubt);
            }
            return outcome.damage() == null && doubt == null ? Main.OK : Main.FAILED;
        } catch (IllegalArgumentException e) {
            throw usage("[" + recording.getFileName() + "] " + e.getMessage());
        } catch (EventSourceException e) {
            err.println(e.getMessage());
        } catch (IOException e) {
            err.println("[" + run.file() + "] cannot be written: " + FileFailure.text(e));
        }
        return Main.FAILED;
    }

    private RenderRun check() {
        positive("--fps", times.fps);
        if (times.fps > 240) {
            throw usage("--fps must be at most 240 but was " + times.fps);
        }
        if (times.slow != null) {
            positive("--slow", times.slow);
        }
        if (times.every != null && times.slow != null) {
            throw usage("--every and --slow exclude each other: a picture comes by events or by time");
        }
        if (times.every != null && times.every < 1) {
            throw usage("--every must be above 0 but was " + times.every);
        }
        if (shown.fullPxPerS != null) {
            positive("--full-speed", shown.fullPxPerS);
        }
        if (shown.scale != null && (shown.scale < 1 || shown.scale > 16)) {
            throw usage("--scale must be between 1 and 16 but was " + shown.scale);
        }
        if (times.maxPictures < 1) {
            throw usage("--max-pictures must be above 0 but was " + times.maxPictures);
        }
        if (!(times.fromS >= 0) || !(times.toS > times.fromS)) {
            throw usage("--from must not be negative and --to must be later but they were " + times.fromS + " and "
                + times.toS);
        }
        if (results != null && shown.panels.contains(Panel.CONTOURS)) {
            throw usage("--panels contours cannot be combined with --results: it needs the track planes");
        }
        if (results != null) {
            methodOptions.refuseLabelling("--results");
        }
        if (lookAhead.isGiven() && shown.panels.contains(Panel.CONTOURS)) {
            throw usage("--panels contours cannot be combined with --look-ahead: track planes are those of the newest "
                + "event");
        }
        MethodChoice asked = methodOptions.choice(parameterOptions);
        MethodChoice method = shown.panels.contains(Panel.CONTOURS)
            ? lookAhead.applyTo(asked, parameterOptions.parameters())
            : lookAhead.ofRecording(asked, parameterOptions.parameters());
        if (!method.method().equals("sofas") && shown.panels.contains(Panel.CONTOURS)) {
            throw usage("--panels contours needs --method sofas but was used with " + method.method());
        }
        reading.check();
        Map<String, Path> named;
        PictureOptions pictures;
        try {
            named = RecordingArguments.byName(RecordingArguments.expand(List.of(recording.toString())), false);
            pictures = pictures();
        } catch (IllegalArgumentException e) {
            throw usage(e.getMessage());
        }
        if (named.size() > 1) {
            throw usage("one recording is rendered at a time but \"" + recording + "\" is " + named.size());
        }
        String name = named.keySet().iterator().next();
        Path film = out.resolve(name + format.ending);
        OutputFiles outputs = new OutputFiles(spec.commandLine());
        if (!force) {
            outputs.refuseExisting(List.of(film));
        }
        Path flow = results == null ? null : new ResultNames(results, name).flow();
        if (flow != null && !Files.isRegularFile(flow)) {
            throw usage("[" + flow + "] no such file; 'sofas run' writes it");
        }
        outputs.check(Arrays.asList(named.get(name), flow, parameterOptions.config()), List.of(film));
        outputs.makeFolder(out);
        double fps = format == RenderRun.Format.GIF ? GifFilm.nearestFps(times.fps) : times.fps;
        double stepUs = 1e6 / (fps * (times.slow == null ? 1 : times.slow));
        RenderRun.Timing timing = new RenderRun.Timing(fps, stepUs, times.every == null ? 0 : times.every, times.fromS,
            times.toS, times.maxPictures);
        return new RenderRun(named.get(name), reading.recordingOptions(), method, flow, film, format, encoder,
            pictures, timing);
    }

    private PictureOptions pictures() {
        double exposureUs = times.every == null ? 33_333 : 0;
        double exposureEvents = times.every == null ? 0 : times.every;
        if (times.exposure != null) {
            Matcher matcher = EXPOSURE.matcher(times.exposure);
            boolean isTime = matcher.matches() && matcher.group(2).equals("ms");
            double value = matcher.matches() ? Double.parseDouble(matcher.group(1)) : 0;
            exposureUs = isTime ? value * 1000 : 0;
            exposureEvents = isTime ? 0 : value;
            if (exposureUs < 1 && exposureEvents < 1) {
                throw new IllegalArgumentException("--exposure must be a time above 0 such as 20ms or a count such as "
                    + "5000ev but was \"" + times.exposure + "\"");
            }
        }
        return new PictureOptions(shown.panels, shown.theme, shown.wheel, shown.scale == null ? 0 : shown.scale,
            (long) exposureUs, (long) exposureEvents, shown.fullPxPerS == null ? 0 : shown.fullPxPerS, crop());
    }

    private PictureOptions.Crop crop() {
        if (shown.crop == null) {
            return null;
        }
        if (!shown.crop.matches("\\d{1,4},\\d{1,4},\\d{1,4},\\d{1,4}")) {
            throw new IllegalArgumentException("--crop must be X,Y,W,H in px but was \"" + shown.crop + "\"");
        }
        String[] parts = shown.crop.split(",");
        return new PictureOptions.Crop(Integer.parseInt(parts[0]), Integer.parseInt(parts[1]),
            Integer.parseInt(parts[2]), Integer.parseInt(parts[3]));
    }

    private void positive(String option, double value) {
        if (!(value > 0 && value < 1e6)) {
            throw usage(option + " must be above 0 and below 1,000,000 but was " + value);
        }
    }

    private ParameterException usage(String message) {
        return new ParameterException(spec.commandLine(), message);
    }
}
