package io.github.sofas.render;

import java.awt.Rectangle;
import java.awt.image.BufferedImage;
import java.awt.image.DataBufferByte;
import java.awt.image.DataBufferInt;
import java.io.IOException;
import java.io.OutputStream;
import java.util.Arrays;
import javax.imageio.IIOImage;
import javax.imageio.ImageIO;
import javax.imageio.ImageTypeSpecifier;
import javax.imageio.ImageWriter;
import javax.imageio.metadata.IIOMetadata;
import javax.imageio.metadata.IIOMetadataNode;
import javax.imageio.stream.ImageOutputStream;

/**
 * An animated GIF that repeats for ever. Each picture has a palette of its own. Of every picture after the first, only
 * the part that differs from the picture before is written.
 */
public final class GifFilm implements Film {
    private static final String FORMAT = "javax_imageio_gif_image_1.0";

    private final ImageOutputStream out;
    private final ImageWriter writer = ImageIO.getImageWritersByFormatName("gif").next();
    private final int delay;
    private final GifColours colours = new GifColours();
    private int[] before;
    private boolean begun;

    /**
     * Starts a film.
     *
     * @param file receives the GIF; closed with the film
     * @param fps pictures per second; the film takes {@link #nearestFps} of this rate
     * @throws IOException if the GIF cannot be written
     */
    public GifFilm(OutputStream file, double fps) throws IOException {
        out = ImageIO.createImageOutputStream(file);
        writer.setOutput(out);
        delay = delay(fps);
    }

    /**
     * {@return the rate nearest to a wanted one that a GIF can have, in pictures per second; at most 50}
     *
     * @param fps wanted rate in pictures per second
     */
    public static double nearestFps(double fps) {
        return 100.0 / delay(fps);
    }

    /** Delay between pictures in hundredths of a second, at least 2: browsers replace smaller delays by 10. */
    private static int delay(double fps) {
        return (int) Math.min(65_535, Math.max(2, Math.round(100 / fps)));
    }

    @Override
    public void add(BufferedImage picture) throws IOException {
        int[] rgb = ((DataBufferInt) picture.getRaster().getDataBuffer()).getData();
        Rectangle part = begun ? changed(rgb, picture.getWidth(), picture.getHeight())
            : new Rectangle(picture.getWidth(), picture.getHeight());
        BufferedImage image = indexed(rgb, picture.getWidth(), part);
        IIOMetadata metadata = writer.getDefaultImageMetadata(new ImageTypeSpecifier(image), null);
        IIOMetadataNode root = (IIOMetadataNode) metadata.getAsTree(FORMAT);
        IIOMetadataNode place = (IIOMetadataNode) root.getElementsByTagName("ImageDescriptor").item(0);
        place.setAttribute("imageLeftPosition", Integer.toString(part.x));
        place.setAttribute("imageTopPosition", Integer.toString(part.y));
        IIOMetadataNode control = (IIOMetadataNode) root.getElementsByTagName("GraphicControlExtension").item(0);
        control.setAttribute("delayTime", Integer.toString(delay));
        control.setAttribute("disposalMethod", "doNotDispose");
        if (!begun) {
            before = rgb.clone();
            IIOMetadataNode all = new IIOMetadataNode("ApplicationExtensions");
            IIOMetadataNode loop = new IIOMetadataNode("ApplicationExtension");
            loop.setAttribute("applicationID", "NETSCAPE");
            loop.setAttribute("authenticationCode", "2.0");
            loop.setUserObject(new byte[] {1, 0, 0});
            all.appendChild(loop);
            root.appendChild(all);
            writer.prepareWriteSequence(null);
            begun = true;
        }
        metadata.setFromTree(FORMAT, root);
        writer.writeToSequence(new IIOImage(image, null, metadata), null);
        System.arraycopy(rgb, 0, before, 0, rgb.length);
    }

    /** The smallest rectangle that holds all differences from the picture before; one pixel if there are none. */
    private Rectangle changed(int[] rgb, int width, int height) {
        int top = 0;
        while (top < height - 1 && Arrays.equals(rgb, top * width, top * width + width, before, top * width,
                top * width + width)) {
            top++;
        }
        int left = width - 1;
        int right = 0;
        int bottom = top;
        for (int y = top; y < height; y++) {
            int first = Arrays.mismatch(rgb, y * width, y * width + width, before, y * width, y * width + width);
            if (first >= 0) {
                bottom = y;
                left = Math.min(left, first);
                int last = width - 1;
                while (last > right && rgb[y * width + last] == before[y * width + last]) {
                    last--;
                }
                right = Math.max(right, last);
            }
        }
        return new Rectangle(Math.min(left, right), top, Math.abs(right - left) + 1, bottom - top + 1);
    }

    /** A part of the picture with a palette of its own. Unchanged pixels are transparent, which compresses well. */
    private BufferedImage indexed(int[] rgb, int width, Rectangle part) {
        colours.clear();
        for (int y = part.y; y < part.y + part.height; y++) {
            for (int i = y * width + part.x; i < y * width + part.x + part.width; i++) {
                if (!begun || rgb[i] != before[i]) {
                    colours.count(rgb[i]);
                }
            }
        }
        BufferedImage image = new BufferedImage(part.width, part.height, BufferedImage.TYPE_BYTE_INDEXED,
            colours.choose());
        byte[] pixels = ((DataBufferByte) image.getRaster().getDataBuffer()).getData();
        for (int y = part.y, to = 0; y < part.y + part.height; y++) {
            for (int i = y * width + part.x; i < y * width + part.x + part.width; i++, to++) {
                pixels[to] = begun && rgb[i] == before[i] ? (byte) GifColours.TRANSPARENT : colours.index(rgb[i]);
            }
        }
        return image;
    }

    @Override
    public void close() throws IOException {
        if (begun) {
            writer.endWriteSequence();
        }
        out.close();
        writer.dispose();
    }
}
