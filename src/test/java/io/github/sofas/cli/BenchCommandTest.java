package io.github.sofas.cli;

import static org.junit.Assert.assertEquals;
import static org.junit.Assert.assertTrue;

import com.fasterxml.jackson.core.JsonFactory;
import com.fasterxml.jackson.core.JsonParser;
import com.fasterxml.jackson.core.JsonToken;
import java.io.PrintWriter;
import java.io.StringWriter;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.List;
import java.util.stream.IntStream;
import org.junit.Before;
import org.junit.Rule;
import org.junit.Test;
import org.junit.rules.TemporaryFolder;

public class BenchCommandTest {
    @Rule
    public final TemporaryFolder folder = new TemporaryFolder();

    private final StringWriter out = new StringWriter();
    private final StringWriter err = new StringWriter();
    private Path edge;

    @Before
    public void writeEdge() throws Exception {
        edge = folder.getRoot().toPath().resolve("edge.txt");
        Files.write(edge, IntStream.range(0, 128)
            .mapToObj(i -> String.format("0.%06d %d %d 1", i / 8 * 10_000 + i % 8, i / 8, i % 8)).toList());
    }

    private int bench(String... arguments) {
        List<String> all = new ArrayList<>(List.of("bench", "--sample-ms", "0", "--warm-up", "1", "--warm-up-ms", "0",
            "--chip", "16x16"));
        all.addAll(List.of(arguments));
        return Main.execute(new PrintWriter(out, true), new PrintWriter(err, true), all.toArray(String[]::new));
    }

    /** The names on the way to each number and text of the output. */
    private List<String> jsonPaths() throws Exception {
        List<String> paths = new ArrayList<>();
        try (JsonParser parser = new JsonFactory().createParser(out.toString())) {
            for (JsonToken token = parser.nextToken(); token != null; token = parser.nextToken()) {
                if (token.isScalarValue()) {
                    paths.add(parser.getParsingContext().pathAsPointer().toString());
                }
            }
        }
        return paths;
    }

    @Test
    public void jsonHasTheMachineAndEveryPartOfEachRecording() throws Exception {
        assertEquals(err.toString(), Main.OK, bench("--json", "--preset", "paper", edge.toString(), edge.toString()));
        List<String> paths = jsonPaths();
        assertTrue(paths.contains("/machine/cpu"));
        assertTrue(paths.contains("/recordings/0/recording"));
        for (String part : List.of("engine", "engine_helped", "decode", "csv", "run")) {
            assertTrue(part, paths.contains("/recordings/0/" + part + "/median_events_per_s"));
        }
        assertTrue("a recording named twice is measured once", paths.stream().noneMatch(p -> p.contains("/1/")));
        assertEquals("", err.toString());
    }

    @Test
    public void textStartsWithTheMachine() {
        assertEquals(err.toString(), Main.OK, bench(edge.toString()));
        List<String> lines = out.toString().lines().toList();
        assertTrue(lines.get(0), lines.get(0).startsWith("machine  "));
        assertTrue(lines.get(3), lines.get(3).startsWith(edge + ": text, 16x16, 128 events, "));
    }

    @Test
    public void aDamagedRecordingFailsAndTheOthersAreMeasured() throws Exception {
        Path bad = Files.write(folder.getRoot().toPath().resolve("bad.txt"), List.of("0.001 1 1 1", "0 1 1"));
        assertEquals(Main.FAILED, bench("--json", bad.toString(), edge.toString()));
        assertEquals("[bad.txt] line 2: malformed, expected \"t x y polarity\" but found 3 fields: \"0 1 1\"\n",
            err.toString());
        assertTrue(jsonPaths().contains("/recordings/0/run/checksum"));
    }

    @Test
    public void fewerThanFiveRunsAreRefused() {
        assertEquals(Main.USAGE, bench("--runs", "4", edge.toString()));
        assertEquals("--runs must be at least 5 but was 4\nTry 'sofas bench --help'.\n", err.toString());
    }
}
