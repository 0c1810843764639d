package io.github.sofas.evaluate;

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

    /** How many events there are. */
    public int size() {
        return timeUs.length;
    }

    double speed(int i) {
        return Math.hypot(vxPxPerS[i], vyPxPerS[i]);
    }
}
