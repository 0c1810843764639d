package io.github.sofas.spark;

import static org.junit.Assert.assertEquals;
import static org.junit.Assert.assertFalse;
import static org.junit.Assert.assertTrue;

import io.github.sofas.Skipped;
import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.nio.file.attribute.FileTime;
import java.util.Arrays;
import java.util.Comparator;
import java.util.HashMap;
import java.util.List;
import java.util.Map;
import java.util.Set;
import java.util.TreeMap;
import java.util.TreeSet;
import java.util.concurrent.TimeUnit;
import java.util.regex.Matcher;
import java.util.regex.Pattern;
import java.util.stream.Stream;
import org.apache.spark.sql.Dataset;
import org.apache.spark.sql.Row;
import org.apache.spark.sql.SparkSession;
import org.junit.Before;
import org.junit.Rule;
import org.junit.Test;
import org.junit.rules.TemporaryFolder;
import org.junit.rules.Timeout;

/** Batches on an embedded Spark, against the command {@code run}. */
public class SparkBatchTest {
    private static final int EVENTS = 20_000;

    /** For processes that never end; each test takes some seconds on a machine that has nothing else to do. */
    private static final int LONGEST_S = 600;

    @Rule
    public final TemporaryFolder folder = new TemporaryFolder();

    @Rule
    public final Timeout timeout = Timeout.seconds(LONGEST_S);

    private Path root;
    private Path recordings;
    private Path out;

    @Before
    public void writesRecordings() throws IOException {
        root = folder.getRoot().toPath().toRealPath();
        recordings = Files.createDirectory(root.resolve("recordings"));
        out = root.resolve("results");
        for (int i = 0; i < 6; i++) {
            Submitted.writeRecording(recordings.resolve("edge-" + i + ".aedat"), EVENTS + 5000 * i);
        }
    }

    private Submitted.Result batch(String... more) throws IOException, InterruptedException {
        String[] arguments = Arrays.copyOf(new String[] {recordings.toString(), "--out", out.toString()},
            3 + more.length);
        System.arraycopy(more, 0, arguments, 3, more.length);
        return Submitted.batch(root, arguments);
    }

    private Map<String, Map<String, String>> rows() throws IOException {
        return Submitted.rows(out.resolve("batch.parquet"));
    }

    private static Map<String, String> column(String name, Map<String, Map<String, String>> rows) {
        Map<String, String> values = new TreeMap<>();
        rows.forEach((recording, row) -> values.put(recording, row.get(name)));
        return values;
    }

    @Test
    public void givesTheSameBytesAsRun() throws Exception {
        Path config = Files.writeString(root.resolve("a.properties"), "lifetime-px=4\nmemory-px=32\n");
        String[] options = {"--format", "csv,parquet,npz", "--config", config.toString(), "--memory-px=16"};
        Path expected = root.resolve("expected");
        Submitted.Result run = Submitted.run(root, Stream.concat(
            Stream.of(recordings.toString(), "--out", expected.toString()), Arrays.stream(options))
            .toArray(String[]::new));
        assertEquals(run.errLines().toString(), 0, run.exitCode());

        Submitted.Result batch = batch(options);

        assertEquals(batch.errLines().toString(), 0, batch.exitCode());
        Map<String, Map<String, String>> rows = rows();
        assertEquals(6, rows.size());
        for (int i = 0; i < 6; i++) {
            Map<String, String> row = rows.get("edge-" + i);
            assertEquals("complete", row.get("outcome"));
            assertEquals(String.valueOf(EVENTS + 5000 * i), row.get("events"));
            assertTrue(row.get("parameters"), row.get("parameters").contains("lifetime-px=4.0")
                && row.get("parameters").contains("memory-px=16.0"));
        }
        Files.delete(out.resolve("batch.parquet"));
        assertEquals(Submitted.contents(expected), Submitted.contents(out));
    }

    @Test
    public void whatFailsIsARowWithItsMessage() throws Exception {
        Path damaged = recordings.resolve("edge-1.aedat");
        byte[] bytes = Files.readAllBytes(damaged);
        Files.write(damaged, Arrays.copyOf(bytes, bytes.length - 3));
        Files.writeString(recordings.resolve("other.aedat4"), "no recording");
        Files.createSymbolicLink(recordings.resolve("gone.aedat"), root.resolve("nowhere"));

        Submitted.Result batch = batch();

        assertEquals(1, batch.exitCode());
        Map<String, Map<String, String>> rows = rows();
        Map<String, String> outcomes = new HashMap<>(column("outcome", rows));
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
        assertFalse(Files.exists(out.resolve("other.summary.json")));
        assertEquals(Set.of(), hidden());
    }

