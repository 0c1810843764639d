package io.github.sofas.render;

import java.awt.image.BufferedImage;
import java.awt.image.DataBufferInt;
import java.io.IOException;
import java.nio.ByteBuffer;
import java.nio.file.Path;
import java.util.Arrays;
import org.jcodec.common.Codec;
import org.jcodec.common.MuxerTrack;
import org.jcodec.common.VideoCodecMeta;
import org.jcodec.common.io.NIOUtils;
import org.jcodec.common.io.SeekableByteChannel;
import org.jcodec.common.model.ColorSpace;
import org.jcodec.common.model.Packet;
import org.jcodec.common.model.Packet.FrameType;
import org.jcodec.common.model.Picture;
import org.jcodec.common.model.Size;
import org.jcodec.containers.mp4.Brand;
import org.jcodec.containers.mp4.muxer.MP4Muxer;

/** An MP4 file with H.264 video (baseline), which browsers and players show without further software. */
public final class Mp4Film implements Film {
    /** Ticks a second of the film's clock: whole numbers of them for all usual rates. */
    private static final int TIMESCALE = 90_000;
    /** Brightness and colour as jcodec holds them: less by 128. */
    private static final int BIAS = 128;
    /** Pixels in a row that are converted together; as many as a block of the video is wide. */
    private static final int STRIP = 16;

    private final SeekableByteChannel channel;
    private final MP4Muxer muxer;
    private final int ticks;
    private FilmEncoder encoder;
    private MuxerTrack track;
    private Picture converted;
    private int[] before;
    private boolean[] changed;
    private ByteBuffer buffer;
    private int pictures;
    private boolean closed;

    /**
     * Starts a film.
     *
     * @param file gets the film; must not be in use
     * @param fps pictures a second
     * @throws IOException where it cannot be written
     */
    public Mp4Film(Path file, double fps) throws IOException {
        channel = NIOUtils.writableChannel(file.toFile());
        muxer = MP4Muxer.createMP4Muxer(channel, Brand.MP4);
        ticks = (int) Math.max(1, Math.round(TIMESCALE / fps));
    }

    @Override
    public void add(BufferedImage picture) throws IOException {
        int[] rgb = ((DataBufferInt) picture.getRaster().getDataBuffer()).getData();
        if (track == null) {
            converted = Picture.create(picture.getWidth(), picture.getHeight(), ColorSpace.YUV420J);
            before = new int[picture.getWidth() * picture.getHeight()];
            // other than the first picture everywhere
            Arrays.setAll(before, i -> ~rgb[i]);
            changed = new boolean[before.length / (STRIP * STRIP)];
            encoder = new FilmEncoder(picture.getWidth(), picture.getHeight());
            buffer = ByteBuffer.allocate(encoder.maxBytes());
            track = muxer.addVideoTrack(Codec.H264, VideoCodecMeta.createSimpleVideoCodecMeta(
                new Size(picture.getWidth(), picture.getHeight()), ColorSpace.YUV420));
        }
        convert(rgb, picture.getWidth(), picture.getHeight());
        buffer.clear();
        boolean isKey = encoder.encode(converted, changed, buffer);
        buffer.flip();
        track.addFrame(Packet.createPacket(buffer, (long) pictures * ticks, TIMESCALE, ticks, pictures,
            isKey ? FrameType.KEY : FrameType.INTER, null));
        pictures++;
    }

    /** Converts what is not as in the picture before, and notes which blocks that is in. */
    private void convert(int[] rgb, int width, int height) {
        Arrays.fill(changed, false);
        for (int y = 0; y < height; y += 2) {
            convertRows(rgb, width, y);
        }
    }

    /** Converts two rows of pixels, which share their colours. */
    private void convertRows(int[] rgb, int width, int y) {
        int at = y * width;
        int upper = next(rgb, at, at + width);
        int lower = next(rgb, at + width, at + 2 * width) - width;
        while (Math.min(upper, lower) < at + width) {
            int from = at + (Math.min(upper, lower) - at) / STRIP * STRIP;
            convertStrip(rgb, from, width, (y >> 1) * (width >> 1) + (from - at >> 1));
            System.arraycopy(rgb, from, before, from, STRIP);
            System.arraycopy(rgb, from + width, before, from + width, STRIP);
            changed[(y / STRIP) * (width / STRIP) + (from - at) / STRIP] = true;
            int rest = from + STRIP;
            upper = upper >= rest ? upper : next(rgb, rest, at + width);
            lower = lower >= rest ? lower : next(rgb, rest + width, at + 2 * width) - width;
        }
    }

    /** The first pixel that is not as before; the end where there is none. */
    private int next(int[] rgb, int from, int end) {
        int first = Arrays.mismatch(rgb, from, end, before, from, end);
        return first < 0 ? end : from + first;
    }

    /** To brightness and, for each 2 x 2 pixels, colour, as ITU-R BT.601 has them for video. */
    private void convertStrip(int[] rgb, int from, int width, int to) {
        byte[] luma = converted.getPlaneData(0);
        byte[] blue = converted.getPlaneData(1);
        byte[] red = converted.getPlaneData(2);
        for (int i = from; i < from + STRIP; i++) {
            luma[i] = luma(rgb[i]);
            luma[i + width] = luma(rgb[i + width]);
        }
        for (int k = 0; k < STRIP / 2; k++) {
            int i = from + 2 * k;
            // sums of four: red and blue together, then green, as no part spills into another
            int rb = (rgb[i] & 0xFF00FF) + (rgb[i + 1] & 0xFF00FF) + (rgb[i + width] & 0xFF00FF)
                + (rgb[i + width + 1] & 0xFF00FF);
            int g = (rgb[i] >> 8 & 0xFF) + (rgb[i + 1] >> 8 & 0xFF) + (rgb[i + width] >> 8 & 0xFF)
                + (rgb[i + width + 1] >> 8 & 0xFF);
            int r = rb >> 16;
            int b = rb & 0xFFFF;
            blue[to + k] = (byte) (-38 * r - 74 * g + 112 * b + 512 >> 10);
            red[to + k] = (byte) (112 * r - 94 * g - 18 * b + 512 >> 10);
        }
    }

    private static byte luma(int c) {
        return (byte) ((66 * (c >> 16 & 0xFF) + 129 * (c >> 8 & 0xFF) + 25 * (c & 0xFF) + 128 >> 8) + 16 - BIAS);
    }

    /** Completes the file; one without pictures stays empty. May be called more than once. */
    @Override
    public void close() throws IOException {
        if (closed) {
            return;
        }
        closed = true;
        try {
            if (track != null) {
                muxer.finish();
            }
        } finally {
            channel.close();
        }
    }
}
