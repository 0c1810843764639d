package io.github.sofas.spark;

import static org.junit.Assert.assertEquals;
import static org.junit.Assert.assertFalse;
import static org.junit.Assert.assertTrue;

import java.nio.file.Files;
import java.nio.file.Path;
import java.util.Arrays;
import java.util.List;
import java.util.Map;
import java.util.Set;
import java.util.TreeMap;
import java.util.stream.Stream;
import org.junit.Rule;
import org.junit.Test;

/** Batches on an embedded Spark, against the command {@code run}. */
public class SparkBatchTest {
    @Rule
    public final SixRecordings six = new SixRecordings();

    @Test
    public void givesTheSameBytesAsRun() throws Exception {
        Path config = Files.writeString(six.root().resolve("a.properties"), "lifetime-px=4\nmemory-px=32\n");
        String[] options = {"--format", "csv,parquet,npz", "--config", config.toString(), "--memory-px=16"};
        Path expected = six.root().resolve("expected");
        Submitted.Result run = Submitted.run(six.root(), Stream.concat(
            Stream.of(six.recordings().toString(), "--out", expected.toString()), Arrays.stream(options))
            .toArray(String[]::new));
        assertEquals(run.errLines().toString(), 0, run.exitCode());

        Submitted.Result batch = six.batch(options);

        assertEquals(batch.errLines().toString(), 0, batch.exitCode());
        Map<String, Map<String, String>> rows = six.rows();
        assertEquals(6, rows.size());
        for (int i = 0; i < 6; i++) {
            Map<String, String> row = rows.get("edge-" + i);
            assertEquals("complete", row.get("outcome"));
            assertEquals(String.valueOf(SixRecordings.EVENTS + 5000 * i), row.get("events"));
            assertTrue(row.get("parameters"), row.get("parameters").contains("lifetime-px=4.0")
                && row.get("parameters").contains("memory-px=16.0"));
        }
        Files.delete(six.out().resolve("batch.parquet"));
        assertEquals(Submitted.contents(expected), Submitted.contents(six.out()));
    }

    @Test
    public void wrongUsageRunsNothing() throws Exception {
        Files.createDirectories(six.root().resolve("a"));
        Files.copy(six.recordings().resolve("edge-0.aedat"), six.root().resolve("a/edge-0.aedat"));
        assertEquals(2, six.batch(six.root().resolve("a").toString()).exitCode());
        assertEquals(2, six.batch("--lifetime-px", "0").exitCode());
        assertEquals(2, six.batch(six.root().resolve("nowhere.aedat").toString()).exitCode());
        assertFalse(Files.exists(six.out()));
    }

    @Test
    public void readsAndWritesWhateverHadoopOpens() throws Exception {
        Path expected = six.root().resolve("expected");
        assertEquals(0, Submitted.run(six.root(), six.recordings().toString(), "--out", expected.toString(), "--format",
            "parquet").exitCode());
        Files.writeString(six.recordings().resolve("events.csv"), "t,x,y,p\n1,2,3,1\n2,3,3,1\n");
        Files.writeString(six.recordings().resolve("notes.txt"), "nothing but words\n");
        Path list = Files.writeString(six.root().resolve("list.txt"), "store://" + six.recordings()
            + "/edge-[1-5].aedat\n\nstore://" + six.recordings() + "/edge-0.aedat\n");
        List<String> settings = List.of("spark.hadoop.fs.store.impl=" + StoreFileSystem.class.getName());

        Submitted.Result batch = Submitted.start(six.root(), settings, "--list", "store://" + list, "--out",
            "store://" + six.out(), "--format", "parquet", "--master", "local[2]").await();

        assertEquals(batch.errLines().toString(), 0, batch.exitCode());
        Map<String, String> contents = Submitted.contents(six.out());
        assertEquals(Set.of("complete"), Set.copyOf(six.column("outcome").values()));
        contents.remove("batch.parquet");
        Map<String, String> wanted = new TreeMap<>();
        Submitted.contents(expected).forEach((name, text) -> wanted.put(name,
            text.replace("\"file\" : \"" + six.recordings(), "\"file\" : \"store:" + six.recordings())));
        assertEquals(wanted, contents);
        assertEquals(Set.of(), six.hidden());

        Submitted.Result again = Submitted.start(six.root(), settings, "store://" + six.recordings(), "--out",
            "store://" + six.out(), "--format", "parquet", "--master", "local[2]", "--resume", "--time", "us", "--chip",
            "DVS128").await();

        assertEquals(again.errLines().toString(), 0, again.exitCode());
        assertEquals(Set.of("edge-0", "edge-1", "edge-2", "edge-3", "edge-4", "edge-5", "events"), six.rows().keySet());
    }
}
