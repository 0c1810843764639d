package io.github.sofas.recording;

import com.github.luben.zstd.Zstd;
import com.github.luben.zstd.ZstdException;
import io.jhdf.exceptions.HdfFilterException;
import io.jhdf.exceptions.UnsupportedHdfException;
import io.jhdf.filter.Filter;
import java.lang.invoke.MethodHandles;
import java.lang.invoke.VarHandle;
import java.nio.ByteOrder;
import java.util.Arrays;
import java.util.zip.DataFormatException;
import java.util.zip.Inflater;
import net.jpountz.lz4.LZ4Exception;
import net.jpountz.lz4.LZ4Factory;
import net.jpountz.lz4.LZ4SafeDecompressor;

/**
 * Unpacks Blosc 1 chunks of HDF5 (filter 32001) that were packed by LZ4, zlib or Zstandard, with shuffled bytes,
 * shuffled bits or neither. Safe for many threads.
 *
 * <p>A chunk consists of a header of 16 bytes, the place of each block, and the blocks. A block has one part, or one
 * part for each byte of an element. Source: c-blosc, {@code README_CHUNK_FORMAT.rst}. This is own code because the only
 * library on Maven Central (com.scalableminds:blosc-java) has machine code for one processor and is not maintained.
 */
final class BloscFilter implements Filter {
    private static final int ID = 32001;
    private static final int HEADER_BYTES = 16;
    private static final int MOST_BYTES = 128 << 20;
    private static final VarHandle INT = MethodHandles.byteArrayViewVarHandle(int[].class, ByteOrder.LITTLE_ENDIAN);

    private static final int FLAGS_AT = 2;
    private static final int ELEMENT_AT = 3;
    private static final int BYTES_AT = 4;
    private static final int BLOCK_BYTES_AT = 8;
    private static final int BYTE_SHUFFLED = 1;
    private static final int PLAIN = 2;
    private static final int BIT_SHUFFLED = 4;
    private static final int NOT_SPLIT = 0x10;
    private static final int CODEC_SHIFT = 5;
    private static final String[] CODECS = {"BloscLZ", "LZ4", "Snappy", "zlib", "Zstandard"};
    private static final int LZ4 = 1;
    private static final int ZLIB = 3;
    private static final int ZSTD = 4;

    private final LZ4SafeDecompressor lz4 = LZ4Factory.safeInstance().safeDecompressor();

    @Override
    public int getId() {
        return ID;
    }

    @Override
    public String getName() {
        return "blosc";
    }

    @Override
    public byte[] decode(byte[] packed, int[] settings) {
        check(packed.length >= HEADER_BYTES, "the header must have 16 bytes");
        int flags = packed[FLAGS_AT];
        int element = packed[ELEMENT_AT] & 0xFF;
        int bytes = (int) INT.get(packed, BYTES_AT);
        int blockBytes = (int) INT.get(packed, BLOCK_BYTES_AT);
        check(bytes >= 0 && bytes <= MOST_BYTES, "a chunk must have at most " + MOST_BYTES + " bytes");
        if ((flags & PLAIN) != 0) {
            check(packed.length - HEADER_BYTES >= bytes, "a chunk must be whole");
            return Arrays.copyOfRange(packed, HEADER_BYTES, HEADER_BYTES + bytes);
        }
        check(blockBytes > 0 && blockBytes <= MOST_BYTES && element > 0, "a block must have some bytes");
        int codec = flags >>> CODEC_SHIFT & 7;
        if (codec != LZ4 && codec != ZLIB && codec != ZSTD) {
            throw new UnsupportedHdfException("Blosc must pack by LZ4, zlib or Zstandard but did by "
                    + (codec < CODECS.length ? CODECS[codec] : codec) + "; h5repack -f GZIP=5 packs it anew");
        }
        int blocks = (int) (((long) bytes + blockBytes - 1) / blockBytes);
        check(packed.length - HEADER_BYTES >= (long) blocks * Integer.BYTES, "the blocks' places must be there");
        byte[] result = new byte[bytes];
        byte[] shuffled = new byte[Math.min(blockBytes, bytes)];
        for (int block = 0; block < blocks; block++) {
            int from = block * blockBytes;
            int length = Math.min(blockBytes, bytes - from);
            boolean isSplit = (flags & NOT_SPLIT) == 0 && length == blockBytes && blockBytes % element == 0;
            int at = (int) INT.get(packed, HEADER_BYTES + block * Integer.BYTES);
            unpackBlock(codec, packed, at, shuffled, length, isSplit ? element : 1);
            if ((flags & BYTE_SHUFFLED) != 0 && element > 1) {
                unshuffleBytes(shuffled, result, from, length, element);
            } else if ((flags & BIT_SHUFFLED) != 0 && length / element % Byte.SIZE == 0) {
                unshuffleBits(shuffled, result, from, length, element);
            } else {
                System.arraycopy(shuffled, 0, result, from, length);
            }
        }
        return result;
    }

