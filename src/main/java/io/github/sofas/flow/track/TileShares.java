package io.github.sofas.flow.track;

import io.github.sofas.event.SensorSize;
import java.util.Arrays;

/** The share of recent events of each square tile of the sensor that something is true of: a mean that fades. */
final class TileShares {
    private final int tileBits;
    /** Number of events over which a share fades. */
    private final float events;
    private final int columns;
    private final float[] share;

    /**
     * Makes shares of 0.
     *
     * @param tileBits tiles have sides of 2^this px
     * @param events number of events over which a share fades
     */
    TileShares(SensorSize sensor, int tileBits, float events) {
        this.tileBits = tileBits;
        this.events = events;
        columns = columns(sensor, tileBits);
        share = new float[tiles(sensor, tileBits)];
    }

    private static int columns(SensorSize sensor, int tileBits) {
        return (sensor.width() >> tileBits) + 1;
    }

    private static int tiles(SensorSize sensor, int tileBits) {
        return columns(sensor, tileBits) * ((sensor.height() >> tileBits) + 1);
    }

    /** Bytes that the array takes. */
    static long bytes(SensorSize sensor, int tileBits) {
        return (long) Float.BYTES * tiles(sensor, tileBits);
    }

    private int tile(int x, int y) {
        return (y >> tileBits) * columns + (x >> tileBits);
    }

    /** Share of the tile at a place. */
    float at(int x, int y) {
        return share[tile(x, y)];
    }

    /** Notes whether it is true of an event; returns the share of its tile. */
    float note(int x, int y, boolean isTrue) {
        int tile = tile(x, y);
        share[tile] += ((isTrue ? 1 : 0) - share[tile]) / events;
        return share[tile];
    }

    /** Sets the share of all tiles. */
    void setAll(float all) {
        Arrays.fill(share, all);
    }

    /** Sets the share of the tile at a place, and of the up to eight tiles around it. */
    void setAround(int x, int y, float around) {
        int column = x >> tileBits;
        int row = y >> tileBits;
        int firstColumn = Math.max(0, column - 1);
        int lastColumn = Math.min(columns - 1, column + 1);
        int lastRow = Math.min(share.length / columns - 1, row + 1);
        for (int r = Math.max(0, row - 1); r <= lastRow; r++) {
            Arrays.fill(share, r * columns + firstColumn, r * columns + lastColumn + 1, around);
        }
    }
}
