package io.github.sofas.cli;

import static org.junit.Assert.assertEquals;
import static org.junit.Assert.assertTrue;

import io.github.sofas.Skipped;
import java.nio.file.Files;
import java.nio.file.Path;
import org.junit.Rule;
import org.junit.Test;
import org.junit.rules.TemporaryFolder;

public class PipeTest {
    @Rule
    public final TemporaryFolder folder = new TemporaryFolder();

    @Test(timeout = 60_000)
    public void whoeverWaitsForAPipeIsToldAndThenReadsIt() throws Exception {
        Path pipe = folder.getRoot().toPath().resolve("pipe.aedat");
        try {
            if (new ProcessBuilder("mkfifo", pipe.toString()).start().waitFor() != 0) {
                throw Skipped.because("this system makes no pipes");
            }
        } catch (java.io.IOException e) {
            throw Skipped.because("this system makes no pipes: " + e.getMessage());
        }
        Process writer = new ProcessBuilder("sh", "-c", "cat recordings/hexagon.aedat > \"$1\"", "sh", pipe.toString())
            .start();
        Executed info = Executed.command("info", pipe.toString());
        assertEquals(0, writer.waitFor());
        assertTrue(info.err, info.err.startsWith("[pipe.aedat] is no file but a pipe or a device: waiting for what is "
            + "written to it\n"));
        assertTrue(info.out, info.out.contains("dvs events:          26101\n"));
        assertEquals(info.err, 0, info.exitCode);
        assertTrue(Files.exists(pipe));
    }
}
