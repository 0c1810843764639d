package io.github.sofas.experiments;

import static org.junit.Assert.assertEquals;

import io.github.sofas.evaluate.Evaluation;
import io.github.sofas.evaluate.EvaluationOptions;
import io.github.sofas.evaluate.FlowEstimate;
import io.github.sofas.evaluate.GroundTruth;
import io.github.sofas.experiments.SceneFigures.Column;
import java.util.ArrayList;
import java.util.Arrays;
import java.util.List;
import org.junit.Test;

public class SceneFiguresTest {
    /** A hundred events at 100 px/s; so many of them have flow, which is so many px/s too fast. */
    private static SceneFigures scene(int withFlow, float tooFast) {
        int n = 100;
        long[] timeUs = new long[n];
        float[] vx = new float[n];
        float[] estimated = new float[n];
        int[] object = new int[n];
        int[] segment = new int[n];
        for (int i = 0; i < n; i++) {
            timeUs[i] = 100L * i;
            vx[i] = 100;
            object[i] = 1;
            estimated[i] = 100 + tooFast;
            segment[i] = i < withFlow ? 1 : 0;
        }
        Evaluation evaluation = Evaluation.of(new GroundTruth(timeUs, vx, new float[n], object),
            FlowEstimate.of(estimated, new float[n], segment), EvaluationOptions.defaults().withSkipFirstShare(0));
        return new SceneFigures("scene", 1, evaluation, Double.NaN, 500);
    }

    @Test
    public void theWorstTenthIsWhatATenthIsNoBetterThan() {
        List<SceneFigures> scenes = new ArrayList<>();
        // Coverage and, as one segment has them all, IoU of 80 to 99 %; errors of 0 to 19 %.
        for (int k = 0; k < 20; k++) {
            scenes.add(scene(80 + k, k));
        }
        // Two of twenty are a tenth.
        assertEquals(81, Column.COVERAGE.worstTenth(scenes), 1e-9);
        assertEquals(0.81, Column.IOU.worstTenth(scenes), 1e-9);
        assertEquals(18, Column.ERROR.worstTenth(scenes), 1e-9);
        assertEquals(80, Column.COVERAGE.worst(scenes), 1e-9);
        assertEquals(19, Column.ERROR.worst(scenes), 1e-9);
        assertEquals(9.5, Column.ERROR.mean(scenes), 1e-9);
        assertEquals(0.8, Column.IOU.of(SceneFigures.worstFirst(scenes).get(0)), 1e-9);
    }

    @Test
    public void aSceneWithoutFlowIsWhollyWrong() {
        assertEquals(100, Column.ERROR.of(scene(0, 0)), 0);
        assertEquals(0, Column.IOU.of(scene(0, 0)), 0);
    }

    @Test
    public void ofASceneWithoutObjectsOnlyNoiseAndTimeMeanSomething() {
        Evaluation noise = Evaluation.of(new GroundTruth(new long[1], new float[1], new float[1], new int[1]),
            FlowEstimate.of(new float[1], new float[1], new int[1]), EvaluationOptions.defaults());
        SceneFigures scene = new SceneFigures("noise", 0, noise, Double.NaN, 1);
        assertEquals(List.of(Column.NOISE, Column.TIME), Arrays.stream(Column.values()).filter(scene::has).toList());
    }
}
