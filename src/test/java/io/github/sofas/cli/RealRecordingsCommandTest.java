package io.github.sofas.cli;

import static org.junit.Assert.assertArrayEquals;
import static org.junit.Assert.assertEquals;
import static org.junit.Assert.assertTrue;

import com.fasterxml.jackson.core.JsonFactory;
import com.fasterxml.jackson.core.JsonParser;
import com.fasterxml.jackson.core.JsonToken;
import io.github.sofas.Skipped;
import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.List;
import java.util.Map;
import java.util.TreeMap;
import java.util.stream.Stream;
import org.junit.Before;
import org.junit.Rule;
import org.junit.Test;
import org.junit.rules.TemporaryFolder;

/** The commands on recordings of real cameras, which the project may not hold itself. */
public class RealRecordingsCommandTest {
    private static final Path FOLDER = Path.of("..", "shared", "recordings");
    /** The chips of those that name none; of the others, {@code --chip} changes nothing. */
    private static final List<String> DAVIS240C = List.of("synthetic-square.aedat", "synthetic-bar-x.aedat",
        "synthetic-double-bar.aedat", "slider-depth.txt");
    private static final String CUT_SAMPLE = "[boxes-translation.aedat] event 162771 at byte 1748132: truncated, an "
        + "IMU sample must have 7 words but had 6";

    @Rule
    public final TemporaryFolder folder = new TemporaryFolder();

    private Path out;

    @Before
    public void needsTheFolder() {
        if (!Files.isDirectory(FOLDER)) {
            throw Skipped.because("needs " + FOLDER + ", which is not part of the project");
        }
        out = folder.getRoot().toPath().resolve("results");
    }

    private static String[] arguments(String command, String chip, Stream<String> names, String... more) {
        List<String> arguments = new ArrayList<>(List.of(command, "--chip", chip));
        arguments.addAll(List.of(more));
        names.map(name -> FOLDER.resolve(name).toString()).forEach(arguments::add);
        return arguments.toArray(new String[0]);
    }

    private Executed run(String chip, String... names) {
        return Executed.command(arguments("run", chip, Stream.of(names), "--out", out.toString(),
            "--name-with-extension", "--jobs", "2", "--quiet"));
    }

    /** Events by file name, as {@code info --json} tells them. */
    private static Map<String, Long> eventsByName(String chip, Stream<String> names) throws IOException {
        Executed info = Executed.command(arguments("info", chip, names, "--json"));
        assertEquals(info.err, 0, info.exitCode);
        Map<String, Long> events = new TreeMap<>();
        try (JsonParser json = new JsonFactory().createParser(info.out)) {
            String name = "";
            while (json.nextToken() != null) {
                if (json.currentToken() == JsonToken.VALUE_STRING && "file".equals(json.currentName())) {
                    name = Path.of(json.getText()).getFileName().toString();
                } else if (json.currentToken() == JsonToken.VALUE_NUMBER_INT && "events".equals(json.currentName())) {
                    events.put(name, json.getLongValue());
                }
            }
        }
        return events;
    }

    @Test
    public void countsTheEventsThatTheFoldersReadmeNames() throws IOException {
        Map<String, Long> expected = new TreeMap<>();
        expected.put("boxes-translation.aedat", 162_771L);
        expected.put("building.aedat", 115_839L);
        expected.put("cars-first-170ms.aedat4", 6_676L);
        expected.put("cars-zstd.aedat4", 78_830L);
        expected.put("cars.aedat", 78_830L);
        expected.put("cars.aedat4", 78_830L);
        expected.put("dark-box-8s.aedat1.dat", 123_702L);
        expected.put("dark-box-8s.aedat2.aedat", 123_702L);
        expected.put("dark-box-8s.aedat3.aedat", 123_702L);
        expected.put("dark-box.aedat", 489_834L);
        expected.put("mouse-negative-time.aedat", 293_096L);
        expected.put("moving-head.aedat4", 323_963L);
        expected.put("pendulum-ball.aedat", 278_538L);
        expected.put("slider-depth.aedat", 50_000L);
        expected.put("slider-depth.txt", 50_000L);
        expected.put("standing-up.aedat", 290_292L);
        expected.put("stripes.aedat", 340_394L);
        expected.put("synthetic-bar-x.aedat", 10_000L);
        expected.put("synthetic-double-bar.aedat", 100_000L);
        expected.put("synthetic-square.aedat", 16_000L);
        expected.put("walking.aedat", 70_304L);
        Map<String, Long> actual = new TreeMap<>();
        actual.putAll(eventsByName("DAVIS240C", DAVIS240C.stream()));
        actual.putAll(eventsByName("DVS128", expected.keySet().stream().filter(name -> !DAVIS240C.contains(name))));
        assertEquals(expected, actual);
    }

    @Test
    public void givesTheSameFlowToOneSliceInThreeFormats() throws IOException {
        Executed run = run("DVS128", "dark-box-8s.aedat1.dat", "dark-box-8s.aedat2.aedat", "dark-box-8s.aedat3.aedat");
        assertEquals("", run.err);
        assertEquals(0, run.exitCode);
        for (String file : List.of(".flow.csv", ".segments.csv")) {
            byte[] aedat2 = Files.readAllBytes(out.resolve("dark-box-8s.aedat2.aedat" + file));
            assertArrayEquals(aedat2, Files.readAllBytes(out.resolve("dark-box-8s.aedat1.dat" + file)));
            assertArrayEquals(aedat2, Files.readAllBytes(out.resolve("dark-box-8s.aedat3.aedat" + file)));
        }
        assertEquals(123_702, rows("dark-box-8s.aedat2.aedat"));
    }

    @Test
    public void givesTheSameFlowToTheCarsWhateverTheirCompression() throws IOException {
        assertEquals(0, run("DVS128", "cars.aedat4", "cars-zstd.aedat4").exitCode);
        assertArrayEquals(Files.readAllBytes(out.resolve("cars.aedat4.flow.csv")),
            Files.readAllBytes(out.resolve("cars-zstd.aedat4.flow.csv")));
        assertEquals(78_830, rows("cars.aedat4"));
    }

    @Test
    public void reportsTheCutImuSampleOfASoundRun() throws IOException {
        Executed run = run("DVS128", "boxes-translation.aedat");
        assertEquals("[boxes-translation.aedat] the header names DAVIS240C, so --chip DVS128 was not used; "
            + "--force-chip uses it\n"
            + CUT_SAMPLE + "\n", run.err);
        assertEquals(0, run.exitCode);
        assertEquals(162_771, rows("boxes-translation.aedat"));
        String summary = Files.readString(out.resolve("boxes-translation.aedat.summary.json"));
        assertTrue(summary, summary.contains("\"imu_samples\" : 4833,"));
        assertTrue(summary, summary.contains("\"" + CUT_SAMPLE + "\""));
    }

    @Test
    public void keepsNegativeTimesInTheRows() throws IOException {
        Executed run = run("DVS128", "mouse-negative-time.aedat");
        assertEquals("", run.err);
        assertEquals(0, run.exitCode);
        List<String> rows = Files.readAllLines(out.resolve("mouse-negative-time.aedat.flow.csv"));
        assertEquals(293_096 + 1, rows.size());
        assertTrue(rows.get(1), rows.get(1).startsWith("-1293810339,"));
        assertTrue(rows.get(293_096), rows.get(293_096).startsWith("-1275385039,"));
    }

    private int rows(String name) throws IOException {
        return Files.readAllLines(out.resolve(name + ".flow.csv")).size() - 1;
    }
}
