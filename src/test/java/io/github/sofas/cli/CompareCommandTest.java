package io.github.sofas.cli;

import static org.junit.Assert.assertEquals;
import static org.junit.Assert.assertTrue;

import java.io.PrintWriter;
import java.io.StringWriter;
import org.junit.Test;

public class CompareCommandTest {
    private final StringWriter err = new StringWriter();

    private int run(String... arguments) {
        return Main.execute(new PrintWriter(new StringWriter()), new PrintWriter(err, true), arguments);
    }

    @Test
    public void needsAFolderOfJaer() {
        assertEquals(Main.USAGE, run("compare", "recordings/short-bar.aedat"));
        assertTrue(err.toString(), err.toString().startsWith("Missing required option: '--jaer=DIR'"));
    }

    @Test
    public void saysWhichFileIsMissing() {
        assertEquals(Main.USAGE, run("compare", "recordings/short-bar.aedat", "--jaer", "no-such-folder"));
        assertEquals("[no-such-folder] no such file or folder\nTry 'sofas compare --help'.",
            err.toString().strip().replace("\r\n", "\n"));
    }

    @Test
    public void saysThatThePluginIsMissing() {
        assertEquals(Main.USAGE,
            run("compare", "recordings/short-bar.aedat", "--jaer", "recordings", "--plugin", "no-such.jar"));
        assertTrue(err.toString(),
            err.toString().startsWith("[no-such.jar] no such file; --plugin names sofas-jAER.jar"));
    }

    @Test
    public void refusesALookAheadOutsideItsRangeBeforeAnythingRuns() {
        assertEquals(Main.USAGE,
            run("compare", "recordings/short-bar.aedat", "--jaer", "recordings", "--look-ahead", "3"));
        assertTrue(err.toString(), err.toString().startsWith("--look-ahead must be 4 to 10000 but was 3"));
    }

    @Test
    public void refusesWhatNoRecordingIsReadWithBeforeAnythingRuns() {
        assertEquals(Main.USAGE,
            run("compare", "recordings/short-bar.aedat", "--jaer", "recordings", "--time", "h"));
        assertTrue(err.toString(), err.toString().startsWith("--time must be s, ms, us or ns but was h"));
    }
}
