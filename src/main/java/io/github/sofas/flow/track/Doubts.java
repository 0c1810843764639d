package io.github.sofas.flow.track;

import io.github.sofas.event.SensorSize;
import java.util.Arrays;

/**
 * Where on the sensor the contours explain events badly: by tile of 8 x 8 px, the share of the events of late whose
 * support was doubtful, or which lay on no contour where one was remembered.
 *
 * <p>Ours, because the contour of a dense texture, and the memory of one even more, is everywhere, and lets no event of
 * what moves before it reach the flow plane. Single events are doubtful in any texture; only where many are is there
 * something else.
 */
final class Doubts {
    private static final int TILE_BITS = 3;
    /** Events of a tile that its share is a mean of, fading. */
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

    /** Bytes of its arrays. */
    static long bytes(SensorSize sensor) {
        return (long) Float.BYTES * tiles(sensor);
    }

    /** Notes whether an event was doubtful; returns whether many of its tile are. */
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
