package io.github.sofas.cli;

import static org.junit.Assert.assertArrayEquals;
import static org.junit.Assert.assertEquals;
import static org.junit.Assert.assertFalse;
import static org.junit.Assert.assertTrue;

import io.github.sofas.Skipped;
import java.io.FileOutputStream;
import java.io.IOException;
import java.io.PrintStream;
import java.io.PrintWriter;
import java.io.StringWriter;
import java.nio.ByteBuffer;
import java.nio.ByteOrder;
import java.nio.file.Files;
import java.nio.file.Path;
import java.nio.file.attribute.PosixFilePermissions;
import java.util.Arrays;
import java.util.List;
import org.junit.Before;
import org.junit.Rule;
import org.junit.Test;
import org.junit.rules.TemporaryFolder;

/** No command writes over what it reads, loses what it made, or keeps quiet about it. */
public class NothingLostTest {
    private static final Path BAR = Path.of("recordings", "short-bar.aedat");
    private static final Path TRUTH = Path.of("recordings", "short-bar.truth.csv");

    @Rule
    public final TemporaryFolder folder = new TemporaryFolder();

    private Path root;
    private Path recording;
    private Path truth;
    private Path out;

    @Before
    public void copyARecording() throws IOException {
        root = folder.getRoot().toPath();
        recording = Files.copy(BAR, root.resolve("e.aedat"));
        truth = Files.copy(TRUTH, root.resolve("e.truth.csv"));
        out = root.resolve("out");
    }

    private static Executed sofas(Object... arguments) {
        return Executed.command(Arrays.stream(arguments).map(String::valueOf).toArray(String[]::new));
    }

    private void assertUsage(String message, Object... arguments) throws IOException {
        Executed executed = sofas(arguments);
        assertEquals(executed.err, message, executed.err.lines().findFirst().orElse(""));
        assertEquals(2, executed.exitCode);
        assertArrayEquals(Files.readAllBytes(BAR), Files.readAllBytes(recording));
        assertArrayEquals(Files.readAllBytes(TRUTH), Files.readAllBytes(truth));
    }

    @Test
    public void noOutputIsAnInput() throws Exception {
        String read = " is read and cannot be written";
        assertUsage("[" + recording + "]" + read, "evaluate", recording, "--truth", truth, "--csv", recording, "-f");
        assertUsage("[" + truth + "]" + read, "evaluate", recording, "--truth", truth, "--json", truth, "-f");
        Path link = Files.createSymbolicLink(root.resolve("link.csv"), truth);
        assertUsage("[" + link + "]" + read + ": it is " + truth, "evaluate", recording, "--truth", truth, "--csv",
            link, "-f");
        Path hard = Files.createLink(root.resolve("hard.csv"), recording);
        assertUsage("[" + hard + "]" + read + ": it is " + recording, "evaluate", recording, "--truth", truth, "--csv",
            hard, "-f");
        Path linkedFolder = Files.createSymbolicLink(root.resolve("folder"), root);
        assertUsage("[" + linkedFolder.resolve("e.aedat") + "]" + read + ": it is " + recording, "evaluate", recording,
            "--truth", truth, "--csv", linkedFolder.resolve("e.aedat"), "-f");
        Path rows = Files.copy(BAR, root.resolve("e.flow.csv"));
        assertUsage("[" + rows + "]" + read, "run", recording, rows, "--out", root, "-f");
        Path config = Files.writeString(root.resolve("e.mp4"), "lifetime-px=6\n");
        assertUsage("[" + config + "]" + read, "render", recording, "--out", root, "--config", config, "-f");
    }

    @Test
    public void noOutputIsAnother() throws Exception {
        Path x = root.resolve("x");
        assertUsage("[" + x + "] cannot be written twice", "evaluate", recording, "--truth", truth, "--json", x,
            "--csv", x);
        Path flow = root.resolve("live.flow.csv");
        assertUsage("[" + flow + "] cannot be written twice", "live", "--out", root, "--record", flow, "--udp", "8991",
            "--chip", "DVS128");
        Path link = Files.createSymbolicLink(root.resolve("l"), root);
        assertUsage("[" + link.resolve("live.flow.csv") + "] cannot be written twice: it is " + flow, "live", "--out",
            root, "--record", link.resolve("live.flow.csv"), "--udp", "8991", "--chip", "DVS128");
    }

