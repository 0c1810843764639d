package io.github.sofas.flow.search;

import io.github.sofas.event.SensorSize;

/**
 * The tiles of the sensor whose events are searched for structures. All tiles are searched, unless more events come per
 * interval than are needed. Then the number of tiles is halved, again and again, until the events are few enough.
 *
 * <p>Ours, because what a search needs is travel, and it costs n² votes per event. Whole tiles are left out, because
 * thinning events one by one thins their meetings by the square. The tiles that are left lie as far from each other as
 * they can: every other one as on a chessboard, then every other row of those, and so on, with one in the middle.
 */
final class SearchedTiles {
    /** Tiles have sides of 2^this px. */
    private static final int TILE_BITS = 5;
    private static final long INTERVAL_US = 4_000;
    /** Most events per interval: about one per microsecond. */
    private static final int MOST = 4_096;
    /** The number of tiles doubles after an interval with fewer events than {@link #MOST} divided by this. */
    private static final int LEAST_PART = 4;
    private static final int MOST_HALVINGS = 12;

    private final int middleX;
    private final int middleY;
    private int halvings;
    private long intervalEndUs;
    private int count;

    SearchedTiles(SensorSize sensor) {
        middleX = sensor.width() >> TILE_BITS + 1;
        middleY = sensor.height() >> TILE_BITS + 1;
        reset();
    }

    /**
     * Whether the tile of an event is searched. The time of the event must be no less than that of the event before.
     */
    boolean takes(int x, int y, long timeUs) {
        if (timeUs >= intervalEndUs) {
            if (count < MOST / LEAST_PART && halvings > 0) {
                halvings--;
            }
            if (timeUs >= intervalEndUs + INTERVAL_US) {
                // no event came for an interval
                halvings = 0;
            }
            intervalEndUs = timeUs + INTERVAL_US;
            count = 0;
        }
        if (!isTaken((x >> TILE_BITS) - middleX, (y >> TILE_BITS) - middleY, halvings)) {
            return false;
        }
        count++;
        if (count > MOST && halvings < MOST_HALVINGS) {
            halvings++;
            count /= 2;
        }
        return true;
    }

    /** Whether only some of the tiles are searched. */
    boolean isThinned() {
        return halvings > 0;
    }

    /** Whether a tile is left after a number of halvings; column and row are counted from the middle tile. */
    static boolean isTaken(int column, int row, int halvings) {
        int doublings = halvings >> 1;
        int rest = (1 << doublings) - 1;
        return ((column | row) & rest) == 0 && ((halvings & 1) == 0 || ((column ^ row) >> doublings & 1) == 0);
    }

    /** Forgets all events. */
    void reset() {
        halvings = 0;
        count = 0;
        intervalEndUs = Long.MIN_VALUE / 2;
    }
}
