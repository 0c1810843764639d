package io.github.sofas.cli;

import static org.junit.Assert.assertArrayEquals;
import static org.junit.Assert.assertEquals;
import static org.junit.Assert.assertTrue;

import io.github.sofas.event.EventBatch;
import io.github.sofas.flow.SmoothedSofas;
import io.github.sofas.flow.Sofas;
import io.github.sofas.flow.SofasParameters;
import io.github.sofas.live.Biases;
import io.github.sofas.live.CameraSource;
import io.github.sofas.live.Cameras;
import io.github.sofas.live.FakeTransport;
import io.github.sofas.recording.Chip;
import io.github.sofas.recording.RecordingOptions;
import io.github.sofas.recording.RecordingReader;
import io.github.sofas.recording.Recordings;
import java.io.IOException;
import java.io.PrintWriter;
import java.io.StringWriter;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.Arrays;
import java.util.List;
import java.util.Map;
import org.junit.Before;
import org.junit.Rule;
import org.junit.Test;
import org.junit.rules.TemporaryFolder;

public class LiveCommandTest {
    private static final Path TWO_OPPOSITE = Path.of("recordings", "two-opposite.aedat");

    @Rule
    public final TemporaryFolder folder = new TemporaryFolder();

    private Path out;

    @Before
    public void names() throws IOException {
        out = folder.newFolder("results").toPath();
    }

    private void refuses(String message, String... arguments) {
        String[] all = new String[arguments.length + 1];
        all[0] = "live";
        System.arraycopy(arguments, 0, all, 1, arguments.length);
        Executed live = Executed.command(all);
        assertEquals(message + "\nTry 'sofas live --help'.\n", live.err);
        assertEquals(2, live.exitCode);
        assertEquals(List.of(), List.of(out.toFile().list()));
    }

    @Test
    public void refusesWhatMakesNoSense() {
        String dir = out.toString();
        String chips = Chip.knownNames();
        refuses("Missing required option: '--out=DIR'");
        refuses("--duration must be positive but was 0.0", "--out", dir, "--duration", "0");
        refuses("--chip is for --udp; a camera reports its own chip", "--out", dir, "--chip", "DVS128");
        refuses("--udp needs --chip, one of " + chips, "--out", dir, "--udp", "8991");
        refuses("--chip must be one of " + chips + " but was \"DVS1\"", "--out", dir, "--udp", "1", "--chip", "DVS1");
        refuses("--serial is for a camera and cannot be combined with --udp", "--out", dir, "--udp", "1", "--serial",
            "7");
        refuses("--biases is for a camera and cannot be combined with --udp", "--out", dir, "--udp", "1", "--biases",
            "f");
        refuses("--udp must be a port from 1 to 65535, or host:port, but was \"65536\"", "--out", dir, "--udp", "65536",
            "--chip", "DVS128");
        refuses("--udp must be a port from 1 to 65535, or host:port, but was \"8991/udp\"", "--out", dir, "--udp",
            "8991/udp", "--chip", "DVS128");
        refuses("[nowhere.properties] no such file", "--out", dir, "--biases",
            "nowhere.properties");
    }

    @Test
    public void replacesNoResultsUnlessForced() throws IOException {
        Path existing = Files.createFile(out.resolve("garden.segments.csv"));
        Executed live = Executed.command("live", "--out", out.toString(), "--name", "garden");
        assertEquals("[" + existing + "] exists already; --force replaces it\nTry 'sofas live --help'.\n", live.err);
        assertEquals(2, live.exitCode);
    }

    /** The words of a DAVIS that sends a recording: time, row, column of each event; 60 events a transfer. */
    private static void play(Path recording, FakeTransport camera) throws Exception {
        EventBatch batch = new EventBatch(60);
        long wraps = 0;
        try (RecordingReader reader = Recordings.open(recording, RecordingOptions.defaults())) {
            while (reader.next(batch)) {
                int[] words = new int[4 * batch.size() + 8];
                int n = 0;
                for (int i = 0; i < batch.size(); i++) {
                    long timeUs = batch.timeUs[i];
                    if (timeUs >> 15 > wraps) {
                        words[n++] = 0x7000 | (int) ((timeUs >> 15) - wraps);
                        wraps = timeUs >> 15;
                    }
                    words[n++] = 0x8000 | (int) (timeUs & 0x7FFF);
                    words[n++] = 0x1000 | batch.y[i];
                    words[n++] = (batch.polarity[i] > 0 ? 0x3000 : 0x2000) | batch.x[i];
                }
                camera.sendWords(Arrays.copyOf(words, n));
            }
        }
    }