    @Test
    public void outLeadsNowhereElse() throws Exception {
        assertUsage("--out must name a directory but was empty", "run", recording, "--out", "");
        assertUsage("--out must name a directory but was empty", "render", recording, "--out", "");
        assertUsage("--out must name a directory but was empty", "simulate", "hexagon", "--out", "");
        for (String name : List.of("../x", "a/b", "..", ".", "/tmp/x")) {
            assertUsage("--name must be the name of a file, without folders, but was \"" + name + "\"", "live",
                "--out", root, "--name", name, "--udp", "8991", "--chip", "DVS128");
        }
    }

    @Test
    public void folderThatMayNotBeMadeIsNoWrongUsage() throws Exception {
        Path locked = Files.createDirectory(root.resolve("locked"),
            PosixFilePermissions.asFileAttribute(PosixFilePermissions.fromString("r-xr-xr-x")));
        if (Files.isWritable(locked)) {
            throw Skipped.because("this user may write everywhere");
        }
        Executed run = sofas("run", recording, "--out", locked.resolve("new"));
        assertEquals("[" + locked.resolve("new") + "] cannot be made a directory: " + locked.resolve("new")
            + ": no permission\n", run.err);
        assertEquals(1, run.exitCode);
    }

    @Test
    public void optionThatStandsTwiceIsRefused() throws Exception {
        assertUsage("option --lifetime-px must stand once but stands twice", "run", recording, "--out", out,
            "--lifetime-px", "5", "--lifetime-px", "6");
        assertUsage("option --lifetime-px must stand once but stands twice", "run", recording, "--out", out,
            "--lifetime-px=5", "--lifetime-px=6");
        assertUsage("option --speed must stand once but stands twice", "simulate", "hexagon", "--out", out, "--speed",
            "5", "--speed", "6");
        assertUsage("option --fps must stand once but stands twice", "render", recording, "--out", out, "--fps", "5",
            "--fps", "6");
        Path config = Files.writeString(root.resolve("c.properties"), "lifetime-px=5\n# or\nlifetime-px = 6\n");
        assertUsage("[c.properties] line 3: \"lifetime-px\" must stand once but stands twice", "run", recording,
            "--out", out, "--config", config);
        // a name after its option, and one behind the end of options, is no option
        assertEquals("[--quiet] no such file", sofas("run", "--out", out, "--quiet", "--", "--quiet").err.lines()
            .findFirst().orElse(""));
    }

    @Test
    public void optionWithoutEffectIsRefused() throws Exception {
        assertEquals(0, sofas("run", recording, "--out", out, "-q").exitCode);
        for (String[] option : new String[][] {{"--preset", "paper"}, {"--lifetime-px", "4"},
            {"--method", "lucas-kanade"}, {"--config", "nowhere"}}) {
            assertUsage(option[0] + " has no effect with --results: the events are not labelled again", "render",
                recording, "--out", root, "--results", out, option[0], option[1]);
        }
        assertUsage("--turns has no effect on hexagon, only on long-bar, short-bar", "simulate", "hexagon", "--out",
            out, "--turns", "2");
        assertUsage("--turn-round has no effect on pendulum, only on four-bars", "simulate", "pendulum", "--out", out,
            "--turn-round");
        assertUsage("--field-of-view has no effect on hexagon, only on pendulum", "simulate", "hexagon", "--out", out,
            "--field-of-view", "1");
        assertUsage("--surface has no effect on poster, only on random, side-by-side, textured-hand, textured-movers, "
            + "textured-pan, textured-roll, textured-slant, textured-turn, textured-zoom", "simulate", "poster",
            "--out", out, "--surface", "smooth");
        assertUsage("--hot-pixel-rate has no effect without --hot-pixels", "simulate", "hexagon", "--out", out,
            "--hot-pixel-rate", "1");
        assertUsage("--force-chip has no effect without --chip", "run", recording, "--out", out, "--force-chip", "-f");
    }

