package io.github.sofas.live;

import static org.junit.Assert.assertEquals;
import static org.junit.Assert.assertFalse;
import static org.junit.Assert.assertTrue;

import io.github.sofas.event.EventBatch;
import io.github.sofas.recording.RecordingOptions;
import io.github.sofas.recording.RecordingReader;
import io.github.sofas.recording.Recordings;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.Arrays;
import java.util.List;
import java.util.regex.Matcher;
import java.util.regex.Pattern;
import org.junit.After;
import org.junit.Before;
import org.junit.Rule;
import org.junit.Test;
import org.junit.rules.TemporaryFolder;

/** The program, real usb4java and real libusb, with a camera that only they believe in. */
public class ModelledCameraTest {
    @Rule
    public final TemporaryFolder folder = new TemporaryFolder();

    private Path out;
    private Path recording;
    private ModelledCamera camera;

    @Before
    public void plugIn() throws Exception {
        ModelledCamera.need();
        out = folder.newFolder("results").toPath();
        recording = folder.getRoot().toPath().resolve("recorded.aedat");
        camera = new ModelledCamera(folder.getRoot().toPath());
    }

    @After
    public void unplug() throws InterruptedException {
        if (camera != null) {
            camera.stop();
        }
    }

    private ModelledCamera run(String... more) throws Exception {
        List<String> arguments = new ArrayList<>(List.of("--out", out.toString(), "--record", recording.toString()));
        arguments.addAll(List.of(more));
        return camera.start(arguments.toArray(String[]::new));
    }

    /** The first four columns of the flow file. */
    private List<String> labelled() throws Exception {
        List<String> rows = new ArrayList<>();
        for (String row : Files.readAllLines(out.resolve("live.flow.csv"))) {
            rows.add(row.substring(0, row.length() - row.replaceFirst("([^,]*,){4}", "").length() - 1));
        }
        assertEquals("t_us,x,y,polarity", rows.remove(0));
        return rows;
    }

    private List<String> recorded() throws Exception {
        List<String> rows = new ArrayList<>();
        try (RecordingReader reader = Recordings.open(recording, RecordingOptions.defaults())) {
            EventBatch batch = new EventBatch(4096);
            while (reader.next(batch)) {
                for (int i = 0; i < batch.size(); i++) {
                    rows.add(batch.timeUs[i] + "," + batch.x[i] + "," + batch.y[i] + "," + batch.polarity[i]);
                }
            }
            assertEquals("DAVIS240C", reader.chip().orElseThrow());
        }
        return rows;
    }

    private static List<String> texts(List<DavisStream.Event> events) {
        return events.stream().map(DavisStream.Event::text).toList();
    }

    private List<String> files() {
        String[] names = out.toFile().list();
        Arrays.sort(names);
        return List.of(names);
    }

    @Test
    public void listsTheCamera() throws Exception {
        camera.start("--list");
        assertEquals(0, camera.exitCode());
        assertEquals("DAVIS240C  serial 84010012     bus 1 address 7  ready\n", camera.out());
        assertEquals("", camera.err());
    }

    @Test
    public void configuresStartsAndStopsTheCameraInOrder() throws Exception {
        run("--duration", "0.2", "--quiet");
        assertEquals(0, camera.exitCode());
        List<String> log = camera.log();
        assertEquals(List.of("claim", "read bf 6/0", "read bf 6/7", "read bf 6/1", "read bf 6/5", "read bf 6/6",
            "read bf 1/0", "read bf 1/1", "read bf 1/2", "write bf 1/3 00000000"), log.subList(0, 10));
        int clear = log.indexOf("clear halt 82");
        assertEquals("write bf 0/3 00000000", log.get(clear - 1));
        assertTrue(log.contains("write bf 5/0 0000427f"));
        assertTrue(log.contains("write bf 9/1 00007530"));
        int start = log.indexOf("write bf 0/3 00000001");
        assertEquals(List.of("write bf 0/3 00000001", "write bf 9/0 00000001", "write bf 0/1 00000001",
            "write bf 0/0 00000001", "write bf 1/3 00000001"), log.subList(start, start + 5));
        int stop = log.lastIndexOf("write bf 1/3 00000000");
        assertTrue("stopped after the start", stop > start);
        assertEquals("release", log.get(log.size() - 2));
    }

    @Test
    public void labelsAndRecordsEveryEventOfTheStream() throws Exception {
        // 200,000 events of 8 µs each: 1.6 s, with 48 wraps
        DavisStream stream = new DavisStream(1, 200_000, 16);
        camera.sends(stream.bytes(), stream.bytes().length);
        run();
        camera.terminateWhenAllIsSent();
        assertEquals(camera.err(), 0, camera.exitCode());
        List<String> expected = texts(stream.events());
        assertEquals(expected, labelled());
        assertEquals(expected, recorded());
        assertEquals(List.of("live.flow.csv", "live.segments.csv", "live.summary.json"), files());
        assertTrue(camera.err(), Pattern.compile("(?m)^ +\\d+ s: +\\d+ events/s, +\\d+\\.\\d % flow, queue +\\d+/256, "
            + "\\d+ dropped, \\d+ segments").matcher(camera.err()).find());
        assertTrue(camera.err(), camera.err().contains("\nlive: 200000 events in "));
    }

