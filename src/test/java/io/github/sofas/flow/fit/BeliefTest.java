package io.github.sofas.flow.fit;

import static org.junit.Assert.assertEquals;

import org.junit.Test;

public class BeliefTest {
    @Test
    public void changeIsBelievedAsFarAsItPassesTheNoise() {
        // 0.2 rad/s shift the ends by a pixel: as much as the noise of 0.1 px half counts, ten times as
        // much 100 parts of 101
        assertEquals(0.01, Belief.in(0.02, 0.2, 0.1), 1e-12);
        assertEquals(-0.01, Belief.in(-0.02, 0.2, 0.1), 1e-12);
        assertEquals(0.2 * 100 / 101, Belief.in(0.2, 0.2, 0.1), 1e-12);
        assertEquals(0, Belief.in(0, 0.2, 0.1), 0);
    }

    @Test
    public void whatMayBeNoiseFallsWithTheNumberOfEvents() {
        // sqrt(0.07² + (30 / 300)²), and of a million events what they have in common
        assertEquals(Math.sqrt(0.0149), Belief.noisePx(0.07, 30, 300), 1e-12);
        assertEquals(0.07, Belief.noisePx(0.07, 30, 1_000_000), 1e-6);
        assertEquals(30, Belief.noisePx(0, 30, 0), 0);
    }

    @Test
    public void changeThatGainsAsMuchAsNoiseDoesIsHalfBelieved() {
        // the standard deviation of a metric of 100 is 10
        assertEquals(0.5, Belief.byGain(20, 2, 100), 1e-12);
        assertEquals(0.8, Belief.byGain(40, 2, 100), 1e-12);
        assertEquals("of nothing", 0, Belief.byGain(0, 0, 0), 0);
    }

    @Test
    public void newChangeIsTakenOverTheMoreTheFartherItIsFromNoise() {
        // half of what is within noise; of what differs by as much as half of the rest is, three quarters
        assertEquals(5, Belief.taken(4, 6, 0.5, 1, 1e6), 1e-6);
        assertEquals(5.5, Belief.taken(4, 6, 0.5, 1, 2), 1e-12);
        assertEquals(6, Belief.taken(4, 6, 0.5, 1, 1e-6), 1e-6);
    }
}
