package io.github.sofas.cli;

import static org.junit.Assert.assertEquals;
import static org.junit.Assert.assertTrue;

import io.github.sofas.event.EventBatch;
import io.github.sofas.recording.Aedat2Writer;
import io.github.sofas.recording.Chip;
import java.io.IOException;
import java.nio.ByteBuffer;
import java.nio.file.Files;
import java.nio.file.Path;
import java.nio.file.StandardOpenOption;
import org.junit.Before;
import org.junit.Rule;
import org.junit.Test;
import org.junit.rules.TemporaryFolder;

public class InfoCommandTest {
    /** Bit 31 set: not of the DVS; IMU where bits 10 and 11 are set, an APS sample otherwise. */
    private static final int NOT_DVS = 0x8000_0000;
    private static final int SPECIAL = 0x400;

    @Rule
    public final TemporaryFolder folder = new TemporaryFolder();

    private Path root;
    private Path recording;

    /** Five events of a DAVIS240C, half a second apart from -1 s on. */
    @Before
    public void writeRecording() throws IOException {
        root = folder.getRoot().toPath();
        recording = root.resolve("five.aedat");
        EventBatch batch = new EventBatch(5);
        for (int i = 0; i < 5; i++) {
            batch.add(500_000L * i - 1_000_000, i, 2 * i, 1);
        }
        try (Aedat2Writer writer = new Aedat2Writer(recording, Chip.named("DAVIS240C").orElseThrow())) {
            writer.write(batch);
        }
    }

    private void append(int address, int timeUs) throws IOException {
        Files.write(recording, ByteBuffer.allocate(8).putInt(address).putInt(timeUs).array(),
            StandardOpenOption.APPEND);
    }

    /** What AEDAT 2.0 can hold beside its events, an event outside the sensor, and one whose time steps back. */
    private void appendOtherKinds() throws IOException {
        append(NOT_DVS, 1_000_000);
        append(NOT_DVS, 1_000_000);
        append(SPECIAL, 1_000_000);
        append(240 << 12, 1_000_000);
        append(0, 999_000);
    }

    @Test
    public void saysWhatIsInARecording() {
        // From -1 s to 1 s; 5 events in 2 s are 2.5 a second, shown as 3.
        Executed info = Executed.command("info", recording.toString());
        assertEquals(recording + "\n"
            + "  format:              AEDAT 2.0\n"
            + "  chip:                DAVIS240C\n"
            + "  sensor:              240x180 px\n"
            + "  duration:            2.000000 s\n"
            + "  first event:         -1000000 us\n"
            + "  last event:          1000000 us\n"
            + "  event rate:          3 events/s\n"
            + "  dvs events:          5\n"
            + "  aps samples:         0\n"
            + "  frames:              0\n"
            + "  imu samples:         0\n"
            + "  triggers:            0\n"
            + "  invalid:             0\n"
            + "  outside sensor:      0\n"
            + "  steps back in time:  0\n"
            + "  time wraps:          0\n"
            + "  other records:       0\n"
            + "  malformed:           0\n"
            + "  damaged times:       0\n"
            + "  time restarts:       0\n"
            + "  faults:              none\n", info.out);
        assertEquals("", info.err);
        assertEquals(0, info.exitCode);
    }

    @Test
    public void countsEachKindAndListsTheFaults() throws IOException {
        // Five events lie behind the header, two APS samples and a special event behind these.
        long header = Files.size(recording) - 5 * 8;
        appendOtherKinds();
        Executed info = Executed.command("info", recording.toString());
        String counts = info.out.substring(info.out.indexOf("  dvs events:"));
        assertEquals("  dvs events:          6\n"
            + "  aps samples:         2\n"
            + "  frames:              0\n"
            + "  imu samples:         0\n"
            + "  triggers:            1\n"
            + "  invalid:             0\n"
            + "  outside sensor:      1\n"
            + "  steps back in time:  1\n"
            + "  time wraps:          0\n"
            + "  other records:       0\n"
            + "  malformed:           0\n"
            + "  damaged times:       0\n"
            + "  time restarts:       0\n"
            + "  fault:               [five.aedat] event 5 at byte " + (header + 64)
            + ": x must be smaller than width 240 but was 240\n"
            + "  fault:               [five.aedat] event 6 at byte " + (header + 72)
            + ": time must not fall below 1000000 us but was 999000 us\n", counts);
        // of six events and the one that was dropped
        assertEquals("doubtful: five.aedat, 28.6 % of whose events were corrected, dropped or malformed\n", info.err);
        assertEquals(1, info.exitCode);
    }

