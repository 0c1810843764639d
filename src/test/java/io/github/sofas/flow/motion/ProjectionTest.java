package io.github.sofas.flow.motion;

import static org.junit.Assert.assertEquals;

import org.junit.Test;

public class ProjectionTest {
    @Test
    public void pixelsTravelledAreRoundedToTheNearest() {
        // 100 px/s: half a pixel in 5 ms, one and a half in 15 ms
        int v = Projection.fixed(100);
        assertEquals(0, Projection.travelled(v, 4_999));
        assertEquals(1, Projection.travelled(v, 5_001));
        assertEquals(1, Projection.travelled(v, 14_999));
        assertEquals(2, Projection.travelled(v, 15_001));
    }

    @Test
    public void timeBeforeTheReferenceTravelsBackwards() {
        int v = Projection.fixed(100);
        assertEquals(0, Projection.travelled(v, -4_999));
        assertEquals(-1, Projection.travelled(v, -5_001));
        assertEquals(-100, Projection.travelled(v, -1_000_000));
        assertEquals(-100, Projection.travelled(Projection.fixed(-100), 1_000_000));
    }

    @Test
    public void slowAndFastVelocitiesAreKeptOverLongTimes() {
        // a step of fixed point is 1e6 / 2^28 = 0.0037 px/s: off by at most half of it, 6.7 px an hour
        assertEquals(3_600, Projection.travelled(Projection.fixed(1), 3_600_000_000L), 6.7);
        assertEquals(5_000_000, Projection.travelled(Projection.fixed(5_000_000), 1_000_000));
        assertEquals(0, Projection.travelled(0, Long.MAX_VALUE / 2));
    }
}
