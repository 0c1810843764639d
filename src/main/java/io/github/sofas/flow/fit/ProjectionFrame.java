package io.github.sofas.flow.fit;

/** How the projections of a fit lie around a velocity: the direction of their first axis, and their distances. */
final class ProjectionFrame {
    private double directionX = 1;
    private double directionY;
    private double h1;
    private double h2;

    /** Sets an upright frame with equal distances in px/s. */
    void set(double h) {
        directionX = 1;
        directionY = 0;
        h1 = h;
        h2 = h;
    }

    /**
     * Turns the frame to the principal axes of the loss, and spaces the projections so that each neighbour loses about
     * the same share of the metric: an edge is sharp across and flat along.
     *
     * @param xx loss of the metric per (px/s)²; xx, xy and yy are the entries of a symmetric matrix
     * @param least distance in px/s
     * @param most distance in px/s
     */
    void set(double metric, double xx, double xy, double yy, double share, double least, double most) {
        double mean = (xx + yy) / 2;
        double dif = (xx - yy) / 2;
        double root = Math.sqrt(dif * dif + xy * xy);
        double angle = 0.5 * StrictMath.atan2(2 * xy, xx - yy);
        directionX = StrictMath.cos(angle);
        directionY = StrictMath.sin(angle);
        h1 = spacing(metric * share, mean + root, least, most);
        h2 = spacing(metric * share, mean - root, least, most);
    }

    private static double spacing(double loss, double curvature, double least, double most) {
        return curvature * most * most <= loss ? most : Math.max(least, Math.sqrt(loss / curvature));
    }

    /** Spreads the projections after a step that left them. */
    void widen(double factor) {
        h1 *= factor;
        h2 *= factor;
    }

    /** Velocity to the right, in px/s, of the projection a and b distances along the axes from one of vx0. */
    double vx(double vx0, double a, double b) {
        return vx0 + a * h1 * directionX - b * h2 * directionY;
    }

    /** The same, downwards. */
    double vy(double vy0, double a, double b) {
        return vy0 + a * h1 * directionY + b * h2 * directionX;
    }

    /** Direction of the first axis, a unit vector. */
    double directionX() {
        return directionX;
    }

    double directionY() {
        return directionY;
    }

    /** Distance along the first axis in px/s. */
    double h1() {
        return h1;
    }

    double h2() {
        return h2;
    }
}
