package io.github.sofas.flow.track;

import static org.junit.Assert.assertEquals;
import static org.junit.Assert.assertTrue;

import io.github.sofas.flow.motion.Motion;
import org.junit.Test;

/** What a structure has looked like, in coordinates that travel and turn with it. */
public class ContourMemoryTest {
    private static Motion motion(long timeUs, double vx, double vy, double omega) {
        Motion motion = new Motion();
        motion.set(timeUs, vx, vy);
        motion.omega = omega;
        motion.centreX = 40 + vx * timeUs * 1e-6;
        motion.centreY = 30 + vy * timeUs * 1e-6;
        return motion;
    }

    /** A vertical edge of twenty pixels at x = 50, seen at time 0 on a structure whose centre is at (40, 30). */
    private static ContourMemory edge(Motion at) {
        ContourMemory shape = new ContourMemory(128, 96);
        shape.start(at);
        shape.follow(at, 1_000_000);
        for (int y = 20; y < 40; y++) {
            shape.see(50, y, 0);
        }
        return shape;
    }

    @Test
    public void remembersWhereItWasSeenAndNowhereElse() {
        ContourMemory shape = edge(motion(0, 0, 0, 0));
        // cells of 2 px from the centre: x 50 and 51 are one; the four around an event are two columns
        assertEquals(2, shape.remembered(50, 30, 1000));
        assertEquals(2, shape.remembered(52, 30, 1000));
        assertEquals(0, shape.remembered(54, 30, 1000));
        assertEquals(0, shape.remembered(47, 30, 1000));
        assertEquals(0, shape.remembered(50, 10, 1000));
    }

    @Test
    public void placesTravelWithTheStructure() {
        // 40 px/s to the right, 20 up: after 0.5 s 20 px and 10 px
        ContourMemory shape = edge(motion(0, 40, -20, 0));
        assertEquals(2, shape.remembered(70, 20, 500_000));
        assertEquals(0, shape.remembered(50, 30, 500_000));
        shape.follow(motion(500_000, 40, -20, 0), 1_000_000);
        assertEquals(2, shape.remembered(70, 20, 500_000));
        assertEquals(2, shape.remembered(78, 16, 700_000));
    }

    @Test
    public void placesTurnWithTheStructure() {
        // a quarter turn a second, from x towards y, followed every 20 ms: what was right of the centre is below it
        double omega = Math.PI / 2;
        ContourMemory shape = edge(motion(0, 0, 0, omega));
        for (int i = 1; i <= 50; i++) {
            shape.follow(motion(i * 20_000, 0, 0, omega), 2_000_000);
        }
        assertTrue(shape.remembered(40, 40, 1_000_000) > 0);
        assertTrue(shape.remembered(34, 40, 1_000_000) > 0);
        assertEquals(0, shape.remembered(50, 30, 1_000_000));
    }

    @Test
    public void placesAreForgottenAfterTheTimeOfMemory() {
        // seen at 0, remembered for 976 ticks of 1,024 us
        ContourMemory shape = edge(motion(0, 0, 0, 0));
        assertEquals(2, shape.remembered(50, 30, (976L << 10) - 1));
        assertEquals(0, shape.remembered(50, 30, 976L << 10));
    }

    @Test
    public void nothingIsRememberedAtTheStart() {
        ContourMemory shape = edge(motion(0, 0, 0, 0));
        shape.start(motion(10, 0, 0, 0));
        shape.follow(motion(10, 0, 0, 0), 1_000_000);
        assertEquals(0, shape.remembered(50, 30, 20));
    }
}
