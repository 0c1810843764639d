package io.github.sofas.flow.fit;

import static org.junit.Assert.assertEquals;

import java.util.Arrays;
import java.util.Random;
import java.util.function.ToDoubleFunction;
import org.junit.Test;

/** Slopes and losses from three pictures against sums over all pairs of events. */
public class TimedVotesTest {
    private static final int SUB = BilinearAccumulator.SUB;
    private static final int COLUMNS = 14;
    private static final int ROWS = 12;
    private static final double CELL_PX = 1.3;
    /** Where the first cell lies from the centre, in px. */
    private static final double X0 = -7.5;
    private static final double Y0 = -8;
    private static final double RADIUS_PX = 4;

    private final Random random = new Random(5);
    private final int size = 60;
    /** In sixteenths of a cell. */
    private final int[] x = new int[size];
    private final int[] y = new int[size];
    private final int[] sign = new int[size];
    /** In quarters of a second up to {@link TimedVotes#MOST_TIME}, so that none is rounded. */
    private final int[] time = new int[size];

    private MetricSlopes slopes(TimedVotes votes) {
        int[] at = new int[size];
        float[] seconds = new float[size];
        for (int i = 0; i < size; i++) {
            int cell = (y[i] / SUB) * COLUMNS + x[i] / SUB;
            at[i] = cell << BilinearAccumulator.KEY_BITS | (sign[i] > 0 ? 0 : BilinearAccumulator.OFF)
                | y[i] % SUB << BilinearAccumulator.SUB_BITS | x[i] % SUB;
            seconds[i] = time[i] / 4f;
        }
        ShiftProfile profile = new ShiftProfile(size);
        profile.take(seconds, size);
        MetricSlopes slopes = new MetricSlopes();
        slopes.plane = new PlaneSlopes();
        slopes.plane.begin(RADIUS_PX);
        votes.addSlopes(at, size, profile, COLUMNS, ROWS, X0, Y0, CELL_PX, slopes);
        return slopes;
    }

    private void scatter() {
        for (int i = 0; i < size; i++) {
            x[i] = 2 * SUB + random.nextInt((COLUMNS - 5) * SUB);
            y[i] = 2 * SUB + random.nextInt((ROWS - 5) * SUB);
            sign[i] = random.nextInt(4) == 0 ? -1 : 1;
            time[i] = random.nextInt(2 * TimedVotes.MOST_TIME + 1) - TimedVotes.MOST_TIME;
        }
        time[0] = TimedVotes.MOST_TIME;
    }

    /** Vote of an event for a cell, 0 to 1 and with its sign. */
    private double vote(int i, int column, int row) {
        return sign[i] * Math.max(0, 1 - Math.abs(x[i] / (double) SUB - column))
            * Math.max(0, 1 - Math.abs(y[i] / (double) SUB - row));
    }

    /** Sum over the cells of the votes of one event, times those of another for the cell beside, times a weight. */
    private double meet(int i, int j, int right, int down, ToDoubleFunction<double[]> weight) {
        double sum = 0;
        // the four cells that the first has votes for
        for (int row = y[i] / SUB; row <= y[i] / SUB + 1; row++) {
            for (int column = x[i] / SUB; column <= x[i] / SUB + 1; column++) {
                double[] fromCentre = {X0 + column * CELL_PX, Y0 + row * CELL_PX};
                sum += vote(i, column, row) * vote(j, column + right, row + down) * weight.applyAsDouble(fromCentre);
            }
        }
        return sum;
    }

    /** What the metric rises by where each event is moved back by its time to a power, times a place. */
    private double slope(int power, ToDoubleFunction<double[]> alongX, ToDoubleFunction<double[]> alongY) {
        double mean = 0;
        for (int i = 0; i < size; i++) {
            mean += power == 2 ? time[i] * time[i] / 16.0 / size : 0;
        }
        double sum = 0;
        for (int i = 0; i < size; i++) {
            double moved = -(Math.pow(time[i] / 4.0, power) - mean) / power / (2 * CELL_PX);
            for (int j = 0; j < size; j++) {
                sum += 2 * moved * (meet(i, j, 1, 0, alongX) - meet(i, j, -1, 0, alongX)
                    + meet(i, j, 0, 1, alongY) - meet(i, j, 0, -1, alongY));
            }
        }
        return sum;
    }

    /** Half of what the metric falls by to second order, with weights of the bend along x, across and along y. */
    private double loss(ToDoubleFunction<double[]> xx, ToDoubleFunction<double[]> xy, ToDoubleFunction<double[]> yy) {
        double sum = 0;
        for (int i = 0; i < size; i++) {
            for (int j = 0; j < size; j++) {
                // with (t2 (t2 - t1)) of the same two, (t1 - t2)²
                double apart = time[i] * (time[i] - time[j]) / 16.0;
                double bend = meet(i, j, 1, 0, xx) + meet(i, j, -1, 0, xx) - 2 * meet(i, j, 0, 0, xx)
                    + meet(i, j, 0, 1, yy) + meet(i, j, 0, -1, yy) - 2 * meet(i, j, 0, 0, yy)
                    + 2 * (meet(i, j, 1, 1, xy) - meet(i, j, 1, -1, xy) - meet(i, j, -1, 1, xy)
                    + meet(i, j, -1, -1, xy)) / 4;
                sum -= apart * bend / (CELL_PX * CELL_PX);
            }
        }
        return sum;
    }

