package io.github.sofas.flow.track;

import io.github.sofas.flow.motion.SteppedProjection;

/**
 * Places of events in a frame, as one sees them who goes on from event to event: all that brings events into it is one
 * similarity for the time in which it goes on by a small part of a pixel. Apart from the frame, so that several may
 * look at once.
 */
final class FrameView {
    private final Frame frame;
    private final SteppedProjection toReference = new SteppedProjection();
    /** Changes of the frame that it has seen. */
    private int changes;
    // from the sensor at the time gone on to, to the frame
    private double cos;
    private double sin;
    private double shiftX;
    private double shiftY;
    private double x;
    private double y;

    FrameView(Frame frame) {
        this.frame = frame;
    }

    /** Goes on to a time. */
    void advance(long timeUs) {
        boolean hasChanged = changes != frame.changes();
        if (hasChanged) {
            changes = frame.changes();
            frame.begin(toReference);
        }
        if (toReference.advance(timeUs) || hasChanged) {
            cos = frame.cos() * toReference.cos() - frame.sin() * toReference.sin();
            sin = frame.cos() * toReference.sin() + frame.sin() * toReference.cos();
            shiftX = frame.fromReferenceX(toReference.shiftX(), toReference.shiftY());
            shiftY = frame.fromReferenceY(toReference.shiftX(), toReference.shiftY());
        }
    }

    /** Locates an event of the sensor. */
    void locate(int eventX, int eventY, long timeUs) {
        advance(timeUs);
        x = cos * eventX + sin * eventY + shiftX;
        y = cos * eventY - sin * eventX + shiftY;
    }

    /** Column in the frame of the event that was located last, in px. */
    double x() {
        return x;
    }

    /** The same, the row. */
    double y() {
        return y;
    }

    /** Column of the sensor, at the time gone on to, of a place in the frame. */
    double sensorX(double inFrameX, double inFrameY) {
        return toReference.backX(frame.toReferenceX(inFrameX, inFrameY), frame.toReferenceY(inFrameX, inFrameY));
    }

    /** The same, the row. */
    double sensorY(double inFrameX, double inFrameY) {
        return toReference.backY(frame.toReferenceX(inFrameX, inFrameY), frame.toReferenceY(inFrameX, inFrameY));
    }
}
