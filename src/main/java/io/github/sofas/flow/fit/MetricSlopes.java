package io.github.sofas.flow.fit;

/**
 * How the metric of a set of events changes with each parameter of their motion, to second order: its rise, and the
 * loss by another motion. Rotation and growth are about the structure's centre.
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
    /** The same for all parameters of the flow of a plane; null where these are not needed. */
    PlaneSlopes plane;
    /** Loss by a parameter that changes by 1 per second, as a share of the loss by 1 of the parameter itself. */
    double changeShare;

    /** The loss as a bilinear form of two velocities; of a velocity with itself, the loss by that velocity. */
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

    /** Multiplies everything that depends on how much the events vote. */
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
