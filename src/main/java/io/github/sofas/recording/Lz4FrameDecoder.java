package io.github.sofas.recording;

import java.lang.invoke.MethodHandles;
import java.lang.invoke.VarHandle;
import java.nio.ByteOrder;
import java.util.Arrays;

/**
 * Unpacks LZ4 frames (github.com/lz4/lz4, doc/lz4_Frame_format.md and lz4_Block_format.md) with linked or independent
 * blocks. Checksums are verified. All blocks go into one array, so that a match reaches back into earlier blocks
 * without a copy. Bytes that were unpacked before damage are kept. Frames that need a dictionary are not supported.
 *
 * <p>This is own code because libraries either refuse linked blocks, which recorders write (lz4-java), or are too slow
 * (commons-compress 1.28: 0.1 to 0.2 million events/s).
 */
final class Lz4FrameDecoder {
    private static final VarHandle SHORT = MethodHandles.byteArrayViewVarHandle(short[].class, ByteOrder.LITTLE_ENDIAN);
    private static final VarHandle INT = MethodHandles.byteArrayViewVarHandle(int[].class, ByteOrder.LITTLE_ENDIAN);
    private static final VarHandle LONG = MethodHandles.byteArrayViewVarHandle(long[].class, ByteOrder.LITTLE_ENDIAN);

    private static final int MAGIC = 0x184D2204;
    private static final int VERSION_MASK = 0xC0;
    private static final int VERSION = 0x40;
    private static final int INDEPENDENT = 0x20;
    private static final int BLOCK_CHECKSUM = 0x10;
    private static final int CONTENT_SIZE = 0x08;
    private static final int CONTENT_CHECKSUM = 0x04;
    private static final int RESERVED = 0x02;
    private static final int DICTIONARY = 0x01;
    private static final int MIN_MATCH = 4;
    private static final int LONG_RUN = 15;
    /** Bytes that a copy in steps of eight may write past the end of a block. */
    private static final int SLACK = 16;
    private static final int FIRST_BYTES = 1 << 16;

    private byte[] output = new byte[FIRST_BYTES];
    private int length;
    private String fault;
    private byte[] input;
    private int end;

    /** The unpacked bytes; entries from {@link #length()} on are meaningless. Valid until the next {@link #decode}. */
    byte[] output() {
        return output;
    }

    /** How many bytes were unpacked. */
    int length() {
        return length;
    }

    /** The fault, starting with truncated, malformed or unsupported; null if there was none. */
    String fault() {
        return fault;
    }

    /**
     * Unpacks one frame.
     *
     * @param maxBytes the greatest number of bytes to unpack, counted in whole blocks; the array grows with the data
     *     that is there, never by the size that a header announces
     */
    void decode(byte[] packed, int from, int to, int maxBytes) {
        input = packed;
        end = to;
        length = 0;
        fault = null;
        int p = from;
        if (to - p < 7) {
            fault = "truncated, an LZ4 frame must have at least 7 bytes but had " + (to - p);
            return;
        }
        int magic = (int) INT.get(packed, p);
        if (magic != MAGIC) {
            fault = String.format("malformed, an LZ4 frame must start with 0x%08X but started with 0x%08X", MAGIC,
                    magic);
            return;
        }
        int flags = packed[p + 4];
        int headerBytes = 7 + ((flags & CONTENT_SIZE) != 0 ? 8 : 0);
        int sizeCode = packed[p + 5] >>> 4 & 7;
        if ((flags & VERSION_MASK) != VERSION || (flags & (RESERVED | DICTIONARY)) != 0 || sizeCode < 4) {
            fault = String.format("unsupported, an LZ4 frame must have version 1, no dictionary and a known block size "
                    + "but had flags 0x%02X%02X", flags & 0xFF, packed[p + 5] & 0xFF);
            return;
        }
        if (to - p < headerBytes) {
            fault = "truncated, an LZ4 frame header must have " + headerBytes + " bytes but had " + (to - p);
            return;
        }
        int check = XxHash32.of(packed, p + 4, p + headerBytes - 1) >>> 8 & 0xFF;
        if (check != (packed[p + headerBytes - 1] & 0xFF)) {
            fault = String.format("malformed, an LZ4 frame header's checksum must be 0x%02X but was 0x%02X", check,
                    packed[p + headerBytes - 1] & 0xFF);
            return;
        }
        blocks(p + headerBytes, flags, 1 << 2 * sizeCode + 8, maxBytes);
    }

