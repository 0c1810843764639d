package io.github.sofas.event;

/**
 * A run of consecutive events in parallel arrays, allocated once and filled again and again.
 *
 * <p>Axes: x to the right, y down, origin at the top left, in pixels. Time is in µs and never decreases within a
 * recording. The arrays are public so that readers fill them, and the engine walks through them, without a call per
 * event. Only the first {@link #size()} entries are valid. A batch is for one thread at a time.
 */
public final class EventBatch {
    /** Time of each event in µs. */
    public final long[] timeUs;
    /** Column of each event, from 0 at the left. */
    public final short[] x;
    /** Row of each event, from 0 at the top. */
    public final short[] y;
    /** +1 for a rise of brightness (ON), -1 for a fall (OFF). */
    public final byte[] polarity;

    private int size;

    /**
     * Makes an empty batch.
     *
     * @param capacity the most events that the batch can hold, at least 1
     * @throws IllegalArgumentException if the capacity is less than 1
     */
    public EventBatch(int capacity) {
        if (capacity < 1) {
            throw new IllegalArgumentException("capacity must be at least 1 but was " + capacity);
        }
        timeUs = new long[capacity];
        x = new short[capacity];
        y = new short[capacity];
        polarity = new byte[capacity];
    }

    /** {@return the most events that fit} */
    public int capacity() {
        return timeUs.length;
    }

    /** {@return the number of events held} */
    public int size() {
        return size;
    }

    /** {@return whether no further event fits} */
    public boolean isFull() {
        return size == timeUs.length;
    }

    /** Forgets all events. */
    public void clear() {
        size = 0;
    }

    /**
     * Appends one event.
     *
     * @param eventTimeUs time in µs
     * @param eventX column of the pixel, from 0 at the left
     * @param eventY row of the pixel, from 0 at the top
     * @param eventPolarity 1 for ON, -1 for OFF
     * @throws ArrayIndexOutOfBoundsException if the batch is full
     */
    public void add(long eventTimeUs, int eventX, int eventY, int eventPolarity) {
        int i = size;
        timeUs[i] = eventTimeUs;
        x[i] = (short) eventX;
        y[i] = (short) eventY;
        polarity[i] = (byte) eventPolarity;
        size = i + 1;
    }

    /**
     * Appends some events of another batch.
     *
     * @param from the batch to copy from, which is only read; not this batch
     * @param first index of the first event to copy
     * @param count number of events to copy
     * @throws IndexOutOfBoundsException if the other batch has no such events, or if they do not fit into this one
     */
    public void addAll(EventBatch from, int first, int count) {
        System.arraycopy(from.timeUs, first, timeUs, size, count);
        System.arraycopy(from.x, first, x, size, count);
        System.arraycopy(from.y, first, y, size, count);
        System.arraycopy(from.polarity, first, polarity, size, count);
        size += count;
    }

    /**
     * Sets the number of valid entries, after a caller has written to the arrays itself.
     *
     * @param newSize number of valid entries, from 0 to {@link #capacity}
     * @throws IllegalArgumentException if the size is negative or above the capacity
     */
    public void setSize(int newSize) {
        if (newSize < 0 || newSize > timeUs.length) {
            throw new IllegalArgumentException("size must be between 0 and " + timeUs.length + " but was " + newSize);
        }
        size = newSize;
    }
}
