package io.github.sofas.simulate;

/** Where an object is and how it moves at one moment. Poses are reused, so that a time step allocates nothing. */
final class Pose {
    /** Position of the object's origin in px. */
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
    /** Size as a multiple of the shape's own size, and its relative rate of growth per s. */
    double scale;
    double growthPerS;

    /** The view of a wall that is not only moved, turned and scaled; null until it is first needed. */
    private WallView view;
    private boolean isView;

    /** Makes the object a wall that is everywhere; returns its view to be filled. Place and angle have no effect. */
    WallView view() {
        if (view == null) {
            view = new WallView();
        }
        isView = true;
        keepSize();
        return view;
    }

    /** Whether the object is a wall whose view is not only moved, turned and scaled. */
    boolean isView() {
        return isView;
    }

    /** Gives the object its own size, without growth. */
    void keepSize() {
        scale = 1;
        growthPerS = 0;
    }

    /** Turns the object to an angle; it is not seen through a view. */
    void turnTo(double angleRad) {
        isView = false;
        cos = StrictMath.cos(angleRad);
        sin = StrictMath.sin(angleRad);
    }

    /** Velocity to the right at a point of the sensor: v + omega x r + growth r, or the velocity of the view. */
    double vxAt(double pointX, double pointY) {
        return isView ? view.vxAt(pointX, pointY) : vxPxPerS - turnRadPerS * (pointY - y) + growthPerS * (pointX - x);
    }

    /** Velocity downwards at a point of the sensor. */
    double vyAt(double pointX, double pointY) {
        return isView ? view.vyAt(pointX, pointY) : vyPxPerS + turnRadPerS * (pointX - x) + growthPerS * (pointY - y);
    }

    /** Position of a point of the sensor on the object's own first axis, in px of the object's own size. */
    double alongX(double pointX, double pointY) {
        return isView ? view.alongX(pointX, pointY) : (cos * (pointX - x) + sin * (pointY - y)) / scale;
    }

    /** Position of a point of the sensor on the object's own second axis. */
    double alongY(double pointX, double pointY) {
        return isView ? view.alongY(pointX, pointY) : (cos * (pointY - y) - sin * (pointX - x)) / scale;
    }

    /** Signed distance from a point of the sensor to the outline of a shape in this pose. */
    double distanceTo(Shape shape, double pointX, double pointY) {
        return scale * shape.signedDistance(alongX(pointX, pointY), alongY(pointX, pointY));
    }
}
