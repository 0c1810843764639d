package io.github.sofas.flow.paper;

/** The angles, in degrees, by which the paper spaces its projections (sections Flow Plane and Track Plane). */
final class Angles {
    /** Angle of the steepest projection: 57 times the velocity scale. */
    static final double STEEPEST_DEG = 89;

    private Angles() {
    }

    /** Angle of the i-th of n projections over a range, centred so that none of them lies at 90 degrees. */
    static double at(int i, int n, double rangeDeg) {
        return (i - (n - 1) / 2.0) * rangeDeg / n;
    }

    /** Limits an angle to less than 90 degrees: there the velocity is infinite, and beyond, it points backwards. */
    static double limited(double angleDeg) {
        return Math.max(-STEEPEST_DEG, Math.min(STEEPEST_DEG, angleDeg));
    }

    /** Velocity of a projection at an angle, in px/s. */
    static double velocity(double angleDeg, Numbers p) {
        return p.velocityScalePxPerS() * StrictMath.tan(Math.toRadians(angleDeg));
    }
}
