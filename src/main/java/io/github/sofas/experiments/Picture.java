package io.github.sofas.experiments;

/**
 * A drawing for a page that may be light or dark.
 *
 * @param light PNG for a light page
 * @param dark PNG for a dark page
 * @param width width on the page in px; the images have twice as many pixels
 * @param height height on the page in px
 * @param alt description of the picture, for those who cannot see it
 */
record Picture(byte[] light, byte[] dark, int width, int height, String alt) {
}
