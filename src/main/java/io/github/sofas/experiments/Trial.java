package io.github.sofas.experiments;

import io.github.sofas.evaluate.Evaluation;
import io.github.sofas.evaluate.EvaluationOptions;
import io.github.sofas.evaluate.FlowEstimate;
import io.github.sofas.evaluate.FlowFigures;
import io.github.sofas.evaluate.GroundTruth;
import io.github.sofas.flow.EventLabeller;
import io.github.sofas.simulate.SimulatedRecording;

/**
 * The results of one method in one setting.
 *
 * @param setting what was filmed
 * @param method the method that labelled the film
 * @param evaluation all figures of the evaluation
 * @param magnitudeError errors of the speed in %, over object events with flow that count
 * @param directionError errors of the direction in degrees, over the same
 * @param speed median estimated speed over time in px/s
 * @param trueSpeed median true speed of the object events over the same time in px/s
 * @param strip pictures; null unless pictures are made of the setting
 */
record Trial(Setting setting, ComparedMethod method, Evaluation evaluation, Histogram magnitudeError,
             Histogram directionError, Curve speed, Curve trueSpeed, Strip strip) {
    /** Bins of 2 % and 4 degrees. Their number is odd, so that an error of zero is in the middle of a bin. */
    private static final int MAGNITUDE_BINS = 101;
    private static final double MAGNITUDE_LIMIT_PERCENT = 101;
    private static final int DIRECTION_BINS = 91;
    private static final double DIRECTION_LIMIT_DEG = 182;
    private static final long CURVE_BIN_US = 20_000;
    private static final int FEWEST_EVENTS = 5;

    static Trial of(Setting setting, SimulatedRecording recording, ComparedMethod method) {
        GroundTruth truth = GroundTruth.of(recording);
        EventLabeller labeller = method.make(recording.sensor());
        FlowEstimate estimate = new FlowEstimate();
        Strip strip = Setting.PICTURED.contains(setting) ? StripPainter.strip(recording, labeller, estimate) : null;
        estimate.label(recording, labeller, recording.size());
        EvaluationOptions options = EvaluationOptions.defaults();
        Evaluation evaluation = Evaluation.of(truth, estimate, options);
        Histogram.Gatherer magnitude = new Histogram.Gatherer(MAGNITUDE_LIMIT_PERCENT, MAGNITUDE_BINS);
        Histogram.Gatherer direction = new Histogram.Gatherer(DIRECTION_LIMIT_DEG, DIRECTION_BINS);
        for (int i = truth.firstCounted(options.skipFirstShare()); i < truth.size(); i++) {
            double vx = truth.vxPxPerS()[i];
            double vy = truth.vyPxPerS()[i];
            if (truth.object()[i] != GroundTruth.NOISE && estimate.hasFlow(i)
                    && Math.hypot(vx, vy) >= FlowFigures.MIN_TRUE_SPEED) {
                double ux = estimate.vxPxPerS(i);
                double uy = estimate.vyPxPerS(i);
                magnitude.add(FlowFigures.magnitudeErrorPercent(vx, vy, ux, uy));
                if (ux != 0 || uy != 0) {
                    direction.add(FlowFigures.directionErrorDeg(vx, vy, ux, uy));
                }
            }
        }
        return new Trial(setting, method, evaluation, magnitude.histogram(), direction.histogram(),
            speed(truth, estimate, true), speed(truth, estimate, false), strip);
    }

    /** Median speeds of the object events in bins of 20 ms. */
    private static Curve speed(GroundTruth truth, FlowEstimate estimate, boolean estimated) {
        int n = truth.size();
        long firstUs = n == 0 ? 0 : truth.timeUs()[0];
        int bins = n == 0 ? 0 : (int) ((truth.timeUs()[n - 1] - firstUs) / CURVE_BIN_US) + 1;
        Medians[] speeds = new Medians[bins];
        for (int b = 0; b < bins; b++) {
            speeds[b] = new Medians();
        }
        for (int i = 0; i < n; i++) {
            if (truth.object()[i] != GroundTruth.NOISE && (!estimated || estimate.hasFlow(i))) {
                speeds[(int) ((truth.timeUs()[i] - firstUs) / CURVE_BIN_US)].add(estimated
                    ? Math.hypot(estimate.vxPxPerS(i), estimate.vyPxPerS(i))
                    : Math.hypot(truth.vxPxPerS()[i], truth.vyPxPerS()[i]));
            }
        }
        double[] timeS = new double[bins];
        double[] values = new double[bins];
        for (int b = 0; b < bins; b++) {
            timeS[b] = (b + 0.5) * CURVE_BIN_US * 1e-6;
            values[b] = speeds[b].size() < FEWEST_EVENTS ? Double.NaN : speeds[b].median();
        }
        return new Curve(timeS, values);
    }
}
