package io.github.sofas.flow.smooth;

import io.github.sofas.event.SensorSize;
import io.github.sofas.flow.motion.PixelBox;
import java.util.Arrays;

/**
 * The picture of events that are moved to one time: the number of events on each pixel, whatever their polarity. Its
 * sharpness shows whether they were moved along their true motion (flow warp loss, Stoffregen et al. 2020).
 */
final class WarpedPicture {
    /**
     * Weights of the blur, of a standard deviation of one pixel: without it, a structure that slides along itself looks
     * sharper.
     */
    private static final int[] BLUR = {6, 4, 1};
    private static final int REACH = BLUR.length - 1;
    /** Room around the sensor, in px, for events that are moved off it, and for their blur. */
    private static final int BORDER = 8 + 2 * REACH;

    private final int width;
    private final int height;
    private final int[] counts;
    private final int[] rows;
    private final int[] line;
    /** Box around the pixels that have events. */
    private final PixelBox box = new PixelBox();

    WarpedPicture(SensorSize sensor) {
        width = sensor.width() + 2 * BORDER;
        height = sensor.height() + 2 * BORDER;
        counts = new int[width * height];
        rows = new int[width * height];
        line = new int[width];
    }

    /** Bytes of its arrays. */
    static long bytes(SensorSize sensor) {
        return Integer.BYTES * (sensor.width() + 2L * BORDER) * (2 * (sensor.height() + 2L * BORDER) + 1);
    }

    /** Forgets all events. */
    void clear() {
        for (int row = box.top; row <= box.bottom; row++) {
            Arrays.fill(counts, row * width + box.left, row * width + box.right + 1, 0);
        }
        box.clear();
    }

    /** Adds an event on the nearest pixel; an event that is moved off the sensor by more than 8 px is left out. */
    void add(double x, double y) {
        int column = (int) Math.floor(x + (BORDER + 0.5));
        int row = (int) Math.floor(y + (BORDER + 0.5));
        if (column >= 2 * REACH && column < width - 2 * REACH && row >= 2 * REACH && row < height - 2 * REACH) {
            counts[row * width + column]++;
            box.add(column, row);
        }
    }

    /**
     * How often the events meet: the sum of the squares of the blurred counts. For the same number of events, a sharper
     * picture has a greater sum.
     */
    double meetings() {
        if (box.events == 0) {
            return 0;
        }
        int left = box.left - REACH;
        int right = box.right + REACH;
        for (int row = box.top; row <= box.bottom; row++) {
            for (int k = row * width + left; k <= row * width + right; k++) {
                rows[k] = BLUR[0] * counts[k] + BLUR[1] * (counts[k - 1] + counts[k + 1])
                    + BLUR[2] * (counts[k - 2] + counts[k + 2]);
            }
        }
        double sum = 0;
        for (int row = box.top - REACH; row <= box.bottom + REACH; row++) {
            Arrays.fill(line, left, right + 1, 0);
            for (int from = Math.max(box.top, row - REACH); from <= Math.min(box.bottom, row + REACH); from++) {
                int weight = BLUR[Math.abs(from - row)];
                for (int column = left; column <= right; column++) {
                    line[column] += weight * rows[from * width + column];
                }
            }
            for (int column = left; column <= right; column++) {
                sum += (double) line[column] * line[column];
            }
        }
        return sum;
    }
}
