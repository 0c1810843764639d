package io.github.sofas.flow.track;

import io.github.sofas.event.SensorSize;
import java.util.Arrays;

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

    private final int columns;
    private final float[] share;

    Doubts(SensorSize sensor) {
        columns = columns(sensor);
        share = new float[tiles(sensor)];
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

    /** Notes whether an event was doubtful; returns whether many events of its tile are. */
    boolean note(int x, int y, boolean doubtful) {
        int tile = (y >> TILE_BITS) * columns + (x >> TILE_BITS);
        share[tile] += ((doubtful ? 1 : 0) - share[tile]) / EVENTS;
        return share[tile] >= LEAST_SHARE;
    }

    /** Forgets all events. */
    void reset() {
        Arrays.fill(share, 0);
    }
}
