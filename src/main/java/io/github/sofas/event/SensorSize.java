package io.github.sofas.event;

/**
 * Size of the pixel array of a sensor.
 *
 * @param width columns, 1 to {@value #MAX_WIDTH}
 * @param height rows, 1 to {@value #MAX_HEIGHT}
 */
public record SensorSize(int width, int height) {
    /** Columns of the largest sensor that is supported. */
    public static final int MAX_WIDTH = 1280;
    /** Rows of the largest sensor that is supported. */
    public static final int MAX_HEIGHT = 720;

    /**
     * Checks that both sides are in range.
     *
     * @param width columns, 1 to {@value #MAX_WIDTH}
     * @param height rows, 1 to {@value #MAX_HEIGHT}
     * @throws IllegalArgumentException if a side is outside its range
     */
    public SensorSize {
        if (width < 1 || width > MAX_WIDTH) {
            throw new IllegalArgumentException("sensor width must be between 1 and " + MAX_WIDTH + " but was " + width);
        }
        if (height < 1 || height > MAX_HEIGHT) {
            throw new IllegalArgumentException(
                "sensor height must be between 1 and " + MAX_HEIGHT + " but was " + height);
        }
    }

    /**
     * {@return whether a pixel lies on the sensor}
     *
     * @param x column of the pixel, from 0 at the left
     * @param y row of the pixel, from 0 at the top
     */
    public boolean contains(int x, int y) {
        return x >= 0 && x < width && y >= 0 && y < height;
    }

    /**
     * {@return the rule that a pixel breaks, with the value found, worded for messages; null if it lies on the sensor}
     *
     * @param x column of the pixel, from 0 at the left
     * @param y row of the pixel, from 0 at the top
     */
    public String brokenRule(int x, int y) {
        if (x < 0 || y < 0) {
            return x < 0 ? "x must not be negative but was " + x : "y must not be negative but was " + y;
        }
        if (x >= width) {
            return "x must be smaller than width " + width + " but was " + x;
        }
        return y < height ? null : "y must be smaller than height " + height + " but was " + y;
    }

    @Override
    public String toString() {
        return width + "x" + height;
    }
}
