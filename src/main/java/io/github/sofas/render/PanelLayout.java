package io.github.sofas.render;

import io.github.sofas.event.SensorSize;
import java.awt.Rectangle;

/**
 * The places of the panels on a picture, in screen pixels: two panels per row, each with its title above and its legend
 * below.
 */
final class PanelLayout {
    static final int MARGIN = 8;
    static final int LEGEND = 64;
    /** Distance from a panel up to the baseline of its title. */
    static final int BASELINE = 7;
    private static final int TITLE = 24;
    private static final int LEAST_WIDTH = 480;
    /** Block of video codecs: they take pictures of whole blocks of 16 x 16 pixels. */
    private static final int BLOCK = 16;
    /**
     * Most pixels of a picture: those of level 5.1 of H.264, which players decode. These are 36,864 blocks, such as
     * 4096 x 2304.
     */
    private static final int MOST_PIXELS = 36_864 * BLOCK * BLOCK;

    private final PictureOptions.Crop crop;
    private final int scale;
    private final int width;
    private final int height;

    /**
     * Lays out the panels for a sensor.
     *
     * @throws IllegalArgumentException if the crop is not on the sensor, or if a picture would have too many pixels
     */
    PanelLayout(SensorSize sensor, PictureOptions options) {
        crop = options.crop() != null ? options.crop()
            : new PictureOptions.Crop(0, 0, sensor.width(), sensor.height());
        if (crop.width() < 1 || crop.height() < 1 || !sensor.contains(crop.x(), crop.y())
                || !sensor.contains(crop.x() + crop.width() - 1, crop.y() + crop.height() - 1)) {
            throw new IllegalArgumentException("crop must lie on the sensor of " + sensor + " but was "
                + crop.x() + "," + crop.y() + "," + crop.width() + "," + crop.height());
        }
        scale = options.scale() > 0 ? options.scale() : (LEAST_WIDTH + crop.width() - 1) / crop.width();
        int columns = Math.min(2, options.panels().size());
        int rows = (options.panels().size() + 1) / 2;
        width = blocks(columns * (panelWidth() + MARGIN) + MARGIN);
        height = blocks(rows * (TITLE + panelHeight() + LEGEND));
        if ((long) width * height > MOST_PIXELS) {
            throw new IllegalArgumentException("a picture must have at most " + MOST_PIXELS + " pixels but would be "
                + width + "x" + height + ": take a smaller scale or fewer panels");
        }
    }

    private static int blocks(int size) {
        return (size + BLOCK - 1) / BLOCK * BLOCK;
    }

    /** The part of the sensor that is shown. */
    PictureOptions.Crop crop() {
        return crop;
    }

    /** Screen pixels per pixel of the sensor. */
    int scale() {
        return scale;
    }

    /** Width of the picture. */
    int width() {
        return width;
    }

    int height() {
        return height;
    }

    int panelWidth() {
        return crop.width() * scale;
    }

    int panelHeight() {
        return crop.height() * scale;
    }

    /** Left side of a panel. */
    int left(int panel) {
        return MARGIN + panel % 2 * (panelWidth() + MARGIN);
    }

    int top(int panel) {
        return TITLE + panel / 2 * (TITLE + panelHeight() + LEGEND);
    }

    Rectangle panel(int panel) {
        return new Rectangle(left(panel), top(panel), panelWidth(), panelHeight());
    }

    /** Index of a panel's top left pixel among the pixels of the picture. */
    int corner(int panel) {
        return top(panel) * width + left(panel);
    }

    /** Whether a pixel of the sensor is shown. */
    boolean shows(int x, int y) {
        return x >= crop.x() && x < crop.x() + crop.width() && y >= crop.y() && y < crop.y() + crop.height();
    }

    /** Offset from a panel's top left pixel to that of a pixel of the sensor, which must be shown. */
    int within(int x, int y) {
        return ((y - crop.y()) * width + x - crop.x()) * scale;
    }

    /** Length of an arrow for the speed of the full colour. */
    double barLength() {
        return Math.min(100, panelWidth() / 4.0);
    }
}
