package io.github.sofas.flow.track;

import static org.junit.Assert.assertEquals;

import org.junit.Test;

/** What noise gives by chance, worked out by hand. */
public class NoiseTest {
    @Test
    public void contourHoldsTwoEventsOnTheNineCellsAround() {
        // one a second on each of nine cells: two in 2/9 s
        assertEquals(222_222, Noise.mostUs(1e-6));
        assertEquals(Long.MAX_VALUE, Noise.mostUs(0));
    }

    @Test
    public void supportPassesItsMeanByTwoStandardDeviations() {
        // a quarter of an event in each sixteenth on nine cells: 0.25 / 1.25 of them have one, 3.2 of either polarity;
        // twice the own less the other's have the same mean, and a variance of 5 times 3.2, so 3.2 + 2 * 4
        assertEquals(11, Noise.support(4e-6 / 9, 1_000_000));
        assertEquals(0, Noise.support(0, 1_000_000));
    }

    @Test
    public void tracePassesItsMeanBySoManyStandardDeviations() {
        // at 100 px/s and 25 Hz a quarter of an event per px of travel: 0.2 on the pixel, which counts 3; else, of
        // three times 0.25, 0.75 / 1.75 beside it. Mean 0.943, variance 2.143 - 0.889 of a px: 7.54 and 3.17² of eight
        assertEquals(7, Noise.trace(25e-6, 100, 0));
        assertEquals(13, Noise.trace(25e-6, 100, 2));
        assertEquals(0, Noise.trace(0, 100, 5));
    }

    @Test
    public void traceOfWhatHardlyMovesIsThatOfOnePxPerS() {
        assertEquals(Noise.trace(1e-7, 1, 3), Noise.trace(1e-7, 0, 3));
    }
}
