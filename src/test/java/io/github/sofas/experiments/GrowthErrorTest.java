package io.github.sofas.experiments;

import static org.junit.Assert.assertEquals;
import static org.junit.Assert.assertTrue;

import io.github.sofas.evaluate.FlowEstimate;
import io.github.sofas.simulate.Scene;
import io.github.sofas.simulate.SimulatedRecording;
import io.github.sofas.simulate.SimulationOptions;
import org.junit.Test;

public class GrowthErrorTest {
    private static final SimulatedRecording NEAR = SimulatedRecording.of(Scene.COMING_NEAR,
        SimulationOptions.defaults().withDurationUs(1_000_000));

    /** The truth, as an estimate that is a factor off. */
    private static FlowEstimate times(float factor, SimulatedRecording film) {
        float[] vx = new float[film.size()];
        float[] vy = new float[film.size()];
        for (int i = 0; i < film.size(); i++) {
            vx[i] = factor * film.vxPxPerS[i] + 30;
            vy[i] = factor * film.vyPxPerS[i] - 20;
        }
        return FlowEstimate.of(vx, vy, film.object.clone());
    }

    @Test
    public void translationDoesNotMatter() {
        assertEquals(0, GrowthError.percent(NEAR, times(1, NEAR)), 1e-3);
    }

    @Test
    public void flowThatIsATenthTooFastGrowsATenthTooFast() {
        assertEquals(10, GrowthError.percent(NEAR, times(1.1f, NEAR)), 1e-3);
        assertEquals(100, GrowthError.percent(NEAR, times(0, NEAR)), 1e-3);
    }

    @Test
    public void whereNothingGrowsThereIsNone() {
        for (Scene scene : new Scene[] {Scene.HEXAGON, Scene.SWINGING_BALL, Scene.SHORT_BAR}) {
            SimulatedRecording film = SimulatedRecording.of(scene,
                SimulationOptions.defaults().withDurationUs(500_000));
            assertTrue(scene.sceneName(), Double.isNaN(GrowthError.percent(film, times(1, film))));
        }
    }
}
