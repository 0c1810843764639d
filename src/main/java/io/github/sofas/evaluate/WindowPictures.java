package io.github.sofas.evaluate;

/**
 * A window's events as two pictures: how many each pixel has, row by row. The arrays are not to be changed.
 *
 * @param window which
 * @param before the events where they were
 * @param after each event moved along its flow to the window's middle
 */
public record WindowPictures(SharpnessWindow window, float[] before, float[] after) {
}
