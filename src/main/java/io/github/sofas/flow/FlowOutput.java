package io.github.sofas.flow;

/**
 * Flow and segment of each event of a batch, in arrays of the caller: entry i belongs to event i of the batch that was
 * processed last. Make one and reuse it: every call overwrites the entries. For one thread at a time.
 */
public final class FlowOutput {
    /** Velocity to the right in px/s; 0 where {@link #segment} is 0. */
    public final float[] vxPxPerS;
    /** Velocity downwards in px/s; 0 where {@link #segment} is 0. */
    public final float[] vyPxPerS;
    /** Id of the segment, from 1; 0 where the event has no flow. */
    public final int[] segment;

    /**
     * Makes the arrays.
     *
     * @param capacity the size of the largest batch, at least 1
     * @throws IllegalArgumentException if the capacity is less than 1
     */
    public FlowOutput(int capacity) {
        if (capacity < 1) {
            throw new IllegalArgumentException("capacity must be at least 1 but was " + capacity);
        }
        vxPxPerS = new float[capacity];
        vyPxPerS = new float[capacity];
        segment = new int[capacity];
    }

    /** Sets entry i. */
    void set(int i, int id, float vx, float vy) {
        segment[i] = id;
        vxPxPerS[i] = vx;
        vyPxPerS[i] = vy;
    }

    /** {@return the size of the largest batch that can be labelled} */
    public int capacity() {
        return segment.length;
    }
}
