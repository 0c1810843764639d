package io.github.sofas.flow.motion;

import static org.junit.Assert.assertEquals;

import org.junit.Test;

public class SteppedProjectionTest {
    private static final double STEP_PX = 1.0 / 16;

    @Test
    public void eventsFallWithinHalfAStepOfWhereTheMotionPutsThem() {
        Motion motion = new Motion();
        motion.set(1_000_000, 120, -40);
        motion.ax = 300;
        motion.ay = 100;
        motion.omega = 1.5;
        motion.centreX = 80;
        motion.centreY = 60;
        SteppedProjection stepped = new SteppedProjection();
        stepped.begin(motion, 200_000, 40, STEP_PX);
        double farthest = 0;
        for (long timeUs = 800_000; timeUs <= 1_000_000; timeUs += 37) {
            // places that stay within 40 px of the centre, which moves by less than 24 px
            int x = 80 - (int) (timeUs / 37 % 15);
            int y = 60 + (int) (timeUs / 37 % 13);
            motion.project(x, y, timeUs);
            stepped.advance(timeUs);
            double off = Math.hypot(stepped.x(x, y) - motion.x, stepped.y(x, y) - motion.y);
            farthest = Math.max(farthest, off);
        }
        assertEquals(0, farthest, STEP_PX / 2 + 1e-9);
    }

    @Test
    public void whatStandsStillIsProjectedInOneStep() {
        Motion motion = new Motion();
        motion.set(1_000_000, 0, 0);
        SteppedProjection stepped = new SteppedProjection();
        stepped.begin(motion, 500_000, 100, STEP_PX);
        stepped.advance(500_000);
        assertEquals(17, stepped.x(17, 31), 0);
        stepped.advance(1_000_000);
        assertEquals(31, stepped.y(17, 31), 0);
    }
}
