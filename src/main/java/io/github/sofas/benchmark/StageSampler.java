package io.github.sofas.benchmark;

import io.github.sofas.event.EventSourceException;
import java.io.IOException;
import java.util.EnumMap;
import java.util.Map;
import java.util.Random;

/**
 * Samples the stack of a running thread every few milliseconds and counts the {@linkplain Stage stages}. The hot loops
 * therefore need no clocks.
 *
 * <p>The virtual machine shows a thread's stack at its next safepoint, at the end of a counted loop or at a return.
 * This blurs the shares of single methods, but hardly those of stages. Java Flight Recorder, which samples at any
 * instruction, gave shares that differed by at most 6 percentage points on four scenes. This class needs neither the
 * recorder's module nor its files.
 */
final class StageSampler implements Runnable {
    private static final int LONGEST_PAUSE_MS = 3;

    private final Thread watched;
    private final long[] seen = new long[Stage.values().length];
    private volatile boolean over;

    private StageSampler(Thread watched) {
        this.watched = watched;
    }

    /** Runs for at least {@code leastMs} and at least once. Returns each stage's share of the time, 1 in total. */
    static Map<Stage, Double> shares(Stopwatch.Run run, int leastMs) throws EventSourceException, IOException {
        StageSampler sampler = new StageSampler(Thread.currentThread());
        Thread thread = new Thread(sampler, "stage sampler");
        thread.setDaemon(true);
        thread.start();
        try {
            long start = System.nanoTime();
            do {
                run.run();
            } while (System.nanoTime() - start < leastMs * 1_000_000L);
        } finally {
            sampler.stop(thread);
        }
        return shares(sampler.seen);
    }

    private void stop(Thread thread) {
        over = true;
        try {
            thread.join();
        } catch (InterruptedException e) {
            // The counts so far are the result; the caller sees the interruption.
            Thread.currentThread().interrupt();
        }
    }

    @Override
    public void run() {
        // Pauses of different lengths keep the samples from falling into step with the work.
        Random random = new Random(1);
        try {
            while (!over) {
                Thread.sleep(1 + random.nextInt(LONGEST_PAUSE_MS));
                seen[Stage.of(watched.getStackTrace()).ordinal()]++;
            }
        } catch (InterruptedException e) {
            over = true;
        }
    }

    /** Computes shares from counts by ordinal; the result is empty if nothing was counted. */
    static Map<Stage, Double> shares(long[] seen) {
        long all = 0;
        for (long count : seen) {
            all += count;
        }
        Map<Stage, Double> shares = new EnumMap<>(Stage.class);
        if (all > 0) {
            for (Stage stage : Stage.values()) {
                shares.put(stage, (double) seen[stage.ordinal()] / all);
            }
        }
        return shares;
    }
}
