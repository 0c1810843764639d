package io.github.sofas.flow.search;

import static org.junit.Assert.assertEquals;
import static org.junit.Assert.assertFalse;
import static org.junit.Assert.assertTrue;

import io.github.sofas.event.SensorSize;
import org.junit.Test;

/** When a region is due, and with which events. */
public class DenseRegionsTest {
    /** Four columns and three rows of regions; those on the right and below are cut off. */
    private static final SensorSize SENSOR = new SensorSize(240, 180);
    /** Three twentieths of 64 x 64 px. */
    private static final int FIRST = 614;

    private final RecentEvents events = new RecentEvents(SENSOR);
    private final DenseRegions regions = new DenseRegions(SENSOR, events);

    private void add(int count, int x, int y, long timeUs) {
        for (int i = 0; i < count; i++) {
            events.add(x, y, timeUs, 1);
            regions.add(x, y, timeUs);
        }
    }

    @Test
    public void regionIsDueOnceThreeTwentiethsOfItsPixelsHaveFired() {
        add(FIRST - 1, 70, 10, 0);
        assertFalse(regions.isAnyDue());
        add(1, 70, 10, 0);
        assertTrue(regions.isAnyDue());
        int region = regions.next();
        assertFalse(regions.isAnyDue());
        assertEquals(64, regions.left(region));
        assertEquals(0, regions.top(region));
        assertEquals(FIRST, regions.count(region));
    }

    @Test
    public void regionIsDueAgainWithTwoFifthsMore() {
        add(FIRST, 70, 10, 0);
        regions.next();
        // 614 x 1.4 = 859.6
        add(858 - FIRST, 70, 10, 0);
        assertFalse(regions.isAnyDue());
        add(1, 70, 10, 0);
        assertTrue(regions.isAnyDue());
    }

    @Test
    public void regionThatWaitsIsDueOnce() {
        add(3 * FIRST, 70, 10, 0);
        regions.next();
        assertFalse(regions.isAnyDue());
    }

    @Test
    public void regionsAreServedInTheOrderInWhichTheyBecameDue() {
        add(FIRST, 239, 179, 0);
        add(FIRST, 0, 70, 0);
        int first = regions.next();
        int second = regions.next();
        assertEquals(192, regions.left(first));
        assertEquals(128, regions.top(first));
        assertEquals(0, regions.left(second));
        assertEquals(64, regions.top(second));
        assertFalse(regions.isAnyDue());
    }

    @Test
    public void eventsOfARegionAreLinkedFromTheNewestBackwards() {
        add(1, 5, 5, 100);
        add(1, 100, 5, 200);
        add(1, 6, 5, 300);
        add(FIRST, 7, 5, 400);
        int region = regions.next();
        int event = regions.newest(region);
        for (int i = 0; i < FIRST - 2; i++) {
            assertEquals(7, events.x(event));
            event = regions.before(event);
        }
        assertEquals(7, events.x(event));
        event = regions.before(regions.before(event));
        assertEquals(6, events.x(event));
        assertEquals(5, events.x(regions.before(event)));
    }

    @Test
    public void regionBeginsAnewAfterAFifthOfASecond() {
        add(FIRST - 1, 5, 5, 0);
        add(1, 5, 5, 200_001);
        assertFalse(regions.isAnyDue());
        add(FIRST - 1, 5, 5, 200_001);
        assertEquals(FIRST, regions.count(regions.next()));
    }

    @Test
    public void regionBeginsAnewWithThreeTimesItsPixels() {
        add(3 * 4096, 5, 5, 0);
        int region = regions.next();
        regions.forgetIfFull(region);
        assertEquals(3 * 4096, regions.count(region));
        add(1, 5, 5, 0);
        regions.forgetIfFull(region);
        assertEquals(0, regions.count(region));
        add(FIRST, 5, 5, 0);
        assertTrue(regions.isAnyDue());
    }

    @Test
    public void nothingIsDueAfterAllIsForgotten() {
        add(FIRST, 5, 5, 0);
        regions.clear();
        assertFalse(regions.isAnyDue());
        add(FIRST - 1, 5, 5, 0);
        assertFalse(regions.isAnyDue());
        add(1, 5, 5, 0);
        assertTrue(regions.isAnyDue());
    }
}
