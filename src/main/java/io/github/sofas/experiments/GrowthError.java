package io.github.sofas.experiments;

import io.github.sofas.evaluate.EvaluationOptions;
import io.github.sofas.evaluate.FlowEstimate;
import io.github.sofas.evaluate.GroundTruth;
import io.github.sofas.simulate.SimulatedRecording;

/**
 * The error of the growth that a flow shows. In each window of 50 ms that counts, a growth rate g is fitted to the
 * events with flow of an object, by least squares of v = a + b t + g r, with place r and time t. Without the term in t,
 * a body that speeds up would seem to grow. With r' for the part of r that t does not explain, the growth rate is
 * <pre>
 *   g = sum of r' v / sum of r'²
 * </pre>
 * It is computed once with the estimated velocities and once with the true ones. A window counts if it has at least
 * {@value #FEWEST_EVENTS} events and the true rate is at least {@value #LEAST_RATE_PER_S} per s in either direction.
 */
final class GrowthError {
    private static final int FEWEST_EVENTS = 50;
    private static final double LEAST_RATE_PER_S = 0.1;

    private final SimulatedRecording film;
    private final FlowEstimate estimate;

    private GrowthError(SimulatedRecording film, FlowEstimate estimate) {
        this.film = film;
        this.estimate = estimate;
    }

    /** Mean of 100 |estimated - true| / |true| over windows and objects, in %; NaN where nothing grows. */
    static double percent(SimulatedRecording film, FlowEstimate estimate) {
        GrowthError error = new GrowthError(film, estimate);
        EvaluationOptions options = EvaluationOptions.defaults();
        double sum = 0;
        int count = 0;
        int from = GroundTruth.of(film).firstCounted(options.skipFirstShare());
        while (from < film.size()) {
            int until = from;
            while (until < film.size() && film.timeUs[until] < film.timeUs[from] + options.windowUs()) {
                until++;
            }
            for (int object = 1; object <= film.objects(); object++) {
                double percent = error.percent(object, from, until);
                if (!Double.isNaN(percent)) {
                    sum += percent;
                    count++;
                }
            }
            from = until;
        }
        return count == 0 ? Double.NaN : sum / count;
    }

    private double percent(int object, int from, int until) {
        int n = 0;
        double meanT = 0;
        double meanX = 0;
        double meanY = 0;
        for (int i = from; i < until; i++) {
            if (counts(i, object)) {
                n++;
                meanT += film.timeUs[i] - film.timeUs[from];
                meanX += film.x[i];
                meanY += film.y[i];
            }
        }
        if (n < FEWEST_EVENTS) {
            return Double.NaN;
        }
        meanT = film.timeUs[from] + meanT / n;
        meanX /= n;
        meanY /= n;
        double squaresT = 0;
        double productX = 0;
        double productY = 0;
        for (int i = from; i < until; i++) {
            if (counts(i, object)) {
                double t = film.timeUs[i] - meanT;
                squaresT += t * t;
                productX += t * (film.x[i] - meanX);
                productY += t * (film.y[i] - meanY);
            }
        }
        double slopeX = squaresT == 0 ? 0 : productX / squaresT;
        double slopeY = squaresT == 0 ? 0 : productY / squaresT;
        double estimated = 0;
        double real = 0;
        double squares = 0;
        for (int i = from; i < until; i++) {
            if (counts(i, object)) {
                double t = film.timeUs[i] - meanT;
                double x = film.x[i] - meanX - slopeX * t;
                double y = film.y[i] - meanY - slopeY * t;
                estimated += x * estimate.vxPxPerS(i) + y * estimate.vyPxPerS(i);
                real += x * film.vxPxPerS[i] + y * film.vyPxPerS[i];
                squares += x * x + y * y;
            }
        }
        if (squares == 0 || Math.abs(real) < LEAST_RATE_PER_S * squares) {
            return Double.NaN;
        }
        return 100 * Math.abs(estimated - real) / Math.abs(real);
    }

    private boolean counts(int i, int object) {
        return film.object[i] == object && estimate.hasFlow(i);
    }
}
