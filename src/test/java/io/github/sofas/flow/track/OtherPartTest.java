package io.github.sofas.flow.track;

import static org.junit.Assert.assertFalse;
import static org.junit.Assert.assertTrue;

import org.junit.Before;
import org.junit.Test;

/** At 100 px/s, 1 px in 10 ms. */
public class OtherPartTest {
    private static final double SPEED = 100;

    private final OtherPart part = new OtherPart();

    @Before
    public void begin() {
        part.start(0);
    }

    @Test
    public void partIsAskedEachFourPixels() {
        assertFalse(part.isDue(7, SPEED, 39_000));
        assertTrue(part.isDue(7, SPEED, 40_000));
        part.note(7, 2, 40_000);
        assertFalse(part.isDue(7, SPEED, 79_000));
        assertTrue(part.isDue(7, SPEED, 80_000));
    }

    @Test
    public void oneThatWasAskedInVainLetsOthersGoFirst() {
        part.note(7, -3, 40_000);
        assertTrue(part.isDue(8, SPEED, 80_000));
        assertFalse(part.isDue(7, SPEED, 80_000));
        assertTrue(part.isDue(7, SPEED, 100_000));
    }

    @Test
    public void oneThatMayBeAPartGoesFirst() {
        part.note(7, 2, 40_000);
        assertTrue(part.isDue(7, SPEED, 80_000));
        assertFalse(part.isDue(8, SPEED, 80_000));
    }

    @Test
    public void partIsSureAfterMoreThanTwoSigmasBeyondNoise() {
        assertFalse(part.note(7, 1.25, 40_000));
        assertFalse(part.note(7, 1.25, 80_000));
        assertTrue(part.note(7, 1.25, 120_000));
        part.start(120_000);
        assertTrue(part.note(7, 2.75, 160_000));
    }

    @Test
    public void whatIsLostIsTakenOffAndNoMoreThanWasGained() {
        part.note(7, 2, 40_000);
        part.note(7, OneBody.NOTHING, 80_000);
        assertFalse(part.note(7, 2.25, 120_000));
        assertTrue(part.note(7, 1, 160_000));
    }

    @Test
    public void anotherBeginsAnew() {
        part.note(7, 2, 40_000);
        assertFalse(part.note(8, 2, 100_000));
    }
}
