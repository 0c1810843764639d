package io.github.sofas.experiments;

import io.github.sofas.event.SensorSize;
import io.github.sofas.simulate.SimulatedRecording;
import java.util.ArrayList;
import java.util.Comparator;
import java.util.List;
import java.util.stream.IntStream;

/**
 * The metric of a set of events under many projections, computed by the paper's formulas word for word. An event of
 * sign s at (u, v, t) falls on the cell nearest to (u - vx t, v - vy t), f sums the signs of a cell, and the metric is
 * the sum of f² (paper, section Structure Detection). Projections are evenly spaced in angle over ±80 degrees, with
 * velocity = 100 px/s x tan(angle).
 *
 * @param n number of projections along each axis
 * @param events number of projected events
 * @param metrics the metrics, by row of vy and column of vx, from the lowest velocity to the greatest
 */
record MetricMap(int n, int events, long[][] metrics) {
    /** Speed of a projection at 45 degrees, in px/s. */
    static final double VELOCITY_SCALE_PX_PER_S = 100;
    /** Greatest angle of a projection, in degrees. */
    static final double GREATEST_ANGLE_DEG = 80;

    /** A projection whose metric is not exceeded by that of any neighbour. */
    record Maximum(double vxPxPerS, double vyPxPerS, long metric) {
    }

    /** Computes the map of the events in a span of time of a recording. */
    static MetricMap of(SimulatedRecording recording, long fromUs, long untilUs, int n) {
        int[] picked = IntStream.range(0, recording.size())
            .filter(i -> recording.timeUs[i] >= fromUs && recording.timeUs[i] < untilUs).toArray();
        double farthestPx = velocity(n - 1, n) * (untilUs - fromUs) * 1e-6;
        int border = (int) Math.ceil(farthestPx) + 1;
        long[][] metrics = new long[n][];
        IntStream.range(0, n).parallel().forEach(row ->
            metrics[row] = row(recording, picked, fromUs, border, velocity(row, n), n));
        return new MetricMap(n, picked.length, metrics);
    }

    private static long[] row(SimulatedRecording recording, int[] picked, long fromUs, int border, double vy, int n) {
        SensorSize sensor = recording.sensor();
        int width = sensor.width() + 2 * border;
        int[] f = new int[width * (sensor.height() + 2 * border)];
        int[] cells = new int[picked.length];
        long[] metrics = new long[n];
        for (int column = 0; column < n; column++) {
            double vx = velocity(column, n);
            long metric = 0;
            for (int k = 0; k < picked.length; k++) {
                int i = picked[k];
                double seconds = (recording.timeUs[i] - fromUs) * 1e-6;
                int x = (int) (recording.x[i] - vx * seconds + border + 0.5);
                int y = (int) (recording.y[i] - vy * seconds + border + 0.5);
                int cell = y * width + x;
                int sign = recording.polarity[i];
                metric += 2 * f[cell] * sign + 1;
                f[cell] += sign;
                cells[k] = cell;
            }
            for (int cell : cells) {
                f[cell] = 0;
            }
            metrics[column] = metric;
        }
        return metrics;
    }

    /** Velocity of a projection along one axis, in px/s. */
    static double velocity(int i, int n) {
        double angleDeg = (2.0 * i / (n - 1) - 1) * GREATEST_ANGLE_DEG;
        return VELOCITY_SCALE_PX_PER_S * Math.tan(Math.toRadians(angleDeg));
    }

    /** Position of a velocity between the first and the last projection, from 0 to 1. */
    static double place(double pxPerS) {
        return (Math.toDegrees(Math.atan(pxPerS / VELOCITY_SCALE_PX_PER_S)) / GREATEST_ANGLE_DEG + 1) / 2;
    }

    /** The greatest local maxima, greatest first: projections that beat all others within a number of steps. */
    List<Maximum> maxima(int steps, int most) {
        List<Maximum> found = new ArrayList<>();
        for (int row = 0; row < n; row++) {
            for (int column = 0; column < n; column++) {
                if (beatsAllAround(row, column, steps)) {
                    found.add(new Maximum(velocity(column, n), velocity(row, n), metrics[row][column]));
                }
            }
        }
        found.sort(Comparator.comparingLong(Maximum::metric).reversed());
        return List.copyOf(found.subList(0, Math.min(most, found.size())));
    }

    private boolean beatsAllAround(int row, int column, int steps) {
        for (int r = Math.max(0, row - steps); r <= Math.min(n - 1, row + steps); r++) {
            for (int c = Math.max(0, column - steps); c <= Math.min(n - 1, column + steps); c++) {
                // among equal metrics, the first wins
                boolean before = r < row || r == row && c < column;
                if (metrics[r][c] > metrics[row][column] || before && metrics[r][c] == metrics[row][column]) {
                    return false;
                }
            }
        }
        return true;
    }
}
