package io.github.sofas.flow.search;

import static org.junit.Assert.assertEquals;
import static org.junit.Assert.assertFalse;
import static org.junit.Assert.assertTrue;

import io.github.sofas.event.SensorSize;
import java.util.Random;
import org.junit.Test;

/** Which events are searched where many come. */
public class SearchedTilesTest {
    private static final SensorSize SENSOR = new SensorSize(240, 180);

    private final SearchedTiles tiles = new SearchedTiles(SENSOR);

    /** Events taken of those that come evenly over the sensor and a time. */
    private int taken(long fromUs, long untilUs, int perUs) {
        Random random = new Random(fromUs);
        int taken = 0;
        for (long timeUs = fromUs; timeUs < untilUs; timeUs++) {
            for (int i = 0; i < perUs; i++) {
                taken += tiles.takes(random.nextInt(240), random.nextInt(180), timeUs) ? 1 : 0;
            }
        }
        return taken;
    }

    @Test
    public void takesAllWhereOneComesInAMicrosecond() {
        assertEquals(40_000, taken(0, 40_000, 1));
        assertFalse(tiles.isThinned());
    }

    @Test
    public void takesNoMoreOfManyThanOfOneInAMicrosecond() {
        taken(0, 8_000, 50);
        assertTrue(tiles.isThinned());
        // of 10 intervals, each with 4,096 and at most one more that halves the tiles
        int taken = taken(8_000, 48_000, 50);
        assertTrue("taken " + taken, taken <= 10 * 4_097 * 2 && taken >= 10 * 4_096 / 4);
    }

    @Test
    public void takesWholeTiles() {
        taken(0, 8_000, 8);
        boolean[] whole = new boolean[2];
        for (int tileX = 0; tileX < 240; tileX += 32) {
            boolean first = tiles.takes(tileX, 64, 8_000);
            whole[first ? 1 : 0] = true;
            for (int x = tileX; x < Math.min(240, tileX + 32); x++) {
                assertEquals(first, tiles.takes(x, 64 + x % 32, 8_000));
            }
        }
        assertTrue(whole[0] && whole[1]);
    }

    @Test
    public void takesAllAgainAfterSilence() {
        taken(0, 8_000, 20);
        assertTrue(tiles.isThinned());
        assertEquals(1_000, taken(30_000, 31_000, 1));
        assertFalse(tiles.isThinned());
    }

    @Test
    public void eachHalvingLeavesEveryOtherTileAndTheMiddle() {
        int before = 64 * 64;
        for (int halvings = 0; halvings <= 6; halvings++) {
            int count = 0;
            for (int row = -32; row < 32; row++) {
                for (int column = -32; column < 32; column++) {
                    boolean taken = SearchedTiles.isTaken(column, row, halvings);
                    assertTrue(!taken || halvings == 0 || SearchedTiles.isTaken(column, row, halvings - 1));
                    count += taken ? 1 : 0;
                }
            }
            assertEquals(halvings == 0 ? before : before / 2, count);
            assertTrue(SearchedTiles.isTaken(0, 0, halvings));
            before = count;
        }
        // as on a chessboard, then every other row
        assertTrue(SearchedTiles.isTaken(3, -1, 1));
        assertFalse(SearchedTiles.isTaken(3, -1, 2));
        assertFalse(SearchedTiles.isTaken(3, 2, 1));
        assertTrue(SearchedTiles.isTaken(-2, 4, 2));
    }
}
