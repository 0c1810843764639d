package io.github.sofas.cli;

import static org.junit.Assert.assertArrayEquals;
import static org.junit.Assert.assertEquals;
import static org.junit.Assert.assertTrue;

import io.github.sofas.Skipped;
import io.github.sofas.event.EventBatch;
import io.github.sofas.recording.Aedat2Writer;
import io.github.sofas.recording.Chip;
import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.nio.file.attribute.FileTime;
import java.util.ArrayList;
import java.util.Arrays;
import java.util.List;
import java.util.Set;
import java.util.TreeSet;
import org.junit.Before;
import org.junit.Rule;
import org.junit.Test;
import org.junit.rules.TemporaryFolder;

/** Batches that go on where they were stopped, and outputs that fail. */
public class ResumedRunTest {
    @Rule
    public final TemporaryFolder folder = new TemporaryFolder();

    private Path recordings;
    private Path out;

    @Before
    public void writesThreeRecordings() throws IOException {
        recordings = folder.newFolder("recordings").toPath();
        out = folder.getRoot().toPath().resolve("results");
        for (String name : List.of("a", "b", "c")) {
            write(recordings.resolve(name + ".aedat"), 40);
        }
    }

    private static void write(Path file, int events) throws IOException {
        EventBatch batch = new EventBatch(events);
        for (int i = 0; i < events; i++) {
            batch.add(1000L * i, 20 + i, 64, 1);
        }
        try (Aedat2Writer writer = new Aedat2Writer(file, Chip.named("DVS128").orElseThrow())) {
            writer.write(batch);
        }
    }

    private Executed run(String... more) {
        List<String> arguments = new ArrayList<>(List.of("run", recordings.toString(), "--out", out.toString()));
        arguments.addAll(List.of(more));
        return Executed.command(arguments.toArray(new String[0]));
    }

    /** The names of the recordings that were run, by their lines, and of those passed over with a minus. */
    private static List<String> names(Executed run) {
        return run.errLines().stream().filter(line -> !line.contains(": run again, because "))
            .map(line -> line.endsWith(": results are complete, skipped")
            ? "-" + line.charAt(0) : line.substring(0, 1)).toList();
    }

    private Set<String> files() {
        return new TreeSet<>(Arrays.asList(out.toFile().list()));
    }

    @Test
    public void passesOverWhatIsCompleteAndRunsTheRest() throws IOException {
        assertEquals(List.of("a", "b", "c"), names(run("--resume")));
        byte[] flow = Files.readAllBytes(out.resolve("b.flow.csv"));
        Files.delete(out.resolve("b.summary.json"));
        Files.writeString(out.resolve("b.flow.csv"), "half");
        Executed again = run("--resume");
        assertEquals(0, again.exitCode);
        assertEquals(List.of("-a", "-c", "b"), names(again));
        assertArrayEquals(flow, Files.readAllBytes(out.resolve("b.flow.csv")));
        assertEquals(List.of("-a", "-b", "-c"), names(run("--resume", "--jobs", "3")));
        assertEquals(List.of(), names(run("--resume", "--quiet")));
    }

    @Test
    public void runsARecordingAnewThatChanged() throws IOException {
        assertEquals(0, run().exitCode);
        write(recordings.resolve("a.aedat"), 50);
        Files.setLastModifiedTime(recordings.resolve("b.aedat"), FileTime.fromMillis(1_000_000));
        assertEquals(List.of("-c", "a", "b"), names(run("--resume")));
        assertEquals(List.of("-a", "-b", "-c"), names(run("--resume")));
    }

    @Test
    public void resultsOfOtherParametersAreNotPassedOver() {
        assertEquals(0, run().exitCode);
        for (String[] other : new String[][] {{"--lifetime-px", "4"}, {"--preset", "paper"},
            {"--method", "local-planes"}, {"--strict"}, {"--report"}}) {
            List<String> all = new ArrayList<>(List.of("--resume"));
            all.addAll(List.of(other));
            Executed run = run(all.toArray(String[]::new));
            assertEquals(0, run.exitCode);
            assertTrue(run.err, run.errLines().contains("a: run again, because its results are of other options or "
                + "parameters"));
        }
        assertEquals(List.of("-a", "-b", "-c"), names(run("--resume", "--report")));
    }

