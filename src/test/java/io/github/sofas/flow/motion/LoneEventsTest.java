package io.github.sofas.flow.motion;

import static org.junit.Assert.assertFalse;
import static org.junit.Assert.assertTrue;

import org.junit.Test;

/** Company in time and space, by hand: at 4 px/s a pixel is crossed in 250 ms, 244 whole ticks of 1,024 µs. */
public class LoneEventsTest {
    private static final long COMPANY_US = 244 * 1024;

    private final LoneEvents lone = new LoneEvents(8, 6, 4);

    @Test
    public void firstEventIsAlone() {
        assertTrue(lone.isAlone(0, 0, 0));
    }

    @Test
    public void eachOfTheEightPixelsAroundIsCompany() {
        for (int dy = -1; dy <= 1; dy++) {
            for (int dx = -1; dx <= 1; dx++) {
                lone.reset();
                lone.isAlone(3 + dx, 3 + dy, 1000);
                assertTrue(dx + "," + dy, lone.isAlone(3, 3, 2000) == (dx == 0 && dy == 0));
            }
        }
    }

    @Test
    public void pixelTwoAwayIsNone() {
        lone.isAlone(3, 3, 0);
        assertTrue(lone.isAlone(5, 3, 1));
    }

    @Test
    public void companyEndsWhenTheSlowestStructureHasCrossedAPixel() {
        lone.isAlone(3, 3, 0);
        assertFalse(lone.isAlone(4, 3, COMPANY_US));
        lone.reset();
        lone.isAlone(3, 3, 0);
        assertTrue(lone.isAlone(4, 3, COMPANY_US + 1024));
    }

    @Test
    public void cornersOfTheSensorHaveABorder() {
        assertTrue(lone.isAlone(7, 5, 0));
        assertFalse(lone.isAlone(6, 5, 1));
        assertTrue(lone.isAlone(0, 5, 2));
    }

    @Test
    public void jumpByYearsForgetsAll() {
        lone.isAlone(3, 3, -5_000_000_000L);
        assertTrue(lone.isAlone(4, 3, 1L << 60));
        assertFalse(lone.isAlone(3, 3, (1L << 60) + 10));
    }
}
