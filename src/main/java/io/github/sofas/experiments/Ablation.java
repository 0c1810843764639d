package io.github.sofas.experiments;

import io.github.sofas.evaluate.KnownTranslations;
import io.github.sofas.event.EventSourceException;
import io.github.sofas.event.SensorSize;
import io.github.sofas.experiments.SceneFigures.Column;
import io.github.sofas.flow.Labelling;
import io.github.sofas.flow.Sofas;
import io.github.sofas.flow.SofasParameters;
import io.github.sofas.simulate.Scene;
import io.github.sofas.simulate.SimulatedRecording;
import io.github.sofas.simulate.SimulationOptions;
import java.io.IOException;
import java.io.PrintWriter;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;
import java.util.concurrent.Callable;
import java.util.function.Function;

/**
 * Measures what each extension of the default preset contributes. The result is a table with one line for all
 * extensions switched on, and one line for each extension switched off alone. The figures cover random scenes, and
 * recordings of real cameras if there are any.
 */
public final class Ablation {
    private static final List<Column> COLUMNS = List.of(Column.IOU, Column.PARTS, Column.ERROR, Column.COVERAGE,
        Column.RUNAWAYS, Column.TIME);

    private final Map<String, SofasParameters> variants = new LinkedHashMap<>();
    private final Map<String, List<SceneFigures>> scenes = new LinkedHashMap<>();
    private final Map<String, List<RecordingFigures>> recordings = new LinkedHashMap<>();
    private final List<String> failures = new ArrayList<>();
    private final int jobs;

    /**
     * Prepares the variants.
     *
     * @param base parameters in which extensions are switched off
     * @param jobs number of scenes or recordings that are labelled at a time, at least 1
     */
    public Ablation(SofasParameters base, int jobs) {
        this.jobs = jobs;
        variants.put("none", base);
        Extension.all().forEach(extension -> variants.put(extension.name(), extension.off(base)));
        variants.keySet().forEach(name -> {
            scenes.put(name, new ArrayList<>());
            recordings.put(name, new ArrayList<>());
        });
    }

    private static Function<SensorSize, Labelling> maker(SofasParameters parameters) {
        return sensor -> Labelling.atOnce(new Sofas(sensor, parameters));
    }

    /** Labels random scenes of consecutive seeds with every variant. */
    public void random(long fromSeed, int count) throws InterruptedException {
        Map<String, Callable<Map<String, SceneFigures>>> parts = new LinkedHashMap<>();
        for (long seed = fromSeed; seed < fromSeed + count; seed++) {
            SimulationOptions options = SimulationOptions.defaults().withSeed(seed);
            String name = Scene.RANDOM.sceneName() + ":" + seed;
            parts.put(name, () -> {
                SimulatedRecording film = SimulatedRecording.of(Scene.RANDOM, options);
                Map<String, SceneFigures> figures = new LinkedHashMap<>();
                variants.forEach((off, parameters) -> figures.put(off, SceneFigures.of(name, film, maker(parameters))));
                return figures;
            });
        }
        Tables.inOrder(parts, jobs, figures -> figures.forEach((off, scene) -> scenes.get(off).add(scene)), failure -> {
            throw new IllegalStateException(failure);
        });
    }

    /**
     * Labels recordings of real cameras with every variant.
     *
     * @param known best single translations; missing ones are found and added
     * @throws IOException if the folder cannot be listed
     */
    public void recordings(Path folder, KnownTranslations known) throws IOException, InterruptedException {
        Map<String, Callable<Map<String, RecordingFigures>>> parts = new LinkedHashMap<>();
        RealRecordings.in(folder).forEach((file, chip) -> parts.put(file.getFileName().toString(), () -> {
            Map<String, RecordingFigures> figures = new LinkedHashMap<>();
            for (Map.Entry<String, SofasParameters> variant : variants.entrySet()) {
                figures.put(variant.getKey(), RecordingFigures.of(file, chip, maker(variant.getValue()), known));
            }
            return figures;
        }));
        Tables.inOrder(parts, jobs,
            figures -> figures.forEach((off, recording) -> recordings.get(off).add(recording)), failure -> {
                if (!(failure instanceof EventSourceException)) {
                    throw new IllegalStateException(failure);
                }
                failures.add(failure.getMessage());
            });
    }

    /** One line for each recording that could not be read to its end; such a recording does not count. */
    public List<String> failures() {
        return List.copyOf(failures);
    }

    /** Prints the table. */
    public void print(PrintWriter out) {
        boolean filmed = !scenes.get("none").isEmpty();
        boolean recorded = !recordings.get("none").isEmpty();
        StringBuilder header = new StringBuilder(Tables.name("switched-off"));
        if (filmed) {
            COLUMNS.forEach(column -> header.append(Tables.cell(column.title())));
        }
        if (recorded) {
            List.of("sharpness", "med.gain", "worst", "blurred", "flow,%", "segments", "ns/event")
                .forEach(title -> header.append(Tables.cell(title)));
        }
        out.println(header);
        for (String off : variants.keySet()) {
            StringBuilder line = new StringBuilder(Tables.name(off));
            if (filmed) {
                COLUMNS.forEach(column -> line.append(Tables.cell(column.text(column.mean(scenes.get(off))))));
            }
            if (recorded) {
                line.append(real(recordings.get(off)));
            }
            out.println(line);
        }
        out.flush();
    }

    private static String real(List<RecordingFigures> figures) {
        return Tables.cell(3, figures.stream().mapToDouble(each -> each.sharpness().sharpness()).average().orElse(0))
            + Tables.cell(2, RecordingFigures.medianGain(figures)) + Tables.cell(2, RecordingFigures.worstGain(figures))
            + Tables.cell(RecordingFigures.blurred(figures))
            + Tables.cell(1, 100 * figures.stream().mapToDouble(each -> each.sharpness().shareWithFlow()).average()
                .orElse(0))
            + Tables.cell(figures.stream().mapToLong(RecordingFigures::segments).sum())
            + Tables.cell(0, figures.stream().mapToDouble(RecordingFigures::nsPerEvent).average().orElse(0));
    }
}
