package io.github.sofas.host;

import io.github.sofas.event.EventBatch;
import io.github.sofas.event.SensorSize;
import io.github.sofas.flow.EventLabeller;
import io.github.sofas.flow.FlowOutput;
import java.io.BufferedInputStream;
import java.io.BufferedOutputStream;
import java.io.DataInputStream;
import java.io.DataOutputStream;
import java.io.IOException;
import java.io.UncheckedIOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.time.Duration;
import java.util.ArrayList;
import java.util.List;
import java.util.concurrent.CompletableFuture;
import java.util.concurrent.TimeUnit;
import java.util.concurrent.atomic.AtomicBoolean;

/**
 * One of jAER's motion-flow filters with its default settings, run in jAER so that its results can be compared with the
 * engine's. jAER runs in another process, which receives the events and returns their flow through its standard input
 * and output. Each batch becomes one packet: unlike the engine's results, those of some filters depend on how the
 * events are cut into packets. Filters without segments give segment 1 to all events with flow.
 */
public final class JaerFilter implements EventLabeller, AutoCloseable {
    private static final int READY = 0x50fa5;
    /** Longest time that jAER may take to start: it starts in 3 s, or in 20 s on a busy machine. */
    private static final Duration LONGEST_START = Duration.ofSeconds(90);
    /** Longest time that the starter may take to end: it gives jAER 5 s. */
    private static final int LONGEST_END_S = 8;
    private static final String STARTER = "io.github.sofas.jaer.StartFilter";

    private final Process process;
    private final DataOutputStream out;
    private final DataInputStream in;
    private final Path log;
    private long filterNs;

    private JaerFilter(Process process, Path log) {
        this.process = process;
        this.log = log;
        out = new DataOutputStream(new BufferedOutputStream(process.getOutputStream(), 1 << 16));
        in = new DataInputStream(new BufferedInputStream(process.getInputStream(), 1 << 16));
    }

    /**
     * Starts jAER with a filter, without a viewer.
     *
     * @param plugin the plugin's jar, sofas-jAER.jar
     * @param folder folder of jAER
     * @param java the Java program to start; it also runs jAER, unless jAER brings its own Java
     * @param filterClass full name of the filter's class
     * @throws JaerException if jAER or the filter does not start
     */
    public static JaerFilter start(Path plugin, Path folder, Path java, Display display, String filterClass,
                                   SensorSize sensor) throws JaerException {
        return start(plugin, folder, java, display, filterClass, sensor, LONGEST_START);
    }

    static JaerFilter start(Path plugin, Path folder, Path java, Display display, String filterClass,
                            SensorSize sensor, Duration longest) throws JaerException {
        try {
            Path log = Files.createTempFile("sofas-jaer", ".log");
            ProcessBuilder builder = new ProcessBuilder(java.toString(), "-cp", plugin.toString(), STARTER,
                folder.toAbsolutePath().toString(), filterClass, Integer.toString(sensor.width()),
                Integer.toString(sensor.height())).redirectError(log.toFile());
            builder.environment().put("DISPLAY", display.name());
            JaerFilter filter = new JaerFilter(builder.start(), log);
            filter.awaitReady(filterClass, longest);
            return filter;
        } catch (JaerException e) {
            throw e;
        } catch (IOException e) {
            throw new JaerException("jAER cannot be started: " + e.getMessage());
        }
    }

    private void awaitReady(String filterClass, Duration longest) throws IOException {
        // a read from a process cannot be cancelled, but ends with the process
        AtomicBoolean answered = new AtomicBoolean();
        CompletableFuture.delayedExecutor(longest.toMillis(), TimeUnit.MILLISECONDS).execute(() -> {
            if (answered.compareAndSet(false, true)) {
                destroy();
            }
        });
        boolean ready = false;
        try {
            ready = in.readInt() == READY;
        } catch (IOException e) {
            // the process ended, or was ended; its log holds the reason
        }
        boolean late = !answered.compareAndSet(false, true);
        if (ready && !late) {
            return;
        }
        String words = lastWords();
        close();
        if (late) {
            throw new JaerException(filterClass + " was not ready in jAER within " + longest.toSeconds() + " s"
                + (words.isEmpty() ? "" : "; jAER said last: " + words));
        }
        throw new JaerException(words.isEmpty() ? "jAER ended before " + filterClass + " was ready" : words);
    }

    /**
     * Ends the starter, which ends jAER and deletes its temporary folder; ends both by force if that takes too long.
     */
    private void destroy() {
        List<ProcessHandle> started = process.descendants().toList();
        process.destroy();
        try {
            process.waitFor(LONGEST_END_S, TimeUnit.SECONDS);
        } catch (InterruptedException e) {
            Thread.currentThread().interrupt();
        }
        process.destroyForcibly();
        started.forEach(ProcessHandle::destroyForcibly);
    }

    /** Last message of a process that ended: its exception, or else the last line of its log. */
    private String lastWords() throws IOException {
        List<String> lines = new ArrayList<>(Files.readAllLines(log));
        lines.removeIf(String::isBlank);
        for (String line : lines) {
            if (line.startsWith("Exception in thread") || line.startsWith("Caused by:")) {
                return line;
            }
        }
        return lines.isEmpty() ? "" : lines.get(lines.size() - 1);
    }

    /**
     * {@inheritDoc}
     *
     * @throws UncheckedIOException if jAER has ended
     */
    @Override
    public void process(EventBatch batch, FlowOutput output) {
        if (batch.size() > output.capacity()) {
            throw new IllegalArgumentException("output must hold " + batch.size() + " events but holds "
                + output.capacity());
        }
        try {
            out.writeInt(batch.size());
            for (int i = 0; i < batch.size(); i++) {
                out.writeLong(batch.timeUs[i]);
                out.writeShort(batch.x[i]);
                out.writeShort(batch.y[i]);
                out.writeByte(batch.polarity[i]);
            }
            out.flush();
            filterNs += in.readLong();
            for (int i = 0; i < batch.size(); i++) {
                float vx = in.readFloat();
                float vy = in.readFloat();
                int segment = in.readInt();
                output.vxPxPerS[i] = segment == 0 ? 0 : vx;
                output.vyPxPerS[i] = segment == 0 ? 0 : vy;
                output.segment[i] = segment;
            }
        } catch (IOException e) {
            throw new UncheckedIOException("jAER ended early: " + words(), e);
        }
    }

    private String words() {
        try {
            return lastWords();
        } catch (IOException e) {
            return e.toString();
        }
    }

    /** Time that the filter itself took so far, in s. */
    public double seconds() {
        return filterNs * 1e-9;
    }

    /** Not supported: one filter labels one recording. */
    @Override
    public void reset() {
        throw new UnsupportedOperationException("start another");
    }

    /** Ends jAER. */
    @Override
    public void close() {
        try {
            out.writeInt(-1);
            out.close();
            process.waitFor(5, TimeUnit.SECONDS);
        } catch (IOException e) {
            // jAER has ended already
        } catch (InterruptedException e) {
            Thread.currentThread().interrupt();
        }
        destroy();
        try {
            Files.deleteIfExists(log);
        } catch (IOException e) {
            // one file stays behind in the folder for temporary files
        }
    }
}
