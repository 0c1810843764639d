package io.github.sofas.recording;

import com.github.luben.zstd.ZstdDecompressCtx;
import com.github.luben.zstd.ZstdException;
import io.github.sofas.recording.Aedat4Format.Compression;
import java.io.Closeable;
import java.nio.ByteBuffer;
import java.util.Arrays;

/**
 * Unpacks payloads of AEDAT 4.0, plain or packed by LZ4 or Zstandard. The output array is reused and grows with the
 * data that is there. Bytes that were unpacked before damage are kept.
 */
final class PacketUnpacker implements Closeable {
    private static final int CHUNK_BYTES = 1 << 16;

    private final Compression compression;
    private final int maxBytes;
    private final Lz4FrameDecoder lz4 = new Lz4FrameDecoder();
    private final ByteBuffer packedChunk;
    private final ByteBuffer unpackedChunk;
    private final ZstdDecompressCtx zstd;
    private byte[] output = new byte[0];
    private int length;
    private String fault;

    PacketUnpacker(Compression compression, int maxBytes) {
        this.compression = compression;
        this.maxBytes = maxBytes;
        boolean usesZstd = compression == Compression.ZSTD || compression == Compression.ZSTD_HIGH;
        zstd = usesZstd ? new ZstdDecompressCtx() : null;
        packedChunk = usesZstd ? ByteBuffer.allocateDirect(CHUNK_BYTES) : null;
        unpackedChunk = usesZstd ? ByteBuffer.allocateDirect(2 * CHUNK_BYTES) : null;
    }

    /** The unpacked bytes; entries from {@link #length()} on are meaningless. Valid until the next {@link #unpack}. */
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

    /** Unpacks the first bytes of an array; without compression the array itself is the output. */
    void unpack(byte[] packed, int packedLength) {
        switch (compression) {
            case NONE:
                output = packed;
                length = packedLength;
                fault = null;
                break;
            case LZ4:
            case LZ4_HIGH:
                lz4.decode(packed, 0, packedLength, maxBytes);
                output = lz4.output();
                length = lz4.length();
                fault = lz4.fault();
                break;
            default:
                unpackZstd(packed, packedLength);
                break;
        }
    }

    private void unpackZstd(byte[] packed, int packedLength) {
        length = 0;
        fault = null;
        zstd.reset();
        int fed = 0;
        boolean whole = false;
        packedChunk.clear().flip();
        try {
            while (!whole) {
                if (!packedChunk.hasRemaining()) {
                    if (fed == packedLength) {
                        fault = "truncated, a ZSTD frame must be whole but ends after " + packedLength + " bytes";
                        return;
                    }
                    int bytes = Math.min(CHUNK_BYTES, packedLength - fed);
                    packedChunk.clear().put(packed, fed, bytes).flip();
                    fed += bytes;
                }
                boolean full;
                do {
                    unpackedChunk.clear();
                    whole = zstd.decompressDirectByteBufferStream(unpackedChunk, packedChunk);
                    full = !unpackedChunk.hasRemaining();
                    if (!append()) {
                        return;
                    }
                    // A full chunk may leave more data inside the decoder, even after the last byte was fed.
                } while (!whole && full);
            }
        } catch (ZstdException e) {
            fault = "malformed, a ZSTD frame cannot be unpacked: " + e.getMessage();
        }
    }

    private boolean append() {
        unpackedChunk.flip();
        int bytes = unpackedChunk.remaining();
        if (bytes > maxBytes - length) {
            fault = "unsupported, a packet must unpack to at most " + maxBytes + " bytes";
            return false;
        }
        if (output.length - length < bytes) {
            int roomy = Math.min(maxBytes, output.length + (output.length >> 1));
            output = Arrays.copyOf(output, Math.max(length + bytes, roomy));
        }
        unpackedChunk.get(output, length, bytes);
        length += bytes;
        return true;
    }

    @Override
    public void close() {
        if (zstd != null) {
            zstd.close();
        }
    }
}