    @Test
    public void saysTheSameAsJson() throws IOException {
        long header = Files.size(recording) - 5 * 8;
        appendOtherKinds();
        Executed info = Executed.command("info", "--json", recording.toString());
        assertEquals("[\n  {\n"
            + "    \"file\" : \"" + recording + "\",\n"
            + "    \"format\" : \"AEDAT 2.0\",\n"
            + "    \"chip\" : \"DAVIS240C\",\n"
            + "    \"width\" : 240,\n"
            + "    \"height\" : 180,\n"
            + "    \"events\" : 6,\n"
            + "    \"first_t_us\" : -1000000,\n"
            + "    \"last_t_us\" : 1000000,\n"
            + "    \"duration_s\" : 2.000000,\n"
            + "    \"events_per_s\" : 3.0,\n"
            + "    \"counts\" : {\n"
            + "      \"dvs_events\" : 6,\n"
            + "      \"aps_samples\" : 2,\n"
            + "      \"frames\" : 0,\n"
            + "      \"imu_samples\" : 0,\n"
            + "      \"triggers\" : 1,\n"
            + "      \"invalid\" : 0,\n"
            + "      \"outside_sensor\" : 1,\n"
            + "      \"steps_back_in_time\" : 1,\n"
            + "      \"time_wraps\" : 0,\n"
            + "      \"other_records\" : 0,\n"
            + "      \"malformed\" : 0,\n"
            + "      \"damaged_times\" : 0,\n"
            + "      \"time_restarts\" : 0\n"
            + "    },\n"
            + "    \"complete\" : true,\n"
            + "    \"faults\" : [\n"
            + "      \"[five.aedat] event 5 at byte " + (header + 64)
            + ": x must be smaller than width 240 but was 240\",\n"
            + "      \"[five.aedat] event 6 at byte " + (header + 72)
            + ": time must not fall below 1000000 us but was 999000 us\"\n"
            + "    ],\n"
            + "    \"notes\" : [ ],\n"
            + "    \"doubtful_share\" : 0.285714\n"
            + "  }\n"
            + "]\n", info.out);
        assertEquals(1, info.exitCode);
    }

    @Test
    public void takesAStepBackForDamageWhereStrict() throws IOException {
        long header = Files.size(recording) - 5 * 8;
        append(0, 999_000);
        Executed info = Executed.command("info", "--strict", recording.toString());
        assertEquals("  fault:               [five.aedat] event 5 at byte " + (header + 40)
            + ": malformed, time must not fall below 1000000 us but was 999000 us",
            info.out.lines().filter(line -> line.startsWith("  fault:")).findFirst().orElse(""));
        assertEquals(1, info.exitCode);
    }

    @Test
    public void saysWhatCameBeforeTheDamage() throws IOException {
        long size = Files.size(recording);
        Files.write(recording, new byte[] {0, 0, 0}, StandardOpenOption.APPEND);
        Executed info = Executed.command("info", recording.toString());
        assertEquals("  dvs events:          5",
            info.out.lines().filter(line -> line.startsWith("  dvs events:")).findFirst().orElse(""));
        assertEquals("  fault:               [five.aedat] event 5 at byte " + size
            + ": truncated, a record must have 8 bytes but had 3",
            info.out.lines().filter(line -> line.startsWith("  fault:")).findFirst().orElse(""));
        assertEquals(1, info.exitCode);
    }

    @Test
    public void goesOnAfterARecordingThatCannotBeRead() throws IOException {
        Path strange = Files.writeString(root.resolve("strange.aedat4"), "no recording");
        Executed info = Executed.command("info", strange.toString(), recording.toString());
        assertEquals("[strange.aedat4] header at byte 0: unsupported, a recording must begin as a known format "
            + "does or have the extension .aedat, .dat, .bin, .csv or .txt\n", info.err);
        assertEquals(recording.toString(), info.out.lines().findFirst().orElse(""));
        assertEquals(1, info.exitCode);
    }

    @Test
    public void refusesAFileThatIsNotThere() {
        Path missing = root.resolve("missing.aedat");
        Executed info = Executed.command("info", missing.toString());
        assertEquals("[" + missing + "] no such file\nTry 'sofas info --help'.\n", info.err);
        assertEquals("", info.out);
        assertEquals(2, info.exitCode);
    }

    @Test
    public void needsARecording() {
        Executed info = Executed.command("info");
        assertEquals("Missing required parameter: 'RECORDING'\nTry 'sofas info --help'.\n", info.err);
        assertEquals(2, info.exitCode);
    }

    @Test
    public void guessesTheSensorOfTextAndSaysSo() throws IOException {
        Path text = Files.writeString(root.resolve("a.csv"), "t_us,x,y,p\n1,2,3,1\n5,300,4,0\n");
        Executed info = Executed.command("info", text.toString());
        assertTrue(info.out, info.out.contains("\n  format:              text\n  chip:                not named\n"
            + "  sensor:              304x240 px\n"));
        assertTrue(info.out, info.out.contains("\n  dvs events:          2\n"));
        assertTrue(info.out, info.out.contains("\n  note:                [a.csv] nothing names the sensor; 304x240 is "
            + "a guess, the smallest usual one that holds all events\n"));
        assertEquals(0, info.exitCode);
    }
}
