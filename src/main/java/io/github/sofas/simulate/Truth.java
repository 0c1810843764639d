package io.github.sofas.simulate;

/**
 * The object that caused each event of a batch, and its velocity, in parallel arrays. Entry i belongs to event i of the
 * batch that was filled last. The arrays are made once and reused.
 */
public final class Truth {
    /** True image velocity to the right in px/s; 0 for noise. */
    public final float[] vxPxPerS;
    /** True image velocity downwards in px/s; 0 for noise. */
    public final float[] vyPxPerS;
    /** Number of the object that caused the event, from 1; 0 for noise and hot pixels. */
    public final int[] object;

    /**
     * Makes the arrays.
     *
     * @param capacity the size of the largest batch, at least 1
     * @throws IllegalArgumentException if the capacity is smaller
     */
    public Truth(int capacity) {
        if (capacity < 1) {
            throw new IllegalArgumentException("capacity must be at least 1 but was " + capacity);
        }
        vxPxPerS = new float[capacity];
        vyPxPerS = new float[capacity];
        object = new int[capacity];
    }

    /** {@return the size of the largest batch that fits} */
    public int capacity() {
        return object.length;
    }
}
