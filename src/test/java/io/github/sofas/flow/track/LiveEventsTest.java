package io.github.sofas.flow.track;

import static org.junit.Assert.assertEquals;

import org.junit.Test;

/** The ring of a track plane's events. */
public class LiveEventsTest {
    @Test
    public void countsTheEventsAfterATime() {
        LiveEvents live = new LiveEvents();
        assertEquals(0, live.since(0));
        for (long timeUs : new long[] {10, 20, 20, 30}) {
            live.add(0, 0, timeUs, 1, false, false);
        }
        assertEquals(4, live.since(9));
        assertEquals(3, live.since(10));
        assertEquals(3, live.since(19));
        assertEquals(1, live.since(20));
        assertEquals(0, live.since(30));
    }

    @Test
    public void countsAcrossTheEndOfTheRing() {
        LiveEvents live = new LiveEvents();
        for (int i = 0; i < LiveEvents.CAPACITY + 100; i++) {
            if (live.isFull()) {
                live.removeOldest();
            }
            live.add(0, 0, i, 1, false, false);
        }
        assertEquals(150, live.since(LiveEvents.CAPACITY - 51));
    }
}
