package io.github.sofas.flow.search;

import static org.junit.Assert.assertEquals;
import static org.junit.Assert.assertFalse;
import static org.junit.Assert.assertTrue;

import org.junit.Test;

/** Where a slice ends, and what is left in it. */
public class EventSliceTest {
    private final EventSlice slice = new EventSlice();

    @Test
    public void endsAfter2048Events() {
        for (int i = 0; i < 2048; i++) {
            assertFalse(slice.isOver(1_000));
            // explained or not, each counts
            slice.add(1, 2, 1_000, 1, i % 2 == 0);
        }
        assertTrue(slice.isOver(1_000));
        assertEquals(1024, slice.size());
        assertEquals(2048, slice.labelled());
    }

    @Test
    public void endsOneMsAfterItsFirstEvent() {
        assertFalse("nothing to give", slice.isOver(Long.MAX_VALUE));
        slice.add(1, 2, 10_000, 1, true);
        slice.add(1, 2, 10_999, 1, true);
        assertFalse(slice.isOver(10_999));
        assertTrue(slice.isOver(11_000));
        assertEquals(10_999, slice.untilUs());
        slice.clear();
        assertFalse(slice.isOver(11_000));
        slice.add(1, 2, 11_000, 1, true);
        assertFalse(slice.isOver(11_999));
        assertTrue(slice.isOver(12_000));
    }

    @Test
    public void keepsWhatIsNotExplainedInItsPlace() {
        slice.add(1, 2, 100, 1, true);
        slice.add(3, 4, 200, -1, false);
        slice.add(5, 6, 300, 1, true);
        slice.add(7, 8, 400, 1, false);
        assertEquals(2, slice.size());
        assertEquals(3, slice.x(0));
        assertEquals(4, slice.y(0));
        assertEquals(200, slice.timeUs(0));
        assertEquals(-1, slice.sign(0));
        assertEquals("the second", 2, slice.place(0));
        assertEquals("the fourth", 4, slice.place(1));
    }

    @Test
    public void whatIsTakenIsLeftOut() {
        for (int i = 1; i <= 4; i++) {
            slice.add(i, 10 * i, 100 * i, i % 2 == 0 ? 1 : -1, false);
        }
        slice.offer((x, y, timeUs, sign) -> x % 2 == 0 && y == 10 * x && timeUs == 100 * x && sign == 1);
        assertEquals(2, slice.size());
        assertEquals(1, slice.x(0));
        assertEquals(3, slice.x(1));
        assertEquals(3, slice.place(1));
        assertEquals(-1, slice.sign(1));
        assertEquals("labelled all the same", 4, slice.labelled());
    }
}
