package io.github.sofas.flow.track;

import static org.junit.Assert.assertEquals;
import static org.junit.Assert.assertFalse;
import static org.junit.Assert.assertTrue;

import io.github.sofas.event.SensorSize;
import org.junit.Test;

public class DoubtsTest {
    private final Doubts doubts = new Doubts(new SensorSize(20, 12));

    @Test
    public void manyOfATileAreDoubtfulAfterSixInARow() {
        // 1 - (15/16)^5 = 0.276, and ^6 0.321
        for (int i = 0; i < 5; i++) {
            assertFalse(doubts.note(9, 9, true));
        }
        assertTrue(doubts.note(9, 9, true));
    }

    @Test
    public void oneInFiveIsNotMany() {
        // settles between 0.15 and 0.23
        for (int i = 0; i < 200; i++) {
            assertFalse(doubts.note(9, 9, i % 5 == 0));
        }
    }

    @Test
    public void tilesOfEightPixelsAreApart() {
        for (int i = 0; i < 20; i++) {
            doubts.note(15, 8, true);
        }
        assertTrue(doubts.note(8, 11, true));
        assertFalse(doubts.note(16, 8, true));
        assertFalse(doubts.note(15, 7, true));
        assertFalse(doubts.note(19, 11, false));
    }

    @Test
    public void resetForgets() {
        for (int i = 0; i < 20; i++) {
            doubts.note(0, 0, true);
        }
        doubts.reset();
        assertFalse(doubts.note(0, 0, true));
    }

    @Test
    public void memoryIsThatOfItsTiles() {
        // 3 x 2 tiles
        assertEquals(24, Doubts.bytes(new SensorSize(20, 12)));
    }
}
