package io.github.sofas.cli;

import static org.junit.Assert.assertArrayEquals;
import static org.junit.Assert.assertEquals;
import static org.junit.Assert.assertFalse;
import static org.junit.Assert.assertTrue;

import io.github.sofas.batch.BatchColumn;
import io.github.sofas.batch.BatchOrder;
import io.github.sofas.batch.BatchRow;
import io.github.sofas.batch.BatchTask;
import io.github.sofas.batch.Cluster;
import io.github.sofas.batch.Storage;
import io.github.sofas.batch.StoredFile;
import io.github.sofas.event.EventBatch;
import io.github.sofas.recording.Aedat2Writer;
import io.github.sofas.recording.Chip;
import java.io.IOException;
import java.io.PrintWriter;
import java.io.StringWriter;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.Arrays;
import java.util.List;
import java.util.Map;
import java.util.TreeMap;
import java.util.function.Consumer;
import org.junit.Before;
import org.junit.Rule;
import org.junit.Test;
import org.junit.rules.TemporaryFolder;

/** The command batch on a cluster of one thread; the tests of the plugin for Spark run it on Spark. */
public class BatchCommandTest {
    @Rule
    public final TemporaryFolder folder = new TemporaryFolder();

    private Path recordings;
    private Path out;
    private OneThread cluster;

    /** Labels one recording after the other, here. */
    private static final class OneThread implements Cluster {
        private final List<String> begun = new ArrayList<>();
        private final Map<String, BatchRow> table = new TreeMap<>();
        private int mostTasks = Integer.MAX_VALUE;

        @Override
        public String qualified(String place) {
            return Path.of(place).toAbsolutePath().normalize().toString();
        }

        @Override
        public List<StoredFile> find(String pattern) {
            throw new AssertionError("all is here");
        }

        @Override
        public Storage storage() {
            return null;
        }

        @Override
        public String start(String master) {
            return "one thread";
        }

        @Override
        public void label(BatchOrder order, List<BatchTask> tasks, Consumer<BatchRow> ended) throws IOException {
            for (BatchTask task : tasks) {
                if (begun.size() == mostTasks) {
                    throw new IOException("the thread is gone");
                }
                begun.add(task.name());
                try {
                    ended.accept(new Batches().label(order, task, null));
                } catch (InterruptedException e) {
                    throw new IllegalStateException(e);
                }
            }
        }

        @Override
        public void writeTable(List<BatchRow> rows, Path file) throws IOException {
            rows.forEach(row -> table.put(row.text(BatchColumn.NAME), row));
            Files.writeString(file, String.join(",", table.keySet()));
        }

        @Override
        public void close() {
            // there is nothing to give back
            return;
        }
    }

    @Before
    public void writesThreeRecordings() throws IOException {
        recordings = folder.newFolder("recordings").toPath();
        out = folder.getRoot().toPath().resolve("results");
        write("a", 40);
        write("b", 60);
        write("c", 50);
    }

    private void write(String name, int events) throws IOException {
        EventBatch batch = new EventBatch(events);
        for (int i = 0; i < events; i++) {
            batch.add(1000L * i, 20 + i, 64, 1);
        }
        try (Aedat2Writer writer = new Aedat2Writer(recordings.resolve(name + ".aedat"),
                Chip.named("DVS128").orElseThrow())) {
            writer.write(batch);
        }
    }

    private int batch(StringWriter err, String... more) {
        cluster = new OneThread();
        return batchOn(cluster, err, more);
    }

    private int batchOn(Cluster any, StringWriter err, String... more) {
        List<String> arguments = new ArrayList<>(List.of("batch", recordings.toString(), "--out", out.toString()));
        arguments.addAll(List.of(more));
        return Main.execute(any, new PrintWriter(new StringWriter()), new PrintWriter(err),
            arguments.toArray(String[]::new));
    }

    @Test
    public void longestRecordingsBeginFirst() {
        assertEquals(0, batch(new StringWriter()));
        assertEquals(List.of("b", "c", "a"), cluster.begun);
        assertEquals(List.of("a", "b", "c"), List.copyOf(cluster.table.keySet()));
        assertEquals(60L, cluster.table.get("b").get(BatchColumn.EVENTS));
    }

    @Test
    public void givesWhatRunGives() throws IOException {
        Path expected = folder.newFolder("expected").toPath();
        assertEquals(0, Executed.command("run", recordings.toString(), "--out", expected.toString(), "--format",
            "csv,parquet", "--preset", "paper").exitCode);
        assertEquals(0, batch(new StringWriter(), "--format", "csv,parquet", "--preset", "paper"));
        for (String name : List.of("a.flow.csv", "b.flow.parquet", "c.tracks.csv", "c.segments.csv")) {
            assertArrayEquals(name, Files.readAllBytes(expected.resolve(name)), Files.readAllBytes(out.resolve(name)));
        }
        assertEquals(3 * 6 + 1, out.toFile().list().length);
    }

