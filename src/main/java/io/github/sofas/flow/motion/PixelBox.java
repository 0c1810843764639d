package io.github.sofas.flow.motion;

/** The bounding box of some events on the sensor, with its sides on the outermost events, and their number. */
public final class PixelBox {
    /** Column of the leftmost event. */
    public int left;
    /** Row of the topmost event. */
    public int top;
    /** Column of the rightmost event. */
    public int right;
    /** Row of the bottommost event. */
    public int bottom;
    /** Number of events. */
    public int events;

    /** Makes a box around no event. */
    public PixelBox() {
        clear();
    }

    /** Empties the box: no column then lies between its left and right side, and no row between its top and bottom. */
    public void clear() {
        left = Integer.MAX_VALUE;
        top = Integer.MAX_VALUE;
        right = Integer.MIN_VALUE;
        bottom = Integer.MIN_VALUE;
        events = 0;
    }

    /** Adds an event. */
    public void add(int x, int y) {
        left = Math.min(left, x);
        right = Math.max(right, x);
        top = Math.min(top, y);
        bottom = Math.max(bottom, y);
        events++;
    }

    /** Adds the events of another box. */
    public void add(PixelBox other) {
        int all = events + other.events;
        add(other.left, other.top);
        add(other.right, other.bottom);
        events = all;
    }

    /** Approximate root-mean-square distance of the events from their middle, in px. */
    public double radius() {
        return Math.hypot(right - left, bottom - top) / 4;
    }
}
