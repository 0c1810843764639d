package io.github.sofas.render;

import java.awt.image.BufferedImage;
import java.awt.image.DataBufferInt;
import java.io.IOException;
import java.io.OutputStream;
import java.nio.ByteBuffer;
import java.nio.charset.StandardCharsets;
import java.util.Locale;
import java.util.zip.CRC32;
import java.util.zip.Deflater;
import java.util.zip.ZipEntry;
import java.util.zip.ZipOutputStream;

/**
 * A ZIP file of PNG pictures, {@code 000001.png} and so on: one file, so that it is there whole or not at all.
 *
 * <p>Rows are packed as they are. Java's own writer tries five filters on each, which photographs need and flat colours
 * do not, and takes several times as long.
 */
public final class PngFilm implements Film {
    private static final byte[] SIGNATURE = {(byte) 0x89, 'P', 'N', 'G', '\r', '\n', 0x1A, '\n'};
    private static final int BIT_DEPTH = 8;
    private static final int TRUE_COLOUR = 2;
    /** Length, type and checksum. */
    private static final int CHUNK_BYTES = 12;

    private final ZipOutputStream zip;
    private final Deflater deflater = new Deflater(Deflater.BEST_SPEED);
    private byte[] rows = new byte[0];
    private ByteBuffer png = ByteBuffer.allocate(0);
    private int pictures;

    /**
     * Starts a film.
     *
     * @param file gets the ZIP; closed with the film
     */
    public PngFilm(OutputStream file) {
        zip = new ZipOutputStream(file);
        // the pictures are packed already
        zip.setMethod(ZipOutputStream.STORED);
    }

    @Override
    public void add(BufferedImage picture) throws IOException {
        pictures++;
        encode(picture);
        CRC32 crc = new CRC32();
        crc.update(png.array(), 0, png.position());
        ZipEntry entry = new ZipEntry(String.format(Locale.ROOT, "%06d.png", pictures));
        entry.setSize(png.position());
        entry.setCrc(crc.getValue());
        zip.putNextEntry(entry);
        zip.write(png.array(), 0, png.position());
        zip.closeEntry();
    }

    private void encode(BufferedImage picture) {
        int width = picture.getWidth();
        int height = picture.getHeight();
        int rowBytes = 1 + 3 * width;
        if (rows.length != rowBytes * height) {
            rows = new byte[rowBytes * height];
            // deflate adds five bytes a block of 16 KB at most, where nothing can be packed
            png = ByteBuffer.allocate(rows.length + rows.length / 1000 + 1024);
        }
        int[] rgb = ((DataBufferInt) picture.getRaster().getDataBuffer()).getData();
        for (int y = 0, from = 0; y < height; y++) {
            // the first byte stays 0: no filter
            for (int x = 0, to = y * rowBytes + 1; x < width; x++, to += 3) {
                int pixel = rgb[from++];
                rows[to] = (byte) (pixel >> 16);
                rows[to + 1] = (byte) (pixel >> 8);
                rows[to + 2] = (byte) pixel;
            }
        }
        png.clear();
        png.put(SIGNATURE);
        int header = begin("IHDR");
        png.putInt(width).putInt(height).put((byte) BIT_DEPTH).put((byte) TRUE_COLOUR).put(new byte[3]);
        end(header);
        int data = begin("IDAT");
        deflater.reset();
        deflater.setInput(rows);
        deflater.finish();
        while (!deflater.finished()) {
            png.position(png.position() + deflater.deflate(png.array(), png.position(),
                png.remaining() - 2 * CHUNK_BYTES));
        }
        end(data);
        end(begin("IEND"));
    }

    /** The place of the chunk's length. */
    private int begin(String type) {
        int place = png.position();
        png.putInt(0).put(type.getBytes(StandardCharsets.US_ASCII));
        return place;
    }

    private void end(int place) {
        png.putInt(place, png.position() - place - 8);
        CRC32 crc = new CRC32();
        crc.update(png.array(), place + 4, png.position() - place - 4);
        png.putInt((int) crc.getValue());
    }

    @Override
    public void close() throws IOException {
        deflater.end();
        zip.close();
    }
}
