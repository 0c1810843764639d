package io.github.sofas.simulate;

import io.github.sofas.event.EventBatch;
import java.util.Arrays;

/**
 * Holds events and their truth on the way from the pixels to the reader. Events are gathered in any order and released
 * in order of time; events of the same time keep the order in which they were gathered.
 */
final class EventQueue {
    private static final int INDEX_BITS = 22;
    private static final int FIRST_CAPACITY = 4096;

    private long[] timeUs = new long[FIRST_CAPACITY];
    private short[] x = new short[FIRST_CAPACITY];
    private short[] y = new short[FIRST_CAPACITY];
    private byte[] polarity = new byte[FIRST_CAPACITY];
    private float[] vxPxPerS = new float[FIRST_CAPACITY];
    private float[] vyPxPerS = new float[FIRST_CAPACITY];
    private int[] object = new int[FIRST_CAPACITY];
    private long[] order = new long[FIRST_CAPACITY];
    private int gathered;
    /** Among the sorted entries of order: the first that is not taken yet, and the end of the ready ones. */
    private int firstReady;
    private int endReady;

    /** Number of events that wait, released or not. */
    int gathered() {
        return gathered;
    }

    boolean hasReady() {
        return firstReady < endReady;
    }

    void add(long eventTimeUs, int eventX, int eventY, int eventPolarity, float vx, float vy, int eventObject) {
        int i = gathered;
        if (i == timeUs.length) {
            grow(2 * i);
        }
        timeUs[i] = eventTimeUs;
        x[i] = (short) eventX;
        y[i] = (short) eventY;
        polarity[i] = (byte) eventPolarity;
        vxPxPerS[i] = vx;
        vyPxPerS[i] = vy;
        object[i] = eventObject;
        gathered = i + 1;
    }

    /**
     * Makes all events before a time ready. May be called only when no event is ready, and when every event still to
     * come is at that time or later.
     */
    void release(long untilUs) {
        int count = gathered;
        if (count == 0) {
            return;
        }
        if (count > 1 << INDEX_BITS) {
            throw new IllegalStateException("at most " + (1 << INDEX_BITS) + " events can wait but were " + count);
        }
        long baseUs = Long.MAX_VALUE;
        for (int i = 0; i < count; i++) {
            baseUs = Math.min(baseUs, timeUs[i]);
        }
        int ready = 0;
        for (int i = 0; i < count; i++) {
            order[i] = timeUs[i] - baseUs << INDEX_BITS | i;
            if (timeUs[i] < untilUs) {
                ready++;
            }
        }
        Arrays.sort(order, 0, count);
        firstReady = 0;
        endReady = ready;
    }

    /** Moves ready events into the batch until the batch is full or no ready event is left. */
    void drainTo(EventBatch batch, Truth truth) {
        int mask = (1 << INDEX_BITS) - 1;
        while (firstReady < endReady && !batch.isFull()) {
            int i = (int) order[firstReady] & mask;
            if (truth != null) {
                int to = batch.size();
                truth.vxPxPerS[to] = vxPxPerS[i];
                truth.vyPxPerS[to] = vyPxPerS[i];
                truth.object[to] = object[i];
            }
            batch.add(timeUs[i], x[i], y[i], polarity[i]);
            firstReady++;
        }
        if (firstReady == endReady && endReady > 0) {
            keepRest();
        }
    }

    /** Moves the events that were not ready to the front, in the order in which they were gathered. */
    private void keepRest() {
        int mask = (1 << INDEX_BITS) - 1;
        int rest = gathered - endReady;
        for (int k = 0; k < rest; k++) {
            order[k] = order[endReady + k] & mask;
        }
        Arrays.sort(order, 0, rest);
        for (int k = 0; k < rest; k++) {
            int i = (int) order[k];
            timeUs[k] = timeUs[i];
            x[k] = x[i];
            y[k] = y[i];
            polarity[k] = polarity[i];
            vxPxPerS[k] = vxPxPerS[i];
            vyPxPerS[k] = vyPxPerS[i];
            object[k] = object[i];
        }
        gathered = rest;
        firstReady = 0;
        endReady = 0;
    }

    private void grow(int capacity) {
        timeUs = Arrays.copyOf(timeUs, capacity);
        x = Arrays.copyOf(x, capacity);
        y = Arrays.copyOf(y, capacity);
        polarity = Arrays.copyOf(polarity, capacity);
        vxPxPerS = Arrays.copyOf(vxPxPerS, capacity);
        vyPxPerS = Arrays.copyOf(vyPxPerS, capacity);
        object = Arrays.copyOf(object, capacity);
        order = Arrays.copyOf(order, capacity);
    }
}
