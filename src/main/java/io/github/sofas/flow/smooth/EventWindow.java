package io.github.sofas.flow.smooth;

import java.util.Arrays;

/**
 * The events that are seen from both sides, with their labels, in a ring in order of time. Events are numbered from the
 * first one on; event i is entry {@link #at} of the arrays.
 */
final class EventWindow {
    private static final int FIRST_CAPACITY = 1 << 14;

    /** Time in µs, never falling. */
    long[] timeUs = new long[FIRST_CAPACITY];
    /** Time as it was handed in, which may step back. */
    long[] givenUs = new long[FIRST_CAPACITY];
    short[] x = new short[FIRST_CAPACITY];
    short[] y = new short[FIRST_CAPACITY];
    byte[] polarity = new byte[FIRST_CAPACITY];
    /** Id of the path of its segment; 0 where it has none. */
    int[] segment = new int[FIRST_CAPACITY];
    /** The label that it gets for good; 0 for none. */
    int[] label = new int[FIRST_CAPACITY];
    float[] vxPxPerS = new float[FIRST_CAPACITY];
    float[] vyPxPerS = new float[FIRST_CAPACITY];

    private long first;
    private long end;

    /** Entry of event i in the arrays. */
    int at(long i) {
        return (int) i & timeUs.length - 1;
    }

    /** Number of the oldest event that is kept. */
    long first() {
        return first;
    }

    /** Number after that of the newest event. */
    long end() {
        return end;
    }

    /** Appends an event, whose label is to be set. */
    int add(long eventUs, long eventGivenUs, int eventX, int eventY, int eventPolarity) {
        if (end - first == timeUs.length) {
            grow();
        }
        int k = at(end++);
        timeUs[k] = eventUs;
        givenUs[k] = eventGivenUs;
        x[k] = (short) eventX;
        y[k] = (short) eventY;
        polarity[k] = (byte) eventPolarity;
        return k;
    }

    private void grow() {
        int n = timeUs.length;
        int head = (int) first & n - 1;
        // in a ring of twice the length those that wrapped round lie behind the others, or the others behind them
        boolean wrapsLater = at(first, 2 * n) == head;
        int from = wrapsLater ? 0 : head;
        int count = wrapsLater ? head : n - head;
        timeUs = Arrays.copyOf(timeUs, 2 * n);
        givenUs = Arrays.copyOf(givenUs, 2 * n);
        x = Arrays.copyOf(x, 2 * n);
        y = Arrays.copyOf(y, 2 * n);
        polarity = Arrays.copyOf(polarity, 2 * n);
        segment = Arrays.copyOf(segment, 2 * n);
        label = Arrays.copyOf(label, 2 * n);
        vxPxPerS = Arrays.copyOf(vxPxPerS, 2 * n);
        vyPxPerS = Arrays.copyOf(vyPxPerS, 2 * n);
        for (Object each : new Object[] {timeUs, givenUs, x, y, polarity, segment, label, vxPxPerS, vyPxPerS}) {
            System.arraycopy(each, from, each, from + n, count);
        }
    }

    private static int at(long i, int length) {
        return (int) i & length - 1;
    }

    /** Gives the events of a segment, from a number on to before another, to one that proved to be the same. */
    void join(long fromEvent, long untilEvent, int from, int to) {
        for (long i = fromEvent; i < untilEvent; i++) {
            int k = at(i);
            if (segment[k] == from) {
                segment[k] = to;
            }
        }
    }

    /** Lets the events before a number go. */
    void forget(long before) {
        first = Math.max(first, before);
    }

    /** Forgets all events, and begins to number them anew. */
    void clear() {
        first = 0;
        end = 0;
    }
}
