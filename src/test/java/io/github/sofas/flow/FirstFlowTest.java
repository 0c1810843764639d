package io.github.sofas.flow;

import static org.junit.Assert.assertTrue;

import io.github.sofas.evaluate.Evaluation;
import io.github.sofas.evaluate.EvaluationOptions;
import io.github.sofas.simulate.Scene;
import io.github.sofas.simulate.SimulatedRecording;
import io.github.sofas.simulate.SimulationOptions;
import io.github.sofas.simulate.Surface;
import java.util.Random;
import org.junit.Test;

/**
 * How early texture has flow: over the first 10 px of travel of a wall, of any speed and contrast. Figures are means of
 * six walls that nothing was tuned on.
 */
public class FirstFlowTest {
    private static final double TRAVEL_PX = 10;
    private static final int WALLS = 6;
    private static final int FIRST_SEED = 7001;

    private static void assertHasFlow(Surface surface, double leastShare, double mostErrorPercent) {
        double share = 0;
        double error = 0;
        for (int seed = FIRST_SEED; seed < FIRST_SEED + WALLS; seed++) {
            Random random = new Random(seed);
            double speed = 30 * Math.pow(30, random.nextDouble());
            SimulationOptions options = SimulationOptions.defaults().withSeed(seed).withSurface(surface)
                .withSpeedPxPerS(speed).withDirectionDeg(360 * random.nextDouble())
                .withTexture(0.25 + 0.5 * random.nextDouble()).withDurationUs((long) (TRAVEL_PX / speed * 1e6));
            Evaluation wall = Evaluation.of(SimulatedRecording.of(Scene.TEXTURED_PAN, options),
                new Sofas(options.sensor(), SofasParameters.defaults()),
                EvaluationOptions.defaults().withSkipFirstShare(0));
            share += wall.flow().shareWithFlow() / WALLS;
            error += wall.flow().relativeEndpointErrorPercent().mean() / WALLS;
        }
        assertTrue(surface + ": share with flow " + share, share >= leastShare);
        assertTrue(surface + ": relative endpoint error " + error + " %", error <= mostErrorPercent);
    }

    @Test
    public void wallOfLeavesHasFlowForHalfOfItsFirstTenPixels() {
        assertHasFlow(Surface.LEAVES, 0.5, 10);
    }

    @Test
    public void wallOfSmoothNoiseHasFlowForHalfOfItsFirstTenPixels() {
        assertHasFlow(Surface.SMOOTH, 0.5, 24);
    }

    @Test
    public void wallOfFractalNoiseHasFlowForHalfOfItsFirstTenPixels() {
        assertHasFlow(Surface.FRACTAL, 0.5, 14);
    }
}