    /** An AEDAT 4 recording may hold any time; the report once failed on those above 2^53 us and took all with it. */
    @Test
    public void reportThatFailsCostsTheReportOnly() throws Exception {
        byte[] bytes = Files.readAllBytes(BAR);
        Path text = root.resolve("late.txt");
        StringBuilder rows = new StringBuilder();
        for (int i = 0; i < 3000; i++) {
            rows.append("99999999999.").append(String.format("%06d", 100 * i)).append(" 5 6 1\n");
        }
        Files.writeString(text, rows);
        Executed late = sofas("run", text, "--chip", "240x180", "--out", out, "--report", "-q");
        assertEquals(late.err, 0, late.exitCode);
        assertTrue(Files.exists(out.resolve("late.report.html")));

        // where the report cannot be written, what it is written to is full
        Files.createSymbolicLink(out.resolve(".e.report.html." + ProcessHandle.current().pid() + ".part"),
            Path.of("/dev/full"));
        Executed run = sofas("run", recording, "--out", out, "--report", "-q", "-f");
        assertEquals(1, run.exitCode);
        assertTrue(run.err, run.err.startsWith("[e.aedat] all results are there but the report, which cannot be "
            + "written: "));
        for (String name : List.of("e.flow.csv", "e.segments.csv", "e.summary.json")) {
            assertTrue(name, Files.isRegularFile(out.resolve(name)));
        }
        assertEquals(bytes.length, Files.size(recording));
    }

    @Test
    public void standardOutputThatIsFullIsAFailure() throws Exception {
        if (!Files.isWritable(Path.of("/dev/full"))) {
            throw Skipped.because("there is no /dev/full");
        }
        for (String[] command : new String[][] {{"info", recording.toString()}, {"info", "--json", BAR.toString()},
            {"evaluate", recording.toString(), "--truth", truth.toString()}, {"--help"}}) {
            StringWriter err = new StringWriter();
            try (PrintStream full = new PrintStream(new FileOutputStream("/dev/full"))) {
                int exitCode = Main.execute(new PrintWriter(full, true), new PrintWriter(err), command);
                assertEquals(String.join(" ", command) + err, 1, exitCode);
            }
            assertTrue(err.toString(), err.toString().endsWith("standard output cannot be written: what was to be "
                + "printed is lost\n"));
        }
    }

    @Test
    public void resumeRunsOutdatedAndCutResultsAgainAndSaysWhy() throws Exception {
        assertEquals(0, sofas("run", recording, "--out", out, "-q").exitCode);
        byte[] flow = Files.readAllBytes(out.resolve("e.flow.csv"));
        assertEquals(List.of("e: results are complete, skipped"), resumed());
        // cut by a full disk, or by hand
        Files.write(out.resolve("e.flow.csv"), Arrays.copyOf(flow, 1000));
        assertEquals("e: run again, because e.flow.csv must have " + flow.length + " bytes but has 1000",
            resumed().get(0));
        assertArrayEquals(flow, Files.readAllBytes(out.resolve("e.flow.csv")));
        Files.delete(out.resolve("e.segments.csv"));
        assertTrue(resumed().get(0).startsWith("e: run again, because e.segments.csv must have "));
        String summary = Files.readString(out.resolve("e.summary.json"));
        Files.writeString(out.resolve("e.summary.json"), summary.substring(0, summary.length() / 2));
        assertEquals("e: run again, because there is no summary, or it is cut", resumed().get(0));
        Files.writeString(out.resolve("e.summary.json"), summary.replaceFirst("\"request\" : \"\\S+", "\"request\" : "
            + "\"0.0.1"));
        assertTrue(resumed().get(0).startsWith("e: run again, because its results are of version 0.0.1 and this is "));
        assertEquals("e: run again, because its results are of other options or parameters",
            resumed("--lifetime-px", "6").get(0));
        Files.write(recording, ByteBuffer.allocate(8).order(ByteOrder.BIG_ENDIAN).putInt(0).putInt(2_000_000).array(),
            java.nio.file.StandardOpenOption.APPEND);
        assertEquals("e: run again, because the recording has another size or time of change than it had",
            resumed("--lifetime-px", "6").get(0));
        assertFalse(Files.exists(out.resolve(".e.flow.csv.part")));
    }

    private List<String> resumed(String... more) {
        String[] all = new String[5 + more.length];
        System.arraycopy(new String[] {"run", recording.toString(), "--out", out.toString(), "--resume"}, 0, all, 0, 5);
        System.arraycopy(more, 0, all, 5, more.length);
        Executed executed = Executed.command(all);
        assertEquals(executed.err, 0, executed.exitCode);
        return executed.errLines();
    }
}
