package io.github.sofas.render;

import java.lang.invoke.MethodHandles;
import java.lang.invoke.VarHandle;
import java.nio.ByteBuffer;
import java.nio.ByteOrder;
import java.util.Arrays;
import org.jcodec.codecs.h264.H264Const;
import org.jcodec.codecs.h264.H264Encoder;
import org.jcodec.codecs.h264.H264Utils;
import org.jcodec.codecs.h264.decode.CoeffTransformer;
import org.jcodec.codecs.h264.encode.DumbRateControl;
import org.jcodec.codecs.h264.encode.EncodedMB;
import org.jcodec.codecs.h264.encode.MBEncoderHelper;
import org.jcodec.codecs.h264.encode.MBEncoderI16x16;
import org.jcodec.codecs.h264.io.CAVLC;
import org.jcodec.codecs.h264.io.model.MBType;
import org.jcodec.codecs.h264.io.model.NALUnit;
import org.jcodec.codecs.h264.io.model.NALUnitType;
import org.jcodec.codecs.h264.io.model.PictureParameterSet;
import org.jcodec.codecs.h264.io.model.RefPicMarkingIDR;
import org.jcodec.codecs.h264.io.model.SeqParameterSet;
import org.jcodec.codecs.h264.io.model.SliceHeader;
import org.jcodec.codecs.h264.io.model.SliceType;
import org.jcodec.codecs.h264.io.write.CAVLCWriter;
import org.jcodec.codecs.h264.io.write.SliceHeaderWriter;
import org.jcodec.common.io.BitWriter;
import org.jcodec.common.model.ColorSpace;
import org.jcodec.common.model.Picture;
import org.jcodec.common.model.Size;

/**
 * Encodes H.264 (baseline) of pictures in which most blocks of 16 x 16 pixels stay as they were: those cost nothing,
 * of the others the difference to the picture before is written. Motion is not searched for: dots that jump from
 * picture to picture have none that a block could follow.
 *
 * <p>Made of jcodec's parts. Its own encoder writes every block of every picture, which is several times slower and
 * larger, and predicts from smoothed blocks where the standard does not, so that what stands still takes on a tint.
 * Here nothing is smoothed: whole pictures are too fine for it, for differences it is switched off.
 */
final class FilmEncoder {
    /** Coarseness of whole pictures, 0 to 51: below 16 the standard smooths nothing. */
    private static final int KEY_QUANTISATION = 15;
    /** Coarseness of differences: thin arrows and letters stay clean. */
    private static final int QUANTISATION = 28;
    /** Difference of colour, in steps of 1 / 256, that is not worth writing. */
    private static final int UNSEEN = 3;
    /** Pictures from one whole one to the next: where a player can begin. */
    private static final int KEY_INTERVAL = 300;
    /** The coarseness that the headers count from. */
    private static final int HEADER_QUANTISATION = 26;
    /** Most blocks of a picture of level 4, which every player shows; above, level 5.1 it is. */
    private static final int LEVEL_4_BLOCKS = 8192;
    private static final int START_CODE = 1;
    /** Bits of the coded block pattern that say that colour is written. */
    private static final int COLOUR = 2 << 4;
    private static final int[] NOTHING = new int[16];
    /** Four pixels at once. */
    private static final VarHandle FOUR = MethodHandles.byteArrayViewVarHandle(int[].class, ByteOrder.LITTLE_ENDIAN);

    private final SeqParameterSet sps;
    private final PictureParameterSet pps;
    private final int columns;
    private final int rows;
    /** The picture before as it was given, and as the player sees it. */
    private final Picture before;
    private final Picture seen;
    private final ByteBuffer slice;
    private int number;

    private CAVLC[] entropy;
    private final int[][] luma = new int[16][16];
    private final boolean[] isWritten = new boolean[16];
    private final int[][] blue = new int[4][16];
    private final int[][] red = new int[4][16];

    /** Prepares for pictures of a size, in whole blocks of 16. */
    FilmEncoder(int width, int height) {
        H264Encoder parameters = new H264Encoder(new DumbRateControl());
        parameters.setKeyInterval(KEY_INTERVAL);
        columns = width / 16;
        rows = height / 16;
        sps = parameters.initSPS(new Size(width, height));
        sps.levelIdc = columns * rows > LEVEL_4_BLOCKS ? 51 : 40;
        pps = parameters.initPPS();
        pps.deblockingFilterControlPresentFlag = true;
        before = Picture.create(width, height, ColorSpace.YUV420J);
        seen = Picture.create(width, height, ColorSpace.YUV420J);
        slice = ByteBuffer.allocate(maxBytes());
    }

    /** No picture takes more. */
    int maxBytes() {
        return (1 << 16) + columns * rows * 1024;
    }

