package io.github.sofas.flow.motion;

/** Gets each motion of a segment that is measured. */
@FunctionalInterface
public interface MeasuredMotions {
    /**
     * Takes a measurement.
     *
     * @param segment id of the segment
     * @param motion with the middle of the window that it was measured over as its reference; the caller goes on to
     *     change it
     */
    void measured(int segment, Motion motion);
}
