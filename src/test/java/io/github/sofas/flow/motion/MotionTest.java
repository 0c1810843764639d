package io.github.sofas.flow.motion;

import static org.junit.Assert.assertEquals;

import org.junit.Test;

/** Projection along a motion. */
public class MotionTest {
    @Test
    public void pointOfATurningBodyIsProjectedAlongItsCircle() {
        // centre (50, 40), 5 rad/s, 0.1 s after the reference: a point 20 px right of the centre has turned by 0.5 rad
        Motion motion = new Motion();
        motion.set(0, 0, 0);
        motion.omega = 5;
        motion.centreX = 50;
        motion.centreY = 40;
        int x = (int) Math.round(50 + 20 * Math.cos(0.5));
        int y = (int) Math.round(40 + 20 * Math.sin(0.5));
        motion.project(x, y, 100_000);
        double dx = x - 50 - 20 * Math.cos(0.5);
        double dy = y - 40 - 20 * Math.sin(0.5);
        // rounding to a pixel turns back too; what is left of the circle is below a hundredth of a pixel
        assertEquals(70 + Math.cos(0.5) * dx + Math.sin(0.5) * dy, motion.x, 0.01);
        assertEquals(40 - Math.sin(0.5) * dx + Math.cos(0.5) * dy, motion.y, 0.01);
    }

    @Test
    public void accelerationCarriesTheVelocityOn() {
        Motion motion = new Motion();
        motion.set(0, 100, -20);
        motion.ax = -50;
        motion.ay = 10;
        assertEquals(90, motion.vxAt(0, 200_000), 1e-4);
        assertEquals(-18, motion.vyAt(0, 200_000), 1e-4);
        motion.moveReference(200_000);
        // 100 * 0.2 - 25 * 0.04
        assertEquals(19, motion.centreX, 1e-9);
        assertEquals(90, motion.vx, 1e-9);
    }
}
