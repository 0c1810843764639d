package io.github.sofas.flow.track;

import io.github.sofas.flow.motion.Motion;
import io.github.sofas.flow.motion.SteppedProjection;

/**
 * Coordinates that travel, turn and grow with a structure, in pixels of the sensor at the time when they were anchored
 * to it. When the motion becomes better known, the frame moves on from its current place, so that the events on a
 * contour stay on their cells.
 */
final class Frame {
    /** Step, in px, by which events are projected into the frame: far less than their jitter. */
    private static final double STEP_PX = 1.0 / 16;
    /** Greatest time between an event and the motion's reference that the steps allow for. */
    private static final long SPAN_US = 1_000_000;

    private final Motion motion = new Motion();
    private final SteppedProjection toReference = new SteppedProjection();
    // similarity from the sensor at the motion's reference to the frame
    private double cos;
    private double sin;
    private double shiftX;
    private double shiftY;
    private double radius;
    // similarity from the sensor at the time last advanced to, to the frame: both transforms in one
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

    /** Follows another motion from its reference on, without a jump of the frame at that time. */
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

    /** Makes the next event take a new step, from the frame as it lies now. */
    private void begin() {
        toReference.begin(motion, SPAN_US, 2 * radius, STEP_PX);
    }

    /** Returns the motion that the frame follows. */
    Motion motion() {
        return motion;
    }

    /** Advances to the time of the next event. */
    void advance(long timeUs) {
        if (toReference.advance(timeUs)) {
            nowCos = cos * toReference.cos() - sin * toReference.sin();
            nowSin = cos * toReference.sin() + sin * toReference.cos();
            nowShiftX = fromReferenceX(toReference.shiftX(), toReference.shiftY());
            nowShiftY = fromReferenceY(toReference.shiftX(), toReference.shiftY());
        }
    }

    /** Returns the column in the frame, in px, of an event at the time advanced to. */
    double x(int eventX, int eventY) {
        return nowCos * eventX + nowSin * eventY + nowShiftX;
    }

    /** Returns the row, as {@link #x} returns the column. */
    double y(int eventX, int eventY) {
        return nowCos * eventY - nowSin * eventX + nowShiftY;
    }

    /** Returns the column in the frame, in px, of a place of the sensor at the motion's reference. */
    double fromReferenceX(double x, double y) {
        return cos * x + sin * y + shiftX;
    }

    /** Returns the row, as {@link #fromReferenceX} returns the column. */
    double fromReferenceY(double x, double y) {
        return cos * y - sin * x + shiftY;
    }

    /** Returns the column of the sensor, at the motion's reference, of a place in the frame. */
    double toReferenceX(double x, double y) {
        return (cos * (x - shiftX) - sin * (y - shiftY)) / (cos * cos + sin * sin);
    }

    /** Returns the row, as {@link #toReferenceX} returns the column. */
    double toReferenceY(double x, double y) {
        return (sin * (x - shiftX) + cos * (y - shiftY)) / (cos * cos + sin * sin);
    }

    /** Returns the column of the sensor, at the time advanced to, of a place in the frame. */
    double sensorX(double x, double y) {
        return toReference.backX(toReferenceX(x, y), toReferenceY(x, y));
    }

    /** Returns the row, as {@link #sensorX} returns the column. */
    double sensorY(double x, double y) {
        return toReference.backY(toReferenceX(x, y), toReferenceY(x, y));
    }

    /** Returns the distance of the frame from the sensor at the motion's reference, in px, at a place of the sensor. */
    double departurePx(double x, double y) {
        double dx = fromReferenceX(x, y) - x;
        double dy = fromReferenceY(x, y) - y;
        return Math.sqrt(dx * dx + dy * dy);
    }

    /** Whether the frame has only been shifted since it was anchored. */
    boolean isOnlyShifted() {
        return cos == 1 && sin == 0;
    }

    /** Shifts the frame by whole pixels. */
    void shift(int dx, int dy) {
        shiftX += dx;
        shiftY += dy;
        begin();
    }

    /** Anchors the frame again, to the sensor at the motion's reference. */
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