    private void blocks(int from, int flags, int maxBlockBytes, int maxBytes) {
        int p = from;
        int checksumBytes = (flags & BLOCK_CHECKSUM) != 0 ? 4 : 0;
        while (true) {
            if (end - p < 4) {
                fault = "truncated, an LZ4 frame must end with an end mark but the data ends";
                return;
            }
            int header = (int) INT.get(input, p);
            p += 4;
            if (header == 0) {
                break;
            }
            int size = header & Integer.MAX_VALUE;
            if (size > maxBlockBytes) {
                fault = "malformed, an LZ4 block must have at most " + maxBlockBytes + " bytes but had " + size;
                return;
            }
            int have = Math.min(size, end - p);
            if (checksumBytes != 0 && end - p >= size + checksumBytes
                    && XxHash32.of(input, p, p + size) != (int) INT.get(input, p + size)) {
                fault = "malformed, an LZ4 block's checksum does not match";
                return;
            }
            if (maxBytes - length < maxBlockBytes) {
                fault = "unsupported, a packet must unpack to at most " + maxBytes + " bytes";
                return;
            }
            reserve(maxBlockBytes, maxBytes);
            if (header < 0) {
                System.arraycopy(input, p, output, length, have);
                length += have;
            } else {
                block(p, p + have, (flags & INDEPENDENT) != 0 ? length : 0, length + maxBlockBytes);
            }
            if (have < size) {
                fault = "truncated, an LZ4 block must have " + size + " bytes but had " + have;
            }
            if (fault != null) {
                return;
            }
            p += size + checksumBytes;
        }
        if ((flags & CONTENT_CHECKSUM) == 0) {
            return;
        }
        if (end - p < 4) {
            fault = "truncated, an LZ4 frame must end with a checksum but the data ends";
        } else if (XxHash32.of(output, 0, length) != (int) INT.get(input, p)) {
            fault = "malformed, an LZ4 frame's content checksum does not match";
        }
    }

    private void reserve(int bytes, int maxBytes) {
        if (output.length - SLACK < length + bytes) {
            int roomy = Math.min(maxBytes + SLACK, output.length + (output.length >> 1));
            output = Arrays.copyOf(output, Math.max(length + bytes + SLACK, roomy));
        }
    }

    /**
     * Unpacks one block to {@code output[length]}. Copies run in steps of eight or sixteen bytes and may write up
     * to sixteen past their end, which stays inside the array because {@link #reserve} keeps slack beyond every limit.
     */
    private void block(int from, int blockEnd, int windowStart, int limit) {
        byte[] in = input;
        byte[] out = output;
        int p = from;
        int o = length;
        while (p < blockEnd) {
            int token = in[p++] & 0xFF;
            int literals = token >>> 4;
            if (literals == LONG_RUN) {
                int more;
                do {
                    if (p >= blockEnd) {
                        length = o;
                        fault = "malformed, an LZ4 block ends inside a run's length";
                        return;
                    }
                    more = in[p++] & 0xFF;
                    literals += more;
                } while (more == 0xFF && literals <= limit);
            }
            if (literals > blockEnd - p || literals > limit - o) {
                int whole = Math.max(0, Math.min(literals, Math.min(blockEnd - p, limit - o)));
                System.arraycopy(in, p, out, o, whole);
                length = o + whole;
                fault = "malformed, an LZ4 block's literals run past the end of the block";
                return;
            }
            if (literals <= 16 && p + 16 <= in.length) {
                LONG.set(out, o, (long) LONG.get(in, p));
                LONG.set(out, o + 8, (long) LONG.get(in, p + 8));
            } else {
                System.arraycopy(in, p, out, o, literals);
            }
            p += literals;
            o += literals;
            if (p == blockEnd) {
                // Only the last sequence of a block has no match.
                break;
            }
            if (blockEnd - p < 2) {
                length = o;
                fault = "malformed, an LZ4 block ends inside a match's offset";
                return;
            }
            int offset = (short) SHORT.get(in, p) & 0xFFFF;
            p += 2;
            int match = (token & LONG_RUN) + MIN_MATCH;
            if (match == LONG_RUN + MIN_MATCH) {
                int more;
                do {
                    if (p >= blockEnd) {
                        length = o;
                        fault = "malformed, an LZ4 block ends inside a run's length";
                        return;
                    }
                    more = in[p++] & 0xFF;
                    match += more;
                } while (more == 0xFF && match <= limit);
            }
            int source = o - offset;
            if (offset == 0 || source < windowStart) {
                length = o;
                fault = "malformed, an LZ4 match must reach back 1 to " + (o - windowStart) + " bytes but reached "
                        + offset;
                return;
            }
            if (match > limit - o) {
                length = o;
                fault = "malformed, an LZ4 match runs past the largest block";
                return;
            }
            int matchEnd = o + match;
            if (offset >= 8) {
                do {
                    LONG.set(out, o, (long) LONG.get(out, source));
                    o += 8;
                    source += 8;
                } while (o < matchEnd);
            } else {
                while (o < matchEnd) {
                    out[o++] = out[source++];
                }
            }
            o = matchEnd;
        }
        length = o;
    }
}
