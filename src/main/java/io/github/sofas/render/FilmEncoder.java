package io.github.sofas.render;

import java.nio.ByteBuffer;
import org.jcodec.codecs.h264.H264Encoder;
import org.jcodec.codecs.h264.H264Utils;
import org.jcodec.codecs.h264.encode.DumbRateControl;
import org.jcodec.codecs.h264.io.model.NALUnit;
import org.jcodec.codecs.h264.io.model.NALUnitType;
import org.jcodec.codecs.h264.io.model.PictureParameterSet;
import org.jcodec.codecs.h264.io.model.RefPicMarkingIDR;
import org.jcodec.codecs.h264.io.model.SeqParameterSet;
import org.jcodec.codecs.h264.io.model.SliceHeader;
import org.jcodec.codecs.h264.io.model.SliceType;
import org.jcodec.codecs.h264.io.write.SliceHeaderWriter;
import org.jcodec.common.io.BitWriter;
import org.jcodec.common.model.Size;

/**
 * Encodes H.264 (baseline) of dots that come and go on a ground that stays: a whole picture from time to time, and
 * between them what differs from the picture before ({@link DifferenceEncoder}).
 *
 * <p>Made of jcodec's parts. Its own encoder writes every block of every picture, which is several times slower and
 * larger, and predicts from smoothed blocks where the standard does not, so that what stands still takes on a tint.
 * Here nothing is smoothed: whole pictures are too fine for it, for differences it is switched off.
 */
final class FilmEncoder {
    /** Pictures from one whole one to the next: where a player can begin. */
    private static final int KEY_INTERVAL = 300;
    /** The coarseness that the headers count from. */
    private static final int HEADER_QUANTISATION = 26;
    /** Most blocks of a picture of level 4, which every player shows; above, level 5.1 it is. */
    private static final int LEVEL_4_BLOCKS = 8192;
    private static final int START_CODE = 1;

    private final SeqParameterSet sps;
    private final PictureParameterSet pps;
    private final int blocks;
    private final WholeEncoder whole;
    private final DifferenceEncoder differences;
    private final ByteBuffer slice;
    private int number;

    /** Prepares for pictures of a size, in whole blocks of 16. */
    FilmEncoder(int width, int height) {
        H264Encoder parameters = new H264Encoder(new DumbRateControl());
        parameters.setKeyInterval(KEY_INTERVAL);
        int columns = width / 16;
        int rows = height / 16;
        blocks = columns * rows;
        sps = parameters.initSPS(new Size(width, height));
        sps.levelIdc = blocks > LEVEL_4_BLOCKS ? 51 : 40;
        pps = parameters.initPPS();
        pps.deblockingFilterControlPresentFlag = true;
        BlockPicture seen = new BlockPicture(columns, rows);
        whole = new WholeEncoder(seen);
        differences = new DifferenceEncoder(seen);
        slice = ByteBuffer.allocate(maxBytes());
    }

    /** No picture takes more. */
    int maxBytes() {
        return (1 << 16) + blocks * 1024;
    }

    /**
     * Appends a picture to the buffer.
     *
     * @param changed of each block, row by row, the parts that differ from the picture before, as bits
     * @return whether it is a whole one
     */
    boolean encode(BlockPicture picture, int[] changed, ByteBuffer out) {
        boolean isKey = number % KEY_INTERVAL == 0;
        if (isKey) {
            number = 0;
            writeParameters(out);
        }
        slice.clear();
        BitWriter bits = new BitWriter(slice);
        SliceHeaderWriter.write(header(isKey), isKey, 2, bits);
        int headerBits = bits.position();
        bits.flush();
        CoefficientWriter coefficients = new CoefficientWriter(slice, headerBits);
        if (isKey) {
            whole.encode(picture, coefficients);
        } else {
            differences.encode(picture, changed, coefficients);
        }
        coefficients.end();
        slice.flip();
        out.putInt(START_CODE);
        new NALUnit(isKey ? NALUnitType.IDR_SLICE : NALUnitType.NON_IDR_SLICE, 3).write(out);
        H264Utils.escapeNAL(slice, out);
        number++;
        return isKey;
    }

    private void writeParameters(ByteBuffer out) {
        ByteBuffer bytes = ByteBuffer.allocate(1024);
        out.putInt(START_CODE);
        new NALUnit(NALUnitType.SPS, 3).write(out);
        sps.write(bytes);
        bytes.flip();
        H264Utils.escapeNAL(bytes, out);
        bytes.clear();
        out.putInt(START_CODE);
        new NALUnit(NALUnitType.PPS, 3).write(out);
        pps.write(bytes);
        bytes.flip();
        H264Utils.escapeNAL(bytes, out);
    }

    private SliceHeader header(boolean isKey) {
        SliceHeader header = new SliceHeader();
        header.sliceType = isKey ? SliceType.I : SliceType.P;
        header.refPicMarkingIDR = isKey ? new RefPicMarkingIDR(false, false) : null;
        header.sps = sps;
        header.pps = pps;
        header.frameNum = number % (1 << sps.log2MaxFrameNumMinus4 + 4);
        header.picOrderCntLsb = (number << 1) % (1 << sps.log2MaxPicOrderCntLsbMinus4 + 4);
        header.sliceQpDelta = (isKey ? WholeEncoder.QUANTISATION : DifferenceEncoder.QUANTISATION)
            - HEADER_QUANTISATION;
        header.disableDeblockingFilterIdc = 1;
        return header;
    }
}
