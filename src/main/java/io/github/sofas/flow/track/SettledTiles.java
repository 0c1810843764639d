package io.github.sofas.flow.track;

import io.github.sofas.event.SensorSize;
import java.util.Arrays;

/**
 * Shows on which tiles of the sensor a lone wall explains nearly all events that are asked whether they lie on its
 * contour. There, only the events that are measured need to be asked; the others are the wall's.
 *
 * <p>Ours, because looking an event up costs more than all else that a label needs. A dense wall is measured on a part
 * of its tiles. These lie all over it, so that their events show when something else appears: it gives the tile
 * unexplained events, and from then on each event of the tile, and of those around it, is asked. Tiles at the border,
 * where texture comes in, are never settled.
 */
final class SettledTiles {
    /** Tiles have sides of 2^this px: 32 px, which hold several tiles of the wall that are measured. */
    private static final int TILE_BITS = 5;
    /** Number of events over which the share of a tile fades. */
    private static final float EVENTS = 128;
    /** Share of unexplained events from which on a tile is not settled: small bodies give a fast wall little more. */
    private static final float MOST_UNEXPLAINED = 0.02f;

    private final int columns;
    private final float[] unexplained;
    private int wall;

    SettledTiles(SensorSize sensor) {
        columns = columns(sensor);
        unexplained = new float[tiles(sensor)];
        Arrays.fill(unexplained, 1);
    }

    private static int columns(SensorSize sensor) {
        return (sensor.width() >> TILE_BITS) + 1;
    }

    private static int tiles(SensorSize sensor) {
        return columns(sensor) * ((sensor.height() >> TILE_BITS) + 1);
    }

    /** Bytes that the array takes. */
    static long bytes(SensorSize sensor) {
        return (long) Float.BYTES * tiles(sensor);
    }

    /** Takes the id of the lone wall, or 0 for none. No tile is settled for another one yet. */
    void follow(int lone) {
        if (lone != wall) {
            wall = lone;
            Arrays.fill(unexplained, 1);
        }
    }

    private int tile(int x, int y) {
        return (y >> TILE_BITS) * columns + (x >> TILE_BITS);
    }

    /** Whether the wall explains nearly all events of the tile at a place. */
    boolean isSettled(int x, int y) {
        return unexplained[tile(x, y)] < MOST_UNEXPLAINED;
    }

    /**
     * Notes whether the wall explains an event that was asked. A tile that is no longer settled has the tiles around it
     * begin anew: what appears there is seldom as small as a tile.
     */
    void note(int x, int y, boolean isExplained) {
        int tile = tile(x, y);
        boolean wasSettled = isSettled(x, y);
        unexplained[tile] += ((isExplained ? 0 : 1) - unexplained[tile]) / EVENTS;
        if (wasSettled && !isSettled(x, y)) {
            beginAnewAround(x >> TILE_BITS, y >> TILE_BITS);
        }
    }

    private void beginAnewAround(int column, int row) {
        int lastRow = Math.min(unexplained.length / columns - 1, row + 1);
        int firstColumn = Math.max(0, column - 1);
        int lastColumn = Math.min(columns - 1, column + 1);
        for (int r = Math.max(0, row - 1); r <= lastRow; r++) {
            Arrays.fill(unexplained, r * columns + firstColumn, r * columns + lastColumn + 1, 1);
        }
    }
}
