package io.github.sofas.baseline;

import static org.junit.Assert.assertEquals;

import io.github.sofas.baseline.LucasKanade.Derivative;
import io.github.sofas.evaluate.Evaluation;
import io.github.sofas.evaluate.EvaluationOptions;
import io.github.sofas.evaluate.FlowFigures;
import io.github.sofas.flow.EventLabeller;
import io.github.sofas.simulate.Scene;
import io.github.sofas.simulate.SimulatedRecording;
import io.github.sofas.simulate.SimulationOptions;
import org.junit.Test;

/** Holds the methods to what jAER's own filters reach on shapes at 58 px/s; the margins are for other scenes. */
public class BaselineFiguresTest {
    private static final SimulatedRecording RECTANGLES = SimulatedRecording.of(Scene.RECTANGLES,
            SimulationOptions.defaults().withBlurPx(0.3));

    private static FlowFigures figures(EventLabeller method) {
        return Evaluation.of(RECTANGLES, method, EvaluationOptions.defaults()).flow();
    }

    @Test
    public void localPlanesAreRightOnStraightEdges() {
        // jAER: +1 %, 4 %, for 22 to 25 % of the events; ours fire less often a pixel.
        FlowFigures figures = figures(new LocalPlanes(RECTANGLES.sensor()));
        assertEquals(1, figures.magnitudeErrorPercent().mean(), 5);
        assertEquals(4, figures.relativeEndpointErrorPercent().mean(), 3);
        assertEquals(0.33, figures.shareWithFlow(), 0.1);
    }

    @Test
    public void savitzkyGolayIsAThirdTooSlow() {
        // jAER: -34 %, 66 %.
        FlowFigures figures = figures(new LucasKanade(RECTANGLES.sensor()));
        assertEquals(-34, figures.magnitudeErrorPercent().mean(), 10);
        assertEquals(66, figures.relativeEndpointErrorPercent().mean(), 20);
    }

    @Test
    public void centralDifferencesSayLittle() {
        // jAER: -57 %, 110 %.
        FlowFigures figures = figures(new LucasKanade(RECTANGLES.sensor(), Derivative.CENTRAL_DIFFERENCE));
        assertEquals(-70, figures.magnitudeErrorPercent().mean(), 15);
        assertEquals(105, figures.relativeEndpointErrorPercent().mean(), 10);
    }
}
