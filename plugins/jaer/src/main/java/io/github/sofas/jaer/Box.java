package io.github.sofas.jaer;

/** A rectangle on the screen, in screen pixels, with y up. */
record Box(float left, float bottom, float right, float top) {

    static Box of(float left, float bottom, float width, float height) {
        return new Box(left, bottom, left + width, bottom + height);
    }

    float width() {
        return right - left;
    }

    float height() {
        return top - bottom;
    }

    boolean overlaps(Box other) {
        return left < other.right && other.left < right && bottom < other.top && other.bottom < top;
    }

    /** Distance between the centres of two boxes. */
    float distance(Box other) {
        return (float) Math.hypot(left + right - other.left - other.right, bottom + top - other.bottom - other.top) / 2;
    }
}
