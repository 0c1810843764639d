package io.github.sofas.flow.track;

import static org.junit.Assert.assertEquals;
import static org.junit.Assert.assertFalse;
import static org.junit.Assert.assertTrue;

import io.github.sofas.flow.track.Life.State;
import org.junit.Before;
import org.junit.Test;

public class LifeTest {
    private static final long PATIENCE_US = 50_000;

    private final Life life = new Life();

    @Before
    public void begin() {
        life.start(1_000);
    }

    private void giveEvents(int count) {
        for (int i = 0; i < count; i++) {
            life.note(2_000);
        }
    }

    private State starve(long nowUs) {
        return life.goOn(true, false, true, PATIENCE_US, nowUs);
    }

    @Test
    public void structureThatGetsItsEventsIsTracked() {
        assertEquals(State.TRACKED, life.goOn(false, false, true, PATIENCE_US, 5_000));
        assertTrue(life.isTracked());
    }

    @Test
    public void starvedStructureIsWaitedForFromTwoHundredEventsOn() {
        giveEvents(199);
        assertEquals(State.ENDED, starve(5_000));
        life.start(1_000);
        giveEvents(200);
        assertEquals(State.WAITED_FOR, starve(5_000));
        assertFalse(life.isTracked());
    }

    @Test
    public void eventsOfWhatWasTakenOverCount() {
        Life other = new Life();
        other.start(0);
        other.note(500);
        giveEvents(199);
        life.takeOver(other);
        assertEquals(200, life.events());
        assertEquals(1_000, life.firstUs());
        assertEquals(2_000, life.lastUs());
        assertEquals(State.WAITED_FOR, starve(5_000));
    }

    @Test
    public void patienceIsCountedFromWhenItStarvedFirst() {
        giveEvents(200);
        starve(5_000);
        assertTrue(life.isWaitedFor(0, 5_000));
        assertFalse(life.isWaitedFor(20_000, 24_999));
        assertTrue(life.isWaitedFor(20_000, 25_000));
        assertEquals(State.WAITED_FOR, starve(54_999));
        assertEquals(State.ENDED, starve(55_000));
    }

    @Test
    public void whatGetsEventsAgainIsTrackedAgain() {
        giveEvents(200);
        starve(5_000);
        assertEquals(State.TRACKED, life.goOn(false, false, true, PATIENCE_US, 10_000));
        assertFalse(life.isWaitedFor(0, 10_000));
        assertEquals(State.WAITED_FOR, starve(15_000));
        assertEquals(State.WAITED_FOR, starve(64_999));
    }

    @Test
    public void whatIsGoneOrOutOfSightIsNotWaitedFor() {
        giveEvents(200);
        assertEquals(State.ENDED, life.goOn(false, true, true, PATIENCE_US, 5_000));
        life.start(1_000);
        giveEvents(200);
        // what still gets events is in sight, whatever its box says
        assertEquals(State.TRACKED, life.goOn(false, false, false, PATIENCE_US, 5_000));
        assertEquals(State.ENDED, life.goOn(true, false, false, PATIENCE_US, 10_000));
    }
}
