package io.github.sofas.flow.paper;

import io.github.sofas.flow.motion.Projection;

/**
 * The live events of a track plane in order of time, and where each falls in the columns and in the rows of its 3 x 3
 * projections: nine projections need three shifts along each axis only.
 */
final class LiveEvents {
    static final int SIDE = 3;
    /** The most, so that no cell overflows; where there are more, the oldest go early. */
    static final int MOST = Short.MAX_VALUE;
    /** Length of arrays that is always enough: full at most half, they are moved to the front seldom. */
    private static final int LONGEST = 2 * (MOST + 1);

    long[] timeUs = new long[256];
    short[] x = new short[256];
    short[] y = new short[256];
    /** Where each falls in the columns and in the rows of projections. */
    final short[][] column = new short[SIDE][256];
    final short[][] row = new short[SIDE][256];
    /** Number of the oldest, and number after the newest. */
    int tail;
    int head;

    /** The most bytes that its arrays take. */
    static long mostBytes() {
        return (long) LONGEST * (Long.BYTES + (2 + 2 * SIDE) * Short.BYTES);
    }

    int size() {
        return head - tail;
    }

    boolean isEmpty() {
        return head == tail;
    }

    /** Time of the newest. */
    long newestUs() {
        return timeUs[head - 1];
    }

    /** Puts an event behind the live ones; it is one of them once {@link #head} has passed it. */
    void put(int eventX, int eventY, long eventUs) {
        if (head == timeUs.length) {
            moveToFront(head - tail > timeUs.length / 2 ? Math.min(2 * timeUs.length, LONGEST) : timeUs.length);
        }
        timeUs[head] = eventUs;
        x[head] = (short) eventX;
        y[head] = (short) eventY;
    }

    /** Moves the live events to the front of arrays of some length. */
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

    /** Finds where events [from, to) fall in the a-th column and row of projections, seen from a time. */
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

    /** Takes over the events of another track plane; all are to be projected anew. */
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
