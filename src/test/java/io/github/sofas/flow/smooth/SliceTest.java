package io.github.sofas.flow.smooth;

import static org.junit.Assert.assertEquals;
import static org.junit.Assert.assertFalse;
import static org.junit.Assert.assertNull;
import static org.junit.Assert.assertTrue;

import io.github.sofas.event.SensorSize;
import io.github.sofas.flow.motion.PixelBox;
import java.util.ArrayList;
import java.util.List;
import org.junit.Test;

/** A sensor of 5 x 3 tiles. */
public class SliceTest {
    private static final SensorSize SENSOR = new SensorSize(160, 96);
    private static final int COLUMNS = 5;

    private final EventWindow window = new EventWindow();
    private long nowUs;

    private void add(int count, int x, int y, int segment) {
        for (int i = 0; i < count; i++) {
            window.give(window.add(nowUs, nowUs, x, y, 1), segment, segment);
            nowUs++;
        }
    }

    private Slice slice() {
        return new Slice(window, SENSOR, 0, 0, nowUs, 0);
    }

    @Test
    public void eventsOfATileAreInOrderAndThoseBesideTheSensorInNone() {
        add(2, 0, 0, 0);
        add(1, 32, 0, 0);
        add(1, 200, 0, 0);
        add(1, 31, 31, 0);
        add(1, 159, 95, 0);
        Slice slice = slice();
        assertEquals(COLUMNS, slice.columns());
        assertEquals(3, slice.rows());
        List<Long> events = new ArrayList<>();
        for (int k = slice.start(0); k < slice.start(COLUMNS * 3); k++) {
            events.add(slice.event(k));
        }
        assertEquals(List.of(0L, 1L, 4L, 2L, 5L), events);
        assertEquals(3, slice.start(1));
        assertEquals(4, slice.start(2));
    }

    @Test
    public void tileOfOneSegmentWithLittleNoiseIsDecided() {
        add(90, 40, 40, 1);
        add(5, 41, 41, 0);
        assertFalse(slice().isOpen(COLUMNS + 1));
    }

    @Test
    public void tileWithManyUnlabelledEventsIsOpen() {
        add(90, 40, 40, 1);
        add(30, 41, 41, 0);
        assertTrue(slice().isOpen(COLUMNS + 1));
    }

    @Test
    public void noiseBesideASegmentIsDecided() {
        add(90, 40, 40, 1);
        // 5 of 5 + 90 / 3
        add(5, 70, 40, 0);
        assertFalse(slice().isOpen(COLUMNS + 2));
        // nothing is labelled there
        add(5, 150, 40, 0);
        assertTrue(slice().isOpen(COLUMNS + 4));
    }

    @Test
    public void tilesThatTwoSegmentsHaveAndThoseAroundAreOpen() {
        add(90, 40, 40, 1);
        add(10, 41, 41, 2);
        add(90, 70, 40, 1);
        add(90, 130, 40, 1);
        Slice slice = slice();
        assertTrue(slice.isOpen(COLUMNS + 1));
        assertTrue(slice.isOpen(COLUMNS + 2));
        assertFalse(slice.isOpen(COLUMNS + 4));
    }

    @Test
    public void largestSegmentHasMostEvents() {
        assertEquals(0, slice().largest());
        add(3, 40, 40, 7);
        add(4, 40, 40, 9);
        add(9, 40, 40, 0);
        assertEquals(9, slice().largest());
        add(1, 80, 40, 7);
        assertEquals("the first of two", 7, slice().largest());
    }

    @Test
    public void tilesOfABoxAreOpenedAndThoseAroundAreNear() {
        add(90, 40, 40, 1);
        Slice slice = slice();
        slice.open(1, 0, 2, 0);
        assertTrue(slice.isOpen(1));
        assertTrue(slice.isOpen(2));
        assertFalse(slice.isOpen(COLUMNS + 1));
        assertTrue(slice.isNearOpen(COLUMNS + 3));
        assertFalse(slice.isNearOpen(4));
        assertFalse(slice.isNearOpen(2 * COLUMNS + 1));
    }

    @Test
    public void boxHoldsTheEventsOfASegment() {
        add(1, 40, 50, 1);
        add(1, 60, 45, 1);
        add(1, 10, 10, 2);
        PixelBox box = slice().box(1);
        assertEquals(40, box.left);
        assertEquals(60, box.right);
        assertEquals(45, box.top);
        assertEquals(50, box.bottom);
        assertNull(slice().box(3));
    }
}
