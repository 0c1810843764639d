package io.github.sofas.render;

import static org.junit.Assert.assertArrayEquals;
import static org.junit.Assert.assertEquals;
import static org.junit.Assert.assertThrows;

import io.github.sofas.Skipped;
import java.awt.image.BufferedImage;
import java.io.ByteArrayInputStream;
import java.io.ByteArrayOutputStream;
import java.io.File;
import java.io.IOException;
import java.nio.charset.StandardCharsets;
import java.nio.file.Files;
import java.nio.file.Path;
import java.time.LocalDateTime;
import java.util.List;
import java.util.Random;
import java.util.zip.ZipInputStream;
import javax.imageio.ImageIO;
import javax.imageio.ImageReader;
import javax.imageio.metadata.IIOMetadataNode;
import org.jcodec.api.FrameGrab;
import org.jcodec.api.JCodecException;
import org.jcodec.common.io.NIOUtils;
import org.jcodec.common.model.Picture;
import org.junit.Rule;
import org.junit.Test;
import org.junit.rules.TemporaryFolder;

/** Three pictures of 64 x 32 px, black, white and orange, come back from every kind of film. */
public class FilmTest {
    private static final int[] COLOURS = {0x000000, 0xFFFFFF, 0xE69F00};

    @Rule
    public final TemporaryFolder folder = new TemporaryFolder();

    private static void shoot(Film film) throws IOException {
        for (int colour : COLOURS) {
            BufferedImage picture = new BufferedImage(64, 32, BufferedImage.TYPE_INT_RGB);
            for (int i = 0; i < 64 * 32; i++) {
                picture.setRGB(i % 64, i / 64, colour);
            }
            film.add(picture);
        }
        film.close();
    }

    private static Film jcodec(File file) throws IOException {
        return new Mp4Film(file.toPath(), 25, Mp4Film.Encoder.JCODEC);
    }

    /** The same pictures are the same bytes, whenever the film is made: no header holds the time. */
    @Test
    public void mp4HoldsNoDate() throws IOException {
        File file = folder.newFile("undated.mp4");
        shoot(jcodec(file));
        String bytes = new String(Files.readAllBytes(file.toPath()), StandardCharsets.ISO_8859_1);
        for (String header : List.of("mvhd", "tkhd", "mdhd")) {
            // after its name a header has version and flags, then when the film was made and when it was changed
            int dates = bytes.indexOf(header) + 8;
            assertEquals(header, "\0".repeat(8), bytes.substring(dates, dates + 8));
        }
    }

    @Test
    public void gifHoldsThePictures() throws IOException {
        ByteArrayOutputStream bytes = new ByteArrayOutputStream();
        shoot(new GifFilm(bytes, 20));
        ImageReader reader = ImageIO.getImageReadersByFormatName("gif").next();
        reader.setInput(ImageIO.createImageInputStream(new ByteArrayInputStream(bytes.toByteArray())));
        assertEquals(3, reader.getNumImages(true));
        for (int i = 0; i < 3; i++) {
            assertEquals(COLOURS[i], reader.read(i).getRGB(30, 15) & 0xFFFFFF);
        }
    }

    /** Dots of 300 colours, more than one palette holds, come and go on a ground that stays. */
    @Test
    public void gifPicturesAddUpWithColoursOfTheirOwn() throws IOException {
        ByteArrayOutputStream bytes = new ByteArrayOutputStream();
        BufferedImage picture = new BufferedImage(64, 32, BufferedImage.TYPE_INT_RGB);
        try (Film film = new GifFilm(bytes, 20)) {
            for (int k = 0; k < 5; k++) {
                paintDots(picture, k);
                film.add(picture);
            }
            film.add(picture);
        }
        ImageReader reader = ImageIO.getImageReadersByFormatName("gif").next();
        reader.setInput(ImageIO.createImageInputStream(new ByteArrayInputStream(bytes.toByteArray())));
        assertEquals(6, reader.getNumImages(true));
        BufferedImage shown = new BufferedImage(64, 32, BufferedImage.TYPE_INT_RGB);
        for (int k = 0; k < 6; k++) {
            IIOMetadataNode root = (IIOMetadataNode) reader.getImageMetadata(k)
                .getAsTree("javax_imageio_gif_image_1.0");
            IIOMetadataNode place = (IIOMetadataNode) root.getElementsByTagName("ImageDescriptor").item(0);
            shown.createGraphics().drawImage(reader.read(k), Integer.parseInt(place.getAttribute("imageLeftPosition")),
                Integer.parseInt(place.getAttribute("imageTopPosition")), null);
            paintDots(picture, Math.min(k, 4));
            for (int i = 0; i < 64 * 32; i++) {
                for (int shift = 0; shift <= 16; shift += 8) {
                    assertEquals("picture " + k + " pixel " + i, picture.getRGB(i % 64, i / 64) >> shift & 0xFF,
                        shown.getRGB(i % 64, i / 64) >> shift & 0xFF, 16);
                }
            }
        }
    }

