package io.github.sofas.evaluate;

import io.github.sofas.event.SensorSize;
import java.util.Arrays;

/**
 * How many events each pixel got, as a picture whose sharpness can be measured. An event counts for the pixel that it
 * is nearest to, whatever its polarity; one that was moved out of the picture is not seen.
 *
 * <p>Counts go to whole pixels because the camera's own events do. Shared among four pixels, moved events would be
 * blurred where those that stay are not, and a right velocity would look worse than none.
 */
final class EventPicture {
    /** Standard deviation of the blur, in px. Without a blur, edges that slide along themselves look sharper. */
    static final double BLUR_SD_PX = 1;

    private static final int BLUR_RADIUS = 4;

    private final int width;
    private final int height;
    private final float[] counts;
    private final float[] blurredRows;
    private final float[] row;
    private final float[] kernel = new float[BLUR_RADIUS + 1];

    EventPicture(SensorSize sensor) {
        width = sensor.width();
        height = sensor.height();
        counts = new float[width * height];
        blurredRows = new float[width * height];
        row = new float[width + 2 * BLUR_RADIUS];
        double sum = 0;
        for (int i = -BLUR_RADIUS; i <= BLUR_RADIUS; i++) {
            sum += gaussian(i);
        }
        for (int i = 0; i <= BLUR_RADIUS; i++) {
            kernel[i] = (float) (gaussian(i) / sum);
        }
    }

    private static double gaussian(int px) {
        return StrictMath.exp(-px * px / (2 * BLUR_SD_PX * BLUR_SD_PX));
    }

    void clear() {
        Arrays.fill(counts, 0);
    }

    /** Adds an event at a place in px; pixel (x, y) reaches half a pixel to each side of that point. */
    void add(double x, double y) {
        int column = (int) Math.floor(x + 0.5);
        int line = (int) Math.floor(y + 0.5);
        if (column >= 0 && column < width && line >= 0 && line < height) {
            counts[line * width + column]++;
        }
    }

    /** Events of each pixel, row by row; the picture's own array. */
    float[] counts() {
        return counts;
    }

    /** Variance of the blurred counts over all pixels. Nothing is outside the picture. */
    double variance() {
        blurRows();
        double sum = 0;
        double squares = 0;
        for (int y = 0; y < height; y++) {
            Arrays.fill(row, 0, width, 0);
            int first = Math.max(0, y - BLUR_RADIUS);
            int last = Math.min(height - 1, y + BLUR_RADIUS);
            for (int from = first; from <= last; from++) {
                float weight = kernel[Math.abs(from - y)];
                int start = from * width;
                for (int x = 0; x < width; x++) {
                    row[x] += weight * blurredRows[start + x];
                }
            }
            for (int x = 0; x < width; x++) {
                double value = row[x];
                sum += value;
                squares += value * value;
            }
        }
        double mean = sum / counts.length;
        return Math.max(0, squares / counts.length - mean * mean);
    }

    private void blurRows() {
        Arrays.fill(row, 0);
        for (int y = 0; y < height; y++) {
            int start = y * width;
            System.arraycopy(counts, start, row, BLUR_RADIUS, width);
            for (int x = 0; x < width; x++) {
                blurredRows[start + x] = kernel[0] * row[x + BLUR_RADIUS];
            }
            for (int away = 1; away <= BLUR_RADIUS; away++) {
                float weight = kernel[away];
                for (int x = 0; x < width; x++) {
                    blurredRows[start + x] += weight * (row[x + BLUR_RADIUS - away] + row[x + BLUR_RADIUS + away]);
                }
            }
        }
        Arrays.fill(row, 0);
    }
}
