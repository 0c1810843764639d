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
    /** The label of that path; 0 for none. */
    int[] label = new int[FIRST_CAPACITY];
    float[] vxPxPerS = new float[FIRST_CAPACITY];
    float[] vyPxPerS = new float[FIRST_CAPACITY];

    private long first;
    private long end;

    /** The most bytes that its arrays take, with that many events at most. */
    static long mostBytes(int mostEvents) {
        long capacity = Integer.highestOneBit(Math.max(FIRST_CAPACITY, mostEvents) - 1) * 2L;
        return capacity * (2 * Long.BYTES + 2 * Short.BYTES + Byte.BYTES + 2 * Integer.BYTES + 2 * Float.BYTES);
    }

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

    /** Gives an entry to a path, whose label is another or the same. */
    void give(int k, int path, int pathLabel) {
        segment[k] = path;
        label[k] = pathLabel;
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

    /** Writes another id where there is one, in the segments or labels of the events from a number on. */
    void replace(int[] ids, long fromEvent, int id, int by) {
        for (long i = Math.max(first, fromEvent); i < end; i++) {
            int k = at(i);
            if (ids[k] == id) {
                ids[k] = by;
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
