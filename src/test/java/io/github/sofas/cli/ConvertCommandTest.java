package io.github.sofas.cli;

import static org.junit.Assert.assertArrayEquals;
import static org.junit.Assert.assertEquals;
import static org.junit.Assert.assertFalse;
import static org.junit.Assert.assertTrue;

import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.Arrays;
import java.util.List;
import org.junit.Rule;
import org.junit.Test;
import org.junit.rules.TemporaryFolder;

public class ConvertCommandTest {
    private static final Path HEXAGON = Path.of("recordings", "hexagon.aedat");

    @Rule
    public final TemporaryFolder folder = new TemporaryFolder();

    private Path root() {
        return folder.getRoot().toPath();
    }

    private Executed convert(Path recording, String to, String... more) {
        List<String> arguments = new ArrayList<>(List.of("convert", recording.toString(), "--to", to, "--out",
            root().toString()));
        arguments.addAll(List.of(more));
        return Executed.command(arguments.toArray(new String[0]));
    }

    @Test
    public void csvAndBackGivesTheRecordingItself() throws IOException {
        Executed there = convert(HEXAGON, "csv");
        assertEquals("hexagon.csv: 26101 events\n", there.err);
        assertEquals(0, there.exitCode);
        List<String> lines = Files.readAllLines(root().resolve("hexagon.csv"));
        assertEquals("t_us,x,y,polarity", lines.get(0));
        assertEquals(26_102, lines.size());
        assertEquals(0, convert(root().resolve("hexagon.csv"), "aedat2", "--chip", "DAVIS240C").exitCode);
        assertArrayEquals(Files.readAllBytes(HEXAGON), Files.readAllBytes(root().resolve("hexagon.aedat")));
    }

    @Test
    public void writesTheTablesOfNumPyAndParquet() throws IOException {
        for (String format : List.of("npz", "parquet")) {
            assertEquals(0, convert(HEXAGON, format).exitCode);
            assertTrue(Files.size(root().resolve("hexagon." + format)) > 10_000);
        }
    }

    @Test
    public void takesTheSmallestChipThatHoldsTheSensorAndSaysSo() throws IOException {
        Path text = Files.writeString(root().resolve("a.csv"), "t_us,x,y,p\n1,2,3,1\n5,299,4,0\n");
        Executed small = convert(text, "aedat2", "--chip", "300x200");
        assertEquals("[a.csv] AEDAT 2.0 has no chip of 300x200; written as of a Davis346red, 346x260, at its upper "
            + "left\na.aedat: 2 events\n", small.err);
        Executed large = convert(text, "aedat2", "--chip", "1280x720", "--force");
        assertEquals("[a.csv] unsupported, AEDAT 2.0 has no chip of 1280x720; --to csv, npz or parquet take any\n",
            large.err);
        assertEquals(1, large.exitCode);
    }

    @Test
    public void damageGivesTheEventsBeforeItAndExitCode1() throws IOException {
        byte[] bytes = Files.readAllBytes(HEXAGON);
        Path cut = Files.write(root().resolve("cut.aedat"), Arrays.copyOf(bytes, bytes.length - 3));
        Executed damaged = convert(cut, "csv");
        assertEquals(1, damaged.exitCode);
        assertTrue(damaged.err, damaged.err.contains("truncated, a record must have 8 bytes but had 5"));
        assertEquals(26_101, Files.readAllLines(root().resolve("cut.csv")).size());
    }

    @Test
    public void refusesItsOwnInputAndWhatExists() throws IOException {
        Path text = Files.writeString(root().resolve("a.csv"), "t_us,x,y,p\n1,2,3,1\n");
        assertEquals("[" + text + "] is read and cannot be written\nTry 'sofas convert --help'.\n",
            convert(text, "csv", "--chip", "DVS128", "--force").err);
        Files.writeString(root().resolve("hexagon.npz"), "mine");
        assertEquals(2, convert(HEXAGON, "npz").exitCode);
        assertEquals("--to must be aedat2, csv, npz or parquet but was xlsx\nTry 'sofas convert --help'.\n",
            convert(HEXAGON, "xlsx").err);
        assertFalse(Files.exists(root().resolve("hexagon.xlsx")));
    }
}
