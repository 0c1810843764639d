package io.github.sofas.cli;

import static org.junit.Assert.assertEquals;
import static org.junit.Assert.assertFalse;
import static org.junit.Assert.assertNotEquals;
import static org.junit.Assert.assertTrue;

import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.List;
import org.junit.Before;
import org.junit.Rule;
import org.junit.Test;
import org.junit.rules.TemporaryFolder;

/** What is refused before anything runs; what is written stands in the experiments' own test. */
public class ExperimentsCommandTest {
    @Rule
    public final TemporaryFolder folder = new TemporaryFolder();

    private Path out;

    @Before
    public void names() {
        out = folder.getRoot().toPath().resolve("out");
    }

    private static void assertUsage(String message, String... arguments) {
        Executed executed = Executed.command(arguments);
        assertEquals(message + "\nTry 'sofas experiments --help'.\n", executed.err);
        assertEquals(2, executed.exitCode);
        assertEquals("", executed.out);
    }

    @Test
    public void needsAFolderForResults() {
        assertUsage("Missing required option: '--out=DIR', or for tables --random, --scenes, --recordings or "
            + "--ablation", "experiments");
    }

    @Test
    public void printsATableOfRandomScenes() {
        Executed one = Executed.command("experiments", "--random", "2", "--from-seed", "2", "--jobs", "1");
        assertEquals(one.err, 0, one.exitCode);
        List<String> lines = one.out.lines().toList();
        assertEquals(List.of("scene", "objects", "events", "IoU", "parts", "rEE,%", "flow,%", "fast,%", "noise,%",
            "growth,%", "ns/event"), List.of(lines.get(0).split(" +")));
        assertTrue(one.out, lines.get(1).startsWith("random:2  "));
        assertTrue(one.out, lines.get(2).startsWith("random:3  "));
        assertTrue(one.out, lines.get(3).startsWith("mean  "));
        Executed two = Executed.command("experiments", "--random", "2", "--from-seed", "2", "--jobs", "2");
        assertEquals("but for the times the same however many at a time", withoutTimes(one.out),
            withoutTimes(two.out));
    }

    private static List<String> withoutTimes(String table) {
        return table.lines().map(line -> line.replaceAll(" +\\S+$", "")).toList();
    }

    @Test
    public void tablesTakeTheMethodAndItsParameters() {
        Executed planes = Executed.command("experiments", "--random", "1", "--from-seed", "3", "--method",
            "local-planes");
        assertEquals(planes.err, 0, planes.exitCode);
        assertUsage("--preset needs --method sofas but was used with local-planes", "experiments", "--random", "1",
            "--method", "local-planes", "--preset", "paper");
        assertUsage("--random must be at least 1 but was 0", "experiments", "--random", "0");
    }

    @Test
    public void tablesTakeALookAhead() {
        // a scene in which a label at once is not as good as it can be
        String[] table = {"experiments", "--random", "1", "--from-seed", "2", "--jobs", "1", "--causal"};
        Executed causal = Executed.command(table);
        table[table.length - 1] = "--look-ahead=100";
        Executed ahead = Executed.command(table);
        assertEquals(ahead.err, 0, ahead.exitCode);
        assertNotEquals(withoutTimes(causal.out), withoutTimes(ahead.out));
        assertEquals(withoutTimes(ahead.out), withoutTimes(Executed.command(table).out));
        assertUsage("--look-ahead needs a table of one method: --random, --scenes or --recordings without --out",
            "experiments", "--out", "out", "--look-ahead", "100");
    }

    @Test
    public void tablesOfRecordingsKeepTheBestSingleTranslations() throws IOException {
        Path recordings = Files.createDirectories(out);
        Files.copy(Path.of("recordings", "hexagon.aedat"), recordings.resolve("hexagon.aedat"));
        Files.writeString(recordings.resolve("notes.md"), "no recording");
        Path translations = folder.getRoot().toPath().resolve("translations.csv");
        Executed first = Executed.command("experiments", "--recordings", recordings.toString(), "--translations",
            translations.toString());
        assertEquals("the notes cannot be read", 1, first.exitCode);
        assertTrue(first.err, first.err.startsWith("[notes.md] "));
        assertTrue(first.out, first.out.contains("\nhexagon.aedat  "));
        String found = Files.readString(translations);
        assertTrue(found, found.startsWith("recording,from_us,until_us,events,vx_px_per_s,vy_px_per_s\n"
            + "hexagon.aedat,"));
        Executed again = Executed.command("experiments", "--recordings", recordings.toString(), "--translations",
            translations.toString());
        assertEquals(withoutTimes(first.out), withoutTimes(again.out));
        assertEquals(found, Files.readString(translations));
    }

    @Test
    public void ablationHasALineForEachExtension() {
        Executed table = Executed.command("experiments", "--ablation", "--random", "1", "--from-seed", "3");
        assertEquals(table.err, 0, table.exitCode);
        List<String> lines = table.out.lines().toList();
        assertTrue(lines.get(0), lines.get(0).matches("switched-off +IoU +parts +rEE,% +flow,% +fast,% +ns/event"));
        assertTrue(lines.get(1), lines.get(1).startsWith("none  "));
        assertTrue(table.out, table.out.contains("\nmemoryPx  "));
        assertTrue(table.out, table.out.contains("\nrotation  "));
        assertUsage("--ablation needs --method sofas and --preset default", "experiments", "--ablation", "--preset",
            "paper");
    }

    @Test
    public void refusesNoJobsAtAll() {
        assertUsage("--jobs must be at least 1 but was 0", "experiments", "--out", out.toString(), "--jobs", "0");
        assertFalse(Files.exists(out));
    }

    @Test
    public void refusesAFolderOfRecordingsThatIsNone() {
        assertUsage("--recordings must be a directory but was \"" + out + "\"", "experiments", "--out", out.toString(),
            "--recordings", out.toString());
        assertFalse(Files.exists(out));
    }

    @Test
    public void refusesToReplaceResults() throws IOException {
        Files.createDirectories(out);
        Path page = Files.writeString(out.resolve("experiments.html"), "mine");
        assertUsage("[" + page + "] exists already; --force replaces it", "experiments", "--out", out.toString());
        assertEquals("mine", Files.readString(page));
    }

    @Test
    public void saysWhereResultsCannotBeWritten() throws IOException {
        Files.writeString(out, "a file");
        Executed executed = Executed.command("experiments", "--out", out.toString());
        assertEquals(2, executed.exitCode);
        assertTrue(executed.err, executed.err.startsWith("[" + out + "] cannot be made a directory: "));
    }
}
