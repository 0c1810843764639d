package io.github.sofas.cli;

import static org.junit.Assert.assertEquals;
import static org.junit.Assert.assertTrue;

import io.github.sofas.Skipped;
import io.github.sofas.event.EventBatch;
import io.github.sofas.recording.RecordingOptions;
import io.github.sofas.recording.RecordingReader;
import io.github.sofas.recording.Recordings;
import java.net.DatagramPacket;
import java.net.DatagramSocket;
import java.net.InetAddress;
import java.net.InetSocketAddress;
import java.nio.ByteBuffer;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.Arrays;
import java.util.List;
import java.util.concurrent.TimeUnit;
import org.junit.After;
import org.junit.Before;
import org.junit.Rule;
import org.junit.Test;
import org.junit.rules.TemporaryFolder;

/** A live run in a Java of its own: what it caught stays, whatever ends it. */
public class LiveCaptureTest {
    private static final int EVENTS_A_DATAGRAM = 1000;
    /** In units of 512 bytes: 2 MiB, in which 100,000 rows do not fit, but 200,000 records do. */
    private static final int MOST_BLOCKS = 4096;

    @Rule
    public final TemporaryFolder folder = new TemporaryFolder();

    private Path out;
    private Path record;
    private Path err;
    private int port;
    private Process program;

    @Before
    public void names() throws Exception {
        if (!Files.isExecutable(Path.of("/bin/sh")) || !Files.exists(Path.of("/proc/self/status"))) {
            throw Skipped.because("there is no /bin/sh or no /proc");
        }
        out = folder.newFolder("out").toPath();
        record = out.resolve("live.aedat");
        err = folder.getRoot().toPath().resolve("err.txt");
        try (DatagramSocket free = new DatagramSocket(new InetSocketAddress(InetAddress.getLoopbackAddress(), 0))) {
            port = free.getLocalPort();
        }
    }

    @After
    public void endTheProgram() throws InterruptedException {
        if (program != null) {
            program.destroyForcibly().waitFor();
        }
    }

    private String said() throws Exception {
        return Files.exists(err) ? Files.readString(err) : "";
    }

    /** Starts a run and waits until it listens. */
    private void start(String before) throws Exception {
        List<String> command = new ArrayList<>(List.of("/bin/sh", "-c", before + "exec \"$@\"", "sh",
            Path.of(System.getProperty("java.home"), "bin", "java").toString(), "-XX:-UsePerfData", "-Xmx256m", "-cp",
            System.getProperty("java.class.path"), Main.class.getName(), "live", "--out", out.toString(), "--record",
            record.toString(), "--udp", String.valueOf(port), "--chip", "DVS128", "--method", "local-planes"));
        program = new ProcessBuilder(command).redirectErrorStream(true).redirectOutput(err.toFile()).start();
        long end = System.nanoTime() + TimeUnit.MINUTES.toNanos(1);
        while (!said().contains("labelling until Ctrl-C") && System.nanoTime() < end) {
            assertTrue(said(), program.isAlive());
            Thread.sleep(20);
        }
    }

    /** Sends events of a DVS128, one a µs, as fast as they are taken. */
    private void send(int datagrams) throws Exception {
        try (DatagramSocket sender = new DatagramSocket()) {
            for (int n = 0; n < datagrams; n++) {
                ByteBuffer data = ByteBuffer.allocate(4 + 8 * EVENTS_A_DATAGRAM).putInt(n + 1);
                for (int i = 0; i < EVENTS_A_DATAGRAM; i++) {
                    int time = 1_000_000 + n * EVENTS_A_DATAGRAM + i;
                    data.putInt((time * 7 & 0x7F) << 8 | (time * 13 & 0x7F) << 1).putInt(time);
                }
                sender.send(new DatagramPacket(data.array(), data.capacity(), InetAddress.getLoopbackAddress(), port));
                Thread.sleep(10);
            }
        }
    }

