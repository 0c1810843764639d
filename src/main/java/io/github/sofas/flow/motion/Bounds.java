package io.github.sofas.flow.motion;

/** The upright bounding box of a set of places, in px. One instance is made once and reused. */
public final class Bounds {
    private double left;
    private double top;
    private double right;
    private double bottom;

    /** Makes an empty box. */
    public Bounds() {
        clear();
    }

    /** Empties the box: its left side is then infinitely far to the right, and so on for the other sides. */
    public void clear() {
        left = Double.POSITIVE_INFINITY;
        top = Double.POSITIVE_INFINITY;
        right = Double.NEGATIVE_INFINITY;
        bottom = Double.NEGATIVE_INFINITY;
    }

    /** Extends the box to hold a place. */
    public void include(double x, double y) {
        left = Math.min(left, x);
        top = Math.min(top, y);
        right = Math.max(right, x);
        bottom = Math.max(bottom, y);
    }

    /** Sets the four sides. */
    public void set(double toLeft, double toTop, double toRight, double toBottom) {
        left = toLeft;
        top = toTop;
        right = toRight;
        bottom = toBottom;
    }

    /** Whether a place lies in the box, or outside by at most a margin in px along each axis. */
    public boolean isAround(double x, double y, double marginPx) {
        return x >= left - marginPx && x <= right + marginPx && y >= top - marginPx && y <= bottom + marginPx;
    }

    /** Whether this box and another lie no farther apart than a gap in px, along both axes. */
    public boolean isWithin(double gapPx, Bounds other) {
        return left <= other.right + gapPx && other.left <= right + gapPx
            && top <= other.bottom + gapPx && other.top <= bottom + gapPx;
    }

    /** Share of the pixels of this box that lie on a sensor; the places are centres of pixels. */
    public double shareOn(int sensorWidth, int sensorHeight) {
        return shareOn(left, right, sensorWidth) * shareOn(top, bottom, sensorHeight);
    }

    private static double shareOn(double from, double to, int side) {
        return Math.max(0, Math.min(to, side - 1) - Math.max(from, 0) + 1) / (to - from + 1);
    }

    /** Least x of the places. */
    public double left() {
        return left;
    }

    /** Least y. */
    public double top() {
        return top;
    }

    /** Greatest x. */
    public double right() {
        return right;
    }

    /** Greatest y. */
    public double bottom() {
        return bottom;
    }
}
