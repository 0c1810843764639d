package io.github.sofas.flow.track;

/**
 * The live events of a track plane, a ring in order of time. A full ring lets its oldest event go, so that memory is
 * bounded; a structure of that many events needs no more to be measured.
 */
final class LiveEvents {
    static final int CAPACITY = 1 << 14;
    /** Bytes of its arrays. */
    static final long BYTES = (long) CAPACITY * (Long.BYTES + 2 * Short.BYTES + 3 * Byte.BYTES + Integer.BYTES);
    private static final int MASK = CAPACITY - 1;

    final long[] timeUs = new long[CAPACITY];
    final short[] x = new short[CAPACITY];
    final short[] y = new short[CAPACITY];
    /** +1 or -1. */
    final byte[] sign = new byte[CAPACITY];
    /** Whether two planes claimed the event: it shows nothing of the motion of either. */
    final boolean[] shared = new boolean[CAPACITY];
    /** Whether no live event was near, only the memory of some: it may be noise, and shows nothing of the motion. */
    final boolean[] remembered = new boolean[CAPACITY];
    /** Cell of the contour that the event is counted on, or -1. */
    final int[] cell = new int[CAPACITY];

    private int head;
    private int size;

    int size() {
        return size;
    }

    boolean isFull() {
        return size == CAPACITY;
    }

    /** Index into the arrays of the k-th event, 0 the oldest. */
    int index(int k) {
        return head - size + k & MASK;
    }

    long oldestUs() {
        return timeUs[index(0)];
    }

    long newestUs() {
        return timeUs[index(size - 1)];
    }

    /** How many events are later than a time. */
    int since(long fromUs) {
        int low = 0;
        int high = size;
        while (low < high) {
            int middle = low + high >>> 1;
            if (timeUs[index(middle)] > fromUs) {
                high = middle;
            } else {
                low = middle + 1;
            }
        }
        return size - low;
    }

    /** Appends an event, not on a contour yet, and returns its index. */
    int add(int eventX, int eventY, long eventUs, int polarity, boolean isShared, boolean isRemembered) {
        int i = head & MASK;
        timeUs[i] = eventUs;
        x[i] = (short) eventX;
        y[i] = (short) eventY;
        sign[i] = (byte) polarity;
        shared[i] = isShared;
        remembered[i] = isRemembered;
        cell[i] = -1;
        head = head + 1 & MASK;
        size++;
        return i;
    }

    /** Lets the oldest event go. */
    void removeOldest() {
        size--;
    }

    void clear() {
        size = 0;
    }

    /** Takes over the events of two others, in order of time; the oldest go where they are too many. */
    void fillFrom(LiveEvents a, LiveEvents b) {
        clear();
        int ka = 0;
        int kb = 0;
        while (ka < a.size || kb < b.size) {
            boolean first = kb == b.size || ka < a.size && a.timeUs[a.index(ka)] <= b.timeUs[b.index(kb)];
            LiveEvents from = first ? a : b;
            int i = from.index(first ? ka++ : kb++);
            if (isFull()) {
                removeOldest();
            }
            add(from.x[i], from.y[i], from.timeUs[i], from.sign[i], from.shared[i], from.remembered[i]);
        }
    }
}
