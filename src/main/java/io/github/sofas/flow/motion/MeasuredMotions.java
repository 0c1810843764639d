package io.github.sofas.flow.motion;

/** Receives each motion that is measured of a segment. */
@FunctionalInterface
public interface MeasuredMotions {
    /**
     * Receives a measurement.
     *
     * @param segment id of the segment
     * @param motion the measured motion, whose reference is the middle of the window it was measured over; the caller
     *     continues to change this object
     */
    void measured(int segment, Motion motion);
}
