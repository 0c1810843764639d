package io.github.sofas.flow.fit;

import static org.junit.Assert.assertEquals;
import static org.junit.Assert.assertTrue;

import java.util.Random;
import org.junit.Test;

/** Corrections by measurements over windows of 0.2 s, each a tenth of which is new but where it says otherwise. */
public class KalmanFilterTest {
    private static final double HALF_S = 0.1;
    private static final double DT_S = 0.02;
    /** Px that the picture travels in a window: more than what pixels hold on to. */
    private static final double FAR_PX = 20;
    /** Noise of the metric of a picture that is so sharp that only pixels make its velocity wrong. */
    private static final double SHARP = 0.04;
    private static final double TINY = 1e-6;

    private static KalmanFilter started(double unrestPx) {
        KalmanFilter filter = new KalmanFilter(unrestPx);
        filter.start(HALF_S);
        return filter;
    }

    @Test
    public void velocityOfWhatIsSteadyIsTakenByHowWellItIsKnown() {
        KalmanFilter filter = started(0);
        filter.correct(DT_S, HALF_S, 2, 50, 0, FAR_PX, SHARP);
        // known to 0.1 px, and by the new one to 0.03 px: 0.01 / (0.01 + 0.0009), but for a walk of 0.003 px
        assertEquals(2 * 0.01 / 0.0109, filter.velocity(), 1e-3);
        assertEquals(0, filter.acceleration(), 0);
        assertEquals(0, filter.jerk(), 0);
        filter.correct(DT_S, HALF_S, 2, 50, 0, FAR_PX, SHARP);
        // both of them together know it to 0.0009 * 0.01 / 0.0109 px²
        double known = 0.0009 * 0.01 / 0.0109;
        assertEquals(2 * known / (known + 0.0009), filter.velocity(), 3e-3);
    }

    @Test
    public void fewNewEventsTellLess() {
        KalmanFilter filter = started(0);
        filter.correct(DT_S / 10, HALF_S, 2, 0, 0, FAR_PX, SHARP);
        assertEquals("ten times the variance", 2 * 0.01 / 0.019, filter.velocity(), 1e-3);
    }

    @Test
    public void whatDoesNotTravelAlongAnAxisIsHeldByItsPixels() {
        KalmanFilter filter = started(0);
        filter.correct(DT_S, HALF_S, 2, 0, 0, 0, SHARP);
        // 0.1 px besides the 0.03
        assertEquals(2 * 0.01 / 0.0209, filter.velocity(), 1e-3);
        filter = started(0);
        filter.correct(DT_S, HALF_S, 2, 0, 0, 1.5, SHARP);
        double locked = 0.1 * Math.exp(-1);
        assertEquals(2 * 0.01 / (0.0109 + locked * locked), filter.velocity(), 1e-3);
    }

    @Test
    public void whatLosesLittleMetricByAShiftTellsLess() {
        KalmanFilter filter = started(0);
        filter.correct(DT_S, HALF_S, 2, 0, 0, FAR_PX, 0.1);
        // 0.05 instead of 0.03 px
        assertEquals(2 * 0.01 / 0.0125, filter.velocity(), 1e-3);
        filter = started(0);
        filter.correct(DT_S, HALF_S, 2, 0, 0, FAR_PX, Double.POSITIVE_INFINITY);
        // 0.6 px at most
        assertEquals(2 * 0.01 / 0.37, filter.velocity(), 1e-3);
    }

    @Test
    public void correctionsAreThoseOfThePlainEquations() {
        for (double unrestPx : new double[] {0, 0.01, 0.2}) {
            KalmanFilter filter = started(unrestPx);
            PlainFilter plain = new PlainFilter(unrestPx);
            Random random = new Random(3);
            for (int i = 0; i < 50; i++) {
                double half = HALF_S * (0.8 + 0.4 * random.nextDouble());
                // where a window grows, its middle may come earlier
                double dt = DT_S * (random.nextDouble() - 0.1);
                double offVelocity = random.nextGaussian();
                double offAcceleration = 30 * random.nextGaussian();
                double jerk = 300 * random.nextGaussian();
                double travel = 3 * random.nextDouble();
                double metric = 0.2 * random.nextDouble();
                filter.correct(dt, half, offVelocity, offAcceleration, jerk, travel, metric);
                double[] by = plain.correct(dt, half, offVelocity, offAcceleration, jerk, travel, metric);
                assertEquals(by[0], filter.velocity(), TINY * (1 + Math.abs(by[0])));
                assertEquals(by[1], filter.acceleration(), TINY * (1 + Math.abs(by[1])));
                assertEquals(by[2], filter.jerk(), TINY * (1 + Math.abs(by[2])));
                assertEquals(by[3], filter.logLikelihood(), TINY * (1 + Math.abs(by[3])));
            }
        }
    }

