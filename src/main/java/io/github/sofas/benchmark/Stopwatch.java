package io.github.sofas.benchmark;

import io.github.sofas.event.EventSourceException;
import java.io.IOException;
import java.lang.management.ManagementFactory;
import java.lang.management.ThreadMXBean;

/** Times repeated runs of a part of a {@link Benchmark}, and checks that all of them give the same result. */
final class Stopwatch {
    private static final ThreadMXBean THREADS = ManagementFactory.getThreadMXBean();
    private static final long NANOS_PER_MS = 1_000_000;

    private final BenchmarkOptions options;

    /** One run of one part. */
    @FunctionalInterface
    interface Run {
        void run() throws EventSourceException, IOException;
    }

    /** Returns the checksum of the previous run's result; not timed. */
    @FunctionalInterface
    interface Result {
        long checksum() throws EventSourceException, IOException;
    }

    Stopwatch(BenchmarkOptions options) {
        this.options = options;
    }

    /**
     * Warms up a part and times it.
     *
     * @param part name of the part, for messages
     * @throws IllegalStateException if the result of a run differs from that of the warm-up
     */
    Rates time(String part, long events, Run run, Result result) throws EventSourceException, IOException {
        long warmUpStart = System.nanoTime();
        for (int i = 0; i < options.warmUps()
                || System.nanoTime() - warmUpStart < options.warmUpMs() * NANOS_PER_MS; i++) {
            run.run();
        }
        long checksum = result.checksum();
        long[] nanos = new long[options.runs()];
        long[] cpuNanos = new long[nanos.length];
        for (int i = 0; i < nanos.length; i++) {
            // Garbage of the previous run must not count for this run.
            Memory.collect();
            long cpuStart = THREADS.getCurrentThreadCpuTime();
            long start = System.nanoTime();
            run.run();
            nanos[i] = System.nanoTime() - start;
            cpuNanos[i] = THREADS.getCurrentThreadCpuTime() - cpuStart;
            long again = result.checksum();
            if (again != checksum) {
                throw new IllegalStateException(String.format("the results of %s must be the same in every run but "
                    + "their checksums were %016x and %016x", part, checksum, again));
            }
        }
        return Rates.of(events, nanos, cpuNanos, checksum);
    }
}
