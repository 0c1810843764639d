package io.github.sofas.flow.motion;

/** The box around some places, upright; made once and used again. */
public final class Bounds {
    private double left;
    private double top;
    private double right;
    private double bottom;

    /** Makes it around no place. */
    public Bounds() {
        clear();
    }

    /** Begins around no place: its left side is then infinitely far to the right, and so on. */
    public void clear() {
        left = Double.POSITIVE_INFINITY;
        top = Double.POSITIVE_INFINITY;
        right = Double.NEGATIVE_INFINITY;
        bottom = Double.NEGATIVE_INFINITY;
    }

    /** Widens it so that it holds a place. */
    public void include(double x, double y) {
        left = Math.min(left, x);
        top = Math.min(top, y);
        right = Math.max(right, x);
        bottom = Math.max(bottom, y);
    }

    /** Makes it a box that is known. */
    public void set(double toLeft, double toTop, double toRight, double toBottom) {
        left = toLeft;
        top = toTop;
        right = toRight;
        bottom = toBottom;
    }

    /** Whether it holds a place, or lies beside it by so many px along either axis at most. */
    public boolean isAround(double x, double y, double marginPx) {
        return x >= left - marginPx && x <= right + marginPx && y >= top - marginPx && y <= bottom + marginPx;
    }

    /** Whether it and another lie no farther apart than a gap in px, along both axes. */
    public boolean isWithin(double gapPx, Bounds other) {
        return left <= other.right + gapPx && other.left <= right + gapPx
            && top <= other.bottom + gapPx && other.top <= bottom + gapPx;
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
