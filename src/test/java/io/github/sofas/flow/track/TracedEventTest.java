package io.github.sofas.flow.track;

import static org.junit.Assert.assertEquals;
import static org.junit.Assert.assertTrue;

import io.github.sofas.event.SensorSize;
import org.junit.Test;

/** An event at (40, 45), to which an edge came from the left through three columns at 100 px/s. */
public class TracedEventTest {
    private static final long NOW_US = 1_000_000;

    private final PixelHistory history = new PixelHistory(new SensorSize(128, 96));
    private final TracedEvent event = new TracedEvent(history);
    private final TrackPlane along = new TrackedEdges().begin(40, 30, 100, 1);

    private void begin() {
        for (int c = 3; c >= 1; c--) {
            history.note(40 - c, 45, NOW_US - c * 10_000, 1);
        }
        event.begin(40, 45, NOW_US, 1);
    }

    @Test
    public void traceIsThatOfTheHistory() {
        begin();
        assertEquals("three px on the very pixel", 9, event.trace(along));
    }

    @Test
    public void traceIsLookedUpOnceAnEvent() {
        begin();
        event.trace(along);
        history.note(36, 45, NOW_US - 40_000, 1);
        assertEquals(9, event.trace(along));
        assertEquals("whatever is known", 9, event.traceBeyond(20, along));
        event.begin(40, 45, NOW_US, 1);
        assertEquals("of another event", 12, event.trace(along));
    }

    @Test
    public void traceThatIsNoMoreThanAKnownOneIsLookedUpAgain() {
        begin();
        assertTrue(event.traceBeyond(9, along) <= 9);
        assertEquals(9, event.trace(along));
    }

    @Test
    public void oneInFourOfThePixelsOfAPlaceIsChosen() {
        int chosen = 0;
        for (int i = 0; i < 16; i++) {
            event.begin(40 + i % 4, 44 + i / 4, NOW_US, 1);
            chosen += event.isOneIn(4) ? 1 : 0;
        }
        assertEquals(4, chosen);
    }
}
