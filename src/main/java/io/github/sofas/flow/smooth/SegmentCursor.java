package io.github.sofas.flow.smooth;

import java.util.List;

/** Iterates over the events of one segment between two times, in order of time. */
final class SegmentCursor {
    /** Returned after the last event. */
    static final int NONE = -1;

    private final EventWindow window;
    private List<Slice> slices;
    private int segment;
    private long fromUs;
    private long untilUs;
    /** Index of the present slice, its events, and the places in it of the next event and after the last one. */
    private int slice;
    private SegmentEvents events;
    private int next;
    private int end;

    SegmentCursor(EventWindow window) {
        this.window = window;
    }

    /**
     * Begins anew.
     *
     * @param among slices in order of time
     * @param id of the segment
     * @param from first time in µs
     * @param until time in µs before which all events lie
     */
    void begin(List<Slice> among, int id, long from, long until) {
        slices = among;
        segment = id;
        fromUs = from;
        untilUs = until;
        slice = -1;
        next = 0;
        end = 0;
    }

    /** Entry of the next event in the arrays of the window; {@value #NONE} if none follows. */
    int next() {
        while (next == end) {
            if (!goOn()) {
                return NONE;
            }
        }
        int at = window.at(events.event(next++));
        return window.timeUs[at] < untilUs ? at : NONE;
    }

    /** Moves on to the next slice that may overlap the time; false if there is none. */
    private boolean goOn() {
        do {
            slice++;
        } while (slice < slices.size() && slices.get(slice).untilUs <= fromUs);
        if (slice >= slices.size() || slices.get(slice).fromUs >= untilUs) {
            return false;
        }
        events = slices.get(slice).bySegment(window);
        end = events.until(segment);
        next = firstInTime();
        return true;
    }

    /** Place, in the present slice, of the segment's first event that is not too early. */
    private int firstInTime() {
        int low = events.from(segment);
        int high = end;
        while (low < high) {
            int middle = low + high >>> 1;
            if (window.timeUs[window.at(events.event(middle))] < fromUs) {
                low = middle + 1;
            } else {
                high = middle;
            }
        }
        return low;
    }
}