    /**
     * Appends a picture to the buffer.
     *
     * @param changed of each block, row by row, whether it may differ from the picture before
     * @return whether it is a whole one
     */
    boolean encode(Picture picture, boolean[] changed, ByteBuffer out) {
        boolean isKey = number % KEY_INTERVAL == 0;
        if (isKey) {
            number = 0;
            writeParameters(out);
        }
        entropy = new CAVLC[] {new CAVLC(sps, pps, 2, 2), new CAVLC(sps, pps, 1, 1), new CAVLC(sps, pps, 1, 1)};
        slice.clear();
        BitWriter bits = new BitWriter(slice);
        SliceHeaderWriter.write(header(isKey), isKey, 2, bits);
        if (isKey) {
            encodeWhole(picture, bits);
        } else {
            encodeDifferences(picture, changed, bits);
        }
        bits.write1Bit(1);
        bits.flush();
        slice.flip();
        out.putInt(START_CODE);
        new NALUnit(isKey ? NALUnitType.IDR_SLICE : NALUnitType.NON_IDR_SLICE, 3).write(out);
        H264Utils.escapeNAL(slice, out);
        for (int plane = 0; plane < 3; plane++) {
            System.arraycopy(picture.getPlaneData(plane), 0, before.getPlaneData(plane), 0,
                picture.getPlaneData(plane).length);
        }
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
        header.sliceQpDelta = (isKey ? KEY_QUANTISATION : QUANTISATION) - HEADER_QUANTISATION;
        header.disableDeblockingFilterIdc = 1;
        return header;
    }

    private void encodeWhole(Picture picture, BitWriter bits) {
        byte[][] left = {new byte[16], new byte[8], new byte[8]};
        byte[][] above = {new byte[columns << 4], new byte[columns << 3], new byte[columns << 3]};
        MBEncoderI16x16 encoder = new MBEncoderI16x16(entropy, left, above);
        EncodedMB block = new EncodedMB();
        for (int row = 0; row < rows; row++) {
            for (int column = 0; column < columns; column++) {
                int type = encoder.getCbpLuma(picture, column, row) / 15 * 12
                    + encoder.getCbpChroma(picture, column, row) * 4 + encoder.getPredMode(picture, column, row);
                CAVLCWriter.writeUE(bits, MBType.I_16x16.code() + type);
                encoder.encodeMacroblock(picture, column, row, bits, block, null, null, KEY_QUANTISATION, 0);
                Picture pixels = block.getPixels();
                MBEncoderHelper.putBlkPic(seen, pixels, column << 4, row << 4);
                for (int plane = 0; plane < 3; plane++) {
                    int side = plane == 0 ? 16 : 8;
                    byte[] data = pixels.getPlaneData(plane);
                    System.arraycopy(data, side * (side - 1), above[plane], column * side, side);
                    for (int i = 0; i < side; i++) {
                        left[plane][i] = data[i * side + side - 1];
                    }
                }
            }
        }
    }

    private void encodeDifferences(Picture picture, boolean[] changed, BitWriter bits) {
        int skipped = 0;
        for (int row = 0; row < rows; row++) {
            for (int column = 0; column < columns; column++) {
                int pattern = changed[row * columns + column] ? transform(picture, column, row) : 0;
                if (pattern == 0) {
                    skipped++;
                    setZero(0, column, row, 4);
                    setZero(1, column, row, 2);
                    setZero(2, column, row, 2);
                } else {
                    CAVLCWriter.writeUE(bits, skipped);
                    skipped = 0;
                    CAVLCWriter.writeUE(bits, MBType.P_16x16.code());
                    // no motion, as predicted
                    CAVLCWriter.writeSE(bits, 0);
                    CAVLCWriter.writeSE(bits, 0);
                    CAVLCWriter.writeUE(bits, H264Const.CODED_BLOCK_PATTERN_INTER_COLOR_INV[pattern]);
                    // no change of coarseness
                    CAVLCWriter.writeSE(bits, 0);
                    writeLuma(column, row, bits, pattern);
                    writeColour(picture, column, row, bits, pattern);
                }
            }
        }
        if (skipped > 0) {
            CAVLCWriter.writeUE(bits, skipped);
        }
    }

