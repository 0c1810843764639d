package io.github.sofas.render;

import java.awt.image.BufferedImage;
import java.awt.image.DataBufferInt;
import java.io.IOException;
import java.nio.ByteBuffer;
import java.nio.file.Path;
import java.util.Arrays;
import java.util.List;
import java.util.Set;
import org.jcodec.common.Codec;
import org.jcodec.common.MuxerTrack;
import org.jcodec.common.VideoCodecMeta;
import org.jcodec.common.io.NIOUtils;
import org.jcodec.common.io.SeekableByteChannel;
import org.jcodec.common.model.ColorSpace;
import org.jcodec.common.model.Packet;
import org.jcodec.common.model.Packet.FrameType;
import org.jcodec.common.model.Size;
import org.jcodec.containers.mp4.Brand;
import org.jcodec.containers.mp4.boxes.Box;
import org.jcodec.containers.mp4.boxes.Header;
import org.jcodec.containers.mp4.boxes.MovieBox;
import org.jcodec.containers.mp4.boxes.NodeBox;
import org.jcodec.containers.mp4.muxer.MP4Muxer;

/** An MP4 file with H.264 video (baseline), which browsers and players show without further software. */
public final class Mp4Film implements Film {
    /** Ticks a second of the film's clock: whole numbers of them for all usual rates. */
    private static final int TIMESCALE = 90_000;
    /** Sides of the video's blocks, px. */
    private static final int SIDE = 16;

    /** Parts of the file's header that begin with version and flags, when it was made and when it was changed. */
    private static final Set<String> DATED = Set.of("mvhd", "tkhd", "mdhd");
    private static final int HEADER_BYTES = 8;
    private static final int DATES_AT = HEADER_BYTES + 4;

    private final SeekableByteChannel channel;
    private final MP4Muxer muxer;
    private final int ticks;
    private FilmEncoder encoder;
    private MuxerTrack track;
    private final BlockConverter converter = new BlockConverter();
    private BlockPicture converted;
    /** Of each block, the parts that are not as in the picture before, as bits. */
    private int[] changed;
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
        boolean[] all = new boolean[picture.getWidth() / SIDE * (picture.getHeight() / SIDE)];
        Arrays.fill(all, true);
        add(picture, all);
    }

    @Override
    public void add(BufferedImage picture, boolean[] mayDiffer) throws IOException {
        int columns = picture.getWidth() / SIDE;
        if (track == null) {
            converted = new BlockPicture(columns, picture.getHeight() / SIDE);
            changed = new int[mayDiffer.length];
            encoder = new FilmEncoder(picture.getWidth(), picture.getHeight());
            buffer = ByteBuffer.allocate(encoder.maxBytes());
            track = muxer.addVideoTrack(Codec.H264, VideoCodecMeta.createSimpleVideoCodecMeta(
                new Size(picture.getWidth(), picture.getHeight()), ColorSpace.YUV420));
        }
        int[] rgb = ((DataBufferInt) picture.getRaster().getDataBuffer()).getData();
        for (int block = 0; block < changed.length; block++) {
            int first = block / columns * SIDE * picture.getWidth() + block % columns * SIDE;
            changed[block] = !mayDiffer[block] ? 0 : converter.convert(rgb, first, picture.getWidth(), converted.words,
                block * BlockPicture.BLOCK_WORDS);
        }
        buffer.clear();
        boolean isKey = encoder.encode(converted, changed, buffer);
        buffer.flip();
        track.addFrame(Packet.createPacket(buffer, (long) pictures * ticks, TIMESCALE, ticks, pictures,
            isKey ? FrameType.KEY : FrameType.INTER, null));
        pictures++;
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
                MovieBox header = muxer.finalizeHeader();
                removeDates(header);
                muxer.storeHeader(header);
            }
        } finally {
            channel.close();
        }
    }

    /** Sets when it was made to nothing: the same pictures are the same file. */
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
