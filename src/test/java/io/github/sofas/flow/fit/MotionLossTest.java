package io.github.sofas.flow.fit;

import static org.junit.Assert.assertEquals;

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
}
