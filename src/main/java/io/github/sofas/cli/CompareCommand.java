package io.github.sofas.cli;

import io.github.sofas.evaluate.Agreement;
import io.github.sofas.evaluate.Evaluation;
import io.github.sofas.evaluate.EvaluationOptions;
import io.github.sofas.evaluate.FlowEstimate;
import io.github.sofas.evaluate.FlowFigures;
import io.github.sofas.evaluate.GroundTruth;
import io.github.sofas.evaluate.TruthCsvReader;
import io.github.sofas.evaluate.TruthException;
import io.github.sofas.event.EventBatch;
import io.github.sofas.event.EventSourceException;
import io.github.sofas.flow.FlowOutput;
import io.github.sofas.flow.LabelledSource;
import io.github.sofas.flow.Sofas;
import io.github.sofas.flow.SofasParameters;
import io.github.sofas.host.Display;
import io.github.sofas.host.JaerException;
import io.github.sofas.host.JaerFilter;
import io.github.sofas.recording.RecordingReader;
import io.github.sofas.recording.Recordings;
import java.io.IOException;
import java.io.PrintWriter;
import java.io.UncheckedIOException;
import java.net.URISyntaxException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Locale;
import java.util.Map;
import java.util.concurrent.Callable;
import java.util.function.DoubleSupplier;
import picocli.CommandLine.Command;
import picocli.CommandLine.Mixin;
import picocli.CommandLine.Model.CommandSpec;
import picocli.CommandLine.Option;
import picocli.CommandLine.ParameterException;
import picocli.CommandLine.Parameters;
import picocli.CommandLine.Spec;

/**
 * Runs jAER's own motion-flow filters and ours inside jAER, and {@code sofas run} outside. Prints the accuracy of each
 * or, without a truth, the agreement of each pair.
 */
@Command(name = "compare", sortOptions = false, customSynopsis = "sofas compare [OPTION]... --jaer DIR RECORDING",
    description = {"Compare SOFAS with jAER's LucasKanadeFlow and LocalPlanesFlow, inside jAER.",
        "The three filters get the same packets, each in its own jAER with default settings, except that measuring of "
        + "accuracy is off. With --truth: the accuracy of each, as 'evaluate' gives it. Without: the agreement of "
        + "each pair. jAER needs a display; if there is none, Xvfb is used.",
        "Filters in jAER label events as they come; 'sofas run', which is compared with them, looks ahead unless "
        + "--causal is given."},
    exitCodeListHeading = "%nExit codes:%n",
    exitCodeList = {"0:compared", "1:the recording is damaged, or jAER or the truth cannot be used", "2:wrong usage"})
final class CompareCommand implements Callable<Integer> {
    private static final String FAMILY = "ch.unizh.ini.jaer.projects.rbodo.opticalflow.";
    private static final Map<String, String> FILTERS = filters();
    private static final String ENGINE = "sofas run";
    private static final String ENGINE_AHEAD = "with look-ahead";
    private static final int BATCH = 4096;

    @Spec
    private CommandSpec spec;

    @Parameters(paramLabel = "RECORDING", description = "A recording.")
    private Path recording;

    @Option(names = "--jaer", paramLabel = "DIR", required = true, description = "Folder of a jAER, 2.1 to 3.3.")
    private Path jaer;

    @Option(names = "--truth", paramLabel = "FILE", description = "CSV file with the truth of its events (see "
        + "'evaluate').")
    private Path truth;

    @Option(names = "--java", paramLabel = "FILE",
        description = "Java program for a jAER that includes none; default: the one that runs this program.")
    private Path java = Path.of(System.getProperty("java.home"), "bin", "java");

    @Option(names = "--plugin", paramLabel = "JAR", description = "The file sofas-jAER.jar; default: the one that "
        + "belongs to this program.")
    private Path plugin;

    @Mixin
    private ReadingOptions reading;

    @Mixin
    private LookAheadOptions lookAhead;

    /** A method's labels of the recording, the time it took for them, and the damage that ended the recording. */
    private record Labelled(String name, FlowEstimate estimate, double seconds, EventSourceException damage) {
    }

    private static Map<String, String> filters() {
        Map<String, String> filters = new LinkedHashMap<>();
        filters.put("SofasFlow", "io.github.sofas.jaer.SofasFlow");
        filters.put("LucasKanadeFlow", FAMILY + "LucasKanadeFlow");
        filters.put("LocalPlanesFlow", FAMILY + "LocalPlanesFlow");
        return filters;
    }

    @Override
    public Integer call() {
        PrintWriter err = spec.commandLine().getErr();
        reading.check();
        for (Path file : truth == null ? List.of(recording, jaer) : List.of(recording, jaer, truth)) {
            if (!Files.exists(file)) {
                throw new ParameterException(spec.commandLine(), "[" + file + "] no such file or folder");
            }
        }
        MethodChoice own = ownMethod();
        Path jar = plugin();
        try (Display display = Display.open(System.getenv("DISPLAY"))) {
            List<Labelled> all = new ArrayList<>();
            all.add(engine(own));
            for (Map.Entry<String, String> filter : FILTERS.entrySet()) {
                all.add(inJaer(jar, display, filter.getKey(), filter.getValue()));
            }
            PrintWriter out = spec.commandLine().getOut();
            out.printf(Locale.ROOT, "%s: %,d events%n", recording, all.get(0).estimate().size());
            if (truth == null) {
                printAgreement(out, all);
            } else {
                printAccuracy(out, all);
            }
            EventSourceException damage = all.get(0).damage();
            if (damage != null) {
                err.println(damage.getMessage());
                return Main.FAILED;
            }
            return Main.OK;
        } catch (EventSourceException | TruthException | JaerException e) {
            err.println(e.getMessage());
        } catch (UncheckedIOException e) {
            err.println(e.getMessage());
        } catch (IOException e) {
            err.println("[" + truth + "] truth cannot be read: " + e);
        }
        return Main.FAILED;
    }

