package io.github.sofas.render;

import java.awt.image.BufferedImage;
import java.io.ByteArrayOutputStream;
import java.io.IOException;
import java.io.OutputStream;
import java.time.LocalDateTime;
import java.util.Locale;
import java.util.zip.Deflater;
import java.util.zip.ZipEntry;
import java.util.zip.ZipOutputStream;
import javax.imageio.ImageIO;
import javax.imageio.stream.ImageOutputStream;
import javax.imageio.stream.MemoryCacheImageOutputStream;

/**
 * A ZIP file of PNG pictures, {@code 000001.png} and so on. The pictures are in one file, so that they are there as a
 * whole or not at all.
 */
public final class PngFilm implements Film {
    /**
     * Date of all pictures: the earliest that a ZIP can have. With real dates, the same pictures would not give the
     * same bytes.
     */
    private static final LocalDateTime NO_DATE = LocalDateTime.of(1980, 1, 1, 0, 0);

    private final ZipOutputStream zip;
    private final ByteArrayOutputStream png = new ByteArrayOutputStream();
    private int pictures;

    /**
     * Starts a film.
     *
     * @param file receives the ZIP; closed with the film
     */
    public PngFilm(OutputStream file) {
        zip = new ZipOutputStream(file);
        // the pictures are already compressed
        zip.setLevel(Deflater.NO_COMPRESSION);
    }

    @Override
    public void add(BufferedImage picture) throws IOException {
        pictures++;
        png.reset();
        try (ImageOutputStream out = new MemoryCacheImageOutputStream(png)) {
            ImageIO.write(picture, "png", out);
        }
        ZipEntry entry = new ZipEntry(String.format(Locale.ROOT, "%06d.png", pictures));
        entry.setTimeLocal(NO_DATE);
        zip.putNextEntry(entry);
        png.writeTo(zip);
        zip.closeEntry();
    }

    @Override
    public void close() throws IOException {
        zip.close();
    }
}
