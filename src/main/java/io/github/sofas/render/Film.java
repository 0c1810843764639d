package io.github.sofas.render;

import java.awt.image.BufferedImage;
import java.io.Closeable;
import java.io.IOException;

/** A sequence of pictures, written to one file. Closing the film completes the file. */
public interface Film extends Closeable {
    /**
     * Adds a picture.
     *
     * @param picture of the same size as the first one, with packed RGB ({@link BufferedImage#TYPE_INT_RGB}); not kept
     * @throws IOException if the picture cannot be written
     */
    void add(BufferedImage picture) throws IOException;
}
