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
    /** Size as a multiple of the shape's own, and its relative rate of growth per s. */
    double scale;
    double growthPerS;

    /** The object has its own size, and keeps it. */
    void keepSize() {
        scale = 1;
        growthPerS = 0;
    }

    void turnTo(double angleRad) {
        cos = StrictMath.cos(angleRad);
        sin = StrictMath.sin(angleRad);
    }

    /** Velocity to the right of the object's point at a point of the sensor: v + omega x r + growth r. */
    double vxAt(double pointX, double pointY) {
        return vxPxPerS - turnRadPerS * (pointY - y) + growthPerS * (pointX - x);
    }

    /** Velocity downwards of the same. */
    double vyAt(double pointX, double pointY) {
        return vyPxPerS + turnRadPerS * (pointX - x) + growthPerS * (pointY - y);
    }

    /** Where a point of the sensor lies on the object's own first axis, in px of its own size. */
    double alongX(double pointX, double pointY) {
        return (cos * (pointX - x) + sin * (pointY - y)) / scale;
    }

    /** The same on its second axis. */
    double alongY(double pointX, double pointY) {
        return (cos * (pointY - y) - sin * (pointX - x)) / scale;
    }

    /** Signed distance from a point of the sensor to the outline of a shape in this pose. */
    double distanceTo(Shape shape, double pointX, double pointY) {
        return scale * shape.signedDistance(alongX(pointX, pointY), alongY(pointX, pointY));
    }
}
