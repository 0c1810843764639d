package io.github.sofas.event;

/**
 * A grey-level picture, taken by the intensity pixels that some event cameras have beside their event pixels. x runs
 * to the right and y down, as for events.
 *
 * @param timeUs time in µs, on the events' clock
 * @param width columns
 * @param height rows
 * @param levels brightness from 0, dark, to 255, as unsigned bytes, row by row; not to be changed
 */
public record GreyFrame(long timeUs, int width, int height, byte[] levels) {
    /**
     * Checks that the number of levels fits the size.
     *
     * @param timeUs time in µs, on the events' clock
     * @param width columns
     * @param height rows
     * @param levels brightness from 0, dark, to 255, as unsigned bytes, row by row; not to be changed
     * @throws IllegalArgumentException unless there is exactly one level for each pixel
     */
    public GreyFrame {
        if (levels.length != width * height) {
            throw new IllegalArgumentException("a frame of " + width + "x" + height + " must have " + width * height
                + " levels but had " + levels.length);
        }
    }

    /**
     * {@return the brightness of a pixel, 0 to 255}
     *
     * @param x column of the pixel, from 0 at the left
     * @param y row of the pixel, from 0 at the top
     */
    public int level(int x, int y) {
        return levels[y * width + x] & 0xFF;
    }
}
