package io.github.sofas.recording;

import static org.junit.Assert.assertArrayEquals;
import static org.junit.Assert.assertEquals;
import static org.junit.Assert.assertThrows;

import com.github.luben.zstd.Zstd;
import io.jhdf.exceptions.HdfException;
import io.jhdf.filter.Filter;
import java.nio.ByteBuffer;
import java.nio.ByteOrder;
import java.util.Arrays;
import java.util.HexFormat;
import java.util.Map;
import org.junit.Test;

/** The codecs of HDF5 chunks, on chunks that their own encoders made. */
public class Hdf5FilterTest {
    private static byte[] unpack(Filter filter, String hex) {
        return filter.decode(HexFormat.of().parseHex(hex), new int[0]);
    }

    /** 1000 nine times, 1001 nine times, and so on, in four bytes each. */
    private static byte[] ninefold(int count) {
        ByteBuffer bytes = ByteBuffer.allocate(4 * count).order(ByteOrder.LITTLE_ENDIAN);
        for (int i = 0; i < count; i++) {
            bytes.putInt(1000 + i / 9);
        }
        return bytes.array();
    }

    /** Chunks by c-blosc 1.21, as h5py with hdf5plugin writes them. */
    @Test public void unpacksBlosc() {
        Map<String, String> packed = Map.of(
            "LZ4, bytes shuffled", "0201310440010000400100004c000000140000003400000014e8010014e9010014ea010014eb0100"
                + "14ec010014ed010014ee010014ef010013f001001f0301003c1f00010087500000000000",
            "LZ4, not shuffled", "0201300440010000400100004e00000014000000360000004fe803000004000d1fe90400101fea040010"
                + "1feb0400101fec0400101fed0400101fee0400101fef0400101ff00400075000f0030000",
            "Zstandard, bytes shuffled", "0201910440010000400100003f000000140000002700000028b52ffd604000ed000060e8e9ea"
                + "ebecedeeeff00300000b9010f00e001b8a917bcf7befbd9706",
            "Zstandard, bits shuffled", "0201940440010000400100004b000000140000003300000028b52ffd6040004d01002202070ef0"
                + "1903d27a8f44ed7297b9b16c0af7deb6f67f4b47f1ef48c5411e041000584a8e57d8441e",
            "zlib, bytes shuffled", "0201710440010000400100003f000000140000002700000078da7bf1020a5ec2c02b18780d036f60e0"
                + "2d0cbc8381f730f0010a98a90c18063900007a1b4aad");
        packed.forEach((name, chunk) -> assertArrayEquals(name, ninefold(80), unpack(new BloscFilter(), chunk)));
        // 83 elements make no whole bytes of bits, so that c-blosc leaves them as they are
        assertArrayEquals(ninefold(83), unpack(new BloscFilter(), "020194044c0100004c01000049000000140000003100000028"
            + "b52ffd604c003d0100a0e8030000e9eaebecedeeeff0f1030000f103000009a810e875d00f10feffaf441f0018c6a514"));
        // bytes that were not packed at all
        assertArrayEquals(new byte[] {7, 8}, unpack(new BloscFilter(), "02010201020000000200000012000000" + "0708"));
    }

    @Test public void refusesBloscOfOtherCodecs() {
        HdfException refused = assertThrows(HdfException.class, () -> unpack(new BloscFilter(),
            "0201110440010000400100004c000000140000003400000023e8e8e8e8600300e9c00000eac00000ebc00000ecc00000edc00000"
            + "eec00000efc00000f0a0000003e046000000e09400010000"));
        assertEquals("Blosc must pack by LZ4, zlib or Zstandard but did by BloscLZ; h5repack -f GZIP=5 packs it anew",
            refused.getMessage());
    }

    @Test public void unpacksZstandard() {
        byte[] bytes = ninefold(100);
        assertArrayEquals(bytes, new ZstdFilter().decode(Zstd.compress(bytes), new int[0]));
    }

    private static byte[] events(long[]... txyp) {
        ByteBuffer bytes = ByteBuffer.allocate(16 * txyp.length).order(ByteOrder.LITTLE_ENDIAN);
        for (long[] event : txyp) {
            bytes.putShort((short) event[1]).putShort((short) event[2]).putShort((short) event[3]).putShort((short) 0)
                .putLong(event[0]);
        }
        return bytes.array();
    }

    /** Chunks by the encoder of prophesee-ai/hdf5_ecf. */
    @Test public void unpacksEcfOfEachKind() {
        assertArrayEquals("rows, columns and polarities together",
            events(new long[] {10, 1, 2, 1}, new long[] {10, 300, 200, 0}, new long[] {11, 5, 3, 1},
                new long[] {40, 1279, 719, 1}, new long[] {5000, 7, 4, 0}),
            unpack(new EcfFilter(), "160000000a000000000000000211fdf101f0f6f3f101580320000b30820cfff92c00000e4000000000"
                + "0000000000"));
        long[][] eight = new long[8][];
        for (int i = 0; i < 8; i += 4) {
            eight[i] = new long[] {10, 7, 9, 1};
            eight[i + 1] = new long[] {10, 300, 9, 0};
            eight[i + 2] = new long[] {10, 20, 9, 0};
            eight[i + 3] = new long[] {10, 1279, 9, 1};
        }
        assertArrayEquals("columns and polarities together", events(eight),
            unpack(new EcfFilter(), "210000000a00000000000000082801f8002825ff09f8002825ff09"));
        int[] columns = {7, 8, 9, 12, 100, 101, 105, 3};
        for (int i = 0; i < 8; i++) {
            eight[i] = new long[] {100 + i, columns[i], 9, 1};
        }
        assertArrayEquals("columns with masks", events(eight),
            unpack(new EcfFilter(), "20000000640000000000000001111111111111112801f900910c600088"));
        long[][] forty = new long[40][];
        Arrays.fill(forty, new long[] {1L << 40, 5, 9, 1});
        assertArrayEquals("long runs", events(forty), unpack(new EcfFilter(), "a100000000000000000100000f28003f012800"
            + "bb000b000b00".repeat(10)));
    }

    @Test public void damageIsAnHdfExceptionAndNothingElse() {
        String ecf = "20000000640000000000000001111111111111112801f900910c600088";
        String blosc = "0201910440010000400100003f000000140000002700000028b52ffd604000ed000060e8e9eaebecedeeeff003000"
            + "00b9010f00e001b8a917bcf7befbd9706";
        Map<Filter, String> chunks = Map.of(new EcfFilter(), ecf, new BloscFilter(), blosc);
        chunks.forEach((filter, hex) -> {
            byte[] whole = HexFormat.of().parseHex(hex);
            for (int i = 0; i < whole.length; i++) {
                byte[] cut = Arrays.copyOf(whole, i);
                assertThrows(HdfException.class, () -> filter.decode(cut, new int[0]));
                for (int bit = 0; bit < 8; bit++) {
                    byte[] spoiled = whole.clone();
                    spoiled[i] ^= (byte) (1 << bit);
                    try {
                        filter.decode(spoiled, new int[0]);
                    } catch (HdfException e) {
                        // what spoils the codec is named; what spoils a value is another value
                        continue;
                    }
                }
            }
        });
    }
}
