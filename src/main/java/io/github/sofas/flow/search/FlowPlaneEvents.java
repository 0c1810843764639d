package io.github.sofas.flow.search;

/**
 * The events that the flow plane holds, numbered in the order in which they came. Marks note the rings of projections
 * from which an event was taken out, and those in which it was looked at in vain. The events lie in ring buffers, which
 * grow with the number of events held.
 */
final class FlowPlaneEvents implements NumberedEvents {
    /** Most events for which the arrays have room. */
    static final int MOST_HELD = 1 << 20;
    private static final int EVENT_BYTES = Long.BYTES + 2 * Short.BYTES + Byte.BYTES + 2 * Integer.BYTES;

    private static final int WORD_BITS = 6;

    // indexed by event number modulo the capacity
    private long[] timeUs = new long[1 << 14];
    private short[] x = new short[1 << 14];
    private short[] y = new short[1 << 14];
    private byte[] sign = new byte[1 << 14];
    /** Rings from which the event was taken out, one bit each. */
    private int[] takenOut = new int[1 << 14];
    /** Events that were taken out of no ring, one bit each. */
    private long[] left = new long[1 << 14 - WORD_BITS];
    /** Rings in which the event was looked at in vain, one bit each. */
    private int[] refused = new int[1 << 14];
    private int mask = timeUs.length - 1;
    private int head;
    private int first;
    /**
     * Number of the oldest event that is still stored. It may come before the first held event, because its votes are
     * yet to be taken out.
     */
    private int kept;

    /** Most bytes of the arrays. */
    static long mostBytes() {
        return (long) EVENT_BYTES * MOST_HELD + MOST_HELD / Byte.SIZE;
    }

    /** Adds an event; no more than {@link #MOST_HELD} may be held. */
    void add(int eventX, int eventY, long eventUs, int polarity) {
        if (head - kept > mask) {
            grow();
        }
        int i = head++ & mask;
        timeUs[i] = eventUs;
        x[i] = (short) eventX;
        y[i] = (short) eventY;
        sign[i] = (byte) polarity;
        takenOut[i] = 0;
        left[i >> WORD_BITS] |= 1L << i;
        refused[i] = 0;
    }

    private void grow() {
        int capacity = 2 * timeUs.length;
        long[] newUs = new long[capacity];
        short[] newX = new short[capacity];
        short[] newY = new short[capacity];
        byte[] newSign = new byte[capacity];
        int[] newTakenOut = new int[capacity];
        int[] newRefused = new int[capacity];
        long[] newLeft = new long[capacity >> WORD_BITS];
        for (int i = kept; i != head; i++) {
            int from = i & mask;
            int to = i & capacity - 1;
            newUs[to] = timeUs[from];
            newX[to] = x[from];
            newY[to] = y[from];
            newSign[to] = sign[from];
            newTakenOut[to] = takenOut[from];
            newRefused[to] = refused[from];
            newLeft[to >> WORD_BITS] |= takenOut[from] == 0 ? 1L << to : 0;
        }
        timeUs = newUs;
        x = newX;
        y = newY;
        sign = newSign;
        takenOut = newTakenOut;
        refused = newRefused;
        left = newLeft;
        mask = capacity - 1;
    }

    @Override
    public int head() {
        return head;
    }

    @Override
    public int oldest() {
        return first;
    }

    /** Releases all events before a number. Those before the second number are not needed any more. */
    void letGo(int before, int beforeNeeded) {
        first = before;
        kept = beforeNeeded;
    }

    /** Whether an event that came is still held. */
    boolean holds(int event) {
        return event - first >= 0;
    }

    int x(int event) {
        return x[event & mask];
    }

    int y(int event) {
        return y[event & mask];
    }

    @Override
    public long timeUs(int event) {
        return timeUs[event & mask];
    }

    /** +1 or -1. */
    int sign(int event) {
        return sign[event & mask];
    }

    /** Notes that an event was taken out of a ring. */
    void takeOut(int ring, int event) {
        takenOut[event & mask] |= 1 << ring;
        left[(event & mask) >> WORD_BITS] &= ~(1L << event);
    }

    boolean isTakenOut(int ring, int event) {
        return (takenOut[event & mask] >> ring & 1) != 0;
    }

    /** Whether the event was taken out of any ring. */
    boolean isTakenOut(int event) {
        return takenOut[event & mask] != 0;
    }

    /**
     * Number of the first event, from the given one on, that was taken out of no ring. Where there is none, a number
     * not before {@link #head()}.
     */
    int left(int event) {
        int e = event;
        long word = left[(e & mask) >> WORD_BITS] >>> e;
        while (word == 0 && head - e > 0) {
            e = (e | Long.SIZE - 1) + 1;
            word = left[(e & mask) >> WORD_BITS];
        }
        return e + Long.numberOfTrailingZeros(word);
    }

    /** Notes that an event was looked at in vain in a ring. */
    void refuse(int ring, int event) {
        refused[event & mask] |= 1 << ring;
    }

    boolean wasRefused(int ring, int event) {
        return (refused[event & mask] >> ring & 1) != 0;
    }

    /** Forgets all events, and restarts their numbering. */
    void clear() {
        head = 0;
        first = 0;
        kept = 0;
    }
}