    @Test
    public void damagedRecordingIsRunAgainAndFailsAgain() throws IOException {
        Path damaged = recordings.resolve("b.aedat");
        byte[] bytes = Files.readAllBytes(damaged);
        Files.write(damaged, Arrays.copyOf(bytes, bytes.length - 3));
        assertEquals(1, run().exitCode);
        Executed again = run("--resume");
        assertEquals(1, again.exitCode);
        assertEquals(List.of("-a", "-c"), names(again).subList(0, 2));
        assertEquals("1 of 1 recording failed: " + damaged, again.errLines().get(again.errLines().size() - 1));
        assertEquals(12, files().size());
    }

    @Test
    public void everyDamageFailsByItselfAndTheLastLineCounts() throws IOException {
        Files.write(recordings.resolve("d.aedat"), new byte[0]);
        Files.writeString(recordings.resolve("e.aedat4"), "no recording");
        Files.write(recordings.resolve("f.dat"), new byte[5]);
        Files.writeString(recordings.resolve("g.aedat"), "#!AER-DAT9.9\r\n");
        Files.createDirectory(recordings.resolve("h.aedat"));
        Files.createSymbolicLink(recordings.resolve("i.aedat"), recordings.resolve("gone.aedat"));
        Executed run = run("--chip", "DVS128", "--jobs", "4");
        assertEquals(1, run.exitCode);
        String last = run.errLines().get(run.errLines().size() - 1);
        assertTrue(last, last.startsWith("5 of 8 recordings failed: "));
        for (String message : List.of("[d.aedat] header at byte 0: truncated, a recording must not be empty",
            "[e.aedat4] header at byte 0: unsupported, a recording must begin as a known format does or have the "
            + "extension .aedat, .dat, .bin, .csv or .txt",
            "[f.dat] event 0 at byte 0: truncated, a record must have 6 bytes but had 5",
            "[g.aedat] header at byte 9: unsupported, the AEDAT version must be one of 1.0, 2.0, 3.0, 3.1, 4.0 but was "
            + "\"9.9\"", "[" + recordings.resolve("i.aedat") + "] cannot be opened: no such file")) {
            assertTrue(run.err, run.errLines().contains(message));
        }
        for (String name : List.of("a", "b", "c")) {
            assertTrue(name, files().contains(name + ".summary.json"));
        }
    }

    @Test
    public void diskThatIsFullFailsOneRecordingAndLosesNoEarlierResult() throws IOException {
        if (!Files.isWritable(Path.of("/dev/full"))) {
            throw Skipped.because("there is no /dev/full");
        }
        assertEquals(0, run().exitCode);
        byte[] summary = Files.readAllBytes(out.resolve("b.summary.json"));
        Path part = out.resolve(".b.flow.csv." + ProcessHandle.current().pid() + ".part");
        Files.createSymbolicLink(part, Path.of("/dev/full"));
        Executed run = run("--force");
        assertEquals(1, run.exitCode);
        assertTrue(run.err, run.errLines().contains("[b.aedat] results cannot be written: No space left on device"));
        assertArrayEquals(summary, Files.readAllBytes(out.resolve("b.summary.json")));
        assertEquals(12, files().size());
    }

    @Test
    public void folderThatVanishesIsNamed() throws IOException {
        String blocked = out.resolve("b.flow.csv").toString();
        Files.createDirectories(out);
        Files.createSymbolicLink(out.resolve(".b.flow.csv." + ProcessHandle.current().pid() + ".part"),
            folder.getRoot().toPath().resolve("gone").resolve("file"));
        Executed run = run();
        assertEquals(1, run.exitCode);
        assertTrue(run.err, run.errLines().contains("[b.aedat] results cannot be written: " + out + "/."
            + blocked.substring(out.toString().length() + 1) + "." + ProcessHandle.current().pid()
            + ".part: the directory is not there"));
        assertEquals(8, files().stream().filter(name -> !name.startsWith(".")).count());
    }
}
