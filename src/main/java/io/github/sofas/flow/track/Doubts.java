package io.github.sofas.flow.track;

import io.github.sofas.event.SensorSize;

/**
 * Shows where on the sensor the contours explain events badly. For each tile of 8 x 8 px, it keeps the share of recent
 * events whose support was doubtful, or which lay on no contour where one was remembered.
 *
 * <p>Ours, because the contour of a dense texture is everywhere, and its memory even more so. They would keep all
 * events of a structure in front of the texture from the flow plane. Single events are doubtful in any texture. Only
 * many doubtful events in a tile indicate another structure.
 */
final class Doubts {
    private static final int TILE_BITS = 3;
    /** Number of events over which the share of a tile fades. */
    private static final float EVENTS = 16;
    private static final float LEAST_SHARE = 0.3f;

    private final TileShares doubtful;

    Doubts(SensorSize sensor) {
        doubtful = new TileShares(sensor, TILE_BITS, EVENTS);
    }

    /** Bytes that the array takes. */
    static long bytes(SensorSize sensor) {
        return TileShares.bytes(sensor, TILE_BITS);
    }

    /** Notes whether an event was doubtful; returns whether many events of its tile are. */
    boolean note(int x, int y, boolean isDoubtful) {
        return doubtful.note(x, y, isDoubtful) >= LEAST_SHARE;
    }

    /** Forgets all events. */
    void reset() {
        doubtful.setAll(0);
    }
}
