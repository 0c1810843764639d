package io.github.sofas.simulate;

/**
 * The view of a wall by a camera: a projective map and its rate of change. The map gives the place of each point of the
 * sensor on the wall, in px of the wall as seen from the front; with the rate it gives the velocity of the picture
 * there. Views are reused, so that a time step allocates nothing.
 */
final class WallView {
    /** Rows of the map from (x, y, 1) to the wall. */
    private final double[] map = new double[9];
    /** Rates of the entries of the map, per s. */
    private final double[] rate = new double[9];

    /** The map, to be filled. */
    double[] map() {
        return map;
    }

    /** The rates of its entries, to be filled. */
    double[] rate() {
        return rate;
    }

    /** Column on the wall at a point of the sensor. */
    double alongX(double x, double y) {
        return row(map, 0, x, y) / row(map, 2, x, y);
    }

    /** Row on the wall at a point of the sensor. */
    double alongY(double x, double y) {
        return row(map, 1, x, y) / row(map, 2, x, y);
    }

    /** Velocity to the right at a point of the sensor, in px/s. */
    double vxAt(double x, double y) {
        return (slope(1, 1, x, y) * change(0, x, y) - slope(0, 1, x, y) * change(1, x, y)) / -area(x, y);
    }

    /** Velocity downwards at a point of the sensor, in px/s. */
    double vyAt(double x, double y) {
        return (slope(0, 0, x, y) * change(1, x, y) - slope(1, 0, x, y) * change(0, x, y)) / -area(x, y);
    }

    private double area(double x, double y) {
        return slope(0, 0, x, y) * slope(1, 1, x, y) - slope(0, 1, x, y) * slope(1, 0, x, y);
    }

    private static double row(double[] rows, int k, double x, double y) {
        return rows[3 * k] * x + rows[3 * k + 1] * y + rows[3 * k + 2];
    }

    /** Change of the place on the wall along one of its axes, per px along another axis (by) of the sensor. */
    private double slope(int axis, int by, double x, double y) {
        double depth = row(map, 2, x, y);
        return (map[3 * axis + by] * depth - row(map, axis, x, y) * map[6 + by]) / (depth * depth);
    }

    /** Change of the place on the wall at a point of the sensor, along one axis of the wall, per second. */
    private double change(int axis, double x, double y) {
        double depth = row(map, 2, x, y);
        return (row(rate, axis, x, y) * depth - row(map, axis, x, y) * row(rate, 2, x, y)) / (depth * depth);
    }
}