    @Test
    public void likelyIsWhatIsMeasuredAsItWasPredicted() {
        KalmanFilter filter = started(0.01);
        filter.correct(DT_S, HALF_S, 0, 0, 0, FAR_PX, SHARP);
        double asPredicted = filter.logLikelihood();
        filter = started(0.01);
        filter.correct(DT_S, HALF_S, 5, 0, 0, FAR_PX, SHARP);
        assertTrue(filter.logLikelihood() < asPredicted - 1);
    }

    /** The same with matrices. */
    private static final class PlainFilter {
        private final double unrestPx;
        private double[][] p;

        PlainFilter(double unrestPx) {
            this.unrestPx = unrestPx;
            double isMoving = unrestPx > 0 ? 1 : 0;
            double toAcceleration = 2 / (HALF_S * HALF_S);
            double toJerk = 6 / (HALF_S * HALF_S * HALF_S);
            p = new double[][] {{square(0.1 / HALF_S), 0, 0}, {0, isMoving * square(0.05 * toAcceleration), 0},
                {0, 0, square(2 * unrestPx * toJerk)}};
        }

        double[] correct(double dt, double half, double offVelocity, double offAcceleration, double jerk,
                         double travel, double metric) {
            double[][] f = {{1, dt, dt * dt / 2}, {0, 1, dt}, {0, 0, 1}};
            p = times(times(f, p), transposed(f));
            double d = Math.max(0, dt);
            double white = square(unrestPx * 6 / Math.pow(half, 3)) / half;
            double[][] q = {{Math.pow(d, 5) / 20, Math.pow(d, 4) / 8, Math.pow(d, 3) / 6},
                {Math.pow(d, 4) / 8, Math.pow(d, 3) / 3, d * d / 2}, {Math.pow(d, 3) / 6, d * d / 2, d}};
            for (int row = 0; row < 3; row++) {
                for (int column = 0; column < 3; column++) {
                    p[row][column] += white * q[row][column];
                }
            }
            p[0][0] += square(0.003) * d / Math.pow(half, 3);
            double news = Math.max(1e-3, dt / (0.2 * half));
            double locked = Math.exp(-square(travel / 1.5));
            double noisy = Math.max(1, 0.5 * metric / 0.03);
            double inVelocity = 0.1 * half * half;
            double[] by = new double[4];
            take(new double[] {1, 0, inVelocity}, offVelocity - inVelocity * jerk,
                (square(0.03 * noisy) + square(0.1 * locked)) / (half * half * news), by);
            take(new double[] {0, 1, 0}, offAcceleration - by[1],
                (square(0.05 * noisy) + square(0.15 * locked)) * square(2 / (half * half)) / news, by);
            by[3] *= Math.min(1, news);
            return by;
        }

        private void take(double[] seen, double off, double noise, double[] by) {
            double[] covariance = new double[3];
            double variance = noise;
            for (int row = 0; row < 3; row++) {
                for (int column = 0; column < 3; column++) {
                    covariance[row] += p[row][column] * seen[column];
                }
                variance += seen[row] * covariance[row];
            }
            for (int row = 0; row < 3; row++) {
                by[row] += covariance[row] / variance * off;
                for (int column = 0; column < 3; column++) {
                    p[row][column] -= covariance[row] * covariance[column] / variance;
                }
            }
            by[3] -= (off * off / variance + Math.log(variance)) / 2;
        }

        private static double[][] times(double[][] a, double[][] b) {
            double[][] c = new double[3][3];
            for (int row = 0; row < 3; row++) {
                for (int column = 0; column < 3; column++) {
                    for (int k = 0; k < 3; k++) {
                        c[row][column] += a[row][k] * b[k][column];
                    }
                }
            }
            return c;
        }

        private static double[][] transposed(double[][] a) {
            double[][] t = new double[3][3];
            for (int row = 0; row < 3; row++) {
                for (int column = 0; column < 3; column++) {
                    t[column][row] = a[row][column];
                }
            }
            return t;
        }

        private static double square(double x) {
            return x * x;
        }
    }
}
