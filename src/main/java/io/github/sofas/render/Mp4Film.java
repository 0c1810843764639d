package io.github.sofas.render;

import java.awt.image.BufferedImage;
import java.awt.image.DataBufferInt;
import java.io.IOException;
import java.nio.ByteBuffer;
import java.nio.file.Path;
import org.jcodec.codecs.h264.H264Encoder;
import org.jcodec.codecs.h264.encode.RateControl;
import org.jcodec.codecs.h264.io.model.SliceType;
import org.jcodec.common.Codec;
import org.jcodec.common.MuxerTrack;
import org.jcodec.common.VideoCodecMeta;
import org.jcodec.common.VideoEncoder.EncodedFrame;
import org.jcodec.common.io.NIOUtils;
import org.jcodec.common.io.SeekableByteChannel;
import org.jcodec.common.model.ColorSpace;
import org.jcodec.common.model.Packet;
import org.jcodec.common.model.Packet.FrameType;
import org.jcodec.common.model.Picture;
import org.jcodec.common.model.Size;
import org.jcodec.containers.mp4.Brand;
import org.jcodec.containers.mp4.muxer.MP4Muxer;

/**
 * An MP4 file with H.264 video (baseline), which browsers and players show without further software.
 *
 * <p>Motion is not searched for: dots that jump from picture to picture have none that a block could follow, and the
 * search took half of the time.
 */
public final class Mp4Film implements Film {
    /** Ticks a second of the film's clock: whole numbers of them for all usual rates. */
    private static final int TIMESCALE = 90_000;
    /** Coarseness of the picture, 0 to 51: thin arrows and letters stay clean. */
    private static final int QUANTISATION = 24;
    /** Pictures from one whole one to the next: jcodec's errors add up in between, to a tint of what stands still. */
    private static final int KEY_INTERVAL = 10;
    /** Brightness and colour as jcodec holds them: less by 128. */
    private static final int BIAS = 128;

    private final SeekableByteChannel channel;
    private final MP4Muxer muxer;
    private final H264Encoder encoder = new H264Encoder(new ConstantQuality());
    private final int ticks;
    private MuxerTrack track;
    private Picture converted;
    private ByteBuffer buffer;
    private int pictures;
    private boolean closed;

    /** Takes the same coarseness for every block, so that no block is encoded twice. */
    private static final class ConstantQuality implements RateControl {
        @Override
        public int startPicture(Size size, int maxSize, SliceType type) {
            return QUANTISATION;
        }

        @Override
        public int initialQpDelta() {
            return 0;
        }

        @Override
        public int accept(int bits) {
            return 0;
        }
    }

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
        encoder.setMotionSearchRange(0);
        encoder.setKeyInterval(KEY_INTERVAL);
        ticks = (int) Math.max(1, Math.round(TIMESCALE / fps));
    }

    @Override
    public void add(BufferedImage picture) throws IOException {
        if (track == null) {
            converted = Picture.create(picture.getWidth(), picture.getHeight(), ColorSpace.YUV420J);
            buffer = ByteBuffer.allocate(encoder.estimateBufferSize(converted));
            track = muxer.addVideoTrack(Codec.H264, VideoCodecMeta.createSimpleVideoCodecMeta(
                new Size(picture.getWidth(), picture.getHeight()), ColorSpace.YUV420));
        }
        convert(((DataBufferInt) picture.getRaster().getDataBuffer()).getData(), picture.getWidth(),
            picture.getHeight());
        buffer.clear();
        EncodedFrame frame = encoder.encodeFrame(converted, buffer);
        track.addFrame(Packet.createPacket(frame.getData(), (long) pictures * ticks, TIMESCALE, ticks, pictures,
            frame.isKeyFrame() ? FrameType.KEY : FrameType.INTER, null));
        pictures++;
    }

    /** To brightness and, for each 2 x 2 pixels, colour, as ITU-R BT.601 has them for video. */
    private void convert(int[] rgb, int width, int height) {
        byte[] luma = converted.getPlaneData(0);
        byte[] blue = converted.getPlaneData(1);
        byte[] red = converted.getPlaneData(2);
        for (int i = 0; i < rgb.length; i++) {
            int c = rgb[i];
            luma[i] = (byte) ((66 * (c >> 16 & 0xFF) + 129 * (c >> 8 & 0xFF) + 25 * (c & 0xFF) + 128 >> 8) + 16 - BIAS);
        }
        int to = 0;
        for (int y = 0; y < height; y += 2) {
            for (int x = 0; x < width; x += 2, to++) {
                int i = y * width + x;
                // sums of four: red and blue together, then green, as no part spills into another
                int rb = (rgb[i] & 0xFF00FF) + (rgb[i + 1] & 0xFF00FF) + (rgb[i + width] & 0xFF00FF)
                    + (rgb[i + width + 1] & 0xFF00FF);
                int g = (rgb[i] >> 8 & 0xFF) + (rgb[i + 1] >> 8 & 0xFF) + (rgb[i + width] >> 8 & 0xFF)
                    + (rgb[i + width + 1] >> 8 & 0xFF);
                int r = rb >> 16;
                int b = rb & 0xFFFF;
                blue[to] = (byte) (-38 * r - 74 * g + 112 * b + 512 >> 10);
                red[to] = (byte) (112 * r - 94 * g - 18 * b + 512 >> 10);
            }
        }
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
