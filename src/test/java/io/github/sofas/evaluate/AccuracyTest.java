package io.github.sofas.evaluate;

import static org.junit.Assert.assertEquals;
import static org.junit.Assert.assertTrue;

import io.github.sofas.event.SensorSize;
import io.github.sofas.flow.Sofas;
import io.github.sofas.flow.SofasParameters;
import io.github.sofas.simulate.Scene;
import io.github.sofas.simulate.SimulatedRecording;
import io.github.sofas.simulate.SimulationOptions;
import java.util.List;
import java.util.Locale;
import java.util.stream.IntStream;
import org.junit.Test;

/**
 * What the presets promise on simulated scenes, after the first 15 %: no more than twice the errors that are reached,
 * so that a change which costs accuracy shows. Each figure is the mean over seeds that nothing was tuned on.
 */
public class AccuracyTest {
    private static final SimulationOptions PLAIN = SimulationOptions.defaults();
    private static final SofasParameters DEFAULTS = SofasParameters.defaults();
    private static final long FIRST_SEED = 7001;
    private static final int SEEDS = 4;
    /** The same where a scene's objects are told apart or not, by chance: 8 of 12 have an IoU above 0.8. */
    private static final int SEEDS_BY_CHANCE = 12;
    /** Errors as small as these are not told apart: % of the velocity, of the events, of the area, of a part. */
    private static final double LEAST = 0.2;

    /**
     * Errors: relative endpoint error in %, object events without flow in %, what lacks of an intersection over union
     * of 1 in %, parts of an object beyond the first in %.
     */
    private record Errors(double velocity, double withoutFlow, double area, double parts) {
        private static Errors of(List<Evaluation> evaluations) {
            Errors sum = new Errors(0, 0, 0, 0);
            for (Evaluation evaluation : evaluations) {
                SegmentationFigures segments = evaluation.segmentation();
                sum = sum.plus(evaluation.flow().relativeEndpointErrorPercent().mean(),
                    100 * (1 - evaluation.flow().shareWithFlow()), 100 * (1 - segments.meanIou()),
                    100 * (segments.partsPerObject() - 1));
            }
            int seeds = evaluations.size();
            return new Errors(sum.velocity / seeds, sum.withoutFlow / seeds, sum.area / seeds, sum.parts / seeds);
        }

        private Errors plus(double v, double w, double a, double p) {
            return new Errors(velocity + v, withoutFlow + w, area + a, parts + p);
        }

        private boolean isWithinTwice(Errors reached) {
            return velocity <= bound(reached.velocity) && withoutFlow <= bound(reached.withoutFlow)
                && area <= bound(reached.area) && parts <= bound(reached.parts);
        }

        private static double bound(double reached) {
            return 2 * Math.max(LEAST, reached);
        }

        @Override
        public String toString() {
            return String.format(Locale.ROOT, "%.2f, %.2f, %.2f, %.2f", velocity, withoutFlow, area, parts);
        }
    }

    private static Evaluation evaluate(Scene scene, SimulationOptions options, SofasParameters parameters) {
        return Evaluation.of(SimulatedRecording.of(scene, options), new Sofas(options.sensor(), parameters),
            EvaluationOptions.defaults());
    }

    /** Evaluates one film per seed, on all cores, because no other test class takes as long. */
    private static List<Evaluation> evaluations(Scene scene, SimulationOptions options, SofasParameters parameters,
                                                int seeds) {
        return IntStream.range(0, seeds).parallel()
            .mapToObj(i -> evaluate(scene, options.withSeed(FIRST_SEED + i), parameters)).toList();
    }

    private static void assertReaches(Scene scene, SimulationOptions options, SofasParameters parameters,
                                      double velocity, double withoutFlow, double area, double parts) {
        assertReaches(scene, evaluations(scene, options, parameters, SEEDS),
            new Errors(velocity, withoutFlow, area, parts));
    }

    private static void assertReaches(Scene scene, List<Evaluation> evaluations, Errors reached) {
        Errors errors = Errors.of(evaluations);
        String message = scene.sceneName() + ": errors " + errors + "; reached were " + reached;
        assertTrue(message, errors.isWithinTwice(reached));
    }

