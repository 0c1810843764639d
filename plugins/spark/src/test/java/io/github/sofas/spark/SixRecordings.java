package io.github.sofas.spark;

import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.Arrays;
import java.util.Map;
import java.util.Set;
import java.util.TreeMap;
import java.util.TreeSet;
import org.junit.rules.TemporaryFolder;
import org.junit.rules.Timeout;
import org.junit.runner.Description;
import org.junit.runners.model.Statement;

/**
 * A folder with six recordings, {@code edge-0.aedat} to {@code edge-5.aedat}, and room for what a batch of them makes;
 * a test that does not end fails.
 */
public final class SixRecordings extends TemporaryFolder {
    /** Events of the first; each other has 5,000 more than the one before. */
    static final int EVENTS = 20_000;

    /** For processes that never end; each test takes some seconds on a machine that has nothing else to do. */
    private static final int LONGEST_S = 600;

    private Path root;
    private Path recordings;

    @Override
    public Statement apply(Statement test, Description description) {
        return super.apply(Timeout.seconds(LONGEST_S).apply(test, description), description);
    }

    @Override
    protected void before() throws Throwable {
        super.before();
        root = getRoot().toPath().toRealPath();
        recordings = Files.createDirectory(root.resolve("recordings"));
        for (int i = 0; i < 6; i++) {
            Submitted.writeRecording(recordings.resolve("edge-" + i + ".aedat"), EVENTS + 5000 * i);
        }
    }

    /** The folder that holds all. */
    Path root() {
        return root;
    }

    /** The folder of the recordings. */
    Path recordings() {
        return recordings;
    }

    /** The folder of the results, which is not there before a batch. */
    Path out() {
        return root.resolve("results");
    }

    /** Runs a batch of the recordings, with more arguments, in {@code local[2]}. */
    Submitted.Result batch(String... more) throws IOException, InterruptedException {
        String[] arguments = Arrays.copyOf(new String[] {recordings.toString(), "--out", out().toString()},
            3 + more.length);
        System.arraycopy(more, 0, arguments, 3, more.length);
        return Submitted.batch(root, arguments);
    }

    /** The rows of the table of the batch. */
    Map<String, Map<String, String>> rows() throws IOException {
        return Submitted.rows(out().resolve("batch.parquet"));
    }

    /** A column of that table, by the names of the recordings. */
    Map<String, String> column(String name) throws IOException {
        Map<String, String> values = new TreeMap<>();
        rows().forEach((recording, row) -> values.put(recording, row.get(name)));
        return values;
    }

    /** The hidden files among the results, which are half written. */
    Set<String> hidden() {
        Set<String> names = new TreeSet<>(Arrays.asList(out().toFile().list()));
        names.removeIf(name -> !name.startsWith("."));
        return names;
    }
}
