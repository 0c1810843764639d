package io.github.sofas.flow.smooth;

import java.util.Map;
import java.util.TreeMap;

/** The events of a slice that have a segment, sorted by segment; those of one segment are in order of time. */
final class SegmentEvents {
    /** Range of the events of one segment in the order. */
    private static final class Run {
        final int segment;
        int from;
        int until;

        Run(int segment) {
            this.segment = segment;
        }
    }

    /**
     * Size of the cache of recent segments, by the last bits of their numbers: a map look-up per event takes longer.
     */
    private static final int RECENT = 64;

    private final long first;
    private final int[] order;
    /** Runs by rising number of the segment. */
    private final Map<Integer, Run> runs = new TreeMap<>();

    /** Sorts the events from one to before another by the segments that they have now. */
    SegmentEvents(EventWindow window, long first, long until) {
        this.first = first;
        Run[] recent = new Run[RECENT];
        int count = 0;
        for (long i = first; i < until; i++) {
            int id = window.segment[window.at(i)];
            if (id != 0) {
                run(id, recent).until++;
                count++;
            }
        }
        int from = 0;
        for (Run run : runs.values()) {
            int events = run.until;
            run.from = from;
            run.until = from;
            from += events;
        }
        order = new int[count];
        for (long i = first; i < until; i++) {
            int id = window.segment[window.at(i)];
            if (id != 0) {
                order[run(id, recent).until++] = (int) (i - first);
            }
        }
    }

    private Run run(int segment, Run[] recent) {
        Run run = recent[segment & RECENT - 1];
        if (run == null || run.segment != segment) {
            run = runs.computeIfAbsent(segment, Run::new);
            recent[segment & RECENT - 1] = run;
        }
        return run;
    }

    /** The segments that have events, by rising number. */
    Iterable<Integer> segments() {
        return runs.keySet();
    }

    /** Place in the order of the first event of a segment. */
    int from(int segment) {
        Run run = runs.get(segment);
        return run == null ? 0 : run.from;
    }

    /** Place in the order after the last event of a segment; equal to {@link #from} if it has none. */
    int until(int segment) {
        Run run = runs.get(segment);
        return run == null ? 0 : run.until;
    }

    /** Number of the k-th event in the order. */
    long event(int k) {
        return first + order[k];
    }
}
