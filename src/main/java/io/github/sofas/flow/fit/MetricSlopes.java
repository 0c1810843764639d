package io.github.sofas.flow.fit;

/**
 * How the metric of a set of events changes with each parameter of their motion: what it rises by, and what another
 * motion loses, to second order. The place in the picture enters turning and growth from the structure's centre.
 */
final class MetricSlopes {
    /** In votes squared. */
    double metric;
    /** Rise per px/s. */
    double vx;
    double vy;
    /** Rise per px/s². */
    double ax;
    double ay;
    /** Rise per rad/s. */
    double turn;
    /** Rise per rad/s². */
    double spin;
    /** Rise per 1/s of growth. */
    double grow;
    /** Loss per (px/s)², a symmetric matrix. */
    double lossXx;
    double lossXy;
    double lossYy;
    /** Loss per (rad/s)². */
    double lossTurn;
    /** Loss per (1/s)². */
    double lossGrow;
    /** The same of all parameters of the flow of a plane; null where that is not asked for. */
    PlaneSlopes plane;
    /** What a change of a parameter by 1 a second loses, as a share of what the parameter itself loses by 1. */
    double changeShare;

    /** The loss, as a bilinear form of two velocities: with itself, what a velocity loses. */
    double loss(double vx1, double vy1, double vx2, double vy2) {
        return lossXx * vx1 * vx2 + lossXy * (vx1 * vy2 + vy1 * vx2) + lossYy * vy1 * vy2;
    }

    void clear() {
        metric = 0;
        vx = 0;
        vy = 0;
        ax = 0;
        ay = 0;
        turn = 0;
        spin = 0;
        grow = 0;
        lossXx = 0;
        lossXy = 0;
        lossYy = 0;
        lossTurn = 0;
        lossGrow = 0;
        changeShare = 0;
    }

    /** Multiplies what depends on how much the events vote. */
    void multiply(double by) {
        metric *= by;
        vx *= by;
        vy *= by;
        ax *= by;
        ay *= by;
        turn *= by;
        spin *= by;
        grow *= by;
        lossXx *= by;
        lossXy *= by;
        lossYy *= by;
        lossTurn *= by;
        lossGrow *= by;
        if (plane != null) {
            plane.multiply(by);
        }
    }
}
