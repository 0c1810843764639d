package io.github.sofas.flow.paper;

/** The angles that the paper spaces its projections by (sections Flow Plane and Track Plane), in degrees. */
final class Angles {
    /** Steepest projection: 57 times the velocity scale. */
    static final double STEEPEST_DEG = 89;

    private Angles() {
    }

    /** Angle of the i-th of n projections over a range, so that none lies at 90 degrees. */
    static double at(int i, int n, double rangeDeg) {
        return (i - (n - 1) / 2.0) * rangeDeg / n;
    }

    /** An angle kept short of the right one: there velocity is infinite, and beyond it points backwards. */
    static double limited(double angleDeg) {
        return Math.max(-STEEPEST_DEG, Math.min(STEEPEST_DEG, angleDeg));
    }

    /** Velocity of a projection at an angle, in px/s. */
    static double velocity(double angleDeg, Numbers p) {
        return p.velocityScalePxPerS() * StrictMath.tan(Math.toRadians(angleDeg));
    }
}
