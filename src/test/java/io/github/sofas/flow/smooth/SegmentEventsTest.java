package io.github.sofas.flow.smooth;

import static org.junit.Assert.assertEquals;

import java.util.ArrayList;
import java.util.Arrays;
import java.util.List;
import org.junit.Test;

public class SegmentEventsTest {
    private final EventWindow window = new EventWindow();

    private void add(int... segments) {
        for (int segment : segments) {
            window.give(window.add(window.end(), 0, 1, 1, 1), segment, segment);
        }
    }

    private static List<Long> events(SegmentEvents events, int segment) {
        List<Long> numbers = new ArrayList<>();
        for (int k = events.from(segment); k < events.until(segment); k++) {
            numbers.add(events.event(k));
        }
        return numbers;
    }

    @Test
    public void eventsOfEachSegmentAreInOrderOfTime() {
        add(5, 7, 0, 7, 5, 0, 7);
        SegmentEvents events = new SegmentEvents(window, 1, 7);
        assertEquals(Arrays.asList(4L), events(events, 5));
        assertEquals(Arrays.asList(1L, 3L, 6L), events(events, 7));
        assertEquals(new ArrayList<>(), events(events, 6));
        List<Integer> segments = new ArrayList<>();
        events.segments().forEach(segments::add);
        assertEquals(Arrays.asList(5, 7), segments);
    }

    @Test
    public void segmentsWhoseNumbersEndAlikeAreToldApart() {
        add(1, 65, 1, 129, 65, 1);
        SegmentEvents events = new SegmentEvents(window, 0, window.end());
        assertEquals(Arrays.asList(0L, 2L, 5L), events(events, 1));
        assertEquals(Arrays.asList(1L, 4L), events(events, 65));
        assertEquals(Arrays.asList(3L), events(events, 129));
    }
}
