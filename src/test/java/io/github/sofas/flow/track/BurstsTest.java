package io.github.sofas.flow.track;

import static org.junit.Assert.assertEquals;
import static org.junit.Assert.assertFalse;
import static org.junit.Assert.assertTrue;

import io.github.sofas.event.SensorSize;
import org.junit.Test;

/** Bursts of 1,000 us, on a sensor of 4 x 3 px. */
public class BurstsTest {
    private static final SensorSize SENSOR = new SensorSize(4, 3);

    private final Bursts bursts = new Bursts(SENSOR);

    private boolean begins(int x, int y, long timeUs, int polarity) {
        return bursts.begins(x, y, timeUs, polarity, 1_000);
    }

    @Test
    public void firstEventOfAPixelBeginsABurst() {
        assertTrue(begins(0, 0, 0, 1));
        assertTrue(begins(3, 2, 0, -1));
    }

    @Test
    public void eventsThatFollowWithinItsTimeAreOfTheSameBurst() {
        assertTrue(begins(1, 1, 5_000, 1));
        assertFalse(begins(1, 1, 5_000, 1));
        assertFalse(begins(1, 1, 6_000, 1));
        assertTrue(begins(1, 1, 6_001, 1));
    }

    @Test
    public void pixelThatFiresOnAndOnBeginsABurstAfterEachOne() {
        int begun = 0;
        for (long us = 0; us < 10_010; us += 10) {
            begun += begins(2, 1, us, 1) ? 1 : 0;
        }
        // at 0, 1,010, 2,020 and so on to 9,090
        assertEquals(10, begun);
    }

    @Test
    public void otherPixelsAndTheOtherPolarityHaveBurstsOfTheirOwn() {
        assertTrue(begins(1, 1, 0, 1));
        assertTrue(begins(1, 1, 0, -1));
        assertTrue(begins(0, 1, 0, 1));
        assertTrue(begins(2, 1, 0, 1));
        assertTrue(begins(1, 0, 0, 1));
        assertTrue(begins(1, 2, 0, 1));
    }

    @Test
    public void eachEventSaysHowLongItsBurstLasts() {
        assertTrue(bursts.begins(1, 1, 0, 1, 1_000));
        assertFalse(bursts.begins(1, 1, 400, 1, 400));
        assertTrue(bursts.begins(1, 1, 400, 1, 399));
    }

    @Test
    public void eventsOfAPastThatIsToldLaterHaveBurstsOfTheirOwn() {
        assertTrue(begins(1, 1, 9_000, 1));
        assertTrue(begins(1, 1, 8_000, 1));
        assertFalse(begins(1, 1, 8_500, 1));
    }

    @Test
    public void resetForgetsAllBursts() {
        assertTrue(begins(1, 1, 5_000, 1));
        bursts.reset();
        assertTrue(begins(1, 1, 5_000, 1));
    }

    /** 2^30 us. */
    @Test
    public void burstsAreToldAfterEighteenMinutesToo() {
        long late = (1 << 30) - 100;
        assertTrue(begins(1, 1, 0, 1));
        assertTrue(begins(1, 1, late, 1));
        assertFalse(begins(1, 1, late + 50, 1));
        assertTrue("its first event", begins(2, 1, late + 100, 1));
        assertTrue("all is forgotten", begins(1, 1, late + 200, 1));
        assertFalse(begins(1, 1, late + 250, 1));
        assertTrue(begins(1, 1, 1L << 42, 1));
        assertFalse(begins(1, 1, (1L << 42) + 1_000, 1));
    }

    @Test
    public void arrayTakesTheBytesThatAreSaid() {
        // a number of four bytes for each of twelve pixels and either polarity
        assertEquals(96, Bursts.bytes(SENSOR));
    }
}
