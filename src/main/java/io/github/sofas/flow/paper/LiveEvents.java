package io.github.sofas.flow.paper;

import io.github.sofas.flow.motion.Projection;

/**
 * The live events of a track plane in order of time, and the cell on which each falls in every column and every row of
 * the 3 x 3 projections. Nine projections need only three shifts along each axis.
 */
final class LiveEvents {
    static final int SIDE = 3;
    /** Greatest number of live events, so that no cell overflows; beyond it, the oldest leave early. */
    static final int MOST = Short.MAX_VALUE;
    /** Array length that always suffices: at most half full, so that events are seldom moved to the front. */
    private static final int LONGEST = 2 * (MOST + 1);

    long[] timeUs = new long[256];
    short[] x = new short[256];
    short[] y = new short[256];
    /** Cell column of each event in each column of projections, and its cell row in each row of projections. */
    final short[][] column = new short[SIDE][256];
    final short[][] row = new short[SIDE][256];
    /** Index of the oldest live event, and index after the newest. */
    int tail;
    int head;

    /** Upper bound of the bytes that the arrays take. */
    static long mostBytes() {
        return (long) LONGEST * (Long.BYTES + (2 + 2 * SIDE) * Short.BYTES);
    }

    int size() {
        return head - tail;
    }

    boolean isEmpty() {
        return head == tail;
    }

    /** Time of the newest event. */
    long newestUs() {
        return timeUs[head - 1];
    }

    /** Stores an event after the live ones; it becomes live once {@link #head} has passed it. */
    void put(int eventX, int eventY, long eventUs) {
        if (head == timeUs.length) {
            moveToFront(head - tail > timeUs.length / 2 ? Math.min(2 * timeUs.length, LONGEST) : timeUs.length);
        }
        timeUs[head] = eventUs;
        x[head] = (short) eventX;
        y[head] = (short) eventY;
    }

    /** Moves the live events to the front of arrays of a given length. */
    private void moveToFront(int length) {
        long[] newTime = length == timeUs.length ? timeUs : new long[length];
        System.arraycopy(timeUs, tail, newTime, 0, head - tail);
        timeUs = newTime;
        x = moved(x, length);
        y = moved(y, length);
        for (int a = 0; a < SIDE; a++) {
            column[a] = moved(column[a], length);
            row[a] = moved(row[a], length);
        }
        head -= tail;
        tail = 0;
    }

    private short[] moved(short[] from, int length) {
        short[] to = length == from.length ? from : new short[length];
        System.arraycopy(from, tail, to, 0, head - tail);
        return to;
    }

    /** Projects events [from, to) into the a-th column and the a-th row of projections, with a reference time. */
    void project(int a, int fixedVx, int fixedVy, int maskX, int maskY, long referenceUs, int from, int to) {
        project(x, fixedVx, maskX, column[a], referenceUs, from, to);
        project(y, fixedVy, maskY, row[a], referenceUs, from, to);
    }

    private void project(short[] position, int velocity, int mask, short[] projected, long referenceUs, int from,
                         int to) {
        for (int i = from; i < to; i++) {
            projected[i] = (short) (position[i] - Projection.travelled(velocity, timeUs[i] - referenceUs) & mask);
        }
    }

    /** Takes over the events of another track plane. The caller must then project all events anew. */
    void merge(LiveEvents other) {
        int mine = size();
        int theirs = other.size();
        long[] newTime = new long[Math.max(timeUs.length, mine + theirs)];
        short[] newX = new short[newTime.length];
        short[] newY = new short[newTime.length];
        int a = tail;
        int b = other.tail;
        for (int i = 0; i < mine + theirs; i++) {
            boolean own = b == other.head || a != head && timeUs[a] <= other.timeUs[b];
            newTime[i] = own ? timeUs[a] : other.timeUs[b];
            newX[i] = own ? x[a] : other.x[b];
            newY[i] = own ? y[a++] : other.y[b++];
        }
        timeUs = newTime;
        x = newX;
        y = newY;
        for (int i = 0; i < SIDE; i++) {
            column[i] = new short[timeUs.length];
            row[i] = new short[timeUs.length];
        }
        tail = Math.max(0, mine + theirs - MOST);
        head = mine + theirs;
    }

    void clear() {
        head = 0;
        tail = 0;
    }
}
