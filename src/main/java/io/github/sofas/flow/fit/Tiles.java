package io.github.sofas.flow.fit;

import java.util.Arrays;

/**
 * Tiles that divide a structure into parts whose events lie near each other: the middle of each tile, and the tile that
 * each event lies on.
 */
final class Tiles {
    /** Side of a tile in px, and tiles along each axis; the outermost tiles include what lies beyond them. */
    private static final float TILE_PX = 32;
    private static final int TILES = 64;

    private final int[] tile;
    private final float[] middleX = new float[TILES * TILES];
    private final float[] middleY = new float[TILES * TILES];
    private final int[] count = new int[TILES * TILES];

    Tiles(int capacity) {
        tile = new int[capacity];
    }

    /** Finds the tiles of the first {@code size} events, at these places from the structure's centre, in px. */
    void find(float[] x, float[] y, int size) {
        Arrays.fill(middleX, 0);
        Arrays.fill(middleY, 0);
        Arrays.fill(count, 0);
        for (int i = 0; i < size; i++) {
            int k = number(y[i]) * TILES + number(x[i]);
            tile[i] = k;
            middleX[k] += x[i];
            middleY[k] += y[i];
            count[k]++;
        }
        for (int k = 0; k < count.length; k++) {
            if (count[k] > 0) {
                middleX[k] /= count[k];
                middleY[k] /= count[k];
            }
        }
    }

    private static int number(float place) {
        return Math.max(0, Math.min(TILES - 1, (int) (place / TILE_PX + TILES / 2)));
    }

    /** The tile of each event. */
    int[] ofEvents() {
        return tile;
    }

    /** Mean place of the events of each tile from the structure's centre, in px; 0 for a tile without events. */
    float[] middleX() {
        return middleX;
    }

    float[] middleY() {
        return middleY;
    }
}
