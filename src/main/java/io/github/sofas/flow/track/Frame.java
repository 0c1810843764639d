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
    /** From the sensor to it at the motion's reference, when another motion is followed. */
    private final SteppedProjection toReference = new SteppedProjection();
    // from the sensor at the motion's reference to the frame: a similarity
    private double cos;
    private double sin;
    private double shiftX;
    private double shiftY;
    private double radius;
    private int changes;

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
        begin(toReference);
        changes++;
    }

    /** The motion that it follows. */
    Motion motion() {
        return motion;
    }

    /** How often it was anchored, or followed another motion. */
    int changes() {
        return changes;
    }

    /** Has a projection bring events of the sensor to the motion's reference. */
    void begin(SteppedProjection projection) {
        projection.begin(motion, SPAN_US, 2 * radius, STEP_PX);
    }

    /** Cosine of the angle between the sensor at the motion's reference and the frame, times the scale. */
    double cos() {
        return cos;
    }

    /** The same, the sine. */
    double sin() {
        return sin;
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
        changes++;
        shiftX += dx;
        shiftY += dy;
    }

    /** Anchors the frame to the sensor at the motion's reference again. */
    void anchorAgain() {
        changes++;
        cos = 1;
        sin = 0;
        shiftX = 0;
        shiftY = 0;
    }

    double shiftX() {
        return shiftX;
    }

    double shiftY() {
        return shiftY;
    }
}
