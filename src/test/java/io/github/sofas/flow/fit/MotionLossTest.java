package io.github.sofas.flow.fit;

import static org.junit.Assert.assertEquals;
import static org.junit.Assert.assertTrue;

import org.junit.Test;

/** What a measurement knows of a velocity, by direction. */
public class MotionLossTest {
    private static MotionLoss loss(double xx, double xy, double yy) {
        MotionLoss loss = new MotionLoss();
        loss.xx = xx;
        loss.xy = xy;
        loss.yy = yy;
        return loss;
    }

    @Test
    public void leastIsTheLesserEigenvalue() {
        assertEquals(1, loss(3, 0, 1).least(), 1e-12);
        // 3 along the diagonal, 1 across it
        assertEquals(1, loss(2, 1, 2).least(), 1e-12);
        assertEquals(1.0 / 3, loss(2, 1, 2).flatness(), 1e-12);
    }

    @Test
    public void straightEdgeLosesNothingAlongItself() {
        assertEquals(0, loss(1, 1, 1).least(), 1e-12);
        assertEquals(0, loss(1, 1, 1).flatness(), 1e-12);
        assertEquals(0, new MotionLoss().flatness(), 0);
    }

    @Test
    public void aParameterIsKnownByWhatAPixelLosesBesideTheNoise() {
        MotionLoss loss = new MotionLoss();
        loss.metric = 10_000;
        // ends of the window 0.1 s from its middle: 1 px by 10 px/s, which loses 2,000, beside a noise of 100
        assertEquals(0.05, loss.noisePx(20, 0.1), 1e-12);
        assertTrue("nothing is known", loss.noisePx(0, 0.1) > 1e100);
    }
}
