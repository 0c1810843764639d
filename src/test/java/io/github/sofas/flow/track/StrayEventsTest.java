package io.github.sofas.flow.track;

import static org.junit.Assert.assertEquals;

import org.junit.Test;

/** The newest events that no track plane took. */
public class StrayEventsTest {
    @Test
    public void newestComesFirst() {
        StrayEvents strays = new StrayEvents();
        strays.add(1, 2, 10);
        strays.add(3, 4, 20);
        assertEquals(2, strays.size());
        assertEquals(20, strays.timeUs[strays.index(0)]);
        assertEquals(3, strays.x[strays.index(0)]);
        assertEquals(4, strays.y[strays.index(0)]);
        assertEquals(10, strays.timeUs[strays.index(1)]);
    }

    @Test
    public void oldestGoWhereThereAreTooMany() {
        StrayEvents strays = new StrayEvents();
        for (int i = 0; i < StrayEvents.CAPACITY + 5; i++) {
            strays.add(0, 0, i);
        }
        assertEquals(StrayEvents.CAPACITY, strays.size());
        assertEquals(StrayEvents.CAPACITY + 4, strays.timeUs[strays.index(0)]);
        assertEquals(5, strays.timeUs[strays.index(StrayEvents.CAPACITY - 1)]);
    }
}