    @Test
    public void losesOneTransferByEachFaultAndGoesOn() throws Exception {
        DavisStream stream = new DavisStream(2, 60_000, 16);
        camera.sends(stream.bytes(), stream.bytes().length).fails(10, "stall").fails(11, "error").fails(20, "overflow")
            .fails(30, "stall");
        run();
        camera.terminateWhenAllIsSent();
        assertEquals(camera.err(), 0, camera.exitCode());
        List<int[]> lost = new ArrayList<>();
        for (String line : camera.log()) {
            Matcher fault = Pattern.compile("\\w+ at transfer \\d+, bytes (\\d+) to (\\d+)").matcher(line);
            if (fault.matches()) {
                lost.add(new int[] {Integer.parseInt(fault.group(1)), Integer.parseInt(fault.group(2))});
            }
        }
        assertEquals(4, lost.size());
        // Of the events with row and column outside the lost bytes; time is of the last time word that came.
        List<String> expected = new ArrayList<>();
        for (DavisStream.Event event : stream.events()) {
            if (lost.stream().noneMatch(range -> event.end() > range[0] && event.row() <= range[1])) {
                expected.add(event.text().replaceFirst("\\d+,", ""));
            }
        }
        assertEquals(expected, labelled().stream().map(row -> row.replaceFirst("\\d+,", "")).toList());
        String err = camera.err();
        assertTrue(err, err.contains("[DAVIS240C 84010012] 2 transfers lost by a stall of the endpoint\n"));
        assertTrue(err, err.contains("[DAVIS240C 84010012] 1 transfer lost by an error on the wire\n"));
        assertTrue(err, err.contains("[DAVIS240C 84010012] 1 transfer lost by more data than asked for\n"));
        assertEquals("the first before the start", 3, camera.log().stream().filter("clear halt 82"::equals).count());
    }

    @Test
    public void keepsAllResultsWhereTheCameraIsUnplugged() throws Exception {
        DavisStream stream = new DavisStream(3, 100_000, 16);
        camera.sends(stream.bytes(), stream.bytes().length).fails(50, "unplug");
        run();
        assertEquals(camera.err(), 1, camera.exitCode());
        assertTrue(camera.err(), camera.err().contains("[DAVIS240C 84010012] the camera was unplugged\n"));
        String last = camera.log().stream().filter(line -> line.startsWith("unplugged, sent ")).findFirst()
            .orElseThrow();
        int sent = Integer.parseInt(last.substring("unplugged, sent ".length()));
        List<String> expected = texts(stream.events().stream().filter(event -> event.end() <= sent).toList());
        assertFalse(expected.isEmpty());
        assertEquals(expected, labelled());
        assertEquals(expected, recorded());
        assertEquals(List.of("live.flow.csv", "live.segments.csv", "live.summary.json"), files());
        assertTrue(Files.readString(out.resolve("live.summary.json")).contains("\"complete\" : false"));
    }

    @Test
    public void takesTheEventsOfADvs128() throws Exception {
        // address 0x0202 is raw x 1, raw y 2, ON: (126, 125)
        byte[] stream = new byte[4 * 10_000];
        for (int i = 0; i < 10_000; i++) {
            stream[4 * i] = 2;
            stream[4 * i + 1] = 2;
            stream[4 * i + 2] = (byte) i;
            stream[4 * i + 3] = (byte) (i >> 8);
        }
        camera.is(CameraModel.DVS128).sends(stream, 100_000);
        run();
        camera.terminateWhenAllIsSent();
        assertEquals(camera.err(), 0, camera.exitCode());
        List<String> rows = labelled();
        assertEquals(10_000, rows.size());
        assertEquals("0,126,125,1", rows.get(0));
        assertEquals("9999,126,125,1", rows.get(9_999));
        assertTrue(camera.log().contains("write b3 0/0 "));
    }

    @Test
    public void sendsTheBiasesOfAFile() throws Exception {
        Path biases = folder.getRoot().toPath().resolve("biases.properties");
        Files.writeString(biases, "# faster\nDiffBn = 0x1234\nPrBp = 5 32\n");
        run("--duration", "0.1", "--quiet", "--biases", biases.toString());
        assertEquals(camera.err(), 0, camera.exitCode());
        assertTrue(camera.log().contains("write bf 5/0 00001234"));
        assertTrue(camera.log().contains("write bf 5/8 0000520d"));
        assertTrue(camera.log().contains("write bf 5/1 00005fff"));
    }

    @Test
    public void refusesABiasThatTheCameraDoesNotHave() throws Exception {
        Path biases = folder.getRoot().toPath().resolve("biases.properties");
        Files.writeString(biases, "# faster\ndiffOff = 1\n");
        run("--biases", biases.toString());
        assertEquals(camera.err(), 2, camera.exitCode());
        String start = "[biases.properties] line 2: unknown bias \"diffOff\"; this camera's are DiffBn, OnBn, ";
        assertEquals(start, camera.err().substring(0, start.length()));
        assertEquals(List.of(), files());
    }

    @Test
    public void writesNothingWhereAnotherProgramHasTheCamera() throws Exception {
        camera.isBusy();
        run();
        assertEquals(1, camera.exitCode());
        assertEquals("[DAVIS240C 84010012] another program uses the camera; close it first\n", camera.err());
        assertEquals(List.of(), files());
    }

    @Test
    public void writesNothingWhereTheChipIsUnknown() throws Exception {
        camera.tells("6/1", 7);
        run();
        assertEquals(1, camera.exitCode());
        assertEquals("[DAVIS240C 84010012] unknown chip: its number must be one of {0=DAVIS240A, 1=DAVIS240B, "
            + "2=DAVIS240C} but was 7\n", camera.err());
        assertEquals(List.of(), files());
    }

    @Test
    public void writesNothingWhereTheFirmwareIsMissing() throws Exception {
        camera.isDevice(new UsbDevice(0x04B4, 0x8613, 0xA001, 1, 7));
        run();
        assertEquals(1, camera.exitCode());
        assertEquals("[camera] firmware missing: bus 1, address 7 is a bare FX2 (04b4:8613); flash the camera's "
            + "firmware with jAER or the maker's tool\n", camera.err());
        assertEquals(List.of(), files());
    }
}
