package io.github.sofas.evaluate;

import static org.junit.Assert.assertEquals;
import static org.junit.Assert.assertThrows;

import org.junit.Test;

public class EvaluationTest {
    private static final EvaluationOptions ALL = EvaluationOptions.defaults().withSkipFirstShare(0);

    /** Events a millisecond apart, all of one truth. */
    private static GroundTruth truth(float vx, float vy, int... object) {
        long[] timeUs = new long[object.length];
        float[] vxs = new float[object.length];
        float[] vys = new float[object.length];
        for (int i = 0; i < object.length; i++) {
            timeUs[i] = 1000L * i;
            vxs[i] = object[i] == 0 ? 0 : vx;
            vys[i] = object[i] == 0 ? 0 : vy;
        }
        return new GroundTruth(timeUs, vxs, vys, object);
    }

    private static int[] repeat(int value, int count) {
        int[] values = new int[count];
        java.util.Arrays.fill(values, value);
        return values;
    }

    private static int[] join(int[]... pieces) {
        return java.util.Arrays.stream(pieces).flatMapToInt(java.util.Arrays::stream).toArray();
    }

    private static FlowEstimate labels(int... segment) {
        return FlowEstimate.of(new float[segment.length], new float[segment.length], segment);
    }

    @Test
    public void measuresMagnitudeSignedAndEndpointErrorAgainstTheTrueSpeed() {
        // True (50, 0). Estimates (55, 0), (40, 0) and none: +10 %, -20 %; endpoint 5 and 10 px/s, 10 and 20 %.
        GroundTruth truth = truth(50, 0, 1, 1, 1);
        FlowEstimate estimate = FlowEstimate.of(new float[] {55, 40, 0}, new float[3], new int[] {4, 4, 0});
        FlowFigures flow = Evaluation.of(truth, estimate, ALL).flow();
        assertEquals(3, flow.events());
        assertEquals(2, flow.eventsWithFlow());
        assertEquals(2.0 / 3, flow.shareWithFlow(), 1e-12);
        assertEquals(-5, flow.magnitudeErrorPercent().mean(), 1e-9);
        // ((10 + 5)² + (-20 + 5)²) / (2 - 1) = 450
        assertEquals(Math.sqrt(450), flow.magnitudeErrorPercent().sd(), 1e-9);
        assertEquals(7.5, flow.endpointErrorPxPerS().mean(), 1e-9);
        assertEquals(15, flow.relativeEndpointErrorPercent().mean(), 1e-9);
        assertEquals(15, flow.endpointErrorPercentOfPeak(), 1e-9);
        assertEquals(0, flow.outliers());
        assertEquals(1, flow.relativeOutlierShare(), 0);
    }

    @Test
    public void turnsClockwiseOnScreenArePositive() {
        // True to the right; (1, 1) points right and down, which on screen is clockwise: +45. (0, -1) is up: -90.
        GroundTruth truth = truth(10, 0, 1, 1);
        FlowEstimate estimate = FlowEstimate.of(new float[] {1, 0}, new float[] {1, -1}, new int[] {1, 1});
        FlowFigures flow = Evaluation.of(truth, estimate, ALL).flow();
        assertEquals(-22.5, flow.directionErrorDeg().mean(), 1e-9);
        assertEquals(67.5, flow.angularErrorDeg().mean(), 1e-9);
    }

    @Test
    public void countsEndpointErrorsAbove135PxPerSAsOutliers() {
        GroundTruth truth = truth(100, 0, 1, 1);
        FlowEstimate estimate = FlowEstimate.of(new float[] {235, 236}, new float[2], new int[] {1, 1});
        assertEquals(1, Evaluation.of(truth, estimate, ALL).flow().outliers());
    }

    @Test
    public void aRunawayIsFasterThanTwiceTheFastestTrueSpeedOfAnyObject() {
        // Objects at 10 and 50 px/s: more than 100 px/s is a runaway, also of the slow one; noise does not count.
        GroundTruth truth = new GroundTruth(new long[] {0, 1, 2, 3}, new float[] {10, 50, 10, 0}, new float[4],
                new int[] {1, 2, 1, 0});
        FlowEstimate estimate = FlowEstimate.of(new float[] {100, 101, 150, 900}, new float[4], new int[] {1, 1, 1, 1});
        Evaluation evaluation = Evaluation.of(truth, estimate, ALL);
        assertEquals(2, evaluation.flow().runaways());
        assertEquals(2.0 / 3, evaluation.flow().runawayShare(), 1e-12);
        assertEquals(1, evaluation.flowByObject().get(0).runaways());
    }

