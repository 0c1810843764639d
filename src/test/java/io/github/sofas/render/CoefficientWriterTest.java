package io.github.sofas.render;

import static org.junit.Assert.assertArrayEquals;
import static org.junit.Assert.assertEquals;

import java.nio.ByteBuffer;
import java.util.Arrays;
import java.util.Random;
import java.util.stream.IntStream;
import org.jcodec.codecs.h264.H264Const;
import org.jcodec.codecs.h264.decode.CAVLCReader;
import org.jcodec.codecs.h264.decode.CoeffTransformer;
import org.jcodec.codecs.h264.io.CAVLC;
import org.jcodec.codecs.h264.io.model.PictureParameterSet;
import org.jcodec.codecs.h264.io.model.SeqParameterSet;
import org.jcodec.common.io.BitReader;
import org.jcodec.common.model.ColorSpace;
import org.junit.Test;

/** What is written is what jcodec reads. */
public class CoefficientWriterTest {
    private static CAVLC reader() {
        SeqParameterSet sps = new SeqParameterSet();
        sps.chromaFormatIdc = ColorSpace.YUV420J;
        return new CAVLC(sps, new PictureParameterSet(), 2, 2);
    }

    private static int[] randomBlock(Random random, int size) {
        int[] block = new int[size];
        int zeros = random.nextInt(size + 1);
        int most = 1 << random.nextInt(8);
        for (int i = 0; i < size; i++) {
            block[i] = random.nextInt(size) < zeros ? 0 : random.nextInt(2 * most) - most;
            block[i] = Math.max(-127, block[i]);
        }
        return block;
    }

    @Test
    public void blocksAreReadAsTheyWereWritten() {
        Random random = new Random(1);
        ByteBuffer bytes = ByteBuffer.allocate(10_000);
        for (int n = 0; n < 20_000; n++) {
            bytes.clear();
            int neighbours = random.nextInt(17);
            int[] block = randomBlock(random, 16);
            int first = random.nextInt(2);
            block[0] = first == 1 ? 0 : n % 5 == 0 ? 9 * block[0] : block[0];
            CoefficientWriter writer = new CoefficientWriter(bytes, 0);
            int[] levels = IntStream.of(CoefficientWriter.SCAN).map(place -> block[place]).toArray();
            int found = IntStream.range(0, 16).filter(i -> levels[i] != 0).map(i -> 1 << i).sum();
            writer.writeBlock(levels, found, first, neighbours);
            writer.end();
            bytes.flip();
            int[] read = new int[16];
            BitReader bits = BitReader.createBitReader(bytes);
            reader().readCoeffs(bits, H264Const.CoeffToken[Math.min(8, neighbours)], H264Const.totalZeros16, read,
                first, 16 - first, CoeffTransformer.zigzag4x4);
            assertArrayEquals(Arrays.toString(block), block, read);
            assertEquals("the end", 1, bits.read1Bit());
        }
    }

    @Test
    public void meansOfColoursAreReadAsTheyWereWritten() {
        Random random = new Random(2);
        ByteBuffer bytes = ByteBuffer.allocate(100);
        for (int n = 0; n < 5_000; n++) {
            bytes.clear();
            int[] means = randomBlock(random, 4);
            CoefficientWriter writer = new CoefficientWriter(bytes, 0);
            writer.writeColourMeans(means);
            writer.end();
            bytes.flip();
            int[] read = new int[4];
            reader().readChromaDCBlock(BitReader.createBitReader(bytes), read, true, true);
            assertArrayEquals(means, read);
        }
    }

    @Test
    public void numbersFollowTheBitsThatWereThere() {
        int[] numbers = {0, 1, -1, 2, 1000, -16_376, 16_376};
        for (int before = 0; before < 16; before++) {
            ByteBuffer bytes = ByteBuffer.allocate(100);
            bytes.putShort(0, (short) (0xFFFF << 16 - before));
            CoefficientWriter writer = new CoefficientWriter(bytes, before);
            for (int number : numbers) {
                writer.writeSigned(number);
                writer.writeUnsigned(Math.abs(number));
            }
            writer.end();
            bytes.flip();
            BitReader bits = BitReader.createBitReader(bytes);
            assertEquals((1 << before) - 1, before == 0 ? 0 : bits.readNBit(before));
            for (int number : numbers) {
                assertEquals(number, CAVLCReader.readSE(bits, ""));
                assertEquals(Math.abs(number), CAVLCReader.readUE(bits));
            }
        }
    }
}