    private static void assertReaches(Scene scene, SimulationOptions options, double velocity, double withoutFlow,
                                      double area, double parts) {
        assertReaches(scene, options, DEFAULTS, velocity, withoutFlow, area, parts);
    }

    @Test
    public void shapesOfThePaperAreRightToHalfAPercent() {
        assertReaches(Scene.HEXAGON, PLAIN, 0.22, 0.00, 0.37, 0.00);
        assertReaches(Scene.LARGE_CIRCLE, PLAIN, 0.19, 0.02, 0.52, 0.00);
        assertReaches(Scene.SMALL_CIRCLE, PLAIN, 0.63, 0.00, 0.57, 0.00);
        assertReaches(Scene.RECTANGLES, PLAIN, 0.59, 0.00, 0.48, 0.00);
    }

    @Test
    public void directionDoesNotMatter() {
        assertReaches(Scene.HEXAGON, PLAIN.withDirectionDeg(35), 0.30, 0.00, 0.53, 0.00);
        assertReaches(Scene.RECTANGLES, PLAIN.withDirectionDeg(200), 0.58, 0.00, 0.56, 0.00);
        // edges along rows and columns, that move across them: what is measured of them may begin within a pixel
        assertReaches(Scene.HEXAGON, PLAIN.withDirectionDeg(127), 0.84, 0.53, 1.23, 0.00);
        assertReaches(Scene.HEXAGON, PLAIN.withDirectionDeg(74), 0.67, 0.22, 0.76, 0.00);
        assertReaches(Scene.RECTANGLES, PLAIN.withDirectionDeg(67), 0.81, 0.00, 0.62, 0.00);
    }

    @Test
    public void slowAndFastAreAsRight() {
        assertReaches(Scene.HEXAGON, PLAIN.withSpeedPxPerS(5.8), 0.85, 0.00, 3.60, 0.00);
        assertReaches(Scene.HEXAGON, PLAIN.withSpeedPxPerS(289), 0.24, 0.00, 0.09, 0.00);
    }

    @Test
    public void whatFiresFewEventsIsAsRight() {
        // a thousand events a second, so that the search's lifetime of 5 px holds fifty
        SimulationOptions faint = PLAIN.withContrast(0.4).withSpeedPxPerS(110);
        assertReaches(Scene.SMALL_CIRCLE, faint.withDirectionDeg(148), 1.22, 0.00, 0.69, 0.00);
        assertReaches(Scene.SMALL_CIRCLE, faint.withDirectionDeg(208), 1.47, 0.00, 0.60, 0.00);
    }

    @Test
    public void noiseAndHotPixelsGetNoFlow() {
        SimulationOptions noisy = PLAIN.withDvs(PLAIN.dvs().withNoiseHzPerPx(1).withHotPixels(20, 100));
        assertReaches(Scene.HEXAGON, noisy, 0.22, 0.00, 4.86, 0.00);
        assertTrue(evaluate(Scene.HEXAGON, noisy, DEFAULTS).noiseShareWithFlow() <= 0.1);
        assertEquals(0, evaluate(Scene.NOISE, PLAIN, DEFAULTS).noiseShareWithFlow(), 0);
    }

    @Test
    public void inTheDarkMoversDoNotTakeTheNoise() {
        // five events a second of each pixel, of which the movers would take a third and more
        SimulationOptions dark = PLAIN.withDvs(PLAIN.dvs().withNoiseHzPerPx(5));
        assertReachesInTheDark(Scene.TWO_OPPOSITE, dark, SEEDS, new Errors(0.24, 0.02, 8.37, 0.00));
        // there the rectangle's edges cut the circle in two by chance
        assertReachesInTheDark(Scene.PASSING_BEHIND, dark, SEEDS_BY_CHANCE, new Errors(6.51, 1.89, 28.32, 18.35));
    }

    private static void assertReachesInTheDark(Scene scene, SimulationOptions dark, int seeds, Errors reached) {
        List<Evaluation> evaluations = evaluations(scene, dark, DEFAULTS, seeds);
        assertReaches(scene, evaluations, reached);
        for (Evaluation evaluation : evaluations) {
            assertTrue(scene.sceneName(), evaluation.noiseShareWithFlow() <= 0.03);
        }
    }