    /** Takes the differences to what is seen, brightness already transformed; the coded block pattern. */
    private int transform(Picture picture, int column, int row) {
        int stride = columns << 4;
        int pattern = 0;
        for (int i = 0; i < 16; i++) {
            int at = ((row << 4) + (i >> 2 << 2)) * stride + (column << 4) + ((i & 3) << 2);
            isWritten[i] = hasChanged(picture, 0, at, stride);
            if (isWritten[i]) {
                subtract(picture, 0, at, stride, luma[i]);
                CoeffTransformer.fdct4x4(luma[i]);
                CoeffTransformer.quantizeAC(luma[i], QUANTISATION);
                isWritten[i] = !Arrays.equals(luma[i], NOTHING);
            }
            if (isWritten[i]) {
                // of a quarter of the block, 8 x 8
                pattern |= 1 << (i >> 3 << 1 | i >> 1 & 1);
            }
        }
        int greatest = 0;
        for (int i = 0; i < 4; i++) {
            int at = ((row << 3) + (i >> 1 << 2)) * (stride >> 1) + (column << 3) + ((i & 1) << 2);
            greatest = Math.max(greatest, subtractColour(picture, 1, at, stride >> 1, blue[i]));
            greatest = Math.max(greatest, subtractColour(picture, 2, at, stride >> 1, red[i]));
        }
        return pattern | (greatest > UNSEEN ? COLOUR : 0);
    }

    /** The greatest difference in 4 x 4 values of colour; none where they are as they were. */
    private int subtractColour(Picture picture, int plane, int at, int stride, int[] block) {
        if (!hasChanged(picture, plane, at, stride)) {
            Arrays.fill(block, 0);
            return 0;
        }
        subtract(picture, plane, at, stride, block);
        int greatest = 0;
        for (int difference : block) {
            greatest = Math.max(greatest, Math.abs(difference));
        }
        return greatest;
    }

    /** Whether 4 x 4 values have. */
    private boolean hasChanged(Picture picture, int plane, int at, int stride) {
        byte[] now = picture.getPlaneData(plane);
        byte[] then = before.getPlaneData(plane);
        int difference = 0;
        for (int y = 0; y < 4; y++) {
            difference |= (int) FOUR.get(now, at + y * stride) ^ (int) FOUR.get(then, at + y * stride);
        }
        return difference != 0;
    }

    /** Of 4 x 4 values. */
    private void subtract(Picture picture, int plane, int at, int stride, int[] block) {
        byte[] now = picture.getPlaneData(plane);
        byte[] then = seen.getPlaneData(plane);
        for (int y = 0, i = 0; y < 4; y++, at += stride) {
            for (int x = 0; x < 4; x++, i++) {
                block[i] = now[at + x] - then[at + x];
            }
        }
    }

    private void writeLuma(int column, int row, BitWriter bits, int pattern) {
        for (int i = 0; i < 16; i++) {
            int x = (column << 2) + H264Const.MB_BLK_OFF_LEFT[i];
            int y = (row << 2) + H264Const.MB_BLK_OFF_TOP[i];
            if ((pattern >> (i >> 2) & 1) == 0) {
                entropy[0].setZeroCoeff(x, y);
                continue;
            }
            int place = H264Const.BLK_INV_MAP[i];
            int[] block = isWritten[place] ? luma[place] : NOTHING;
            entropy[0].writeACBlock(bits, x, y, MBType.P_16x16, MBType.P_16x16, block, H264Const.totalZeros16, 0, 16,
                CoeffTransformer.zigzag4x4);
            if (!isWritten[place]) {
                continue;
            }
            CoeffTransformer.dequantizeAC(block, QUANTISATION, null);
            CoeffTransformer.idct4x4(block);
            add(0, x << 2, y << 2, block);
        }
    }

    private void writeColour(Picture picture, int column, int row, BitWriter bits, int pattern) {
        if ((pattern & COLOUR) == 0) {
            setZero(1, column, row, 2);
            setZero(2, column, row, 2);
            return;
        }
        MBEncoderI16x16.chromaResidual(picture, column, row, bits, QUANTISATION, blue, red, entropy[1], entropy[2],
            MBType.P_16x16, MBType.P_16x16);
        for (int i = 0; i < 4; i++) {
            int x = (column << 3) + ((i & 1) << 2);
            int y = (row << 3) + (i >> 1 << 2);
            add(1, x, y, blue[i]);
            add(2, x, y, red[i]);
        }
    }

    /** Adds a difference to what is seen. */
    private void add(int plane, int x, int y, int[] block) {
        byte[] pixels = seen.getPlaneData(plane);
        int stride = columns * (plane == 0 ? 16 : 8);
        for (int i = 0; i < 16; i++) {
            int at = (y + (i >> 2)) * stride + x + (i & 3);
            pixels[at] = (byte) Math.max(-128, Math.min(127, pixels[at] + block[i]));
        }
    }

    /** Notes that a block has no coefficients, which the code of its neighbours depends on. */
    private void setZero(int plane, int column, int row, int side) {
        for (int y = 0; y < side; y++) {
            for (int x = 0; x < side; x++) {
                entropy[plane].setZeroCoeff(column * side + x, row * side + y);
            }
        }
    }
}