    @Test
    public void takesNoAngleFromAnEstimateOfZeroNorFromATruthThatStandsStill() {
        GroundTruth truth = new GroundTruth(new long[] {0, 1}, new float[] {50, 0.5f}, new float[2], new int[] {1, 1});
        FlowEstimate estimate = FlowEstimate.of(new float[] {0, 30.5f}, new float[2], new int[] {1, 1});
        FlowFigures flow = Evaluation.of(truth, estimate, ALL).flow();
        assertEquals(0, flow.directionErrorDeg().count());
        assertEquals(1, flow.magnitudeErrorPercent().count());
        assertEquals(-100, flow.magnitudeErrorPercent().mean(), 1e-9);
        // 50 and 30 px/s
        assertEquals(40, flow.endpointErrorPxPerS().mean(), 1e-5);
    }

    @Test
    public void leavesTheFirstShareOfTheTimeOut() {
        // Times 0 to 20 ms; 15 % of 20 ms is 3 ms, so events 0, 1 and 2 do not count.
        GroundTruth truth = truth(10, 0, repeat(1, 21));
        Evaluation evaluation = Evaluation.of(truth, labels(repeat(1, 21)), EvaluationOptions.defaults());
        assertEquals(21, evaluation.events());
        assertEquals(18, evaluation.eventsCounted());
        assertEquals(18, evaluation.flow().events());
    }

    @Test
    public void countsNoiseApartAndEachObjectForItself() {
        GroundTruth truth = truth(10, 0, 0, 7, 0, 3, 7);
        Evaluation evaluation = Evaluation.of(truth, labels(0, 1, 2, 0, 1), ALL);
        assertEquals(2, evaluation.noiseEvents());
        assertEquals(1, evaluation.noiseEventsWithFlow());
        assertEquals(0.5, evaluation.noiseShareWithFlow(), 0);
        assertEquals(3, evaluation.flowByObject().get(0).object());
        assertEquals(0, evaluation.flowByObject().get(0).eventsWithFlow());
        assertEquals(7, evaluation.flowByObject().get(1).object());
        assertEquals(2, evaluation.flowByObject().get(1).eventsWithFlow());
        assertEquals(3, evaluation.flow().events());
    }

    @Test
    public void countsNoiseInTheUnionOfItsSegment() {
        // Object: 10 events, 8 of them in segment 1, which also holds 2 of 4 noise events.
        // Union 10 + 10 - 8 = 12; without noise 10 + 8 - 8 = 10.
        GroundTruth truth = truth(10, 0, join(repeat(1, 10), repeat(0, 4)));
        SegmentationFigures figures = Evaluation.of(truth,
                labels(join(repeat(1, 8), repeat(0, 2), repeat(1, 2), repeat(0, 2))), ALL).segmentation();
        assertEquals(1, figures.pairs());
        assertEquals(8.0 / 12, figures.meanIou(), 1e-12);
        assertEquals(0.8, figures.meanIouWithoutNoise(), 1e-12);
        assertEquals(1, figures.partsPerObject(), 0);
        assertEquals(1, figures.objectsPerPart(), 0);
    }

