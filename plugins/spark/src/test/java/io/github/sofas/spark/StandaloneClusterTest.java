package io.github.sofas.spark;

import static org.junit.Assert.assertEquals;
import static org.junit.Assert.assertTrue;

import java.io.File;
import java.io.IOException;
import java.net.ServerSocket;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.Arrays;
import java.util.List;
import java.util.Map;
import java.util.Set;
import java.util.TreeSet;
import java.util.concurrent.TimeUnit;
import org.junit.After;
import org.junit.Before;
import org.junit.Rule;
import org.junit.Test;
import org.junit.rules.TemporaryFolder;
import org.junit.rules.Timeout;

/** Batches on a cluster of three processes: Spark's own master and two workers, on the loopback address. */
public class StandaloneClusterTest {
    private static final int RECORDINGS = 40;
    private static final String LOOPBACK = "127.0.0.1";

    /** For processes that never end; each test takes some seconds on a machine that has nothing else to do. */
    private static final int LONGEST_S = 600;

    @Rule
    public final TemporaryFolder folder = new TemporaryFolder();

    @Rule
    public final Timeout timeout = Timeout.seconds(LONGEST_S);

    private final List<Submitted> processes = new ArrayList<>();
    private Path root;
    private String master;

    @Before
    public void startsMasterAndWorkers() throws Exception {
        root = folder.getRoot().toPath().toRealPath();
        layOutSpark();
        int port = freePort();
        master = "spark://" + LOOPBACK + ":" + port;
        processes.add(spark("master.Master", "--host", LOOPBACK, "--port", String.valueOf(port), "--webui-port", "0"));
        for (int i = 0; i < 2; i++) {
            processes.add(spark("worker.Worker", "--host", LOOPBACK, "--webui-port", "0", "--cores", "1", "--memory",
                "1g", "--work-dir", root.resolve("work-" + i).toString(), master));
        }
    }

    /** As a distribution has it; executors take their jars from there. */
    private void layOutSpark() throws IOException {
        Path jars = Files.createDirectories(root.resolve("spark/jars"));
        for (String jar : System.getProperty("sofas.spark.classPath").split(File.pathSeparator)) {
            Files.createSymbolicLink(jars.resolve(Path.of(jar).getFileName()), Path.of(jar));
        }
    }

    private static int freePort() throws IOException {
        try (ServerSocket socket = new ServerSocket(0)) {
            return socket.getLocalPort();
        }
    }

    private Submitted spark(String type, String... arguments) throws IOException {
        List<String> command = new ArrayList<>(List.of(Submitted.java(), "-Xmx512m", "-cp",
            System.getProperty("sofas.spark.classPath"), "org.apache.spark.deploy." + type));
        command.addAll(List.of(arguments));
        return Submitted.start(root, command, Map.of("SPARK_HOME",
            root.resolve("spark").toString(), "SPARK_SCALA_VERSION", "2.13"));
    }

    @After
    public void endsThem() {
        processes.forEach(each -> each.process().destroyForcibly());
    }

    @Test
    public void workerThatIsKilledLosesAndDoublesNothing() throws Exception {
        Path recordings = Files.createDirectory(root.resolve("recordings"));
        for (int i = 0; i < RECORDINGS; i++) {
            Submitted.writeRecording(recordings.resolve("edge-" + i + ".aedat"), 30_000 + 1000 * i);
        }
        Path expected = root.resolve("expected");
        assertEquals(0, Submitted.run(root, recordings.toString(), "--out", expected.toString()).exitCode());
        Path out = root.resolve("results");

        Submitted batch = Submitted.start(root, List.of("spark.driver.host=" + LOOPBACK,
            "spark.driver.bindAddress=" + LOOPBACK, "spark.executor.memory=600m"),
            recordings.toString(), "--out", out.toString(), "--master", master);
        Process worker = processes.get(2).process();
        while (!(hasBegun(root.resolve("work-1")) && summaries(out) >= 4) && batch.process().isAlive()) {
            TimeUnit.MILLISECONDS.sleep(20);
        }
        // the executor, which does the work, dies with its worker
        List<ProcessHandle> executors = worker.descendants().toList();
        worker.destroyForcibly();
        executors.forEach(ProcessHandle::destroyForcibly);
        int done = summaries(out);
        Submitted.Result result = batch.await();

        assertEquals(result.errLines().toString(), 0, result.exitCode());
        assertTrue(done + " done when it was killed", done < RECORDINGS);
        assertEquals("executors", 1, executors.size());
        Map<String, Map<String, String>> rows = Submitted.rows(out.resolve("batch.parquet"));
        assertEquals(RECORDINGS, rows.size());
        Set<String> attempts = new TreeSet<>();
        rows.values().forEach(row -> {
            assertEquals("complete", row.get("outcome"));
            attempts.add(row.get("task_attempt"));
        });
        assertTrue("attempts " + attempts, attempts.contains("1"));
        Files.delete(out.resolve("batch.parquet"));
        assertEquals(Submitted.contents(expected), Submitted.contents(out));
    }

    /** Whether a worker's executor has unpacked the program and so has a task. */
    private static boolean hasBegun(Path work) throws IOException {
        if (!Files.isDirectory(work)) {
            return false;
        }
        try (var files = Files.walk(work)) {
            return files.anyMatch(file -> file.endsWith("sofas-spark.jar"));
        }
    }

    private static int summaries(Path out) {
        String[] names = out.toFile().list();
        return names == null ? 0 : (int) Arrays.stream(names).filter(name -> name.endsWith(".summary.json")).count();
    }
}