    private void unpackBlock(int codec, byte[] packed, int at, byte[] target, int length, int parts) {
        int part = length / parts;
        int p = at;
        for (int to = 0; to < length; to += part) {
            check(p >= HEADER_BYTES && p <= packed.length - Integer.BYTES, "a block must lie within its chunk");
            int size = (int) INT.get(packed, p);
            p += Integer.BYTES;
            check(size >= 0 && size <= packed.length - p, "a block must lie within its chunk");
            if (size == part) {
                System.arraycopy(packed, p, target, to, part);
            } else {
                check(unpack(codec, packed, p, size, target, to, part) == part, "a block must be whole");
            }
            p += size;
        }
    }

    private int unpack(int codec, byte[] packed, int from, int size, byte[] target, int to, int length) {
        try {
            switch (codec) {
                case LZ4:
                    return lz4.decompress(packed, from, size, target, to, length);
                case ZSTD:
                    return (int) Zstd.decompressByteArray(target, to, length, packed, from, size);
                default:
                    return inflate(packed, from, size, target, to, length);
            }
        } catch (LZ4Exception | ZstdException | DataFormatException e) {
            throw new HdfFilterException("Blosc: a block cannot be unpacked: " + e.getMessage(), e);
        }
    }

    private static int inflate(byte[] packed, int from, int size, byte[] target, int to, int length)
            throws DataFormatException {
        Inflater inflater = new Inflater();
        try {
            inflater.setInput(packed, from, size);
            return inflater.inflate(target, to, length);
        } finally {
            inflater.end();
        }
    }

    /**
     * Undoes the shuffling of bytes: the first bytes of all elements precede all second bytes, and so on. Bytes that
     * make no whole element come last, as they are.
     */
    private static void unshuffleBytes(byte[] shuffled, byte[] target, int from, int length, int element) {
        int count = length / element;
        int source = 0;
        for (int k = 0; k < element; k++) {
            for (int i = 0, to = from + k; i < count; i++, to += element) {
                target[to] = shuffled[source++];
            }
        }
        System.arraycopy(shuffled, source, target, from + source, length - source);
    }

    /**
     * Undoes the shuffling of bits: the first bits of all elements precede all second bits, and so on. The number of
     * elements is a multiple of 8, so that these bits fill whole bytes.
     */
    private static void unshuffleBits(byte[] shuffled, byte[] target, int from, int length, int element) {
        int count = length / element;
        int rowBytes = count / Byte.SIZE;
        Arrays.fill(target, from, from + count * element, (byte) 0);
        for (int k = 0; k < element * Byte.SIZE; k++) {
            int bit = k % Byte.SIZE;
            int to = from + k / Byte.SIZE;
            for (int i = 0; i < rowBytes; i++) {
                int eight = shuffled[k * rowBytes + i];
                for (int j = 0; j < Byte.SIZE; j++, to += element) {
                    target[to] |= (byte) ((eight >>> j & 1) << bit);
                }
            }
        }
        int done = count * element;
        System.arraycopy(shuffled, done, target, from + done, length - done);
    }

    private static void check(boolean holds, String rule) {
        if (!holds) {
            throw new HdfFilterException("Blosc: " + rule);
        }
    }
}
