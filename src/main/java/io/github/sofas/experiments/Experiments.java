package io.github.sofas.experiments;

import io.github.sofas.evaluate.Evaluation;
import io.github.sofas.event.EventSourceException;
import io.github.sofas.simulate.SimulatedRecording;
import io.github.sofas.simulate.SimulationOptions;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.Comparator;
import java.util.EnumMap;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;
import java.util.concurrent.ExecutionException;
import java.util.concurrent.ExecutorService;
import java.util.concurrent.Executors;
import java.util.concurrent.Future;
import java.util.concurrent.atomic.AtomicInteger;
import java.util.function.Consumer;

/**
 * The results of the paper's experiments: every method in every setting, metric maps, random scenes, and recordings of
 * real cameras if there are any. {@link #run} runs all experiments, and {@link ExperimentFiles} writes the results.
 */
public final class Experiments {
    private static final int FINE_MAP = 400;
    private static final int COARSE_MAP = 20;
    /** Time span of the events of the metric maps: well inside the film, and long enough for some px of travel. */
    private static final long MAP_FROM_US = 500_000;
    private static final long MAP_UNTIL_US = 600_000;

    private final Map<Setting, Map<ComparedMethod, Trial>> trials = new LinkedHashMap<>();
    private final List<RealExperiment> real = new ArrayList<>();
    private final List<String> missing = new ArrayList<>();
    private final List<String> failures = new ArrayList<>();
    private final int jobs;
    private MetricMap oneObject;
    private MetricMap twoObjects;
    private Picture methodPicture;
    private RandomScenes randomScenes;
    private double seconds;

    private Experiments(int jobs) {
        this.jobs = jobs;
    }

    /**
     * Runs everything.
     *
     * @param recordings folder of recordings of real cameras; null for none
     * @param randomScenes number of random scenes, at least 1
     * @param jobs number of scenes or methods that run at a time, at least 1
     * @param progress receives a line whenever a part is done, from several threads
     * @throws InterruptedException if the thread is interrupted; nothing is left running
     */
    public static Experiments run(Path recordings, int randomScenes, int jobs, Consumer<String> progress)
            throws InterruptedException {
        return run(recordings, randomScenes, jobs, progress, Long.MAX_VALUE);
    }

    /** Runs everything on films that are cut off after a time. */
    static Experiments run(Path recordings, int randomScenes, int jobs, Consumer<String> progress, long longestUs)
            throws InterruptedException {
        long start = System.nanoTime();
        Experiments experiments = new Experiments(jobs);
        Consumer<String> counted = counting(parts(recordings, randomScenes), progress);
        ExecutorService workers = Executors.newFixedThreadPool(jobs);
        try {
            Map<Setting, SimulatedRecording> films = film(workers, longestUs);
            Map<Setting, Map<ComparedMethod, Future<Trial>>> trials = start(films, workers, counted);
            Map<String, Future<RealExperiment>> real = experiments.startReal(recordings, workers, counted);
            Future<MetricMap> one = workers.submit(() -> MetricMap.of(films.get(Setting.HEXAGON), MAP_FROM_US,
                MAP_UNTIL_US, FINE_MAP));
            Future<MetricMap> two = workers.submit(() -> MetricMap.of(films.get(Setting.TWO_OPPOSITE), MAP_FROM_US,
                MAP_UNTIL_US, COARSE_MAP));
            for (Setting setting : Setting.ALL) {
                Map<ComparedMethod, Trial> byMethod = new EnumMap<>(ComparedMethod.class);
                for (Map.Entry<ComparedMethod, Future<Trial>> trial : trials.get(setting).entrySet()) {
                    byMethod.put(trial.getKey(), result(trial.getValue()));
                }
                experiments.trials.put(setting, byMethod);
            }
            experiments.takeReal(real);
            experiments.oneObject = result(one);
            experiments.twoObjects = result(two);
            experiments.methodPicture = MethodPicture.of(films.get(Setting.TWO_OPPOSITE), MAP_FROM_US, MAP_UNTIL_US,
                experiments.twoObjects);
            experiments.randomScenes = RandomScenes.run(randomScenes, jobs, longestUs, counted);
            experiments.seconds = (System.nanoTime() - start) * 1e-9;
            return experiments;
        } finally {
            workers.shutdownNow();
        }
    }

    /** Number of parts that progress reports. */
    static int parts(Path recordings, int randomScenes) {
        int real = 0;
        for (RealExperiments each : RealExperiments.values()) {
            real += recordings != null && Files.isRegularFile(recordings.resolve(each.fileName())) ? 1 : 0;
        }
        return Setting.ALL.size() * ComparedMethod.values().length + real + RandomScenes.parts(randomScenes);
    }

    private static Consumer<String> counting(int parts, Consumer<String> progress) {
        AtomicInteger done = new AtomicInteger();
        return part -> progress.accept(done.incrementAndGet() + " of " + parts + ": " + part);
    }

