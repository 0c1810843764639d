package io.github.sofas.experiments;

/**
 * A drawing for a page that may be light or dark.
 *
 * @param light PNG for a light page
 * @param dark PNG for a dark page
 * @param width on the page in px; the images have twice as many
 * @param height on the page in px
 * @param alt what is to be seen, for those who cannot
 */
record Picture(byte[] light, byte[] dark, int width, int height, String alt) {
}
