package io.github.sofas.flow.search;

import io.github.sofas.event.SensorSize;

/**
 * The newest events that no track plane took, including those of tiles that are not searched. From these, a new
 * structure takes over its surroundings. The events lie in a ring buffer by number, in which each costs only its place.
 */
final class RecentEvents implements NumberedEvents {
    /**
     * Least number of events held per pixel of the sensor: more than the densest texture gives in a few px of travel.
     * On sensors of more than half a million px, fewer are held, since there are at most {@link #MOST}.
     */
    private static final int PER_PIXEL = 2;
    private static final int MOST = 1 << 20;
    private static final int EVENT_BYTES = Long.BYTES + 2 * Short.BYTES + Byte.BYTES;

    private final long[] timeUs;
    private final short[] x;
    private final short[] y;
    /** +1 or -1; 0 for an event that was taken. */
    private final byte[] sign;
    private final int mask;
    private int head;
    private int size;

    RecentEvents(SensorSize sensor) {
        int capacity = capacity(sensor);
        mask = capacity - 1;
        timeUs = new long[capacity];
        x = new short[capacity];
        y = new short[capacity];
        sign = new byte[capacity];
    }

    /** Most events that are held. */
    static int capacity(SensorSize sensor) {
        int wanted = Math.min(MOST, PER_PIXEL * sensor.width() * sensor.height());
        return 1 << Integer.SIZE - Integer.numberOfLeadingZeros(wanted - 1);
    }

    /** Bytes of the arrays. */
    static long bytes(SensorSize sensor) {
        return (long) EVENT_BYTES * capacity(sensor);
    }

    void add(int eventX, int eventY, long eventUs, int polarity) {
        int i = head++ & mask;
        timeUs[i] = eventUs;
        x[i] = (short) eventX;
        y[i] = (short) eventY;
        sign[i] = (byte) polarity;
        size = Math.min(size + 1, mask + 1);
    }

    @Override
    public int head() {
        return head;
    }

    @Override
    public int oldest() {
        return head - size;
    }

    /** Time of the newest event. */
    long newestUs() {
        return timeUs[head - 1 & mask];
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

    /** +1 or -1; 0 for an event that was taken. */
    int sign(int event) {
        return sign[event & mask];
    }

    /** Notes that a structure took an event. */
    void take(int event) {
        sign[event & mask] = 0;
    }

    /** Forgets all events. */
    void clear() {
        size = 0;
    }
}