    private static Map<Setting, SimulatedRecording> film(ExecutorService workers, long longestUs)
            throws InterruptedException {
        Map<Setting, Future<SimulatedRecording>> filming = new LinkedHashMap<>();
        for (Setting setting : Setting.ALL) {
            // a film that is not cut equals that of ./sofas simulate, to the last event
            SimulationOptions options = setting.scene().durationUs(setting.options()) <= longestUs
                ? setting.options() : setting.options().withDurationUs(longestUs);
            filming.put(setting, workers.submit(() -> SimulatedRecording.of(setting.scene(), options)));
        }
        Map<Setting, SimulatedRecording> films = new LinkedHashMap<>();
        for (Map.Entry<Setting, Future<SimulatedRecording>> film : filming.entrySet()) {
            films.put(film.getKey(), result(film.getValue()));
        }
        return films;
    }

    /** Starts with the films with the most events, so that no long film is left to the end. */
    private static Map<Setting, Map<ComparedMethod, Future<Trial>>> start(Map<Setting, SimulatedRecording> films,
            ExecutorService workers, Consumer<String> progress) {
        List<Setting> longestFirst = new ArrayList<>(Setting.ALL);
        longestFirst.sort(Comparator.comparingInt(setting -> -films.get(setting).size()));
        Map<Setting, Map<ComparedMethod, Future<Trial>>> started = new LinkedHashMap<>();
        for (Setting setting : longestFirst) {
            Map<ComparedMethod, Future<Trial>> byMethod = new EnumMap<>(ComparedMethod.class);
            for (ComparedMethod method : ComparedMethod.values()) {
                byMethod.put(method, workers.submit(() -> {
                    Trial trial = Trial.of(setting, films.get(setting), method);
                    progress.accept(setting.title() + ": " + method.title());
                    return trial;
                }));
            }
            started.put(setting, byMethod);
        }
        return started;
    }

    private Map<String, Future<RealExperiment>> startReal(Path recordings, ExecutorService workers,
                                                          Consumer<String> progress) {
        Map<String, Future<RealExperiment>> started = new LinkedHashMap<>();
        for (RealExperiments each : RealExperiments.values()) {
            if (recordings == null || !Files.isRegularFile(recordings.resolve(each.fileName()))) {
                missing.add(each.fileName());
                continue;
            }
            started.put(each.fileName(), workers.submit(() -> {
                RealExperiment experiment = each.on(recordings.resolve(each.fileName()));
                progress.accept(each.fileName());
                return experiment;
            }));
        }
        return started;
    }

    private void takeReal(Map<String, Future<RealExperiment>> started) throws InterruptedException {
        for (Future<RealExperiment> each : started.values()) {
            try {
                real.add(each.get());
            } catch (ExecutionException e) {
                if (!(e.getCause() instanceof EventSourceException)) {
                    throw new IllegalStateException(e.getCause());
                }
                failures.add(e.getCause().getMessage());
            }
        }
    }

    /** Waits for the result of a part that can fail only through a fault of the program. */
    private static <T> T result(Future<T> future) throws InterruptedException {
        try {
            return future.get();
        } catch (ExecutionException e) {
            throw new IllegalStateException(e.getCause());
        }
    }

    /** One line for each recording that could not be read to its end; nothing else is reported about it. */
    public List<String> failures() {
        return List.copyOf(failures);
    }

    /** Duration of the whole run, in s. */
    public double seconds() {
        return seconds;
    }

    /** Number of scenes or methods that ran at a time. */
    int jobs() {
        return jobs;
    }

    /** The result of a method in a setting. */
    Trial trial(Setting setting, ComparedMethod method) {
        return trials.get(setting).get(method);
    }

    /** The goals of the default preset and what it reached, by the setting's title or the recording's file name. */
    Map<String, List<Goal.Check>> checksByScene() {
        Map<String, List<Goal.Check>> byScene = new LinkedHashMap<>();
        trials.forEach((setting, byMethod) -> {
            Map<ComparedMethod, Evaluation> evaluations = new EnumMap<>(ComparedMethod.class);
            byMethod.forEach((method, trial) -> evaluations.put(method, trial.evaluation()));
            byScene.put(setting.title(), setting.goals().stream().map(goal -> goal.check(evaluations)).toList());
        });
        real.forEach(each -> byScene.put(each.file(), each.checks()));
        return byScene;
    }

    /** The results of the default preset in random and textured scenes. */
    RandomScenes randomScenes() {
        return randomScenes;
    }

    /** Metrics of one moving object, 400 x 400 projections. */
    MetricMap oneObject() {
        return oneObject;
    }

    /** Metrics of two opposite movers, 20 x 20 projections. */
    MetricMap twoObjects() {
        return twoObjects;
    }

    /** The method at work on two opposite movers. */
    Picture methodPicture() {
        return methodPicture;
    }

    /** The results of the recordings of real cameras that were found. */
    List<RealExperiment> real() {
        return real;
    }

    /** File names of the recordings that were not found; all of them if no folder was given. */
    List<String> missing() {
        return missing;
    }
}
