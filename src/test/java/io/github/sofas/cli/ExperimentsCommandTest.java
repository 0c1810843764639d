package io.github.sofas.cli;

import static org.junit.Assert.assertEquals;
import static org.junit.Assert.assertFalse;
import static org.junit.Assert.assertTrue;

import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
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
        assertUsage("Missing required option: '--out=DIR'", "experiments");
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
        assertEquals(1, executed.exitCode);
        assertTrue(executed.err, executed.err.startsWith("[" + out + "] cannot be written: "));
    }
}