    /** The method that labels events outside jAER: as 'run' does, with look-ahead unless the options say otherwise. */
    private MethodChoice ownMethod() {
        SofasParameters parameters = SofasParameters.defaults();
        return lookAhead.ofRecording(new MethodChoice(MethodOptions.Method.SOFAS.toString(), "default", Map.of(),
            (sensor, ended) -> new Sofas(sensor, parameters, ended)), parameters);
    }

    private Labelled engine(MethodChoice method) throws EventSourceException {
        try (RecordingReader reader = Recordings.open(recording, reading.recordingOptions());
                OpenLabelling open = method.open(reader.sensor())) {
            LabelledSource source = new LabelledSource(reader, open.labelling());
            return labelled(method.looksAhead() ? ENGINE_AHEAD : ENGINE, source::next,
                () -> source.labellingNs() * 1e-9);
        }
    }

    private Labelled inJaer(Path jar, Display display, String name, String filterClass)
            throws EventSourceException, JaerException {
        try (RecordingReader reader = Recordings.open(recording, reading.recordingOptions());
             JaerFilter filter = JaerFilter.start(jar, jaer, java, display, filterClass, reader.sensor())) {
            return labelled(name, (batch, output) -> {
                boolean more = reader.next(batch);
                if (more) {
                    filter.process(batch, output);
                }
                return more;
            }, filter::seconds);
        }
    }

    private static Labelled labelled(String name, LabelledEvents events, DoubleSupplier seconds) {
        EventBatch batch = new EventBatch(BATCH);
        FlowOutput output = new FlowOutput(BATCH);
        FlowEstimate estimate = new FlowEstimate();
        EventSourceException damage = null;
        try {
            while (events.next(batch, output)) {
                estimate.append(output, batch.size());
            }
        } catch (EventSourceException e) {
            damage = e;
        }
        return new Labelled(name, estimate, seconds.getAsDouble(), damage);
    }

    private Path plugin() {
        Path jar = plugin;
        if (jar == null) {
            try {
                Path own = Path.of(CompareCommand.class.getProtectionDomain().getCodeSource().getLocation().toURI());
                jar = own.resolveSibling("../jaer/sofas-jAER.jar").normalize();
            } catch (URISyntaxException e) {
                throw new IllegalStateException(e);
            }
        }
        if (!Files.exists(jar)) {
            throw new ParameterException(spec.commandLine(),
                "[" + jar + "] no such file; --plugin names sofas-jAER.jar");
        }
        return jar;
    }

    private static void printAgreement(PrintWriter out, List<Labelled> all) {
        out.printf("%-17s %10s %12s%n", "", "with flow", "events/s");
        for (Labelled one : all) {
            out.printf(Locale.ROOT, "%-17s %8.1f %% %,12.0f%n", one.name(), percentWithFlow(one), perSecond(one));
        }
        out.printf("%n%-35s %10s %21s %14s%n", "", "both", "median difference", "median angle");
        for (int a = 0; a < all.size(); a++) {
            for (int b = a + 1; b < all.size(); b++) {
                Agreement agreement = Agreement.of(all.get(a).estimate(), all.get(b).estimate());
                out.printf(Locale.ROOT, "%-35s %,10d %16.2f px/s %10.2f deg%n",
                    all.get(a).name() + ", " + all.get(b).name(), agreement.both(), agreement.difference().median(),
                    agreement.angle().median());
            }
        }
    }

    private void printAccuracy(PrintWriter out, List<Labelled> all) throws EventSourceException, TruthException,
            IOException {
        GroundTruth known = truth();
        out.printf("%-17s %10s %20s %18s %15s %12s%n", "", "with flow", "magnitude error", "direction error",
            "endpoint error", "events/s");
        for (Labelled one : all) {
            FlowFigures figures = Evaluation.of(known, one.estimate(), EvaluationOptions.defaults()).flow();
            out.printf(Locale.ROOT, "%-17s %8.1f %% %8.1f +- %6.1f %% %6.1f +- %4.1f deg %13.1f %% %,12.0f%n",
                one.name(), 100 * figures.shareWithFlow(), figures.magnitudeErrorPercent().mean(),
                figures.magnitudeErrorPercent().sd(), figures.directionErrorDeg().mean(),
                figures.directionErrorDeg().sd(), figures.relativeEndpointErrorPercent().mean(), perSecond(one));
        }
        out.println("With flow: of the objects' events. Endpoint error: mean, relative to the true speed. "
            + "The first 15 % of the time do not count.");
    }

    private GroundTruth truth() throws EventSourceException, TruthException, IOException {
        try (RecordingReader reader = Recordings.open(recording, reading.recordingOptions());
             TruthCsvReader truthReader = TruthCsvReader.open(truth)) {
            EventBatch batch = new EventBatch(BATCH);
            try {
                while (reader.next(batch)) {
                    truthReader.read(batch);
                }
                truthReader.end();
            } catch (EventSourceException e) {
                // the truth covers the events before the damage, which is reported at the end
            }
            return truthReader.truth();
        }
    }

    private static double percentWithFlow(Labelled one) {
        int with = 0;
        for (int i = 0; i < one.estimate().size(); i++) {
            with += one.estimate().hasFlow(i) ? 1 : 0;
        }
        return 100.0 * with / Math.max(1, one.estimate().size());
    }

    private static double perSecond(Labelled one) {
        return one.seconds() > 0 ? one.estimate().size() / one.seconds() : 0;
    }
}
