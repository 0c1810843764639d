package io.github.sofas.flow.smooth;

/** The box around some events on the sensor, with its sides on the outermost ones, and how many they are. */
final class PixelBox {
    int left;
    int top;
    int right;
    int bottom;
    int events;

    PixelBox() {
        clear();
    }

    /** Begins around no event: no column is from its left to its right side then, and no row from its top down. */
    void clear() {
        left = Integer.MAX_VALUE;
        top = Integer.MAX_VALUE;
        right = Integer.MIN_VALUE;
        bottom = Integer.MIN_VALUE;
        events = 0;
    }

    /** Adds an event. */
    void add(int x, int y) {
        left = Math.min(left, x);
        right = Math.max(right, x);
        top = Math.min(top, y);
        bottom = Math.max(bottom, y);
        events++;
    }

    /** Adds the events of another one. */
    void add(PixelBox other) {
        int all = events + other.events;
        add(other.left, other.top);
        add(other.right, other.bottom);
        events = all;
    }

    /** About the root of the mean square distance of its events from their middle. */
    double radius() {
        return Math.hypot(right - left, bottom - top) / 4;
    }
}
