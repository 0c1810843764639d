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

    /**
     * Adds a picture of which it is known where it may differ from the one before.
     *
     * @param picture not kept
     * @param mayDiffer of each block of 16 x 16 pixels, row by row, whether it may; all blocks of the first picture
     * @throws IOException where it cannot be written
     */
    default void add(BufferedImage picture, boolean[] mayDiffer) throws IOException {
        add(picture);
    }
}
