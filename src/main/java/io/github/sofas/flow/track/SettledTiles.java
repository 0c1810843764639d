package io.github.sofas.flow.track;

import io.github.sofas.event.SensorSize;

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

    private final TileShares unexplained;
    private int wall;

    SettledTiles(SensorSize sensor) {
        unexplained = new TileShares(sensor, TILE_BITS, EVENTS);
        unexplained.setAll(1);
    }

    /** Bytes that the array takes. */
    static long bytes(SensorSize sensor) {
        return TileShares.bytes(sensor, TILE_BITS);
    }

    /** Takes the id of the lone wall, or 0 for none. No tile is settled for another one yet. */
    void follow(int lone) {
        if (lone != wall) {
            wall = lone;
            unexplained.setAll(1);
        }
    }

    /** Whether the wall explains nearly all events of the tile at a place. */
    boolean isSettled(int x, int y) {
        return unexplained.at(x, y) < MOST_UNEXPLAINED;
    }

    /**
     * Notes whether the wall explains an event that was asked. A tile that is no longer settled begins anew with the
     * tiles around it: what appears there is seldom as small as a tile.
     */
    void note(int x, int y, boolean isExplained) {
        boolean wasSettled = isSettled(x, y);
        if (unexplained.note(x, y, !isExplained) >= MOST_UNEXPLAINED && wasSettled) {
            unexplained.setAround(x, y, 1);
        }
    }
}
