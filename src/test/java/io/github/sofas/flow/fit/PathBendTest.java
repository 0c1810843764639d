package io.github.sofas.flow.fit;

import static org.junit.Assert.assertEquals;
import static org.junit.Assert.assertTrue;

import io.github.sofas.flow.motion.Motion;
import org.junit.Test;

/** The rotation of what turns with its path. */
public class PathBendTest {
    private static final double LENGTH_PX = 64;

    private static Motion heading(double timeS, double speed, double angleRad) {
        Motion motion = new Motion();
        motion.set(Math.round(timeS * 1e6), speed * Math.cos(angleRad), speed * Math.sin(angleRad));
        return motion;
    }

    @Test
    public void bodyOnACircleTurnsOnceARound() {
        // 200 px/s on a circle of 100 px: 2 rad/s, followed over 400 px, of which the path's mean forgets all but e^-6
        PathBend path = new PathBend();
        path.start(0);
        for (int i = 0; i <= 200; i++) {
            path.follow(heading(i * 0.01, 200, 2 * i * 0.01), LENGTH_PX);
        }
        assertEquals(2, path.omega(heading(2, 200, 4), LENGTH_PX), 0.1);
        // half as fast on the same path, half as fast round
        assertEquals(1, path.omega(heading(2, 100, 4), LENGTH_PX), 0.05);
    }

    @Test
    public void bodyThatTurnsRoundTurnsTheOtherWayOnItsWayBack() {
        PathBend path = new PathBend();
        path.start(0);
        for (int i = 0; i <= 200; i++) {
            path.follow(heading(i * 0.01, 200, 2 * i * 0.01), LENGTH_PX);
        }
        Motion back = heading(2.01, 200, 4 + Math.PI);
        path.follow(back, LENGTH_PX);
        assertEquals(-2, path.omega(back, LENGTH_PX), 0.1);
    }

    @Test
    public void bodyOnAStraightPathDoesNotTurn() {
        PathBend path = new PathBend();
        path.start(0);
        // half a degree to and fro
        for (int i = 0; i <= 200; i++) {
            path.follow(heading(i * 0.01, 200, i % 2 == 0 ? 0.0044 : -0.0044), LENGTH_PX);
        }
        assertTrue(Math.abs(path.omega(heading(2, 200, 0), LENGTH_PX)) < 0.001);
    }

    @Test
    public void reboundIsNoBend() {
        PathBend path = new PathBend();
        path.start(0);
        for (int i = 0; i <= 100; i++) {
            path.follow(heading(i * 0.01, 200, i < 50 ? 0 : Math.PI / 2), LENGTH_PX);
        }
        assertEquals(0, path.omega(heading(1, 200, Math.PI / 2), LENGTH_PX), 1e-9);
    }
}
