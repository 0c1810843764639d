package io.github.sofas.render;

import java.awt.image.BufferedImage;
import java.io.IOException;
import java.io.OutputStream;
import java.util.Locale;
import java.util.zip.ZipEntry;
import java.util.zip.ZipOutputStream;
import javax.imageio.ImageIO;

/** A ZIP file of PNG pictures, {@code 000001.png} and so on: one file, so that it is there whole or not at all. */
public final class PngFilm implements Film {
    private final ZipOutputStream zip;
    private int pictures;

    /**
     * Starts a film.
     *
     * @param file gets the ZIP; closed with the film
     */
    public PngFilm(OutputStream file) {
        zip = new ZipOutputStream(file);
        zip.setLevel(1); // the pictures are packed already
    }

    @Override
    public void add(BufferedImage picture) throws IOException {
        pictures++;
        zip.putNextEntry(new ZipEntry(String.format(Locale.ROOT, "%06d.png", pictures)));
        ImageIO.write(picture, "png", zip);
        zip.closeEntry();
    }

    @Override
    public void close() throws IOException {
        zip.close();
    }
}