    private void stop(String signal) throws Exception {
        new ProcessBuilder("sh", "-c", "kill -" + signal + " " + program.pid()).start().waitFor();
        assertTrue("ends within a minute", program.waitFor(1, TimeUnit.MINUTES));
    }

    private List<String> files() {
        String[] names = out.toFile().list();
        Arrays.sort(names);
        return List.of(names);
    }

    private static long events(Path recording) throws Exception {
        EventBatch batch = new EventBatch(4096);
        long events = 0;
        try (RecordingReader reader = Recordings.open(recording, RecordingOptions.defaults())) {
            while (reader.next(batch)) {
                events += batch.size();
            }
        }
        return events;
    }

    private static void assertWholeRows(Path rows, int most) throws Exception {
        List<String> lines = Files.readAllLines(rows);
        assertTrue(lines.size() + " lines", lines.size() > most / 2 && lines.size() <= most + 1);
        for (String line : lines) {
            assertEquals(line, 6, line.chars().filter(c -> c == ',').count());
        }
        assertTrue("ends with a line's end", Files.readString(rows).endsWith("\n"));
    }

    /** A limit on the size of files stands for the disk: it stops the rows, and later would the records. */
    @Test(timeout = 180_000)
    public void whatIsOnAFullDiskStaysAndTheOtherFileGoesOn() throws Exception {
        start("ulimit -f " + MOST_BLOCKS + "; ");
        send(150);
        Thread.sleep(1500);
        stop("TERM");
        String said = said();
        assertEquals(said, 1, program.exitValue());
        assertEquals(List.of("live.aedat", "live.flow.csv", "live.segments.csv", "live.summary.json"), files());
        assertTrue(said, said.contains("[" + out.resolve("live.flow.csv") + "] cannot be written on: File too large; "
            + "what it holds is whole, of less than the first "));
        assertWholeRows(out.resolve("live.flow.csv"), 150_000);
        assertTrue(Files.size(out.resolve("live.flow.csv")) <= MOST_BLOCKS * 512L);
        long recorded = events(record);
        assertTrue(recorded + " recorded", recorded > 140_000);
        String summary = Files.readString(out.resolve("live.summary.json"));
        assertTrue(summary, summary.contains("\"complete\" : false"));
        assertTrue(summary, summary.contains("File too large"));
    }

    @Test(timeout = 180_000)
    public void runThatIsKilledLeavesWhatItHadAndTheNextOneSaysSo() throws Exception {
        start("");
        send(50);
        Thread.sleep(2500);
        stop("KILL");
        long pid = program.pid();
        Path rows = out.resolve(".live.flow.csv." + pid + ".caught");
        assertWholeRows(rows, 50_000);
        Path copy = Files.copy(out.resolve(".live.aedat." + pid + ".caught"), out.resolve("copy.aedat"));
        assertTrue(events(copy) > 40_000);
        start("");
        assertTrue(said(), said().contains("[" + rows + "] was left by a run that was killed: " + Files.size(rows)
            + " bytes; give it another name to keep it, or delete it\n"));
        stop("TERM");
        assertTrue("nothing of it is deleted", Files.exists(rows));
    }

    @Test(timeout = 180_000)
    public void secondCtrlCEndsAtOnceAndDeletesNothing() throws Exception {
        start("");
        send(20);
        Thread.sleep(1500);
        // the first one asks the run to finish, which it cannot while the process stands
        new ProcessBuilder("sh", "-c", "kill -STOP " + program.pid() + "; kill -TERM " + program.pid() + "; kill -TERM "
            + program.pid() + "; kill -CONT " + program.pid()).start().waitFor();
        assertTrue(program.waitFor(1, TimeUnit.MINUTES));
        assertTrue(files().toString(), files().stream().anyMatch(name -> name.contains("live.flow.csv")));
        assertTrue(files().toString(), files().stream().anyMatch(name -> name.contains("live.aedat")));
    }
}