    private Set<String> hidden() {
        Set<String> names = new TreeSet<>(Arrays.asList(out.toFile().list()));
        names.removeIf(name -> !name.startsWith("."));
        return names;
    }

    @Test
    public void resumesOnlyWhatIsMissingOrOutdated() throws Exception {
        assertEquals(0, batch().exitCode());
        Map<String, String> first = Submitted.contents(out);
        Files.delete(out.resolve("edge-2.summary.json"));
        Files.writeString(out.resolve("edge-2.flow.csv"), "half");
        Files.writeString(out.resolve("edge-3.tracks.csv"), "half");
        Files.setLastModifiedTime(recordings.resolve("edge-4.aedat"), FileTime.fromMillis(1_000_000));
        Submitted.Result refused = batch();
        assertEquals(2, refused.exitCode());

        Submitted.Result batch = batch("--resume");

        assertEquals(batch.errLines().toString(), 0, batch.exitCode());
        assertEquals(Map.of("edge-0", "true", "edge-1", "true", "edge-2", "false", "edge-3", "false", "edge-4", "false",
            "edge-5", "true"), column("earlier", rows()));
        Map<String, String> second = Submitted.contents(out);
        for (String each : List.of("edge-2.flow.csv", "edge-3.tracks.csv", "edge-4.flow.csv", "edge-5.summary.json")) {
            assertEquals(each, first.get(each), second.get(each));
        }
    }

    @Test
    public void wrongUsageRunsNothing() throws Exception {
        Files.createDirectories(root.resolve("a"));
        Files.copy(recordings.resolve("edge-0.aedat"), root.resolve("a/edge-0.aedat"));
        assertEquals(2, batch(root.resolve("a").toString()).exitCode());
        assertEquals(2, batch("--lifetime-px", "0").exitCode());
        assertEquals(2, batch(root.resolve("nowhere.aedat").toString()).exitCode());
        assertFalse(Files.exists(out));
    }

    @Test
    public void readsAndWritesWhateverHadoopOpens() throws Exception {
        Path expected = root.resolve("expected");
        assertEquals(0, Submitted.run(root, recordings.toString(), "--out", expected.toString(), "--format", "parquet")
            .exitCode());
        Files.writeString(recordings.resolve("events.csv"), "t,x,y,p\n1,2,3,1\n2,3,3,1\n");
        Files.writeString(recordings.resolve("notes.txt"), "nothing but words\n");
        Path list = Files.writeString(root.resolve("list.txt"), "store://" + recordings
            + "/edge-[1-5].aedat\n\nstore://" + recordings + "/edge-0.aedat\n");
        List<String> settings = List.of("spark.hadoop.fs.store.impl=" + StoreFileSystem.class.getName());

        Submitted.Result batch = Submitted.start(root, settings, "--list", "store://" + list, "--out", "store://" + out,
            "--format", "parquet", "--master", "local[2]").await();

        assertEquals(batch.errLines().toString(), 0, batch.exitCode());
        Map<String, String> contents = Submitted.contents(out);
        assertEquals(Set.of("complete"), Set.copyOf(column("outcome", rows()).values()));
        contents.remove("batch.parquet");
        Map<String, String> wanted = new TreeMap<>();
        Submitted.contents(expected).forEach((name, text) -> wanted.put(name,
            text.replace("\"file\" : \"" + recordings, "\"file\" : \"store:" + recordings)));
        assertEquals(wanted, contents);
        assertEquals(Set.of(), hidden());

        Submitted.Result again = Submitted.start(root, settings, "store://" + recordings, "--out", "store://" + out,
            "--format", "parquet", "--master", "local[2]", "--resume", "--time", "us", "--chip", "DVS128").await();

        assertEquals(again.errLines().toString(), 0, again.exitCode());
        assertEquals(Set.of("edge-0", "edge-1", "edge-2", "edge-3", "edge-4", "edge-5", "events"), rows().keySet());
    }

