package io.github.sofas.report;

import java.util.Arrays;

/**
 * Counts of events over equal bins of time. If there are too many bins, each pair of neighbours becomes one, so that
 * all bins are twice as long and memory stays bounded.
 */
final class TimeBins {
    static final int MOST = 512;
    private static final long FIRST_WIDTH_US = 10_000;

    private long widthUs = FIRST_WIDTH_US;
    private int used;
    private final long[] events = new long[MOST];
    private final long[] withFlow = new long[MOST];

    /** The bin of a time since the recording's first event. Makes room for this bin. */
    int place(long sinceFirstUs) {
        while (sinceFirstUs / widthUs >= MOST) {
            for (int i = 0; i < MOST / 2; i++) {
                events[i] = events[2 * i] + events[2 * i + 1];
                withFlow[i] = withFlow[2 * i] + withFlow[2 * i + 1];
            }
            Arrays.fill(events, MOST / 2, MOST, 0);
            Arrays.fill(withFlow, MOST / 2, MOST, 0);
            used = (used + 1) / 2;
            widthUs *= 2;
        }
        int place = (int) (sinceFirstUs / widthUs);
        used = Math.max(used, place + 1);
        return place;
    }

    void add(int place, boolean hasFlow) {
        events[place]++;
        withFlow[place] += hasFlow ? 1 : 0;
    }

    int used() {
        return used;
    }

    double widthS() {
        return widthUs * 1e-6;
    }

    long widthUs() {
        return widthUs;
    }

    /** Events per second. */
    double rate(int place) {
        return events[place] / widthS();
    }

    /** Percentage of the events that have flow; NaN if there are no events. */
    double share(int place) {
        return events[place] == 0 ? Double.NaN : 100.0 * withFlow[place] / events[place];
    }
}
