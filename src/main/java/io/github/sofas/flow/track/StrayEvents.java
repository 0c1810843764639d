package io.github.sofas.flow.track;

/** The newest events that no track plane took: noise, new structures, and those that slipped off their contours. */
final class StrayEvents {
    static final int CAPACITY = 1 << 10;
    /** Bytes of its arrays. */
    static final long BYTES = CAPACITY * (Long.BYTES + 2L * Short.BYTES);
    private static final int MASK = CAPACITY - 1;

    final long[] timeUs = new long[CAPACITY];
    final short[] x = new short[CAPACITY];
    final short[] y = new short[CAPACITY];
    private int head;
    private int size;

    int size() {
        return size;
    }

    /** Index into the arrays of the k-th event, 0 the newest. */
    int index(int k) {
        return head - 1 - k & MASK;
    }

    void add(int eventX, int eventY, long eventUs) {
        timeUs[head] = eventUs;
        x[head] = (short) eventX;
        y[head] = (short) eventY;
        head = head + 1 & MASK;
        size = Math.min(size + 1, CAPACITY);
    }

    void clear() {
        size = 0;
    }
}