    @Test
    public void allEventsAreOneDataSet() throws Exception {
        Files.move(recordings.resolve("edge-5.aedat"), recordings.resolve("a=b:5.aedat"));
        Path events = root.resolve("events");
        Submitted.Result batch = batch("--events", events.toString());
        assertEquals(batch.errLines().toString(), 0, batch.exitCode());
        try (SparkSession spark = SparkSession.builder().master("local[1]").config("spark.ui.enabled", false)
                // not 200, each a task
                .config("spark.sql.shuffle.partitions", 1)
                .config("spark.driver.bindAddress", "127.0.0.1").config("spark.driver.host", "127.0.0.1")
                .getOrCreate()) {
            Dataset<Row> all = spark.read().parquet(events.toString());
            Map<String, Long> counts = new TreeMap<>();
            all.groupBy("recording").count().collectAsList()
                .forEach(row -> counts.put(row.getString(0), row.getLong(1)));
            assertEquals(Map.of("edge-0", 20_000L, "edge-1", 25_000L, "edge-2", 30_000L, "edge-3", 35_000L, "edge-4",
                40_000L, "a=b:5", 45_000L), counts);
            assertEquals(Set.of("t_us", "x", "y", "polarity", "vx_px_per_s", "vy_px_per_s", "segment", "recording"),
                Set.of(all.columns()));
            Matcher query = Pattern.compile("```sql\n(.*?)```", Pattern.DOTALL)
                .matcher(Files.readString(Path.of("../../README.md")));
            assertTrue("a query", query.find());
            List<Row> speeds = spark.sql(query.group(1).replace("results/events", events.toString())).collectAsList();
            assertEquals(all.where("segment > 0").count(), speeds.stream().mapToLong(row -> row.getLong(1)).sum());
            // 10 px/s: a pixel of 1000 events, one each 100 us
            assertEquals(10.0, speeds.stream().max(Comparator.comparingLong(row -> row.getLong(1))).orElseThrow()
                .getDouble(0), 0);
        }
        Submitted.Result again = batch("--events", events.toString(), "--resume");
        assertEquals(again.errLines().toString(), 0, again.exitCode());
        assertEquals(Set.of("true"), Set.copyOf(column("earlier", rows()).values()));
    }

    @Test
    public void whatIsStoppedLeavesNothingHalfAndGoesOn() throws Exception {
        for (int i = 6; i < 60; i++) {
            Submitted.writeRecording(recordings.resolve("edge-" + i + ".aedat"), EVENTS);
        }
        Submitted batch = Submitted.start(root, List.of(), recordings.toString(), "--out", out.toString(), "--master",
            "local[1]");
        while (summaries() < 3 && batch.process().isAlive()) {
            TimeUnit.MILLISECONDS.sleep(20);
        }
        batch.process().destroy();
        Submitted.Result stopped = batch.await();
        // that of a process which SIGTERM ended
        assertEquals(stopped.errLines().toString(), 143, stopped.exitCode());
        int done = summaries();
        assertTrue(done + " done", done >= 3 && done < 60);
        assertEquals(Set.of(), hidden());
        assertFalse(Files.exists(out.resolve("batch.parquet")));

        Submitted.Result rest = batch("--resume");

        assertEquals(rest.errLines().toString(), 0, rest.exitCode());
        Map<String, String> earlier = column("earlier", rows());
        assertEquals(60, earlier.size());
        assertEquals(done, earlier.values().stream().filter("true"::equals).count());
    }

    private int summaries() {
        String[] names = out.toFile().list();
        return names == null ? 0 : (int) Arrays.stream(names).filter(name -> name.endsWith(".summary.json")).count();
    }

    @Test
    public void fullDiskFailsTheRecordingsThatDoNotFit() throws Exception {
        Files.createDirectory(out);
        // room for the results of some, 30 bytes an event
        if (new ProcessBuilder("mount", "-t", "tmpfs", "-o", "size=2m", "tmpfs", out.toString())
                .redirectErrorStream(true).start().waitFor() != 0) {
            throw Skipped.because("no small disk can be mounted here");
        }
        try {
            Submitted.Result batch = batch();
            assertEquals(1, batch.exitCode());
            assertTrue(batch.errLines().toString(), batch.errLines().stream()
                .anyMatch(line -> line.matches("\\[edge-\\d.aedat\\] results cannot be written: No space left .*")));
            assertEquals(Set.of(), hidden());
            for (String name : out.toFile().list()) {
                assertTrue(name, name.equals("batch.parquet")
                    || Files.exists(out.resolve(name.split("\\.")[0] + ".summary.json")));
            }
        } finally {
            new ProcessBuilder("umount", out.toString()).start().waitFor();
        }
    }
}
