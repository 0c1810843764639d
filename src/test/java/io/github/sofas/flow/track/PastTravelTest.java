package io.github.sofas.flow.track;

import static org.junit.Assert.assertEquals;

import io.github.sofas.flow.motion.Motion;
import org.junit.Test;

public class PastTravelTest {
    private final PastTravel travel = new PastTravel();
    private final Motion motion = new Motion();

    @Test
    public void travelIsThatAlongTheMotionAsItWas() {
        // 50 px/s now, 66 px/s 40 ms ago
        motion.set(100_000, 30, 40);
        motion.ax = -240;
        motion.ay = -320;
        assertEquals(58 * 0.04, travel.px(motion, 0, 60_000, 100_000), 1e-9);
    }

    @Test
    public void turningCountsAtTheRadiusOfTheStructure() {
        motion.set(0, 3, 0);
        motion.omega = 2;
        assertEquals(Math.hypot(3, 2 * 2) * 0.5, travel.px(motion, 2, 0, 500_000), 1e-9);
    }

    @Test
    public void wayThereAndBackBothCount() {
        // from 10 to -10 px/s: looked at four times, at 7.5 and 2.5 px/s either way
        motion.set(200_000, -10, 0);
        motion.ax = -100;
        assertEquals(1, travel.px(motion, 0, 0, 200_000), 1e-9);
    }
}
