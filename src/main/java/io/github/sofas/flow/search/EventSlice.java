package io.github.sofas.flow.search;

/**
 * A short slice of the event stream, as the flow plane receives it: the events that no track plane explains, and the
 * number of all events that were labelled. While one slice is labelled, the flow plane searches the one before ({@link
 * SearchedFlowPlane}).
 *
 * <p>The events alone determine where a slice ends, whatever the batches in which they come.
 */
public final class EventSlice {
    /**
     * Most labelled events of a slice. Searching one then takes at most as long as labelling some thousands of events.
     */
    private static final int MOST = 2048;
    /** Longest duration of a slice. Tracking of a structure may begin up to twice this time after it was found. */
    private static final long LONGEST_US = 1_000;

    private final int[] x = new int[MOST];
    private final int[] y = new int[MOST];
    private final long[] timeUs = new long[MOST];
    private final byte[] sign = new byte[MOST];
    /** For each kept event, the number of events labelled up to and including it. */
    private final int[] place = new int[MOST];
    private int size;
    private int labelled;
    private long fromUs;
    private long untilUs;

    /** Receives the events that no track plane explains. */
    public interface Taker {
        /** Whether the receiver takes the event. */
        boolean takes(int x, int y, long timeUs, int polarity);
    }

    /** Bytes of the arrays of a slice. */
    public static long bytes() {
        return MOST * (3L * Integer.BYTES + Long.BYTES + 1);
    }

    /** Whether the slice ends before an event of the given time. */
    public boolean isOver(long nextUs) {
        return labelled == MOST || labelled > 0 && nextUs - fromUs >= LONGEST_US;
    }

    /** Counts a labelled event of polarity +1 or -1, and keeps it unless it is explained. */
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

    /** Offers the kept events to a taker. Those that it takes are explained, and are dropped. */
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

    /** Number of kept events. */
    int size() {
        return size;
    }

    /** Number of labelled events. */
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

    /** Number of events labelled up to and including the i-th kept event. */
    int place(int i) {
        return place[i];
    }
}
