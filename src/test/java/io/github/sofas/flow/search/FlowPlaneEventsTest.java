package io.github.sofas.flow.search;

import static org.junit.Assert.assertEquals;
import static org.junit.Assert.assertFalse;
import static org.junit.Assert.assertTrue;

import org.junit.Test;

/** Events are found by the numbers in which they came, whatever was let go before them. */
public class FlowPlaneEventsTest {
    private final FlowPlaneEvents events = new FlowPlaneEvents();

    private void add(int from, int to) {
        for (int e = from; e < to; e++) {
            events.add(e % 300, e % 200, 10L * e, e % 2 == 0 ? 1 : -1);
        }
    }

    private void assertHeld(int from, int to) {
        for (int e = from; e < to; e++) {
            assertTrue(events.holds(e));
            assertEquals(e % 300, events.x(e));
            assertEquals(e % 200, events.y(e));
            assertEquals(10L * e, events.timeUs(e));
            assertEquals(e % 2 == 0 ? 1 : -1, events.sign(e));
        }
        assertEquals(to, events.head());
    }

    @Test
    public void eventsAreKeptWhileTheArraysGrow() {
        // let go within the first 16,384, then held far beyond them
        add(0, 10_000);
        events.letGo(9_000, 9_000);
        add(10_000, 100_000);
        assertHeld(9_000, 100_000);
        assertFalse(events.holds(8_999));
    }

    @Test
    public void marksAreKeptWhileTheArraysGrow() {
        add(0, 10_000);
        events.takeOut(3, 9_500);
        events.refuse(30, 9_501);
        add(10_000, 40_000);
        assertTrue(events.isTakenOut(3, 9_500));
        assertFalse(events.isTakenOut(2, 9_500));
        assertTrue(events.isTakenOut(9_500));
        assertFalse(events.isTakenOut(9_501));
        assertTrue(events.wasRefused(30, 9_501));
        assertFalse(events.wasRefused(30, 9_500));
    }

    @Test
    public void eventsThatWereTakenOutOfAnyRingArePassedOver() {
        add(0, 10_000);
        events.takeOut(3, 0);
        for (int e = 100; e < 400; e++) {
            events.takeOut(e % 9, e);
        }
        add(10_000, 40_000);
        assertEquals(1, events.left(0));
        assertEquals(99, events.left(99));
        assertEquals(400, events.left(100));
        assertEquals(400, events.left(399));
        assertEquals(401, events.left(401));
        assertTrue("none is left", events.left(40_000) >= 40_000);
    }

    @Test
    public void newEventHasNoMarkOfTheOneInWhosePlaceItIs() {
        add(0, 16_384);
        events.takeOut(0, 5);
        events.refuse(0, 5);
        events.letGo(100, 100);
        add(16_384, 16_400);
        // 16,389 lies where 5 was
        assertFalse(events.isTakenOut(16_389));
        assertFalse(events.wasRefused(0, 16_389));
        assertEquals(16_389, events.left(16_389));
        assertHeld(100, 16_400);
    }

    @Test
    public void eventThatIsNeededYetIsKeptThoughItIsHeldNoLonger() {
        add(0, 16_384);
        events.letGo(500, 100);
        add(16_384, 20_000);
        assertFalse(events.holds(499));
        assertEquals("first held", 500, events.first(0));
        for (int e = 100; e < 500; e++) {
            assertEquals(10L * e, events.timeUs(e));
        }
    }

    @Test
    public void numbersBeginAnewWhenCleared() {
        add(0, 50);
        events.letGo(20, 20);
        events.clear();
        assertEquals(0, events.head());
        add(0, 10);
        assertHeld(0, 10);
    }

    @Test
    public void firstOfATimeIsTheOldestHeldThatIsNotBeforeIt() {
        add(0, 20_000);
        events.letGo(9_000, 9_000);
        assertEquals(9_500, events.first(95_000));
        assertEquals(9_501, events.first(95_001));
        assertEquals("held no longer", 9_000, events.first(0));
        assertEquals("yet to come", 20_000, events.first(1_000_000));
    }
}
