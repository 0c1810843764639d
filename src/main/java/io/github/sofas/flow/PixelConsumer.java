package io.github.sofas.flow;

/** Takes pixels one by one. */
@FunctionalInterface
public interface PixelConsumer {
    /**
     * Takes a pixel of the sensor: x from 0 at the left, y from 0 at the top.
     *
     * @param x column of the pixel, from 0 at the left
     * @param y row of the pixel, from 0 at the top
     */
    void accept(int x, int y);
}
