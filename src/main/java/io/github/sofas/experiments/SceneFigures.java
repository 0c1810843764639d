package io.github.sofas.experiments;

import io.github.sofas.evaluate.Evaluation;
import io.github.sofas.evaluate.EvaluationOptions;
import io.github.sofas.evaluate.FlowEstimate;
import io.github.sofas.evaluate.GroundTruth;
import io.github.sofas.event.SensorSize;
import io.github.sofas.flow.Labelling;
import io.github.sofas.simulate.Scene;
import io.github.sofas.simulate.SimulatedRecording;
import io.github.sofas.simulate.SimulationOptions;
import java.util.Arrays;
import java.util.Comparator;
import java.util.List;
import java.util.Locale;
import java.util.function.Function;
import java.util.function.ToDoubleFunction;

/**
 * The results of a method in one scene, with the figures by which scenes are compared.
 *
 * @param name name of the scene
 * @param objects number of objects in the scene
 * @param evaluation all figures of the evaluation
 * @param growthErrorPercent see {@link GrowthError}; NaN where nothing grows
 * @param nsPerEvent processor time of the method per event, in ns
 */
record SceneFigures(String name, int objects, Evaluation evaluation, double growthErrorPercent, double nsPerEvent) {
    /** A figure by which scenes are compared. */
    enum Column {
        /** Mean intersection over union. */
        IOU("IoU", 3, true, scene -> scene.evaluation.segmentation().meanIou()),
        /** Parts per object. */
        PARTS("parts", 2, false, scene -> scene.evaluation.segmentation().partsPerObject()),
        /** Mean relative endpoint error in %; 100 if no event has flow. */
        ERROR("rEE,%", 1, false, scene -> scene.evaluation.flow().eventsWithFlow() == 0 ? 100
            : scene.evaluation.flow().relativeEndpointErrorPercent().mean()),
        /** Share of the object events that have flow, in %. */
        COVERAGE("flow,%", 1, true, scene -> 100 * scene.evaluation.flow().shareWithFlow()),
        /** Share of the events with flow that are more than twice as fast as any true motion, in %. */
        RUNAWAYS("fast,%", 2, false, scene -> 100 * scene.evaluation.flow().runawayShare()),
        /** Share of the noise events that have flow, in %. */
        NOISE("noise,%", 1, false, scene -> 100 * scene.evaluation.noiseShareWithFlow()),
        /** Error of the growth rate in %. */
        GROWTH("growth,%", 1, false, scene -> scene.growthErrorPercent),
        /** Processor time of the method per event, in ns. */
        TIME("ns/event", 0, false, scene -> scene.nsPerEvent);

        private final String title;
        private final int decimals;
        private final boolean moreIsBetter;
        private final ToDoubleFunction<SceneFigures> value;

        Column(String title, int decimals, boolean moreIsBetter, ToDoubleFunction<SceneFigures> value) {
            this.title = title;
            this.decimals = decimals;
            this.moreIsBetter = moreIsBetter;
            this.value = value;
        }

        /** All columns but the time, which differs from run to run. */
        static List<Column> ofResults() {
            return Arrays.stream(values()).filter(column -> column != TIME).toList();
        }

        String title() {
            return title;
        }

        double of(SceneFigures scene) {
            return value.applyAsDouble(scene);
        }

        /** Text of a figure in tables; a dash if there is no figure. */
        String text(double figure) {
            return Double.isNaN(figure) ? "-" : String.format(Locale.ROOT, "%." + decimals + "f", figure);
        }

        /** Mean over the scenes that have the figure. */
        double mean(List<SceneFigures> scenes) {
            return scenes.stream().filter(scene -> scene.has(this)).mapToDouble(this::of).average().orElse(Double.NaN);
        }

        /** The figure of the best scene of the worst tenth: a tenth of the scenes is no better. */
        double worstTenth(List<SceneFigures> scenes) {
            double[] sorted = worstFirst(scenes);
            return sorted.length == 0 ? Double.NaN : sorted[Math.max(0, (int) Math.ceil(0.1 * sorted.length) - 1)];
        }

        double worst(List<SceneFigures> scenes) {
            double[] sorted = worstFirst(scenes);
            return sorted.length == 0 ? Double.NaN : sorted[0];
        }

        private double[] worstFirst(List<SceneFigures> scenes) {
            double sign = moreIsBetter ? 1 : -1;
            double[] sorted = scenes.stream().filter(scene -> scene.has(this)).mapToDouble(scene -> sign * of(scene))
                .sorted().toArray();
            return Arrays.stream(sorted).map(figure -> sign * figure).toArray();
        }
    }

    /** Films a scene, labels the film by a method and evaluates the labels. */
    static SceneFigures of(String name, Scene scene, SimulationOptions options,
                           Function<SensorSize, Labelling> maker) {
        return of(name, SimulatedRecording.of(scene, options), maker);
    }

    static SceneFigures of(String name, SimulatedRecording film, Function<SensorSize, Labelling> maker) {
        CpuTime method = new CpuTime(maker.apply(film.sensor()));
        FlowEstimate estimate = FlowEstimate.of(film, method);
        Evaluation evaluation = Evaluation.of(GroundTruth.of(film), estimate, EvaluationOptions.defaults());
        return new SceneFigures(name, film.objects(), evaluation, GrowthError.percent(film, estimate),
            method.nsPerEvent());
    }

    /** The scenes with the smallest intersection over union first. */
    static List<SceneFigures> worstFirst(List<SceneFigures> scenes) {
        return scenes.stream().sorted(Comparator.comparingDouble(Column.IOU::of)).toList();
    }

    /** Whether the figure is meaningful: a scene of noise alone has no object, and most scenes have no growth. */
    boolean has(Column column) {
        if (column == Column.GROWTH) {
            return !Double.isNaN(growthErrorPercent);
        }
        return column == Column.NOISE || column == Column.TIME || evaluation.flow().events() > 0;
    }
}
