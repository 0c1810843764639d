package io.github.sofas.cli;

import static org.junit.Assert.assertEquals;
import static org.junit.Assert.assertTrue;

import io.github.sofas.Skipped;
import io.github.sofas.event.EventBatch;
import io.github.sofas.recording.Aedat2Writer;
import io.github.sofas.recording.Chip;
import io.github.sofas.recording.RecordingOptions;
import io.github.sofas.recording.RecordingReader;
import io.github.sofas.recording.Recordings;
import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.Arrays;
import java.util.List;
import java.util.concurrent.TimeUnit;
import org.junit.After;
import org.junit.Before;
import org.junit.Rule;
import org.junit.Test;
import org.junit.rules.TemporaryFolder;

/** A run in a Java of its own that is stopped by a signal, as by Ctrl-C. */
public class InterruptedRunTest {
    private static final Path HEXAGON = Path.of("recordings", "hexagon.aedat");
    private static final int HEXAGON_EVENTS = 26_101;
    /** How often the hexagon passes: five million events, which no machine labels before the signal comes. */
    private static final int PASSES = 200;
    private static final long PASS_US = 1_200_000;
    /** The bit of signal 2 in the masks of /proc, whose lowest bit is signal 1. */
    private static final int SIGINT_IGNORED = 1 << 1;

    @Rule
    public final TemporaryFolder folder = new TemporaryFolder();

    private Path out;
    private Process program;

    @Before
    public void names() throws IOException {
        out = folder.newFolder("results").toPath();
    }

    @After
    public void endTheProgram() throws InterruptedException {
        if (program != null) {
            program.destroyForcibly().waitFor();
        }
    }

    private Path writeLongRecording(String name) throws Exception {
        EventBatch batch = new EventBatch(HEXAGON_EVENTS);
        try (RecordingReader reader = Recordings.open(HEXAGON, RecordingOptions.defaults())) {
            EventBatch some = new EventBatch(4096);
            while (reader.next(some)) {
                for (int i = 0; i < some.size(); i++) {
                    batch.add(some.timeUs[i], some.x[i], some.y[i], some.polarity[i]);
                }
            }
        }
        Path file = folder.getRoot().toPath().resolve(name);
        try (Aedat2Writer writer = new Aedat2Writer(file, Chip.named("DAVIS240C").orElseThrow())) {
            for (int pass = 0; pass < PASSES; pass++) {
                writer.write(batch);
                for (int i = 0; i < batch.size(); i++) {
                    batch.timeUs[i] += PASS_US;
                }
            }
        }
        return file;
    }

    /** Starts a run of two recordings at once and returns when rows of both were written. */
    private void start() throws Exception {
        Path first = writeLongRecording("first.aedat");
        Path second = folder.getRoot().toPath().resolve("second.aedat");
        Files.createLink(second, first);
        Path err = folder.getRoot().toPath().resolve("err.txt");
        program = new ProcessBuilder(Path.of(System.getProperty("java.home"), "bin", "java").toString(), "-Xmx256m",
            "-cp", System.getProperty("java.class.path"), Main.class.getName(), "run", "--jobs", "2", "--out",
            out.toString(), first.toString(), second.toString())
            .redirectErrorStream(true).redirectOutput(err.toFile()).start();
        while (startedFiles() < 2) {
            assertTrue("ended before the signal: " + Files.readString(err), program.isAlive());
            Thread.sleep(10);
        }
    }

    private int startedFiles() {
        int started = 0;
        for (String name : filesThere()) {
            assertTrue(name, name.matches("\\.(first|second)\\.(flow|tracks)\\.csv\\.\\d+\\.part"));
            started += name.contains(".flow.") && out.resolve(name).toFile().length() > 0 ? 1 : 0;
        }
        return started;
    }

    private List<String> filesThere() {
        String[] names = out.toFile().list();
        Arrays.sort(names);
        return List.of(names);
    }

    private void send(String signal) throws Exception {
        Process kill = new ProcessBuilder("sh", "-c", "kill -" + signal + " " + program.pid()).inheritIO().start();
        assertEquals(0, kill.waitFor());
        assertTrue("ends within a minute", program.waitFor(1, TimeUnit.MINUTES));
    }

    private static void needsSignals() {
        if (!Files.exists(Path.of("/proc/self/status")) || !Files.isExecutable(Path.of("/bin/sh"))) {
            throw Skipped.because("there is no /proc or no /bin/sh");
        }
    }

    @Test
    public void leavesNoFileWhereCtrlCStopsIt() throws Exception {
        needsSignals();
        start();
        if (ignoresCtrlC(program.pid())) {
            throw Skipped.because("the tests were started with SIGINT ignored, as a shell's background jobs are");
        }
        send("INT");
        assertEquals(List.of(), filesThere());
        // 128 and the number of the signal.
        assertEquals(130, program.exitValue());
    }

    @Test
    public void leavesNoFileWhereItIsTerminated() throws Exception {
        needsSignals();
        start();
        send("TERM");
        assertEquals(List.of(), filesThere());
        assertEquals(143, program.exitValue());
    }

    @Test
    public void leavesNothingUnderTheNamesOfResultsWhereItIsKilled() throws Exception {
        needsSignals();
        start();
        send("KILL");
        assertEquals(137, program.exitValue());
        // fails where a file has another name than those of the beginning
        assertEquals(2, startedFiles());
    }

    private static boolean ignoresCtrlC(long pid) throws IOException {
        for (String line : Files.readAllLines(Path.of("/proc", Long.toString(pid), "status"))) {
            if (line.startsWith("SigIgn:")) {
                return (Long.parseUnsignedLong(line.substring("SigIgn:".length()).strip(), 16) & SIGINT_IGNORED) != 0;
            }
        }
        return false;
    }
}
