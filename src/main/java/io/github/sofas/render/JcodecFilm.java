package io.github.sofas.render;

import java.awt.image.BufferedImage;
import java.awt.image.DataBufferInt;
import java.io.IOException;
import java.nio.ByteBuffer;
import java.nio.file.Path;
import java.util.List;
import java.util.Set;
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
import org.jcodec.containers.mp4.boxes.Box;
import org.jcodec.containers.mp4.boxes.Header;
import org.jcodec.containers.mp4.boxes.MovieBox;
import org.jcodec.containers.mp4.boxes.NodeBox;
import org.jcodec.containers.mp4.muxer.MP4Muxer;

/**
 * An MP4 file, encoded by the library jcodec. Its settings suit pictures of events, and the same pictures give the same
 * bytes.
 */
final class JcodecFilm implements Film {
    /** Ticks per second of the film's clock: a picture takes a whole number of ticks at all usual rates. */
    private static final int TIMESCALE = 90_000;
    /** Number of pictures from one complete picture to the next; players can start at a complete one. */
    private static final int KEY_INTERVAL = 300;
    /**
     * Quantisation of the coefficients: larger is coarser. jcodec predicts from pictures that are not smoothed, players
     * predict from smoothed ones. Areas that stand still therefore take on a tint. Up to 15, the standard smooths
     * nothing. With 12, files are 4 % larger, and colours are off by 0.2 instead of 0.9 of 255 levels on average.
     */
    private static final int QUANTISATION = 12;
    /**
     * Range of the search for motion, 0 for none. Dots appear and vanish, but do not shift by whole blocks: a search
     * would find nothing and double the time.
     */
    private static final int SEARCH_RANGE = 0;

    /**
     * Boxes of the file's header that begin with version and flags, followed by the times of creation and of
     * modification.
     */
    private static final Set<String> DATED = Set.of("mvhd", "tkhd", "mdhd");
    private static final int HEADER_BYTES = 8;
    private static final int DATES_AT = HEADER_BYTES + 4;

    private final SeekableByteChannel channel;
    private final MP4Muxer muxer;
    private final MuxerTrack track;
    private final int ticks;
    private final H264Encoder encoder = new H264Encoder(new OneQuantisation());
    private final Picture yuv;
    private final ByteBuffer buffer;
    private int pictures;
    private boolean closed;

    /** Starts a film of pictures whose width and height are even. */
    JcodecFilm(Path file, double fps, int width, int height) throws IOException {
        channel = NIOUtils.writableChannel(file.toFile());
        muxer = MP4Muxer.createMP4Muxer(channel, Brand.MP4);
        track = muxer.addVideoTrack(Codec.H264, VideoCodecMeta.createSimpleVideoCodecMeta(new Size(width, height),
            ColorSpace.YUV420));
        ticks = (int) Math.max(1, Math.round(TIMESCALE / fps));
        encoder.setKeyInterval(KEY_INTERVAL);
        encoder.setMotionSearchRange(SEARCH_RANGE);
        yuv = Picture.create(width, height, ColorSpace.YUV420J);
        // even noise takes less than twice the bytes of its samples
        buffer = ByteBuffer.allocate((1 << 16) + 3 * width * height);
    }

    /** The same quantisation for all blocks. */
    private static final class OneQuantisation implements RateControl {
        @Override
        public int startPicture(Size size, int mostBytes, SliceType kind) {
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

    @Override
    public void add(BufferedImage picture) throws IOException {
        convert(((DataBufferInt) picture.getRaster().getDataBuffer()).getData(), yuv);
        buffer.clear();
        EncodedFrame frame = encoder.encodeFrame(yuv, buffer);
        track.addFrame(Packet.createPacket(frame.getData(), (long) pictures * ticks, TIMESCALE, ticks, pictures,
            frame.isKeyFrame() ? FrameType.KEY : FrameType.INTER, null));
        pictures++;
    }

    /**
     * Converts RGB to the luma of each pixel and the chroma of each 2 x 2 pixels, by BT.601 in the range of video,
     * minus 128.
     */
    private static void convert(int[] rgb, Picture yuv) {
        byte[] luma = yuv.getPlaneData(0);
        byte[] blue = yuv.getPlaneData(1);
        byte[] red = yuv.getPlaneData(2);
        int width = yuv.getWidth();
        for (int y = 0, colour = 0; y < yuv.getHeight(); y += 2) {
            for (int x = 0; x < width; x += 2, colour++) {
                int r = 0;
                int g = 0;
                int b = 0;
                for (int k = 0; k < 4; k++) {
                    int i = (y + (k >> 1)) * width + x + (k & 1);
                    int pixelR = rgb[i] >> 16 & 0xFF;
                    int pixelG = rgb[i] >> 8 & 0xFF;
                    int pixelB = rgb[i] & 0xFF;
                    luma[i] = (byte) ((66 * pixelR + 129 * pixelG + 25 * pixelB + 128 >> 8) + 16 - 128);
                    r += pixelR;
                    g += pixelG;
                    b += pixelB;
                }
                blue[colour] = (byte) (-38 * r - 74 * g + 112 * b + 512 >> 10);
                red[colour] = (byte) (112 * r - 94 * g - 18 * b + 512 >> 10);
            }
        }
    }

    /** Completes the file. May be called more than once. */
    @Override
    public void close() throws IOException {
        if (closed) {
            return;
        }
        closed = true;
        try {
            MovieBox header = muxer.finalizeHeader();
            removeDates(header);
            muxer.storeHeader(header);
        } finally {
            channel.close();
        }
    }

    /** Sets the times of creation and modification to zero, so that the same pictures give the same file. */
    private static void removeDates(NodeBox box) {
        List<Box> children = box.getBoxes();
        for (int i = 0; i < children.size(); i++) {
            Box child = children.get(i);
            if (child instanceof NodeBox) {
                removeDates((NodeBox) child);
            } else if (DATED.contains(child.getFourcc())) {
                ByteBuffer bytes = ByteBuffer.allocate(child.estimateSize());
                child.write(bytes);
                bytes.putLong(DATES_AT, 0);
                bytes.flip().position(HEADER_BYTES);
                Header header = Header.createHeader(child.getFourcc(), bytes.limit());
                children.set(i, Box.createLeafBox(header, bytes.slice()));
            }
        }
    }
}
