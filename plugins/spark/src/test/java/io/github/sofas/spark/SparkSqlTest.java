package io.github.sofas.spark;

import static org.junit.Assert.assertEquals;
import static org.junit.Assert.assertTrue;

import java.nio.file.Files;
import java.nio.file.Path;
import java.util.Comparator;
import java.util.List;
import java.util.Map;
import java.util.Set;
import java.util.TreeMap;
import java.util.regex.Matcher;
import java.util.regex.Pattern;
import org.apache.spark.sql.Dataset;
import org.apache.spark.sql.Row;
import org.apache.spark.sql.SparkSession;
import org.junit.Rule;
import org.junit.Test;

/** What Spark reads of the events that a batch writes. */
public class SparkSqlTest {
    @Rule
    public final SixRecordings six = new SixRecordings();

    @Test
    public void allEventsAreOneDataSet() throws Exception {
        Files.move(six.recordings().resolve("edge-5.aedat"), six.recordings().resolve("a=b:5.aedat"));
        Path events = six.root().resolve("events");
        Submitted.Result batch = six.batch("--events", events.toString());
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
        Submitted.Result again = six.batch("--events", events.toString(), "--resume");
        assertEquals(again.errLines().toString(), 0, again.exitCode());
        assertEquals(Set.of("true"), Set.copyOf(six.column("earlier").values()));
    }
}
