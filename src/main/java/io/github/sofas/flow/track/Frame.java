package io.github.sofas.flow.track;

import io.github.sofas.flow.motion.Motion;
import io.github.sofas.flow.motion.SteppedProjection;

/**
 * Coordinates that travel, turn and grow with a structure, in pixels of the sensor at the time when they were anchored
 * to it. A motion that is known better carries them on from where they are, so that what was seen stays in its place.
 */
final class Frame {
    /** Events are brought into the frame in steps of this part of a pixel: far less than they jitter. */
    private static final double STEP_PX = 1.0 / 16;
    /** Span of the steps, and radius that the motion's turning is allowed for. */
    private static final long SPAN_US = 1_000_000;

    private final Motion motion = new Motion();
    private final SteppedProjection toReference = new SteppedProjection();
    // from the sensor at the motion's reference to the frame: a similarity
    private double cos;
    private double sin;
    private double shiftX;
    private double shiftY;
    private double radius;
    // from the sensor at the time gone on to, to the frame: both in one
    private double nowCos;
    private double nowSin;
    private double nowShiftX;
    private double nowShiftY;

    /** Anchors the frame to the sensor at the reference of a motion, which it follows from then on. */
    void anchor(Motion along, double structureRadius) {
        cos = 1;
        sin = 0;
        shiftX = 0;
        shiftY = 0;
        take(along, structureRadius);
    }

    /** Follows another motion from its reference on; the frame stays where it is then. */
    void follow(Motion along, double structureRadius) {
        toReference.goTo(along.referenceUs);
        double c = cos * toReference.cos() - sin * toReference.sin();
        double s = sin * toReference.cos() + cos * toReference.sin();
        double x = cos * toReference.shiftX() + sin * toReference.shiftY() + shiftX;
        double y = cos * toReference.shiftY() - sin * toReference.shiftX() + shiftY;
        cos = c;
        sin = s;
        shiftX = x;
        shiftY = y;
        take(along, structureRadius);
    }

    private void take(Motion along, double structureRadius) {
        motion.copyFrom(along);
        radius = structureRadius;
        begin();
    }

    /** Has the next event take a step, with the frame as it lies now. */
    private void begin() {
        toReference.begin(motion, SPAN_US, 2 * radius, STEP_PX);
    }

    /** The motion that it follows. */
    Motion motion() {
        return motion;
    }

    /** Goes on to the time of the next event. */
    void advance(long timeUs) {
        if (toReference.advance(timeUs)) {
            nowCos = cos * toReference.cos() - sin * toReference.sin();
            nowSin = cos * toReference.sin() + sin * toReference.cos();
            nowShiftX = fromReferenceX(toReference.shiftX(), toReference.shiftY());
            nowShiftY = fromReferenceY(toReference.shiftX(), toReference.shiftY());
        }
    }

    /** Column in the frame of an event of this time, in px. */
    double x(int eventX, int eventY) {
        return nowCos * eventX + nowSin * eventY + nowShiftX;
    }

    /** The same, the row. */
    double y(int eventX, int eventY) {
        return nowCos * eventY - nowSin * eventX + nowShiftY;
    }

    /** Column in the frame of a place of the sensor at the motion's reference, in px. */
    double fromReferenceX(double x, double y) {
        return cos * x + sin * y + shiftX;
    }

    /** The same, the row. */
    double fromReferenceY(double x, double y) {
        return cos * y - sin * x + shiftY;
    }

    /** Column of the sensor at the motion's reference of a place in the frame. */
    double toReferenceX(double x, double y) {
        return (cos * (x - shiftX) - sin * (y - shiftY)) / (cos * cos + sin * sin);
    }

    /** The same, the row. */
    double toReferenceY(double x, double y) {
        return (sin * (x - shiftX) + cos * (y - shiftY)) / (cos * cos + sin * sin);
    }

    /** Column of the sensor, at the time gone on to, of a place in the frame. */
    double sensorX(double x, double y) {
        return toReference.backX(toReferenceX(x, y), toReferenceY(x, y));
    }

    /** The same, the row. */
    double sensorY(double x, double y) {
        return toReference.backY(toReferenceX(x, y), toReferenceY(x, y));
    }

    /** How far the frame lies from the sensor at the motion's reference, at most, at a place of it, in px. */
    double departurePx(double x, double y) {
        double dx = fromReferenceX(x, y) - x;
        double dy = fromReferenceY(x, y) - y;
        return Math.sqrt(dx * dx + dy * dy);
    }

    /** Whether it was only shifted since it was anchored. */
    boolean isOnlyShifted() {
        return cos == 1 && sin == 0;
    }

    /** Shifts the frame by whole pixels. */
    void shift(int dx, int dy) {
        shiftX += dx;
        shiftY += dy;
        begin();
    }

    /** Anchors the frame to the sensor at the motion's reference again. */
    void anchorAgain() {
        cos = 1;
        sin = 0;
        shiftX = 0;
        shiftY = 0;
        begin();
    }

    double shiftX() {
        return shiftX;
    }

    double shiftY() {
        return shiftY;
    }
}
