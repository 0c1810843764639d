package io.github.sofas.render;

import java.awt.image.BufferedImage;
import java.io.IOException;
import java.io.OutputStream;
import javax.imageio.IIOImage;
import javax.imageio.ImageIO;
import javax.imageio.ImageTypeSpecifier;
import javax.imageio.ImageWriter;
import javax.imageio.metadata.IIOMetadata;
import javax.imageio.metadata.IIOMetadataNode;
import javax.imageio.stream.ImageOutputStream;

/** An animated GIF that repeats for ever. */
public final class GifFilm implements Film {
    private static final String FORMAT = "javax_imageio_gif_image_1.0";

    private final ImageOutputStream out;
    private final ImageWriter writer = ImageIO.getImageWritersByFormatName("gif").next();
    private final int delay;
    private boolean begun;

    /**
     * Starts a film.
     *
     * @param file gets the GIF; closed with the film
     * @param fps pictures a second; GIF counts hundredths of a second, so that the nearest possible is taken
     * @throws IOException where it cannot be written
     */
    public GifFilm(OutputStream file, double fps) throws IOException {
        out = ImageIO.createImageOutputStream(file);
        writer.setOutput(out);
        // browsers take a delay below 2 for 10
        delay = (int) Math.max(2, Math.round(100 / fps));
    }

    @Override
    public void add(BufferedImage picture) throws IOException {
        IIOMetadata metadata = writer.getDefaultImageMetadata(ImageTypeSpecifier.createFromRenderedImage(picture),
            null);
        IIOMetadataNode root = (IIOMetadataNode) metadata.getAsTree(FORMAT);
        IIOMetadataNode control = (IIOMetadataNode) root.getElementsByTagName("GraphicControlExtension").item(0);
        control.setAttribute("delayTime", Integer.toString(delay));
        control.setAttribute("disposalMethod", "none");
        if (!begun) {
            begun = true;
            IIOMetadataNode all = new IIOMetadataNode("ApplicationExtensions");
            IIOMetadataNode loop = new IIOMetadataNode("ApplicationExtension");
            loop.setAttribute("applicationID", "NETSCAPE");
            loop.setAttribute("authenticationCode", "2.0");
            loop.setUserObject(new byte[] {1, 0, 0});
            all.appendChild(loop);
            root.appendChild(all);
            writer.prepareWriteSequence(null);
        }
        metadata.setFromTree(FORMAT, root);
        writer.writeToSequence(new IIOImage(picture, null, metadata), null);
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
