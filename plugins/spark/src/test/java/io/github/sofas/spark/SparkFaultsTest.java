package io.github.sofas.spark;

import static org.junit.Assert.assertEquals;
import static org.junit.Assert.assertFalse;
import static org.junit.Assert.assertTrue;

import io.github.sofas.Skipped;
import java.nio.file.Files;
import java.nio.file.Path;
import java.nio.file.attribute.FileTime;
import java.util.Arrays;
import java.util.HashMap;
import java.util.List;
import java.util.Map;
import java.util.Set;
import java.util.concurrent.TimeUnit;
import org.junit.Rule;
import org.junit.Test;

/** Batches with recordings that fail, and batches that are stopped or find no room, on an embedded Spark. */
public class SparkFaultsTest {
    /** Of a batch that is stopped after three of them. */
    private static final int RECORDINGS = 24;

    @Rule
    public final SixRecordings six = new SixRecordings();

    @Test
    public void whatFailsIsARowWithItsMessage() throws Exception {
        Path damaged = six.recordings().resolve("edge-1.aedat");
        byte[] bytes = Files.readAllBytes(damaged);
        Files.write(damaged, Arrays.copyOf(bytes, bytes.length - 3));
        Files.writeString(six.recordings().resolve("other.aedat4"), "no recording");
        Files.createSymbolicLink(six.recordings().resolve("gone.aedat"), six.root().resolve("nowhere"));

        Submitted.Result batch = six.batch();

        assertEquals(1, batch.exitCode());
        Map<String, Map<String, String>> rows = six.rows();
        Map<String, String> outcomes = new HashMap<>(six.column("outcome"));
        assertEquals("damaged", outcomes.remove("edge-1"));
        assertEquals("failed", outcomes.remove("other"));
        assertEquals("failed", outcomes.remove("gone"));
        assertEquals(Set.of("complete"), Set.copyOf(outcomes.values()));
        assertEquals("24999", rows.get("edge-1").get("events"));
        assertTrue(rows.get("edge-1").get("fault"), rows.get("edge-1").get("fault")
            .startsWith("[edge-1.aedat] event 24999 at byte "));
        assertTrue(rows.get("other").get("fault"), rows.get("other").get("fault")
            .startsWith("[other.aedat4] header at byte 0: unsupported, "));
        assertTrue(rows.get("gone").get("fault"), rows.get("gone").get("fault").endsWith("no such file"));
        assertTrue(batch.errLines().contains(rows.get("other").get("fault")));
        assertTrue(batch.errLines().toString(), batch.errLines().get(batch.errLines().size() - 1)
            .startsWith("3 of 8 recordings failed: "));
        assertFalse(Files.exists(six.out().resolve("other.summary.json")));
        assertEquals(Set.of(), six.hidden());
    }

    @Test
    public void resumesOnlyWhatIsMissingOrOutdated() throws Exception {
        assertEquals(0, six.batch().exitCode());
        Map<String, String> first = Submitted.contents(six.out());
        Files.delete(six.out().resolve("edge-2.summary.json"));
        Files.writeString(six.out().resolve("edge-2.flow.csv"), "half");
        Files.writeString(six.out().resolve("edge-3.tracks.csv"), "half");
        Files.setLastModifiedTime(six.recordings().resolve("edge-4.aedat"), FileTime.fromMillis(1_000_000));
        Submitted.Result refused = six.batch();
        assertEquals(2, refused.exitCode());

        Submitted.Result batch = six.batch("--resume");

        assertEquals(batch.errLines().toString(), 0, batch.exitCode());
        assertEquals(Map.of("edge-0", "true", "edge-1", "true", "edge-2", "false", "edge-3", "false", "edge-4", "false",
            "edge-5", "true"), six.column("earlier"));
        Map<String, String> second = Submitted.contents(six.out());
        for (String each : List.of("edge-2.flow.csv", "edge-3.tracks.csv", "edge-4.flow.csv", "edge-5.summary.json")) {
            assertEquals(each, first.get(each), second.get(each));
        }
    }

    @Test
    public void whatIsStoppedLeavesNothingHalfAndGoesOn() throws Exception {
        for (int i = 6; i < RECORDINGS; i++) {
            Submitted.writeRecording(six.recordings().resolve("edge-" + i + ".aedat"), SixRecordings.EVENTS);
        }
        Submitted batch = Submitted.start(six.root(), List.of(), six.recordings().toString(), "--out",
            six.out().toString(), "--master", "local[1]");
        while (summaries() < 3 && batch.process().isAlive()) {
            TimeUnit.MILLISECONDS.sleep(20);
        }
        batch.process().destroy();
        Submitted.Result stopped = batch.await();
        // that of a process which SIGTERM ended
        assertEquals(stopped.errLines().toString(), 143, stopped.exitCode());
        int done = summaries();
        assertTrue(done + " done", done >= 3 && done < RECORDINGS);
        assertEquals(Set.of(), six.hidden());
        assertFalse(Files.exists(six.out().resolve("batch.parquet")));

        Submitted.Result rest = six.batch("--resume");

        assertEquals(rest.errLines().toString(), 0, rest.exitCode());
        Map<String, String> earlier = six.column("earlier");
        assertEquals(RECORDINGS, earlier.size());
        assertEquals(done, earlier.values().stream().filter("true"::equals).count());
    }

    private int summaries() {
        String[] names = six.out().toFile().list();
        return names == null ? 0 : (int) Arrays.stream(names).filter(name -> name.endsWith(".summary.json")).count();
    }

    @Test
    public void fullDiskFailsTheRecordingsThatDoNotFit() throws Exception {
        Files.createDirectory(six.out());
        // room for the results of some, 30 bytes an event
        if (new ProcessBuilder("mount", "-t", "tmpfs", "-o", "size=2m", "tmpfs", six.out().toString())
                .redirectErrorStream(true).start().waitFor() != 0) {
            throw Skipped.because("no small disk can be mounted here");
        }
        try {
            Submitted.Result batch = six.batch();
            assertEquals(1, batch.exitCode());
            assertTrue(batch.errLines().toString(), batch.errLines().stream()
                .anyMatch(line -> line.matches("\\[edge-\\d.aedat\\] results cannot be written: No space left .*")));
            assertEquals(Set.of(), six.hidden());
            for (String name : six.out().toFile().list()) {
                assertTrue(name, name.equals("batch.parquet")
                    || Files.exists(six.out().resolve(name.split("\\.")[0] + ".summary.json")));
            }
        } finally {
            new ProcessBuilder("umount", six.out().toString()).start().waitFor();
        }
    }
}
