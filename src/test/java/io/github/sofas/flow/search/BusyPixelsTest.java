package io.github.sofas.flow.search;

import static org.junit.Assert.assertEquals;
import static org.junit.Assert.assertFalse;
import static org.junit.Assert.assertTrue;

import io.github.sofas.flow.SofasParameters;
import org.junit.Test;

public class BusyPixelsTest {
    private static final SofasParameters P = SofasParameters.defaults();
    /** (32,767 - 2,048) / 2 = 15,359 over 8 + 3 x 6 px of travel = 26. */
    private static final int MOST = 590;
    /** Nine eighths of 6 px at 4 px/s, and 10 ms. */
    private static final long INTERVAL_US = 1_697_500;

    private final BusyPixels busy = new BusyPixels(8, 4, P.search());

    private void fire(int times, int x, int y, long timeUs) {
        for (int i = 0; i < times; i++) {
            assertFalse("event " + i, busy.isBusy(x, y, timeUs));
        }
    }

    @Test
    public void allowsAPixelSoManyEventsAnInterval() {
        assertEquals(MOST, BusyPixels.MOST);
        fire(MOST, 3, 2, 1000);
        assertTrue(busy.isBusy(3, 2, 1000));
        assertTrue(busy.isBusy(3, 2, 1000 + INTERVAL_US - 1));
        fire(MOST, 3, 2, 1000 + INTERVAL_US);
        assertTrue(busy.isBusy(3, 2, 1000 + INTERVAL_US));
    }

    @Test
    public void countsEachPixelByItself() {
        fire(MOST, 0, 0, 0);
        fire(MOST, 7, 3, 0);
        fire(MOST, 7, 0, 0);
        assertTrue(busy.isBusy(0, 0, 0));
        assertTrue(busy.isBusy(7, 3, 0));
    }

    @Test
    public void forgetsAtAReset() {
        fire(MOST, 0, 0, 5);
        busy.reset();
        fire(MOST, 0, 0, 5);
        assertTrue(busy.isBusy(0, 0, 5));
    }

    @Test
    public void noCellOverflowsHoweverOftenPixelsSideBySideFire() {
        // the worst case: every pixel that a cell can meet fires as often as it may in two intervals
        int pixels = 4 + 2 * (int) Math.ceil(2 + Math.sqrt(2) * Projections.TRAVEL_PX);
        assertTrue(2 * BusyPixels.MOST * pixels + 2048 <= Short.MAX_VALUE);
    }

    @Test
    public void noCellOfTheFlowPlaneWrapsRoundHoweverOftenPixelsFire() {
        BusyPixels busy = new BusyPixels(64, 48, SofasParameters.defaults().search());
        FlowPlane plane = new FlowPlane(64, 48, SofasParameters.defaults().search());
        for (int i = 0; i < 400_000; i++) {
            // an eight by eight block of hot pixels, five million events per second
            int x = 20 + (i & 7);
            int y = 20 + (i >> 3 & 7);
            long timeUs = i / 5;
            if (!busy.isBusy(x, y, timeUs)) {
                plane.add(x, y, timeUs, 1);
            }
            if (i % 256 == 255) {
                plane.settle(timeUs);
            }
        }
        for (int k = 0; k < plane.projections().n() * plane.projections().n(); k++) {
            long squares = 0;
            for (short f : plane.accumulator(k)) {
                assertTrue("cell of projection " + k, f >= 0);
                squares += (long) f * f;
            }
            assertEquals("metric of projection " + k, squares, plane.metric(k));
        }
    }
}