    private RunOutcome label(FakeTransport camera, boolean unplugged, Path recording) throws Exception {
        SofasParameters parameters = SofasParameters.defaults();
        return label(camera, unplugged, recording, new MethodChoice("sofas", "default", Map.of(),
            (sensor, ended) -> new Sofas(sensor, parameters, ended)));
    }

    private RunOutcome label(FakeTransport camera, boolean unplugged, Path recording, MethodChoice method)
            throws Exception {
        try (CameraSource source = new Cameras(camera).open(null)) {
            LiveStatus status = new LiveStatus(source, new PrintWriter(new StringWriter()), 80,
                System::nanoTime);
            return new LiveRun(source, method, new ResultNames(out, "live"), recording, false, status).run(() -> {
                source.start(Biases.defaults(source.model()));
                // The camera sends while the run labels, never more than the queue holds.
                new Thread(() -> send(camera, source, unplugged)).start();
            });
        }
    }

    private static void send(FakeTransport camera, CameraSource source, boolean unplugged) {
        camera.beforeSending = () -> {
            while (source.packetsWaiting() > source.queueLimit() / 2) {
                Thread.yield();
            }
        };
        try {
            play(TWO_OPPOSITE, camera);
        } catch (Exception e) {
            throw new IllegalStateException(e);
        }
        if (unplugged) {
            camera.unplug();
        } else {
            source.stop();
        }
    }

    private void assertSameAsAFileRun(Path recording, String... options) throws IOException {
        Path file = out.resolve("file");
        List<String> command = new ArrayList<>(List.of("run", "--quiet", "--out", file.toString()));
        command.addAll(List.of(options));
        command.add(recording.toString());
        assertEquals(0, Executed.command(command.toArray(new String[0])).exitCode);
        for (String ending : List.of(".flow.csv", ".segments.csv")) {
            assertArrayEquals(ending, Files.readAllBytes(file.resolve("recorded" + ending)),
                Files.readAllBytes(out.resolve("live" + ending)));
        }
    }

    @Test
    public void givesTheResultsOfARunOverItsRecording() throws Exception {
        Path recording = folder.getRoot().toPath().resolve("recorded.aedat");
        RunOutcome outcome = label(FakeTransport.davis240c(), false, recording);
        assertEquals(25_074, outcome.summary().recording().events());
        assertTrue("both movers are found", outcome.summary().eventsWithFlow() > 15_000);
        assertSameAsAFileRun(recording, "--causal");
    }

    @Test
    public void givesTheResultsOfARunWhereTheCameraIsUnplugged() throws Exception {
        Path recording = folder.getRoot().toPath().resolve("recorded.aedat");
        RunOutcome outcome = label(FakeTransport.davis240c(), true, recording);
        assertEquals("[DAVIS240C 00000042] the camera was unplugged", outcome.damage().getMessage());
        assertEquals(25_074, outcome.summary().recording().events());
        assertSameAsAFileRun(recording, "--causal");
    }

    @Test
    public void givesWithADelayTheResultsOfARunWithLookAhead() throws Exception {
        Path recording = folder.getRoot().toPath().resolve("recorded.aedat");
        SofasParameters parameters = SofasParameters.defaults();
        MethodChoice delayed = new MethodChoice("sofas", "default", Map.of(),
            (sensor, ended) -> new Sofas(sensor, parameters, ended),
            (sensor, ended) -> new SmoothedSofas(sensor, parameters, 100_000, ended));
        RunOutcome outcome = label(FakeTransport.davis240c(), true, recording, delayed);
        assertEquals(25_074, outcome.summary().recording().events());
        assertSameAsAFileRun(recording, "--look-ahead", "100");
    }

    @Test
    public void delayIsForTheDefaultPresetOfSofas() {
        String dir = out.toString();
        refuses("--delay must be 4 to 10000 but was 20000", "--out", dir, "--delay", "20000");
        refuses("--delay needs --preset default but was used with paper", "--out", dir, "--delay", "100", "--preset",
            "paper");
    }
}
