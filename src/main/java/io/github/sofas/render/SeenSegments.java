package io.github.sofas.render;

import java.util.Arrays;

/**
 * The segments with exposed pixels at the time of a picture: for each, the number of its pixels, their mean position
 * and their mean velocity.
 */
final class SeenSegments {
    private int size;
    private int[] ids = new int[16];
    private int[] pixels = new int[16];
    private double[] sums = new double[16 * 4];
    /** Index at which an id was last found, by the low bits of the id. Makes most searches unnecessary. */
    private final int[] places = new int[256];

    void clear() {
        size = 0;
    }

    /** Adds a pixel and returns the index of its segment. */
    int add(int id, int x, int y, double vx, double vy) {
        int last = places[id & places.length - 1];
        if (last >= size || ids[last] != id) {
            last = 0;
            while (last < size && ids[last] != id) {
                last++;
            }
            if (last == size) {
                append(id);
            }
            places[id & places.length - 1] = last;
        }
        pixels[last]++;
        sums[4 * last] += x;
        sums[4 * last + 1] += y;
        sums[4 * last + 2] += vx;
        sums[4 * last + 3] += vy;
        return last;
    }

    private void append(int id) {
        if (size == ids.length) {
            ids = Arrays.copyOf(ids, 2 * size);
            pixels = Arrays.copyOf(pixels, 2 * size);
            sums = Arrays.copyOf(sums, 8 * size);
        }
        ids[size] = id;
        pixels[size] = 0;
        Arrays.fill(sums, 4 * size, 4 * size + 4, 0);
        size++;
    }

    int size() {
        return size;
    }

    int id(int i) {
        return ids[i];
    }

    int pixels(int i) {
        return pixels[i];
    }

    /** Mean column of the pixels. */
    double x(int i) {
        return sums[4 * i] / pixels[i];
    }

    double y(int i) {
        return sums[4 * i + 1] / pixels[i];
    }

    /** Mean velocity, px/s. */
    double vx(int i) {
        return sums[4 * i + 2] / pixels[i];
    }

    double vy(int i) {
        return sums[4 * i + 3] / pixels[i];
    }
}
