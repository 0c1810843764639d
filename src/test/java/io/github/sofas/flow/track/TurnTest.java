package io.github.sofas.flow.track;

import static org.junit.Assert.assertEquals;
import static org.junit.Assert.assertFalse;
import static org.junit.Assert.assertTrue;

import io.github.sofas.flow.motion.Motion;
import org.junit.Test;

/** A motion of 10 px/s and 100 px/s²: it turns 0.1 s away from now, which is at 1 s. */
public class TurnTest {
    private static final long NOW_US = 1_000_000;

    private final Turn turn = new Turn();
    private final Motion motion = new Motion();

    private void moves(double vy, double ay) {
        motion.set(NOW_US, 0, vy);
        motion.ay = ay;
        turn.take(motion, NOW_US);
    }

    @Test
    public void turnIsNearForHalfALifetimeAfterItAndAFifthBeforeIt() {
        moves(-10, -100);
        assertTrue(turn.isNear(201_000));
        assertFalse(turn.isNear(199_000));
        moves(10, -100);
        assertTrue(turn.isNear(501_000));
        assertFalse(turn.isNear(499_000));
    }

    @Test
    public void whatRestsMayTurnAndWhatIsSteadyDoesNot() {
        moves(0, 0);
        assertTrue(turn.isNear(1));
        assertFalse(turn.isAfter(0));
        moves(10, 0);
        assertFalse(turn.isNear(1_000_000));
        assertFalse(turn.isAfter(0));
    }

    @Test
    public void eventsOfBeforeTheTurnHaveTheOtherPolarityNow() {
        moves(10, 100);
        assertTrue(turn.isAfter(899_999));
        assertFalse(turn.isAfter(900_001));
        assertEquals(-1, turn.polarity(899_999, 1));
        assertEquals(1, turn.polarity(899_999, -1));
        assertEquals(1, turn.polarity(900_001, 1));
    }

    @Test
    public void turnAheadChangesNothingYet() {
        moves(10, -100);
        assertFalse(turn.isAfter(0));
    }
}