    private static void paintDots(BufferedImage picture, int k) {
        for (int i = 0; i < 64 * 32; i++) {
            picture.setRGB(i % 64, i / 64, i % 64 < 32 ? 0x15181C : 0xE6E8EA);
        }
        for (int i = 0; i < 60; i++) {
            int n = 60 * k + i;
            picture.setRGB(5 + k + i % 30, 3 * k + i / 30, n * 7 % 256 << 16 | n * 37 % 256 << 8 | n * 11 % 256);
        }
    }

    /** Nor does a ZIP hold when it was made: an entry's time has a step of 2 s. */
    @Test
    public void zipHoldsNoDate() throws IOException {
        ByteArrayOutputStream bytes = new ByteArrayOutputStream();
        shoot(new PngFilm(bytes));
        ZipInputStream zip = new ZipInputStream(new ByteArrayInputStream(bytes.toByteArray()));
        assertEquals(LocalDateTime.of(1980, 1, 1, 0, 0), zip.getNextEntry().getTimeLocal());
    }

    @Test
    public void zipHoldsNumberedPictures() throws IOException {
        ByteArrayOutputStream bytes = new ByteArrayOutputStream();
        shoot(new PngFilm(bytes));
        ZipInputStream zip = new ZipInputStream(new ByteArrayInputStream(bytes.toByteArray()));
        for (int i = 0; i < 3; i++) {
            assertEquals("00000" + (i + 1) + ".png", zip.getNextEntry().getName());
            assertEquals(COLOURS[i], ImageIO.read(zip).getRGB(30, 15) & 0xFFFFFF);
        }
    }

    /** Dots change over a ground of two shades; a player that has seen 40 pictures still sees both as they are. */
    @Test
    public void whatStandsStillInAnMp4KeepsItsColour() throws IOException, JCodecException {
        File file = folder.newFile("film.mp4");
        BufferedImage picture = new BufferedImage(64, 64, BufferedImage.TYPE_INT_RGB);
        try (Film film = jcodec(file)) {
            Random random = new Random(1);
            for (int k = 0; k < 40; k++) {
                for (int i = 0; i < 64 * 64; i++) {
                    int ground = i % 64 < 32 ? 0x101418 : 0xE6E8EA;
                    picture.setRGB(i % 64, i / 64, i / 64 < 32 && random.nextInt(8) == 0 ? 0xE69F00 : ground);
                }
                film.add(picture);
            }
        }
        FrameGrab grab = FrameGrab.createFrameGrab(NIOUtils.readableChannel(file));
        Picture last = null;
        for (int k = 0; k < 40; k++) {
            last = grab.getNativeFrame();
        }
        int[] luma = {16 + 4 + 10 + 2 - 128, 16 + 59 + 117 + 23 - 128};
        for (int i = 32 * 64; i < 64 * 64; i++) {
            assertEquals("still", luma[i % 64 / 32], last.getPlaneData(0)[i], 6);
        }
        for (int i = 0; i < 32 * 64; i++) {
            int rgb = picture.getRGB(i % 64, i / 64);
            double expected = 16 + 0.257 * (rgb >> 16 & 0xFF) + 0.504 * (rgb >> 8 & 0xFF) + 0.098 * (rgb & 0xFF) - 128;
            assertEquals("dots", expected, last.getPlaneData(0)[i], 25);
        }
    }

    /** Dots jump over a ground of one colour, which is also that of the margin on the right. */
    @Test
    public void dotsThatGoLeaveNothingInAnMp4() throws IOException, JCodecException {
        File file = folder.newFile("film.mp4");
        int ground = 0x202428;
        BufferedImage picture = new BufferedImage(96, 64, BufferedImage.TYPE_INT_RGB);
        Random random = new Random(3);
        try (Film film = jcodec(file)) {
            for (int k = 0; k < 20; k++) {
                for (int i = 0; i < 96 * 64; i++) {
                    picture.setRGB(i % 96, i / 96, ground);
                }
                for (int dot = 0; dot < 60 && k < 19; dot++) {
                    picture.setRGB(random.nextInt(88), random.nextInt(64), 0xE69F00);
                }
                film.add(picture);
            }
        }
        FrameGrab grab = FrameGrab.createFrameGrab(NIOUtils.readableChannel(file));
        Picture last = null;
        for (int k = 0; k < 20; k++) {
            last = grab.getNativeFrame();
        }
        // 16 + 0.257 * 32 + 0.504 * 36 + 0.098 * 40; colours 128 - 1 and 128 + 1, all less by 128; jcodec's colours
        // are up to 4 levels off where dots were, however many pictures follow
        for (int i = 0; i < 96 * 64; i++) {
            assertEquals("pixel " + i, 16 + 8 + 18 + 4 - 128, last.getPlaneData(0)[i], 3);
        }
        for (int i = 0; i < 48 * 32; i++) {
            assertEquals(1, last.getPlaneData(1)[i], 5);
            assertEquals(-1, last.getPlaneData(2)[i], 5);
        }
    }

