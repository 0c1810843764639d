package io.github.sofas.recording;

import com.github.luben.zstd.Zstd;
import com.github.luben.zstd.ZstdException;
import io.jhdf.exceptions.HdfFilterException;
import io.jhdf.filter.Filter;

/** Unpacks chunks of HDF5 that are Zstandard frames (filter 32015). Safe for many threads. */
final class ZstdFilter implements Filter {
    private static final int ID = 32015;
    private static final int MOST_BYTES = 128 << 20;

    @Override
    public int getId() {
        return ID;
    }

    @Override
    public String getName() {
        return "zstd";
    }

    @Override
    public byte[] decode(byte[] packed, int[] settings) {
        long bytes = Zstd.getFrameContentSize(packed);
        if (bytes < 0 || bytes > MOST_BYTES) {
            throw new HdfFilterException("Zstandard: a chunk must say its size, of at most " + MOST_BYTES + " bytes");
        }
        try {
            byte[] result = new byte[(int) bytes];
            if (Zstd.decompress(result, packed) == bytes) {
                return result;
            }
        } catch (ZstdException e) {
            throw new HdfFilterException("Zstandard: a chunk cannot be unpacked: " + e.getMessage(), e);
        }
        throw new HdfFilterException("Zstandard: a chunk must be whole");
    }
}
