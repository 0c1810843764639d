package io.github.sofas.flow.smooth;

import static org.junit.Assert.assertFalse;
import static org.junit.Assert.assertTrue;

import org.junit.Test;

/** Slices of a quarter of 200 ms, which end at multiples of 50 ms. */
public class SliceClockTest {
    private final SliceClock clock = new SliceClock(200_000);

    @Test
    public void sliceBeginsAtMultiplesOfItsDuration() {
        assertFalse("the first one", clock.begins(120_000));
        assertFalse(clock.begins(149_999));
        assertTrue(clock.begins(150_000));
        assertFalse(clock.begins(199_999));
        assertTrue("after an hour", clock.begins(3_600_010_000L));
        assertFalse(clock.begins(3_600_049_999L));
        assertTrue(clock.begins(3_600_050_000L));
    }

    @Test
    public void timesBeforeZeroAreCutAtMultiplesToo() {
        assertFalse(clock.begins(-60_000));
        assertTrue(clock.begins(-50_000));
        assertTrue(clock.begins(0));
    }

    @Test
    public void sliceThatIsFullEndsEarly() {
        for (int i = 0; i < Smoother.MOST_EVENTS; i++) {
            assertFalse(clock.begins(10_000));
        }
        assertTrue("of the same time", clock.begins(10_000));
        assertFalse(clock.begins(49_999));
        assertTrue(clock.begins(50_000));
    }
}
