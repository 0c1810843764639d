package io.github.sofas.export;

import static org.junit.Assert.assertArrayEquals;
import static org.junit.Assert.assertEquals;
import static org.junit.Assert.assertTrue;

import io.github.sofas.Python;
import io.github.sofas.event.EventBatch;
import io.github.sofas.flow.FlowOutput;
import java.io.IOException;
import java.nio.ByteBuffer;
import java.nio.ByteOrder;
import java.nio.charset.StandardCharsets;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.Arrays;
import java.util.List;
import java.util.Locale;
import java.util.Map;
import java.util.Random;
import java.util.Set;
import java.util.TreeSet;
import java.util.stream.Collectors;
import java.util.stream.Stream;
import java.util.zip.ZipEntry;
import java.util.zip.ZipFile;
import org.junit.Rule;
import org.junit.Test;
import org.junit.rules.TemporaryFolder;

/** Tables in each format hold the same; the readers of Python say what is in them. */
public class TableFormatTest {
    private static final Map<String, String> METADATA = Map.of("recording", "caf\u00e9.aedat");

    @Rule
    public final TemporaryFolder folder = new TemporaryFolder();

    private Path root() {
        return folder.getRoot().toPath();
    }

    /** Events with and without flow, from before zero to beyond 32 bits of time. */
    private void write(TableFormat format, int events, int batchSize) throws IOException {
        Random random = new Random(1);
        EventBatch batch = new EventBatch(batchSize);
        FlowOutput flow = new FlowOutput(batchSize);
        long timeUs = -5;
        Path file = root().resolve("a.flow." + format.extension());
        try (ResultFiles results = new ResultFiles(true)) {
            try (FlowWriter writer = FlowTable.open(format, results, file, METADATA)) {
                for (int i = 0; i < events; i++) {
                    int n = batch.size();
                    batch.add(timeUs, random.nextInt(1280), random.nextInt(720), random.nextBoolean() ? 1 : -1);
                    flow.segment[n] = random.nextInt(4);
                    // thousandths, so that CSV has them exactly
                    flow.vxPxPerS[n] = flow.segment[n] == 0 ? 0 : (random.nextInt(200_000) - 100_000) / 64f;
                    flow.vyPxPerS[n] = flow.segment[n] == 0 ? 0 : -flow.vxPxPerS[n] / 2;
                    timeUs += i == 3 ? 1L << 40 : random.nextInt(100);
                    if (batch.isFull() || i == events - 1) {
                        writer.write(batch, flow);
                        batch.clear();
                    }
                }
            }
            results.commit();
        }
    }

    @Test
    public void theSameRowsGiveTheSameBytesHoweverTheyAreCut() throws IOException {
        for (TableFormat format : TableFormat.values()) {
            Path file = root().resolve("a.flow." + format.extension());
            write(format, 40_000, 4096);
            byte[] first = Files.readAllBytes(file);
            write(format, 40_000, 77);
            assertArrayEquals(format.name(), first, Files.readAllBytes(file));
            Files.delete(file);
        }
        try (Stream<Path> left = Files.list(root())) {
            assertEquals("nothing is left beside the results", 0, left.count());
        }
    }

    @Test
    public void parquetIsAThirdOfTheCsvAtMost() throws IOException {
        write(TableFormat.CSV, 100_000, 4096);
        write(TableFormat.PARQUET, 100_000, 4096);
        long csv = Files.size(root().resolve("a.flow.csv"));
        long parquet = Files.size(root().resolve("a.flow.parquet"));
        assertTrue(parquet + " of " + csv, 3 * parquet <= csv);
    }

    /** NumPy's format 1.0: magic, length of the header, a header in words, numbers. */
    @Test
    public void npzHoldsNumPysArrays() throws IOException {
        write(TableFormat.NPZ, 5, 2);
        try (ZipFile zip = new ZipFile(root().resolve("a.flow.npz").toFile())) {
            assertEquals(List.of("t_us.npy", "x.npy", "y.npy", "polarity.npy", "vx_px_per_s.npy", "vy_px_per_s.npy",
                "segment.npy", "recording.npy"), zip.stream().map(ZipEntry::getName).toList());
            byte[] times = zip.getInputStream(zip.getEntry("t_us.npy")).readAllBytes();
            assertArrayEquals(new byte[] {(byte) 0x93, 'N', 'U', 'M', 'P', 'Y', 1, 0, 118, 0},
                Arrays.copyOf(times, 10));
            assertEquals("{'descr': '<i8', 'fortran_order': False, 'shape': (5,), }",
                new String(times, 10, 118, StandardCharsets.US_ASCII).strip());
            assertEquals(128 + 5 * 8, times.length);
            assertEquals(-5, ByteBuffer.wrap(times).order(ByteOrder.LITTLE_ENDIAN).getLong(128));
        }
    }

    @Test
    public void pandasPyArrowNumPyAndH5pyReadEqualValues() throws Exception {
        for (TableFormat format : TableFormat.values()) {
            write(format, 70_000, 4096);
        }
        String program = """
            import sys
            import h5py, numpy, pandas, pyarrow.parquet
            csv = pandas.read_csv("a.flow.csv")
            parquet = pandas.read_parquet("a.flow.parquet")
            npz = numpy.load("a.flow.npz")
            types = dict(t_us="int64", x="int16", y="int16", polarity="int8", vx_px_per_s="float32",
                         vy_px_per_s="float32", segment="int32")
            assert list(parquet.columns) == list(csv.columns) == list(types), parquet.columns
            for name, kind in types.items():
                assert str(parquet[name].dtype) == str(npz[name].dtype) == kind, (name, parquet[name].dtype)
                assert len(csv) == len(npz[name]) == 70000
                assert numpy.array_equal(parquet[name].to_numpy(), npz[name], equal_nan=kind == "float32"), name
                # CSV has three decimals
                assert numpy.allclose(csv[name].to_numpy(), npz[name], rtol=0, atol=0.0006, equal_nan=True), name
            assert (parquet.segment == 0).equals(parquet.vx_px_per_s.isna())
            metadata = pyarrow.parquet.read_metadata("a.flow.parquet")
            assert metadata.metadata[b"recording"].decode() == npz["recording"].item().decode() == "caf\u00e9.aedat"
            with h5py.File("a.h5", "w") as file:
                for name in types:
                    file[name] = npz[name]
            print("equal")
            """;
        assertEquals("equal", Python.run(root(), program, "numpy", "pandas", "pyarrow", "h5py").strip());
    }

    @Test
    public void everyFormatIsKnownByItsName() {
        Set<String> names = Arrays.stream(TableFormat.values()).map(TableFormat::extension)
            .collect(Collectors.toCollection(TreeSet::new));
        assertEquals(Set.of("csv", "npz", "parquet"), names);
        names.forEach(name -> assertEquals(name,
            TableFormat.named(name.toUpperCase(Locale.ROOT)).orElseThrow().extension()));
        assertTrue(TableFormat.named("xlsx").isEmpty());
    }
}