    private static double none(double[] fromCentre) {
        return 0;
    }

    private static double all(double[] fromCentre) {
        return 1;
    }

    @Test
    public void slopesAreThoseOfAllPairs() {
        TimedVotes votes = new TimedVotes(COLUMNS * ROWS);
        for (int run = 0; run < 3; run++) {
            scatter();
            MetricSlopes slopes = slopes(votes);
            assertClose(slope(1, TimedVotesTest::all, TimedVotesTest::none), slopes.vx);
            assertClose(slope(1, TimedVotesTest::none, TimedVotesTest::all), slopes.vy);
            assertClose(slope(2, TimedVotesTest::all, TimedVotesTest::none), slopes.ax);
            assertClose(slope(2, TimedVotesTest::none, TimedVotesTest::all), slopes.ay);
            assertClose(slope(1, r -> -r[1], r -> r[0]), slopes.turn);
            assertClose(slope(2, r -> -r[1], r -> r[0]), slopes.spin);
            assertClose(slope(1, r -> r[0], r -> r[1]), slopes.grow);
        }
    }

    @Test
    public void metricAndLossesAreThoseOfAllPairs() {
        TimedVotes votes = new TimedVotes(COLUMNS * ROWS);
        for (int run = 0; run < 3; run++) {
            scatter();
            MetricSlopes slopes = slopes(votes);
            double metric = 0;
            for (int i = 0; i < size; i++) {
                for (int j = 0; j < size; j++) {
                    metric += i == j ? 0 : meet(i, j, 0, 0, TimedVotesTest::all);
                }
            }
            assertClose(metric, slopes.metric);
            assertClose(loss(TimedVotesTest::all, TimedVotesTest::none, TimedVotesTest::none), slopes.lossXx);
            assertClose(loss(TimedVotesTest::none, TimedVotesTest::none, TimedVotesTest::all), slopes.lossYy);
            assertClose(loss(TimedVotesTest::none, r -> 0.5, TimedVotesTest::none), slopes.lossXy);
            assertClose(loss(r -> r[1] * r[1], r -> -r[0] * r[1], r -> r[0] * r[0]), slopes.lossTurn);
            assertClose(loss(r -> r[0] * r[0], r -> r[0] * r[1], r -> r[1] * r[1]), slopes.lossGrow);
        }
    }

    /** Velocity that a unit of a parameter gives a place, in the order of {@link PlaneSlopes}. */
    private static double[] flow(int parameter, double[] fromCentre) {
        double x = fromCentre[0] / RADIUS_PX;
        double y = fromCentre[1] / RADIUS_PX;
        double[][] flows = {{1, 0}, {0, 1}, {-y, x}, {x, y}, {x, -y}, {y, x}, {x * x, x * y}, {x * y, y * y}};
        return flows[parameter];
    }

    @Test
    public void slopesAndLossesOfAPlaneAreThoseOfAllPairs() {
        scatter();
        PlaneSlopes plane = slopes(new TimedVotes(COLUMNS * ROWS)).plane;
        for (int i = 0; i < PlaneSlopes.COUNT; i++) {
            int p = i;
            assertClose(slope(1, r -> flow(p, r)[0], r -> flow(p, r)[1]), plane.rise(i));
            for (int j = 0; j < PlaneSlopes.COUNT; j++) {
                int q = j;
                assertClose(loss(r -> flow(p, r)[0] * flow(q, r)[0],
                    r -> (flow(p, r)[0] * flow(q, r)[1] + flow(p, r)[1] * flow(q, r)[0]) / 2,
                    r -> flow(p, r)[1] * flow(q, r)[1]), plane.loss(i, j));
            }
        }
    }

    @Test
    public void eventsOfOneTimeKnowNoMotion() {
        scatter();
        Arrays.fill(time, 8);
        MetricSlopes slopes = slopes(new TimedVotes(COLUMNS * ROWS));
        assertEquals(0, slopes.lossXx, 1e-9);
        assertEquals(0, slopes.lossTurn, 1e-9);
        assertEquals(0, slopes.changeShare, 0);
    }

    @Test
    public void changeLosesByTheSpreadOfTheSquaresOfTime() {
        scatter();
        double square = 0;
        double fourth = 0;
        for (int t : time) {
            square += t * t / 16.0 / size;
            fourth += t * t * t * t / 256.0 / size;
        }
        assertClose((fourth - square * square) / 4 / square, slopes(new TimedVotes(COLUMNS * ROWS)).changeShare);
    }

    private static void assertClose(double expected, double actual) {
        assertEquals(expected, actual, 1e-6 * Math.max(1, Math.abs(expected)));
    }
}
