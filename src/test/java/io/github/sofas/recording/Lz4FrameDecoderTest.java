package io.github.sofas.recording;

import static org.junit.Assert.assertArrayEquals;
import static org.junit.Assert.assertEquals;
import static org.junit.Assert.assertNotNull;
import static org.junit.Assert.assertNull;
import static org.junit.Assert.assertTrue;

import java.nio.charset.StandardCharsets;
import java.util.Arrays;
import java.util.Random;
import org.apache.commons.compress.compressors.lz4.FramedLZ4CompressorOutputStream.BlockSize;
import org.apache.commons.compress.compressors.lz4.FramedLZ4CompressorOutputStream.Parameters;
import org.junit.Test;

/** Frames come from commons-compress. */
public class Lz4FrameDecoderTest {
    private static final int MAX = 1 << 24;

    private final Lz4FrameDecoder decoder = new Lz4FrameDecoder();

    @Test public void unpacksLinkedAndIndependentBlocksWithAndWithoutChecksums() throws Exception {
        for (byte[] data : new byte[][] {text(0), text(1), text(13), text(3_000), noise(3_000), runs(20_000)}) {
            for (BlockSize size : new BlockSize[] {BlockSize.K64, BlockSize.M1}) {
                for (int flags = 0; flags < 8; flags++) {
                    assertUnpacks(data, size, flags);
                }
            }
        }
    }

    @Test public void unpacksSeveralBlocks() throws Exception {
        for (byte[] data : new byte[][] {text(100_000), noise(150_000), runs(100_000)}) {
            assertUnpacks(data, BlockSize.K64, 0);
            assertUnpacks(data, BlockSize.K64, 7);
        }
    }

    private void assertUnpacks(byte[] data, BlockSize size, int flags) throws Exception {
        byte[] packed = Aedat4Bytes.lz4(data,
            new Parameters(size, (flags & 1) != 0, (flags & 2) != 0, (flags & 4) != 0));
        decoder.decode(packed, 0, packed.length, MAX);
        assertNull(decoder.fault(), decoder.fault());
        assertArrayEquals(data, Arrays.copyOf(decoder.output(), decoder.length()));
    }

    @Test public void keepsWhatPrecedesATruncation() throws Exception {
        byte[] data = text(3000);
        byte[] packed = Aedat4Bytes.lz4(data, new Parameters(BlockSize.K64, false, false, true));
        int before = 0;
        for (int length = 0; length < packed.length; length++) {
            decoder.decode(packed, 0, length, MAX);
            assertTrue(decoder.fault(), decoder.fault().startsWith("truncated, "));
            assertTrue("more bytes give more", decoder.length() >= before);
            before = decoder.length();
            assertArrayEquals(Arrays.copyOf(data, before), Arrays.copyOf(decoder.output(), before));
        }
        assertEquals(data.length, before);
    }

    /** With checksums, whatever byte is spoiled is noticed; without, nothing is written where it must not be. */
    @Test public void survivesAnySpoiledByte() throws Exception {
        byte[] data = text(2000);
        for (boolean checksums : new boolean[] {true, false}) {
            byte[] packed = Aedat4Bytes.lz4(data, new Parameters(BlockSize.K64, checksums, checksums, true));
            for (int i = 0; i < packed.length; i++) {
                for (int bit = 0; bit < 8; bit++) {
                    byte[] spoiled = packed.clone();
                    spoiled[i] ^= (byte) (1 << bit);
                    decoder.decode(spoiled, 0, spoiled.length, MAX);
                    if (checksums) {
                        assertNotNull("byte " + i + " bit " + bit, decoder.fault());
                    }
                }
            }
        }
    }

    @Test public void unpacksNoMoreThanAllowed() throws Exception {
        byte[] packed = Aedat4Bytes.lz4(runs(400_000), new Parameters(BlockSize.K64, false, false, true));
        decoder.decode(packed, 0, packed.length, 300_000);
        assertEquals("unsupported, a packet must unpack to at most 300000 bytes", decoder.fault());
        assertTrue(decoder.output().length < 600_000);
    }

    @Test public void namesWhatIsNoFrame() {
        decoder.decode(new byte[20], 0, 20, MAX);
        assertEquals("malformed, an LZ4 frame must start with 0x184D2204 but started with 0x00000000", decoder.fault());
    }

    /** As xxhsum -H32 gives them. */
    @Test public void computesXxHash32() {
        assertEquals(0x02CC5D05, XxHash32.of(new byte[0], 0, 0));
        assertEquals(0x32D153FF, XxHash32.of("abc".getBytes(StandardCharsets.US_ASCII), 0, 3));
    }

    private static byte[] text(int length) {
        StringBuilder text = new StringBuilder();
        for (int i = 0; text.length() < length; i++) {
            text.append("event ").append(i * 7919L % 1000).append(" at ").append(i).append('\n');
        }
        return Arrays.copyOf(text.toString().getBytes(StandardCharsets.US_ASCII), length);
    }

    private static byte[] noise(int length) {
        byte[] bytes = new byte[length];
        new Random(1).nextBytes(bytes);
        return bytes;
    }

    /** Runs of every period from 1 to 20, so that matches overlap themselves. */
    private static byte[] runs(int length) {
        byte[] bytes = new byte[length];
        for (int i = 0; i < length; i++) {
            bytes[i] = (byte) (i % (1 + i / 1000 % 20));
        }
        return bytes;
    }
}
