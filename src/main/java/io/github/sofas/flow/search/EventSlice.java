package io.github.sofas.flow.search;

/**
 * A short piece of the stream as the flow plane gets to know it: the events that no track plane explains, and how many
 * were labelled. It ends by the events alone, whatever the batches that they came in.
 */
public final class EventSlice {
    /** Most events that are labelled: searching takes as long as labelling some thousands of events then at most. */
    private static final int MOST = 2048;
    /** Longest time: as late as that, and as much again, a structure may be tracked after it was found. */
    private static final long LONGEST_US = 1_000;

    private final int[] x = new int[MOST];
    private final int[] y = new int[MOST];
    private final long[] timeUs = new long[MOST];
    private final byte[] sign = new byte[MOST];
    /** How many were labelled before each, and it. */
    private final int[] place = new int[MOST];
    private int size;
    private int labelled;
    private long fromUs;
    private long untilUs;

    /** What is to be done with an event that no track plane explains. */
    public interface Taker {
        /** Whether it takes the event. */
        boolean takes(int x, int y, long timeUs, int polarity);
    }

    /** Bytes of its arrays. */
    public static long bytes() {
        return MOST * (3L * Integer.BYTES + Long.BYTES + 1);
    }

    /** Whether it ends before an event of a time. */
    public boolean isOver(long nextUs) {
        return labelled == MOST || labelled > 0 && nextUs - fromUs >= LONGEST_US;
    }

    /** Notes an event that was labelled, +1 or -1; keeps it unless it is explained. */
    public void add(int eventX, int eventY, long eventUs, int polarity, boolean isExplained) {
        if (labelled == 0) {
            fromUs = eventUs;
        }
        untilUs = eventUs;
        labelled++;
        if (!isExplained) {
            x[size] = eventX;
            y[size] = eventY;
            timeUs[size] = eventUs;
            sign[size] = (byte) polarity;
            place[size] = labelled;
            size++;
        }
    }

    /** Hands out the events that are kept; those that are taken are explained. */
    public void offer(Taker taker) {
        int left = 0;
        for (int i = 0; i < size; i++) {
            if (!taker.takes(x[i], y[i], timeUs[i], sign[i])) {
                x[left] = x[i];
                y[left] = y[i];
                timeUs[left] = timeUs[i];
                sign[left] = sign[i];
                place[left] = place[i];
                left++;
            }
        }
        size = left;
    }

    /** Forgets all events. */
    public void clear() {
        size = 0;
        labelled = 0;
    }

    /** Events that are kept. */
    int size() {
        return size;
    }

    /** Events that were labelled. */
    public int labelled() {
        return labelled;
    }

    /** Time of the last event. */
    long untilUs() {
        return untilUs;
    }

    int x(int i) {
        return x[i];
    }

    int y(int i) {
        return y[i];
    }

    long timeUs(int i) {
        return timeUs[i];
    }

    int sign(int i) {
        return sign[i];
    }

    /** How many events were labelled until the i-th that is kept, with it. */
    int place(int i) {
        return place[i];
    }
}
