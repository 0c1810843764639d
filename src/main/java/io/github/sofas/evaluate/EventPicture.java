package io.github.sofas.evaluate;

import io.github.sofas.event.SensorSize;
import java.util.Arrays;

/**
 * A picture of event counts per pixel, whose variance measures its sharpness. An event counts for the nearest pixel,
 * whatever its polarity. An event that was moved out of the picture does not count.
 *
 * <p>Counts go to whole pixels, as the camera's own events do. Bilinear votes would blur the events that were moved,
 * but not the events that stay, and a correct velocity would look worse than none.
 */
final class EventPicture {
    /** Standard deviation of the blur, in px. Without blur, edges that slide along themselves would look sharper. */
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

    /** Adds an event at a position in px. Pixel (x, y) extends half a pixel to each side of the point (x, y). */
    void add(double x, double y) {
        int column = (int) Math.floor(x + 0.5);
        int line = (int) Math.floor(y + 0.5);
        if (column >= 0 && column < width && line >= 0 && line < height) {
            counts[line * width + column]++;
        }
    }

    /** Returns the number of events of each pixel, row by row, in the picture's own array. */
    float[] counts() {
        return counts;
    }

    /** Returns the variance of the blurred counts over all pixels. The blur takes 0 for counts beyond the border. */
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
