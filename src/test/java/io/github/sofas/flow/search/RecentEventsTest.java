package io.github.sofas.flow.search;

import static org.junit.Assert.assertEquals;

import io.github.sofas.event.SensorSize;
import org.junit.Test;

/** The newest events that nothing tracks. */
public class RecentEventsTest {
    private static final SensorSize SENSOR = new SensorSize(16, 8);

    private final RecentEvents events = new RecentEvents(SENSOR);

    private void add(int count) {
        for (int i = 0; i < count; i++) {
            int number = events.head();
            events.add(number % 16, number % 8, 10L * number, number % 2 == 0 ? 1 : -1);
        }
    }

    @Test
    public void givesWhatWasAdded() {
        add(7);
        assertEquals(6, events.x(6));
        assertEquals(6, events.y(6));
        assertEquals(60, events.timeUs(6));
        assertEquals(1, events.sign(6));
        assertEquals(-1, events.sign(5));
        assertEquals(60, events.newestUs());
        assertEquals(7, events.head());
    }

    @Test
    public void firstIsTheOldestOfATime() {
        add(20);
        assertEquals(0, events.first(-5));
        assertEquals(5, events.first(50));
        assertEquals(6, events.first(51));
        assertEquals(20, events.first(191));
    }

    @Test
    public void oldestGoesWhereTwoAPixelAreHeld() {
        add(2 * 16 * 8 + 3);
        assertEquals(3, events.first(0));
        assertEquals(2, events.x(2 * 16 * 8 + 2));
    }

    @Test
    public void takenEventHasNoSign() {
        add(3);
        events.take(1);
        assertEquals(0, events.sign(1));
        assertEquals(1, events.sign(2));
    }

    @Test
    public void clearedRingHoldsNone() {
        add(3);
        events.clear();
        assertEquals(events.head(), events.first(0));
    }
}