    /** Shades, a flat ground and noise, each in both halves of the picture. */
    @Test
    public void theFirstPictureOfAnMp4IsNearlyAsItWas() throws IOException, JCodecException {
        File file = folder.newFile("film.mp4");
        BufferedImage picture = new BufferedImage(96, 64, BufferedImage.TYPE_INT_RGB);
        Random random = new Random(7);
        for (int i = 0; i < 96 * 64; i++) {
            int x = i % 96;
            int y = i / 96;
            int colour = x < 32 ? 2 * x << 16 | 3 * y << 8 | 0x80 : x < 64 ? 0xE69F00 : random.nextInt(1 << 24);
            // two pixels by two, as many as share a colour
            picture.setRGB(x, y, x % 2 == 0 && y % 2 == 0 ? colour : picture.getRGB(x / 2 * 2, y / 2 * 2));
        }
        try (Film film = jcodec(file)) {
            film.add(picture);
        }
        Picture seen = FrameGrab.createFrameGrab(NIOUtils.readableChannel(file)).getNativeFrame();
        for (int i = 0; i < 48 * 32; i++) {
            int rgb = picture.getRGB(i % 48 * 2, i / 48 * 2);
            int r = rgb >> 16 & 0xFF;
            int g = rgb >> 8 & 0xFF;
            int b = rgb & 0xFF;
            assertEquals("brightness " + i, 16 + 0.257 * r + 0.504 * g + 0.098 * b - 128,
                seen.getPlaneData(0)[i / 48 * 2 * 96 + i % 48 * 2], 5);
            assertEquals("blue " + i, -0.148 * r - 0.291 * g + 0.439 * b, seen.getPlaneData(1)[i], 5);
            assertEquals("red " + i, 0.439 * r - 0.368 * g - 0.071 * b, seen.getPlaneData(2)[i], 5);
        }
    }

    @Test
    public void mp4HoldsThePictures() throws IOException, JCodecException {
        File file = folder.newFile("film.mp4");
        shoot(jcodec(file));
        assertHoldsThePictures(file);
    }

    @Test
    public void mp4OfFfmpegHoldsThePicturesInTheSameBytesEachTime() throws IOException, JCodecException {
        if (Ffmpeg.onPath() == null) {
            throw Skipped.because("there is no ffmpeg with an H.264 encoder on PATH");
        }
        File file = folder.newFile("film.mp4");
        File again = folder.newFile("again.mp4");
        shoot(new Mp4Film(file.toPath(), 25, Mp4Film.Encoder.FFMPEG));
        shoot(new Mp4Film(again.toPath(), 25, Mp4Film.Encoder.AUTO));
        assertHoldsThePictures(file);
        assertArrayEquals(Files.readAllBytes(file.toPath()), Files.readAllBytes(again.toPath()));
    }

    /** A program of that name which takes no picture: the film fails with what the program said. */
    @Test
    public void ffmpegThatFailsIsSaidToHaveFailed() throws IOException {
        Path program = folder.newFile("ffmpeg").toPath();
        Files.writeString(program, "#!/bin/sh\necho 'no space left' >&2\nexit 3\n");
        if (!program.toFile().setExecutable(true) || !Files.isExecutable(Path.of("/bin/sh"))) {
            throw Skipped.because("there is no /bin/sh");
        }
        Film film = new Ffmpeg(program, List.of("libx264")).film(folder.newFile("film.mp4").toPath(), 25, 64, 32);
        IOException fault = assertThrows(IOException.class, () -> shoot(film));
        assertEquals("ffmpeg ended with 3: no space left", fault.getMessage());
    }

    private static void assertHoldsThePictures(File file) throws IOException, JCodecException {
        FrameGrab grab = FrameGrab.createFrameGrab(NIOUtils.readableChannel(file));
        assertEquals(3, grab.getVideoTrack().getMeta().getTotalFrames());
        assertEquals(3 / 25.0, grab.getVideoTrack().getMeta().getTotalDuration(), 1e-6);
        // brightness as BT.601 has it for video: 16 + 0.257 R + 0.504 G + 0.098 B, here less by 128
        int[] luma = {16 - 128, 235 - 128, 16 + 59 + 80 - 128};
        for (int i = 0; i < 3; i++) {
            Picture picture = grab.getNativeFrame();
            assertEquals("picture " + i, luma[i], picture.getPlaneData(0)[15 * 64 + 30], 3);
        }
    }
}
