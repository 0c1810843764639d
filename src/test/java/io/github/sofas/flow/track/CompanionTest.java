package io.github.sofas.flow.track;

import static org.junit.Assert.assertEquals;
import static org.junit.Assert.assertFalse;
import static org.junit.Assert.assertTrue;

import org.junit.Before;
import org.junit.Test;

/** At 100 px/s, 1 px in 10 ms. */
public class CompanionTest {
    private static final double SPEED = 100;

    private final Companion companion = new Companion();

    @Before
    public void begin() {
        companion.start();
    }

    @Test
    public void wayTogetherCountsFromTheFirstAgreement() {
        assertTrue(companion.mayBe(7, 1_000));
        companion.note(7, true, SPEED, 1_000);
        assertEquals(0, companion.togetherPx(), 0);
        companion.note(7, true, SPEED, 11_000);
        companion.note(7, true, 2 * SPEED, 21_000);
        assertEquals(1 + 2, companion.togetherPx(), 1e-9);
    }

    @Test
    public void wayThatIsGoneOtherwiseIsTakenOff() {
        companion.note(7, true, SPEED, 1_000);
        companion.note(7, true, SPEED, 11_000);
        companion.note(7, true, SPEED, 21_000);
        companion.note(7, false, SPEED, 31_000);
        assertEquals(1, companion.togetherPx(), 1e-9);
        assertFalse(companion.mayBe(8, 31_000));
    }

    @Test
    public void thereIsOneAtATime() {
        companion.note(7, true, SPEED, 1_000);
        assertTrue(companion.mayBe(7, 6_000));
        assertFalse(companion.mayBe(8, 6_000));
    }

    @Test
    public void oneThatWentAsFarOtherwiseMakesRoomForAnother() {
        companion.note(7, true, SPEED, 1_000);
        companion.note(7, true, SPEED, 11_000);
        companion.note(7, false, SPEED, 21_000);
        assertTrue(companion.mayBe(8, 21_000));
        assertEquals(0, companion.togetherPx(), 0);
    }

    @Test
    public void oneThatNeverMovedAlikeIsNone() {
        companion.note(7, false, SPEED, 1_000);
        assertTrue(companion.mayBe(8, 1_000));
    }

    @Test
    public void oneThatIsNotSeenForLongMakesRoomToo() {
        companion.note(7, true, SPEED, 1_000);
        companion.note(7, true, SPEED, 11_000);
        assertFalse(companion.mayBe(8, 31_000));
        assertTrue(companion.mayBe(8, 31_001));
        companion.note(7, true, SPEED, 31_001);
        assertEquals("and begins anew itself", 0, companion.togetherPx(), 0);
    }
}
