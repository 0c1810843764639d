package io.github.sofas.experiments;

import io.github.sofas.event.SensorSize;
import io.github.sofas.flow.Labelling;
import io.github.sofas.simulate.Scene;
import io.github.sofas.simulate.SimulatedRecording;
import io.github.sofas.simulate.SimulationOptions;
import java.util.ArrayList;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;
import java.util.concurrent.Callable;
import java.util.function.Consumer;
import java.util.function.Function;

/**
 * The results of the default preset in many random scenes, and in the scenes with texture, growth and flicker, with
 * pictures of the worst random scenes.
 *
 * @param random figures of the random scenes, by increasing seed
 * @param textured figures of the other scenes
 * @param worst the random scenes with the smallest intersection over union, the worst first
 */
record RandomScenes(List<SceneFigures> random, List<SceneFigures> textured, List<Pictured> worst) {
    private static final int PICTURED = 5;
    private static final String SEED_MARK = ":";

    /**
     * A scene with pictures.
     *
     * @param figures its figures
     * @param strip its pictures at four moments
     */
    record Pictured(SceneFigures figures, Strip strip) {
    }

    /**
     * Runs all scenes.
     *
     * @param count number of random scenes, with seeds from 1 on
     * @param jobs number of scenes that run at a time
     * @param longestUs time at which films are cut off, in µs
     * @param progress receives a line whenever a scene is done
     */
    static RandomScenes run(int count, int jobs, long longestUs, Consumer<String> progress)
            throws InterruptedException {
        Function<SensorSize, Labelling> maker =
            sensor -> Labelling.atOnce(ComparedMethod.SOFAS_DEFAULT.make(sensor));
        Map<String, Callable<SceneFigures>> random = new LinkedHashMap<>();
        for (long seed = 1; seed <= count; seed++) {
            TableScene scene = scene(seed);
            random.put(scene.name(), () -> SceneFigures.of(scene.name(), film(scene, longestUs), maker));
        }
        Map<String, Callable<SceneFigures>> textured = new LinkedHashMap<>();
        TableScene.textured().forEach(scene -> textured.put(scene.name(),
            () -> SceneFigures.of(scene.name(), film(scene, longestUs), maker)));
        List<SceneFigures> ofRandom = all(random, jobs, progress);
        List<SceneFigures> ofTextured = all(textured, jobs, progress);
        Map<String, Callable<Pictured>> worst = new LinkedHashMap<>();
        for (SceneFigures figures : SceneFigures.worstFirst(ofRandom).subList(0, Math.min(PICTURED, count))) {
            long seed = Long.parseLong(figures.name().substring(figures.name().indexOf(SEED_MARK) + 1));
            worst.put(figures.name(), () -> {
                SimulatedRecording film = film(scene(seed), longestUs);
                return new Pictured(figures,
                    StripPainter.strip(film, ComparedMethod.SOFAS_DEFAULT.make(film.sensor())));
            });
        }
        return new RandomScenes(ofRandom, ofTextured, all(worst, jobs, pictured -> { }));
    }

    /** Number of scenes that progress reports. */
    static int parts(int count) {
        return count + TableScene.textured().size();
    }

    private static TableScene scene(long seed) {
        return new TableScene(Scene.RANDOM.sceneName() + SEED_MARK + seed, Scene.RANDOM,
            SimulationOptions.defaults().withSeed(seed));
    }

    private static SimulatedRecording film(TableScene scene, long longestUs) {
        long ownUs = scene.scene().durationUs(scene.options());
        return SimulatedRecording.of(scene.scene(),
            ownUs <= longestUs ? scene.options() : scene.options().withDurationUs(longestUs));
    }

    private static <T> List<T> all(Map<String, Callable<T>> parts, int jobs, Consumer<String> progress)
            throws InterruptedException {
        List<T> all = new ArrayList<>();
        List<String> names = List.copyOf(parts.keySet());
        Tables.inOrder(parts, jobs, figures -> {
            progress.accept(names.get(all.size()));
            all.add(figures);
        }, failure -> {
            throw new IllegalStateException(failure);
        });
        return all;
    }

    /** CSV with one line per scene: its name, objects, events and figures. */
    String csv() {
        StringBuilder csv = new StringBuilder("scene,objects,events");
        for (SceneFigures.Column column : SceneFigures.Column.ofResults()) {
            csv.append(",\"").append(column.title()).append('"');
        }
        csv.append('\n');
        List<SceneFigures> all = new ArrayList<>(random);
        all.addAll(textured);
        for (SceneFigures scene : all) {
            csv.append(scene.name()).append(',').append(scene.objects()).append(',')
                .append(scene.evaluation().events());
            for (SceneFigures.Column column : SceneFigures.Column.ofResults()) {
                csv.append(',').append(scene.has(column) ? column.text(column.of(scene)) : "");
            }
            csv.append('\n');
        }
        return csv.toString();
    }
}
