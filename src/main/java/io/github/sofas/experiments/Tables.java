package io.github.sofas.experiments;

import io.github.sofas.evaluate.KnownTranslations;
import io.github.sofas.event.EventSourceException;
import io.github.sofas.event.SensorSize;
import io.github.sofas.experiments.SceneFigures.Column;
import io.github.sofas.flow.Labelling;
import io.github.sofas.simulate.Scene;
import io.github.sofas.simulate.SimulationOptions;
import java.io.IOException;
import java.io.PrintWriter;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Locale;
import java.util.Map;
import java.util.concurrent.Callable;
import java.util.concurrent.ExecutionException;
import java.util.concurrent.ExecutorService;
import java.util.concurrent.Executors;
import java.util.concurrent.Future;
import java.util.function.Consumer;
import java.util.function.Function;

/**
 * Prints the figures of one method in many scenes and recordings, as tables of text. A table has one line per scene or
 * recording, printed as soon as that one and all before it are done, and then lines of means. Columns are separated by
 * spaces, so that a script can read them. Everything but the times is independent of the number of jobs.
 */
public final class Tables {
    private static final int NAME_WIDTH = 28;
    private static final int WIDTH = 10;
    private static final String NONE = "-";

    private final Function<SensorSize, Labelling> method;
    private final int jobs;
    private final PrintWriter out;

    /**
     * Prepares the tables.
     *
     * @param method makes the method for a sensor
     * @param jobs number of scenes or recordings that are labelled at a time, at least 1
     * @param out receives the lines
     */
    public Tables(Function<SensorSize, Labelling> method, int jobs, PrintWriter out) {
        this.method = method;
        this.jobs = jobs;
        this.out = out;
    }

    /** Prints random scenes of consecutive seeds, then the mean, the best of the worst tenth, and the worst. */
    public void random(long fromSeed, int count) throws InterruptedException {
        Map<String, Callable<SceneFigures>> parts = new LinkedHashMap<>();
        for (long seed = fromSeed; seed < fromSeed + count; seed++) {
            SimulationOptions options = SimulationOptions.defaults().withSeed(seed);
            String name = Scene.RANDOM.sceneName() + ":" + seed;
            parts.put(name, () -> SceneFigures.of(name, Scene.RANDOM, options, method));
        }
        scenes(parts);
    }

    /** Prints every scene whose figures are known to differ from method to method. */
    public void scenes() throws InterruptedException {
        Map<String, Callable<SceneFigures>> parts = new LinkedHashMap<>();
        for (TableScene scene : TableScene.all()) {
            parts.put(scene.name(), () -> SceneFigures.of(scene.name(), scene.scene(), scene.options(), method));
        }
        scenes(parts);
    }

    private void scenes(Map<String, Callable<SceneFigures>> parts) throws InterruptedException {
        StringBuilder header = new StringBuilder(name("scene")).append(cell("objects")).append(cell("events"));
        for (Column column : Column.values()) {
            header.append(cell(column.title()));
        }
        out.println(header);
        List<SceneFigures> all = new ArrayList<>();
        inOrder(parts, jobs, figures -> {
            StringBuilder line = new StringBuilder(name(figures.name())).append(cell(figures.objects()))
                .append(cell(figures.evaluation().events()));
            for (Column column : Column.values()) {
                line.append(cell(figures.has(column) ? column.text(column.of(figures)) : NONE));
            }
            out.println(line);
            out.flush();
            all.add(figures);
        }, failure -> {
            throw new IllegalStateException(failure);
        });
        List<SceneFigures> withObjects = all.stream().filter(figures -> figures.has(Column.IOU)).toList();
        if (!withObjects.isEmpty()) {
            summary("mean", column -> column.mean(withObjects));
            summary("worst-tenth", column -> column.worstTenth(withObjects));
            summary("worst", column -> column.worst(withObjects));
        }
        out.println();
        out.flush();
    }

    private void summary(String title, Function<Column, Double> figure) {
        StringBuilder line = new StringBuilder(name(title)).append(cell("")).append(cell(""));
        for (Column column : Column.values()) {
            line.append(cell(column.text(figure.apply(column))));
        }
        out.println(line);
    }

    /**
     * Prints recordings of real cameras: the sharpness, that of the best single translation, and the gain.
     *
     * @param folder the folder of the recordings
     * @param known best single translations; missing ones are found and added
     * @return one line for each recording that could not be read to its end; such a recording is not in the table
     * @throws IOException if the folder cannot be listed
     */
    public List<String> recordings(Path folder, KnownTranslations known) throws IOException, InterruptedException {
        Map<String, Callable<RecordingFigures>> parts = new LinkedHashMap<>();
        RealRecordings.in(folder).forEach((file, chip) -> parts.put(file.getFileName().toString(),
            () -> RecordingFigures.of(file, chip, method, known)));
        out.println(name("recording") + cell("events") + cell("windows") + cell("sharpness") + cell("single")
            + cell("gain") + cell("flow,%") + cell("segments") + cell("ns/event"));
        List<RecordingFigures> all = new ArrayList<>();
        List<String> failures = new ArrayList<>();
        inOrder(parts, jobs, figures -> {
            out.println(name(figures.name()) + cell(figures.sharpness().events())
                + cell(figures.sharpness().windows().size()) + cell(3, figures.sharpness().sharpness())
                + cell(3, figures.sharpness().translationSharpness())
                + (figures.sharpness().hasGain() ? cell(2, figures.sharpness().gain()) : cell("-"))
                + cell(1, 100 * figures.sharpness().shareWithFlow()) + cell(figures.segments())
                + cell(0, figures.nsPerEvent()));
            out.flush();
            all.add(figures);
        }, failure -> {
            if (!(failure instanceof EventSourceException)) {
                throw new IllegalStateException(failure);
            }
            failures.add(failure.getMessage());
        });
        out.println(String.format(Locale.ROOT, "%d recordings: median gain %.2f, worst %.2f; %d blurred", all.size(),
            RecordingFigures.medianGain(all), RecordingFigures.worstGain(all), RecordingFigures.blurred(all)));
        out.println();
        out.flush();
        return failures;
    }

    /** Runs parts in parallel, and passes on their results, or the causes of their failure, in order. */
    static <T> void inOrder(Map<String, Callable<T>> parts, int jobs, Consumer<T> done,
                            Consumer<Throwable> failed) throws InterruptedException {
        ExecutorService workers = Executors.newFixedThreadPool(jobs);
        try {
            List<Future<T>> futures = new ArrayList<>();
            parts.values().forEach(part -> futures.add(workers.submit(part)));
            for (int i = 0; i < futures.size(); i++) {
                try {
                    done.accept(futures.get(i).get());
                } catch (ExecutionException e) {
                    failed.accept(e.getCause());
                }
                // The figures of a film are no longer needed, and there are many of them.
                futures.set(i, null);
            }
        } finally {
            workers.shutdownNow();
        }
    }

    static String name(String text) {
        return String.format(Locale.ROOT, "%-" + NAME_WIDTH + "s", text);
    }

    static String cell(String text) {
        return String.format(Locale.ROOT, " %" + (WIDTH - 1) + "s", text);
    }

    static String cell(long number) {
        return cell(Long.toString(number));
    }

    static String cell(int decimals, double number) {
        return cell(String.format(Locale.ROOT, "%." + decimals + "f", number));
    }
}
