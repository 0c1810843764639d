package io.github.sofas.simulate;

/**
 * Where each point of the sensor lies on a wall that a camera sees, in px of the wall as seen from the front, and how
 * fast what is there moves: a projective map and its change. Reused, so that a time step allocates nothing.
 */
final class WallView {
    /** Rows of the map from (x, y, 1) to the wall. */
    private final double[] map = new double[9];
    /** Their rates per s. */
    private final double[] rate = new double[9];

    /** The map, to be filled. */
    double[] map() {
        return map;
    }

    /** The rates of its entries, to be filled. */
    double[] rate() {
        return rate;
    }

    /** Column on the wall of a point of the sensor. */
    double alongX(double x, double y) {
        return row(map, 0, x, y) / row(map, 2, x, y);
    }

    /** The same, the row. */
    double alongY(double x, double y) {
        return row(map, 1, x, y) / row(map, 2, x, y);
    }

    /** Velocity to the right of what is at a point of the sensor, in px/s. */
    double vxAt(double x, double y) {
        return (slope(1, 1, x, y) * change(0, x, y) - slope(0, 1, x, y) * change(1, x, y)) / -area(x, y);
    }

    /** The same, downwards. */
    double vyAt(double x, double y) {
        return (slope(0, 0, x, y) * change(1, x, y) - slope(1, 0, x, y) * change(0, x, y)) / -area(x, y);
    }

    private double area(double x, double y) {
        return slope(0, 0, x, y) * slope(1, 1, x, y) - slope(0, 1, x, y) * slope(1, 0, x, y);
    }

    private static double row(double[] rows, int k, double x, double y) {
        return rows[3 * k] * x + rows[3 * k + 1] * y + rows[3 * k + 2];
    }

    /** What a place on the wall changes by along one axis a px of the sensor along another. */
    private double slope(int axis, int by, double x, double y) {
        double depth = row(map, 2, x, y);
        return (map[3 * axis + by] * depth - row(map, axis, x, y) * map[6 + by]) / (depth * depth);
    }

    /** What the place on the wall that a point of the sensor shows changes by a second. */
    private double change(int axis, double x, double y) {
        double depth = row(map, 2, x, y);
        return (row(rate, axis, x, y) * depth - row(map, axis, x, y) * row(rate, 2, x, y)) / (depth * depth);
    }
}
