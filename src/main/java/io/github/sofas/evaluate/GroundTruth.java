package io.github.sofas.evaluate;

import io.github.sofas.simulate.SimulatedRecording;

/**
 * The truth of each event of a recording: the velocity and the object behind the event, in parallel arrays. The arrays
 * are held, not copied.
 *
 * @param timeUs time in µs, never decreasing
 * @param vxPxPerS velocity of the object's surface at the event, to the right, in px/s
 * @param vyPxPerS velocity of the object's surface at the event, downwards, in px/s
 * @param object id of the object that caused the event, from 1; 0 for noise
 */
public record GroundTruth(long[] timeUs, float[] vxPxPerS, float[] vyPxPerS, int[] object) {
    /** The object id of noise. */
    public static final int NOISE = 0;

    /**
     * Checks the arrays.
     *
     * @param timeUs time in µs, never decreasing
     * @param vxPxPerS velocity of the object's surface at the event, to the right, in px/s
     * @param vyPxPerS velocity of the object's surface at the event, downwards, in px/s
     * @param object id of the object that caused the event, from 1; 0 for noise
     * @throws IllegalArgumentException if lengths differ, time decreases, an id is negative or a velocity is not finite
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
     * {@return the truth that the simulator stored with a recording; shares the recording's arrays}
     *
     * @param recording a recording of the simulator
     */
    public static GroundTruth of(SimulatedRecording recording) {
        return new GroundTruth(recording.timeUs, recording.vxPxPerS, recording.vyPxPerS, recording.object);
    }

    /**
     * {@return the number of the first event that counts if a share of the time is left out at the beginning} This is
     * the first event whose time is at least first + share (last - first).
     *
     * @param skipFirstShare share of the time that is left out, 0 to below 1
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
