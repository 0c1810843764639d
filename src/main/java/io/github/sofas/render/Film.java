package io.github.sofas.render;

import java.awt.image.BufferedImage;
import java.io.Closeable;
import java.io.IOException;

/** Pictures that follow each other, as one file. Closed when complete. */
public interface Film extends Closeable {
    /**
     * Adds a picture.
     *
     * @param picture of the size of the first one, with packed RGB ({@link BufferedImage#TYPE_INT_RGB}); not kept
     * @throws IOException where it cannot be written
     */
    void add(BufferedImage picture) throws IOException;
}
