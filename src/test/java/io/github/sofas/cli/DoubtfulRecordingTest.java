package io.github.sofas.cli;

import static org.junit.Assert.assertEquals;
import static org.junit.Assert.assertTrue;

import java.io.IOException;
import java.nio.ByteBuffer;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.List;
import org.junit.Before;
import org.junit.Rule;
import org.junit.Test;
import org.junit.rules.TemporaryFolder;

/** Over a share of events that are not as they were recorded, the exit code is 1 and the last line says why. */
public class DoubtfulRecordingTest {
    private static final int EVENTS = 26_101;

    @Rule
    public final TemporaryFolder folder = new TemporaryFolder();

    private Path recording;
    private String out;

    @Before
    public void prepare() {
        recording = folder.getRoot().toPath().resolve("spoiled.aedat");
        out = folder.getRoot().toPath().resolve("out").toString();
    }

    /** The hexagon with bit 29 of every so many times set. */
    private void spoil(int every) throws IOException {
        byte[] bytes = Files.readAllBytes(Path.of("recordings/hexagon.aedat"));
        ByteBuffer buffer = ByteBuffer.wrap(bytes);
        for (int event = every; event < EVENTS; event += every) {
            int at = bytes.length - 8 * (EVENTS - event) + 4;
            buffer.putInt(at, buffer.getInt(at) | 1 << 29);
        }
        Files.write(recording, bytes);
    }

    private static String last(String text) {
        List<String> lines = text.lines().toList();
        return lines.get(lines.size() - 1);
    }

    @Test
    public void everyCommandThatReadsEndsWithTheDoubt() throws Exception {
        // 522 of 26,101 events: 2.0 %
        spoil(50);
        String file = recording.toString();
        String doubt = "doubtful: spoiled.aedat, 2.0 % of whose events were corrected, dropped or malformed";
        for (String[] command : new String[][] {{"run", file, "--out", out}, {"run", file, "--out", out, "-q", "-f"},
            {"run", file, "--out", out, "--resume"}, {"info", file}, {"info", "--json", file},
            {"render", file, "--out", out, "--to", "0.1", "--format", "gif"}}) {
            Executed executed = Executed.command(command);
            assertEquals(String.join(" ", command) + executed.err, doubt, last(executed.err));
            assertEquals(String.join(" ", command), 1, executed.exitCode);
        }
        assertTrue(Files.readString(Path.of(out, "spoiled.summary.json")).contains("\"doubtful_share\" : 0.019999"));
    }

    @Test
    public void evaluationIsDoubtfulToo() throws Exception {
        spoil(50);
        List<String> truth = new ArrayList<>(Files.readAllLines(Path.of("recordings/hexagon.truth.csv")));
        for (int event = (EVENTS - 1) / 50 * 50; event > 0; event -= 50) {
            truth.remove(event + 1);
        }
        Path truthFile = Files.write(folder.getRoot().toPath().resolve("truth.csv"), truth);
        Executed executed = Executed.command("evaluate", recording.toString(), "--truth", truthFile.toString());
        assertEquals(executed.err, 1, executed.exitCode);
        assertTrue(last(executed.err), last(executed.err).startsWith("doubtful: "));
    }

    @Test
    public void shareThatIsAllowedIsTheUsers() throws Exception {
        // 130 of 26,101 events: 0.5 %
        spoil(200);
        assertEquals(0, Executed.command("run", recording.toString(), "--out", out).exitCode);
        Executed strict = Executed.command("run", recording.toString(), "--out", out, "--force", "--doubtful-share",
            "0.001");
        assertEquals(1, strict.exitCode);
        assertEquals("doubtful: spoiled.aedat, 0.5 % of whose events were corrected, dropped or malformed",
            last(strict.err));
        Executed wrong = Executed.command("info", recording.toString(), "--doubtful-share", "2");
        assertEquals(2, wrong.exitCode);
        assertTrue(wrong.err, wrong.err.startsWith("--doubtful-share must be 0 to 1 but was 2.0\n"));
    }
}