    @Test
    public void otherSensorsAndSizesAreAsRight() {
        SimulationOptions davis346 = PLAIN.withSensor(new SensorSize(346, 260));
        assertReaches(Scene.HEXAGON, davis346.withScale(2).withContrast(0.4).withDirectionDeg(60).withSpeedPxPerS(40),
            0.49, 0.00, 1.18, 0.00);
        assertReaches(Scene.LARGE_CIRCLE, davis346.withDirectionDeg(170).withSpeedPxPerS(600), 0.24, 0.00, 0.05, 0.00);
    }

    @Test
    public void manyMoversAreOneSegmentEach() {
        assertReaches(Scene.TWO_OPPOSITE, PLAIN, 0.24, 0.00, 0.37, 0.00);
        assertReaches(Scene.SIXTEEN, PLAIN, 0.78, 0.74, 6.60, 13.56);
    }

    @Test
    public void moversWhoseSpeedsDifferByATenthStayTwo() {
        assertReaches(Scene.SIXTEEN, PLAIN.withDirectionDeg(240), 2.24, 6.55, 23.77, 3.25);
        assertReaches(Scene.SIXTEEN, PLAIN.withDirectionDeg(300), 2.07, 6.82, 20.85, 2.95);
    }

    @Test
    public void pendulumLosesNoVelocityToItsAcceleration() {
        // the velocity of the middle of the window would lag by 25 px/s: a mean error of 7 % of the peak
        assertReaches(Scene.PENDULUM, PLAIN, 6.65, 0.03, 0.81, 0.85);
    }

    @Test
    public void rotatingBarIsOneSegmentThatTurns() {
        assertReaches(Scene.SHORT_BAR, PLAIN, 2.33, 0.00, 0.30, 0.00);
    }

    @Test
    public void moversThatCrossOrHideEachOtherKeepTheirSegments() {
        assertReaches(Scene.THREE_CROSSING, PLAIN, 8.11, 0.52, 8.57, 27.78);
        assertReaches(Scene.FOUR_BARS, PLAIN, 3.90, 0.35, 12.89, 17.49);
        assertReaches(Scene.PASSING_BEHIND, PLAIN, 1.93, 0.18, 5.56, 11.83);
    }

    @Test
    public void shapesSideBySideThatPartSlowlyAreTwo() {
        assertReaches(Scene.SIDE_BY_SIDE, evaluations(Scene.SIDE_BY_SIDE, PLAIN, DEFAULTS, SEEDS_BY_CHANCE),
            new Errors(4.86, 0.16, 17.66, 24.40));
    }

    @Test
    public void whatComesNearOrGoesAwayIsOneSegment() {
        // found as edges or corners, each of which moves straight
        assertReaches(Scene.COMING_NEAR, PLAIN.withScale(1.5).withDirectionDeg(52), 4.67, 2.01, 17.67, 15.08);
        assertReaches(Scene.GOING_AWAY, PLAIN, 12.65, 0.00, 3.54, 2.60);
    }

    @Test
    public void edgesThatAreAllButParallelAreNotTakenForOneThatSlidesAlongThem() {
        assertReaches(Scene.FOUR_BARS, PLAIN.withDirectionDeg(67), 8.68, 0.84, 13.40, 16.84);
        assertReaches(Scene.FOUR_BARS, PLAIN.withDirectionDeg(307), 5.85, 1.02, 13.39, 21.00);
    }

    @Test
    public void publishedMethodIsAsRightAsItCanBe() {
        SofasParameters paper = SofasParameters.paper();
        assertReaches(Scene.HEXAGON, PLAIN, paper, 4.96, 2.71, 2.85, 0.00);
        assertReaches(Scene.LARGE_CIRCLE, PLAIN, paper, 5.96, 7.93, 8.25, 0.00);
        assertReaches(Scene.TWO_OPPOSITE, PLAIN, paper, 5.54, 4.50, 4.43, 0.00);
    }
}
