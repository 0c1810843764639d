package io.github.sofas.flow.track;

import static org.junit.Assert.assertEquals;
import static org.junit.Assert.assertFalse;
import static org.junit.Assert.assertTrue;

import io.github.sofas.event.SensorSize;
import org.junit.Test;

public class SettledTilesTest {
    private final SettledTiles settled = new SettledTiles(new SensorSize(70, 40));

    private void note(int events, boolean areExplained) {
        for (int i = 0; i < events; i++) {
            settled.note(40, 10, areExplained);
        }
    }

    @Test
    public void tileIsSettledOnceNearlyAllOfItsEventsAreExplained() {
        settled.follow(1);
        // (127/128)^498 = 0.0201, and ^499 0.0200 less a little
        note(498, true);
        assertFalse(settled.isSettled(40, 10));
        note(1, true);
        assertTrue(settled.isSettled(40, 10));
    }

    @Test
    public void threeUnexplainedEventsInARowUnsettleIt() {
        settled.follow(1);
        note(2_000, true);
        // two are 0.0156, three 0.0233
        note(2, false);
        assertTrue(settled.isSettled(40, 10));
        note(1, false);
        assertFalse(settled.isSettled(40, 10));
    }

    @Test
    public void tileThatIsNoLongerSettledHasThoseAroundItBeginAnew() {
        SettledTiles large = new SettledTiles(new SensorSize(159, 159));
        large.follow(1);
        for (int i = 0; i < 2_000; i++) {
            for (int tile = 0; tile < 25; tile++) {
                large.note(tile % 5 * 32, tile / 5 * 32, true);
            }
        }
        assertTrue(large.isSettled(158, 31));
        for (int i = 0; i < 3; i++) {
            large.note(140, 10, false);
        }
        // the tile in the last column of the first row, and the three around it
        for (int tile = 0; tile < 25; tile++) {
            boolean isAround = tile % 5 >= 3 && tile / 5 <= 1;
            assertEquals("tile " + tile, !isAround, large.isSettled(tile % 5 * 32, tile / 5 * 32));
        }
    }

    @Test
    public void tilesOf32PixelsAreApart() {
        settled.follow(1);
        note(2_000, true);
        assertTrue(settled.isSettled(32, 31));
        assertTrue(settled.isSettled(63, 0));
        assertFalse(settled.isSettled(31, 31));
        assertFalse(settled.isSettled(64, 31));
        assertFalse(settled.isSettled(40, 32));
    }

    @Test
    public void nothingIsSettledForAnotherWall() {
        settled.follow(1);
        note(2_000, true);
        settled.follow(1);
        assertTrue(settled.isSettled(40, 10));
        settled.follow(2);
        assertFalse(settled.isSettled(40, 10));
    }

    @Test
    public void memoryIsThatOfItsTiles() {
        // 3 x 2 tiles
        assertEquals(24, SettledTiles.bytes(new SensorSize(70, 40)));
    }
}