    @Test
    public void whatRunHasDoneIsResumedByBatch() throws IOException {
        assertEquals(0, Executed.command("run", recordings.resolve("b.aedat").toString(), "--out", out.toString(),
            "--lifetime-px", "4").exitCode);
        Path config = folder.newFile("a.properties").toPath();
        Files.writeString(config, "lifetime-px=4\n");
        assertEquals(0, batch(new StringWriter(), "--resume", "--config", config.toString()));
        assertEquals(true, cluster.table.get("b").get(BatchColumn.EARLIER));
        assertEquals(false, cluster.table.get("a").get(BatchColumn.EARLIER));
        StringWriter err = new StringWriter();
        assertEquals(0, batch(err, "--resume", "--lifetime-px", "5"));
        assertTrue(err.toString(), err.toString().contains("3 recordings: 3 complete, 0 done before; 150 events"));
    }

    @Test
    public void clusterThatGivesUpLeavesWhatIsDone() throws IOException {
        cluster = new OneThread();
        cluster.mostTasks = 2;
        StringWriter err = new StringWriter();
        assertEquals(1, batchOn(cluster, err));
        assertTrue(err.toString(), err.toString().contains("the batch was stopped after 2 of 3 recordings, --resume "
            + "goes on with it: the thread is gone"));
        assertTrue(Files.exists(out.resolve("b.summary.json")));
        assertFalse(Arrays.stream(out.toFile().list()).anyMatch(name -> name.startsWith(".")));
        assertEquals(0, batch(new StringWriter(), "--resume"));
        assertEquals(false, cluster.table.get("a").get(BatchColumn.EARLIER));
        assertEquals(true, cluster.table.get("c").get(BatchColumn.EARLIER));
    }

    @Test
    public void recordingThatFailsIsARow() throws IOException {
        Files.writeString(recordings.resolve("d.aedat4"), "no recording");
        StringWriter err = new StringWriter();
        assertEquals(1, batch(err));
        BatchRow row = cluster.table.get("d");
        assertEquals("failed", row.text(BatchColumn.OUTCOME));
        assertTrue(row.text(BatchColumn.FAULT), row.text(BatchColumn.FAULT).startsWith("[d.aedat4] header at byte 0"));
        assertTrue(err.toString(), err.toString().contains("4 recordings: 3 complete, 1 failed, 0 done before"));
        assertTrue(err.toString(), err.toString().contains("1 of 4 recordings failed: " + recordings));
    }

    @Test
    public void wrongUsageRunsNothing() throws IOException {
        for (String[] more : new String[][] {{"--lifetime-px", "0"}, {"--threads", "4"}, {"--format", "xml"},
            {folder.getRoot() + "/nowhere.aedat"}, {"--list", folder.getRoot() + "/nowhere.txt"},
            {"--look-ahead", "200", "--preset", "paper"}}) {
            assertEquals(String.join(" ", more), 2, batch(new StringWriter(), more));
            assertEquals(List.of(), cluster.begun);
        }
        assertEquals(0, batch(new StringWriter()));
        StringWriter err = new StringWriter();
        assertEquals(2, batch(err));
        assertTrue(err.toString(), err.toString().contains("a.flow.csv] exists already; --force replaces it")
            || err.toString().contains("b.flow.csv] exists already; --force replaces it"));
        assertEquals(0, batch(new StringWriter(), "--force"));
    }

    @Test
    public void withoutAClusterNothingIsRun() {
        StringWriter err = new StringWriter();
        assertEquals(69, batchOn(null, err));
        assertEquals("batch runs on Apache Spark, which is not here yet" + System.lineSeparator(), err.toString());
        assertFalse(Files.exists(out));
    }

    @Test
    public void linesOfAListAreInputs() throws IOException {
        Path list = folder.newFile("list.txt").toPath();
        Files.writeString(list, recordings.resolve("a.aedat") + "\n\n  " + recordings + "/[bc].aedat\n");
        cluster = new OneThread();
        assertEquals(0, Main.execute(cluster, new PrintWriter(new StringWriter()), new PrintWriter(new StringWriter()),
            "batch", "--list", list.toString(), "--out", out.toString()));
        assertEquals(List.of("b", "c", "a"), cluster.begun);
    }

    @Test
    public void partitionOfANameIsOneFolder() throws IOException {
        Files.move(recordings.resolve("a.aedat"), recordings.resolve("a=1%:x.aedat"));
        Path events = folder.getRoot().toPath().resolve("events");
        assertEquals(0, batch(new StringWriter(), "--events", events.toString()));
        // % is 25, : is 3A, = is 3D
        assertTrue(Files.exists(events.resolve("recording=a%3D1%25%3Ax/events.parquet")));
        assertTrue(Files.exists(out.resolve("a=1%:x.tracks.parquet")));
        assertFalse(Files.exists(out.resolve("a=1%:x.flow.parquet")));
        assertEquals(0, batch(new StringWriter(), "--events", events.toString(), "--resume"));
        assertEquals(true, cluster.table.get("a=1%:x").get(BatchColumn.EARLIER));
    }
}
