package io.github.sofas.simulate;

/** Where an object is and how it moves at one moment; reused, so that a time step allocates nothing. */
final class Pose {
    /** Place of the object's origin in px. */
    double x;
    double y;
    /** Cosine and sine of the angle by which the object is turned, from right to down. */
    double cos;
    double sin;
    /** Velocity of the origin in px/s. */
    double vxPxPerS;
    double vyPxPerS;
    /** Rate of turning in rad/s, positive from right to down. */
    double turnRadPerS;

    void turnTo(double angleRad) {
        cos = StrictMath.cos(angleRad);
        sin = StrictMath.sin(angleRad);
    }

    /** Velocity to the right of the object's point at row pointY: v = omega x r. */
    double vxAt(double pointY) {
        return vxPxPerS - turnRadPerS * (pointY - y);
    }

    /** Velocity downwards of the object's point at column pointX. */
    double vyAt(double pointX) {
        return vyPxPerS + turnRadPerS * (pointX - x);
    }

    /** Signed distance from a point of the sensor to the outline of a shape in this pose. */
    double distanceTo(Shape shape, double pointX, double pointY) {
        double dx = pointX - x;
        double dy = pointY - y;
        return shape.signedDistance(cos * dx + sin * dy, cos * dy - sin * dx);
    }
}
