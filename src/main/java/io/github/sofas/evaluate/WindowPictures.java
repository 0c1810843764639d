package io.github.sofas.evaluate;

/**
 * Two pictures of a window's events: the number of events of each pixel, row by row. Callers must not change the
 * arrays.
 *
 * @param window the window
 * @param before picture of the events where they occurred
 * @param after picture of the events, each moved along its flow to the window's middle
 */
public record WindowPictures(SharpnessWindow window, float[] before, float[] after) {
}
