package io.github.sofas.flow.motion;

/** The box around some events on the sensor, with its sides on the outermost ones, and how many they are. */
public final class PixelBox {
    /** Column of the event farthest to the left. */
    public int left;
    /** Row of the highest one. */
    public int top;
    /** Column of the one farthest to the right. */
    public int right;
    /** Row of the lowest one. */
    public int bottom;
    /** How many events there are. */
    public int events;

    /** Makes it around no event. */
    public PixelBox() {
        clear();
    }

    /** Begins around no event: no column is from its left to its right side then, and no row from its top down. */
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

    /** Adds the events of another one. */
    public void add(PixelBox other) {
        int all = events + other.events;
        add(other.left, other.top);
        add(other.right, other.bottom);
        events = all;
    }

    /** About the root of the mean square distance of its events from their middle. */
    public double radius() {
        return Math.hypot(right - left, bottom - top) / 4;
    }
}
