package io.github.sofas.flow.smooth;

import java.util.Arrays;

/**
 * The events that are looked at from both sides, with their labels: a ring in order of time. Events are numbered from
 * the first one of the recording on; event i is entry {@link #at} of the arrays.
 */
final class EventWindow {
    private static final int FIRST_CAPACITY = 1 << 14;

    /** Time in µs, never falling. */
    long[] timeUs = new long[FIRST_CAPACITY];
    /** Time as it was handed in; may step back. */
    long[] givenUs = new long[FIRST_CAPACITY];
    short[] x = new short[FIRST_CAPACITY];
    short[] y = new short[FIRST_CAPACITY];
    byte[] polarity = new byte[FIRST_CAPACITY];
    /** Id of the path of the event's segment; 0 for none. */
    int[] segment = new int[FIRST_CAPACITY];
    /** The label of that path; 0 for none. */
    int[] label = new int[FIRST_CAPACITY];
    float[] vxPxPerS = new float[FIRST_CAPACITY];
    float[] vyPxPerS = new float[FIRST_CAPACITY];

    private long first;
    private long end;

    /** Most bytes that its arrays take if it holds at most so many events. */
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

    /** One more than the number of the newest event. */
    long end() {
        return end;
    }

    /** Appends an event, and returns its entry; the caller sets its label. */
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

    /** Assigns an entry to a path, with the label of that path. */
    void give(int k, int path, int pathLabel) {
        segment[k] = path;
        label[k] = pathLabel;
    }

    private void grow() {
        int n = timeUs.length;
        int head = (int) first & n - 1;
        // in a ring of twice the length, the entries that had wrapped round move behind the others, or the others
        // behind them
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

    /** Replaces an id by another in the segments or the labels of the events from a number on. */
    void replace(int[] ids, long fromEvent, int id, int by) {
        for (long i = Math.max(first, fromEvent); i < end; i++) {
            int k = at(i);
            if (ids[k] == id) {
                ids[k] = by;
            }
        }
    }

    /** Drops the events before a number. */
    void forget(long before) {
        first = Math.max(first, before);
    }

    /** Forgets all events, and numbers them from 0 again. */
    void clear() {
        first = 0;
        end = 0;
    }
}
