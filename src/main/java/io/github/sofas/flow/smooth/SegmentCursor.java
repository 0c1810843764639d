package io.github.sofas.flow.smooth;

import java.util.List;

/** Goes through the events of one segment from a time to before another, in order of time. */
final class SegmentCursor {
    /** What there is after the last event. */
    static final int NONE = -1;

    private final EventWindow window;
    private List<Slice> slices;
    private int segment;
    private long fromUs;
    private long untilUs;
    /** Number of the slice whose events follow, those, and the places of the next one and after the last. */
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
     * @param among in order of time
     * @param id the segment
     * @param from first time in µs
     * @param until time in µs that all events are before
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

    /** Entry of the next event in the arrays of the window; {@value #NONE} where none follows. */
    int next() {
        do {
            while (next < end) {
                int at = window.at(events.event(next++));
                if (window.timeUs[at] >= fromUs) {
                    return window.timeUs[at] < untilUs ? at : NONE;
                }
            }
        } while (goOn());
        return NONE;
    }

    /** Goes on to the next slice that may have some of the time; false where there is none. */
    private boolean goOn() {
        do {
            slice++;
        } while (slice < slices.size() && slices.get(slice).untilUs <= fromUs);
        if (slice >= slices.size() || slices.get(slice).fromUs >= untilUs) {
            return false;
        }
        events = slices.get(slice).bySegment(window);
        next = events.from(segment);
        end = events.until(segment);
        return true;
    }
}
