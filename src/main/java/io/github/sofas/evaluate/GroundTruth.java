package io.github.sofas.evaluate;

import io.github.sofas.simulate.SimulatedRecording;

/**
 * What is true of each event of a recording, in parallel arrays. The arrays are held, not copied.
 *
 * @param timeUs time in µs, never falling
 * @param vxPxPerS velocity of the object's surface at the event, to the right, in px/s
 * @param vyPxPerS the same downwards
 * @param object id of the object that caused the event, from 1; 0 where it is noise
 */
public record GroundTruth(long[] timeUs, float[] vxPxPerS, float[] vyPxPerS, int[] object) {
    /** The object id of noise. */
    public static final int NOISE = 0;

    /**
     * Checks the arrays.
     *
     * @param timeUs time in µs, never falling
     * @param vxPxPerS velocity of the object's surface at the event, to the right, in px/s
     * @param vyPxPerS the same downwards
     * @param object id of the object that caused the event, from 1; 0 where it is noise
     * @throws IllegalArgumentException where lengths differ, time falls, an id is negative or a velocity is not finite
     */
    public GroundTruth {
        int n = timeUs.length;
        if (vxPxPerS.length != n || vyPxPerS.length != n || object.length != n) {
            throw new IllegalArgumentException("truth arrays must have one length but have " + n + ", "
                    + vxPxPerS.length + ", " + vyPxPerS.length + " and " + object.length);
        }
        for (int i = 0; i < n; i++) {
            if (i > 0 && timeUs[i] < timeUs[i - 1]) {
                throw new IllegalArgumentException("truth event " + i + ": time must not fall but went from "
                        + timeUs[i - 1] + " to " + timeUs[i] + " us");
            }
            if (object[i] < 0) {
                throw new IllegalArgumentException("truth event " + i + ": object must be at least 0 but was "
                        + object[i]);
            }
            if (!Float.isFinite(vxPxPerS[i]) || !Float.isFinite(vyPxPerS[i])) {
                throw new IllegalArgumentException("truth event " + i + ": velocity must be finite but was ("
                        + vxPxPerS[i] + ", " + vyPxPerS[i] + ")");
            }
        }
    }

    /**
     * {@return what the simulator knows of its recording; the recording's own arrays}
     *
     * @param recording of the simulator
     */
    public static GroundTruth of(SimulatedRecording recording) {
        return new GroundTruth(recording.timeUs, recording.vxPxPerS, recording.vyPxPerS, recording.object);
    }

    /**
     * {@return the first event that counts if a share of the time is left out at the beginning} Its time is the first
     * that is at least first + share (last - first).
     *
     * @param skipFirstShare 0 to below 1
     */
    public int firstCounted(double skipFirstShare) {
        int n = size();
        if (n == 0) {
            return 0;
        }
        double from = timeUs[0] + skipFirstShare * (timeUs[n - 1] - timeUs[0]);
        int i = 0;
        while (i < n && timeUs[i] < from) {
            i++;
        }
        return i;
    }

    /** {@return the number of events} */
    public int size() {
        return timeUs.length;
    }

    double speed(int i) {
        return Math.hypot(vxPxPerS[i], vyPxPerS[i]);
    }
}
