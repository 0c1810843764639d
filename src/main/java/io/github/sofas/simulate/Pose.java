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

    /** How a wall is seen that is not only moved, turned and scaled; null until one is. */
    private WallView view;
    private boolean isView;

    /** The object is a wall that is everywhere, whose view is to be filled; place and angle count for nothing. */
    WallView view() {
        if (view == null) {
            view = new WallView();
        }
        isView = true;
        keepSize();
        return view;
    }

    /** Whether it is a wall whose view is not only moved, turned and scaled. */
    boolean isView() {
        return isView;
    }

    /** The object has its own size, and keeps it. */
    void keepSize() {
        scale = 1;
        growthPerS = 0;
    }

    /** The object is seen as it is, turned by an angle. */
    void turnTo(double angleRad) {
        isView = false;
        cos = StrictMath.cos(angleRad);
        sin = StrictMath.sin(angleRad);
    }

    /** Velocity to the right of what is at a point of the sensor: v + omega x r + growth r, or that of the view. */
    double vxAt(double pointX, double pointY) {
        return isView ? view.vxAt(pointX, pointY) : vxPxPerS - turnRadPerS * (pointY - y) + growthPerS * (pointX - x);
    }

    /** Velocity downwards of the same. */
    double vyAt(double pointX, double pointY) {
        return isView ? view.vyAt(pointX, pointY) : vyPxPerS + turnRadPerS * (pointX - x) + growthPerS * (pointY - y);
    }

    /** Where a point of the sensor lies on the object's own first axis, in px of its own size. */
    double alongX(double pointX, double pointY) {
        return isView ? view.alongX(pointX, pointY) : (cos * (pointX - x) + sin * (pointY - y)) / scale;
    }

    /** The same on its second axis. */
    double alongY(double pointX, double pointY) {
        return isView ? view.alongY(pointX, pointY) : (cos * (pointY - y) - sin * (pointX - x)) / scale;
    }

    /** Signed distance from a point of the sensor to the outline of a shape in this pose. */
    double distanceTo(Shape shape, double pointX, double pointY) {
        return scale * shape.signedDistance(alongX(pointX, pointY), alongY(pointX, pointY));
    }
}
