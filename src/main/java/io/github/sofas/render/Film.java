package io.github.sofas.render;

import java.awt.image.BufferedImage;
import java.io.Closeable;
import java.io.IOException;

/** Pictures that follow each other, as one file or several. Closed when complete. */
public interface Film extends Closeable {
    /**
     * Adds a picture, of the size of the first one.
     *
     * @param picture not kept
     * @throws IOException where it cannot be written
     */
    void add(BufferedImage picture) throws IOException;
}