    @Test
    public void countsPartsOfAnObjectAndObjectsOfAPart() {
        // Object 1: 10 events in segment 1, 10 in segment 2, 2 in segment 3 (too few to be a part).
        // Object 2: 10 events, all in segment 2, which therefore has two objects; segment 1 has one.
        GroundTruth truth = truth(10, 0, join(repeat(1, 22), repeat(2, 10)));
        Evaluation evaluation = Evaluation.of(truth,
                labels(join(repeat(1, 10), repeat(2, 10), repeat(3, 2), repeat(2, 10))), ALL);
        SegmentationFigures all = evaluation.segmentation();
        assertEquals(2, all.pairs());
        assertEquals(1.5, all.partsPerObject(), 0);
        assertEquals(1.5, all.objectsPerPart(), 0);
        assertEquals(2, evaluation.segmentationByObject().get(0).partsPerObject(), 0);
        assertEquals(2, evaluation.segmentationByObject().get(1).objectsPerPart(), 0);
        // Object 1: best is segment 1, 10 / 22. Object 2: segment 2, 10 / (10 + 20 - 10).
        assertEquals((10.0 / 22 + 0.5) / 2, all.meanIou(), 1e-12);
        assertEquals(10.0 / 22, all.worstIou(), 1e-12);
    }

    @Test
    public void countsAnUnlabelledObjectAsNoOverlapAndNoPart() {
        SegmentationFigures figures = Evaluation.of(truth(10, 0, repeat(1, 20)), labels(repeat(0, 20)), ALL)
                .segmentation();
        assertEquals(1, figures.pairs());
        assertEquals(0, figures.meanIou(), 0);
        assertEquals(0, figures.partsPerObject(), 0);
        assertEquals(0, figures.labelled());
    }

    @Test
    public void countsEachWindowAndEachChangeOfTheBestSegment() {
        // 100 events over 100 ms: two windows; segment 1 in the first, 2 in the second.
        SegmentationFigures figures = Evaluation.of(truth(10, 0, repeat(1, 100)),
                labels(join(repeat(1, 50), repeat(2, 50))), ALL).segmentation();
        assertEquals(2, figures.pairs());
        assertEquals(1, figures.meanIou(), 0);
        assertEquals(1, figures.identityChanges());
    }

    @Test
    public void firstLabelledNeedsHalfOfTheNextEventsLabelled() {
        // A stray label at event 5; steady labels from event 40 on, at 40 ms and 40 ms x 100 px/s = 4 px.
        int[] segment = join(repeat(0, 40), repeat(1, 60));
        segment[5] = 1;
        SegmentationFigures figures = Evaluation.of(truth(0, 100, repeat(1, 100)), labels(segment), ALL)
                .segmentation();
        assertEquals(40_000, figures.firstLabelledUs());
        assertEquals(4, figures.firstLabelledPx(), 1e-9);
        assertEquals(1, figures.labelled());
    }

    @Test
    public void convergenceCountsFromEachObjectsAppearance() {
        // Object 1 from 0 ms, object 2 from 30 ms; the first bin of 20 ms holds 20 events of each.
        GroundTruth truth = truth(10, 0, join(repeat(1, 30), repeat(2, 30)));
        float[] vx = new float[60];
        java.util.Arrays.fill(vx, 11);
        Evaluation evaluation = Evaluation.of(truth, FlowEstimate.of(vx, new float[60],
                join(repeat(0, 20), repeat(1, 40))), EvaluationOptions.defaults());
        ConvergenceBin first = evaluation.convergence().get(0);
        assertEquals(40, first.events());
        assertEquals(20, first.eventsWithFlow());
        assertEquals(0.5, first.shareWithFlow(), 0);
        assertEquals(10, first.meanMagnitudeErrorPercent(), 1e-4);
        assertEquals(1, first.meanEndpointErrorPxPerS(), 1e-4);
        ConvergenceBin second = evaluation.convergence().get(1);
        assertEquals(20_000, second.fromUs());
        assertEquals(20, second.events());
        assertEquals(20, second.eventsWithFlow());
    }

    @Test
    public void evaluatesARecordingWithoutEvents() {
        Evaluation evaluation = Evaluation.of(truth(0, 0), labels(), EvaluationOptions.defaults());
        assertEquals(0, evaluation.events());
        assertEquals(0, evaluation.flow().shareWithFlow(), 0);
        assertEquals(0, evaluation.segmentation().worstIou(), 0);
    }

    @Test
    public void refusesAnEstimateOfAnotherLength() {
        IllegalArgumentException e = assertThrows(IllegalArgumentException.class,
                () -> Evaluation.of(truth(1, 0, 1, 1), labels(1), ALL));
        assertEquals("estimate must have as many events as the truth, 2, but has 1", e.getMessage());
    }
}
