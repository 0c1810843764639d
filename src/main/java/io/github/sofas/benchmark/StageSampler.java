package io.github.sofas.benchmark;

import io.github.sofas.event.EventSourceException;
import java.io.IOException;
import java.util.EnumMap;
import java.util.Map;
import java.util.Random;

/**
 * Looks at a running thread's stack every few milliseconds and counts the stages: the hot loops carry no clocks.
 *
 * <p>The virtual machine shows a thread's stack where it next can, at the end of a counted loop or at a return, so that
 * single methods are blurred; stages hardly are: Java Flight Recorder, which shows any instruction, gave shares that
 * differed by at most 6 points of a hundred on four scenes. This needs neither its module nor its files.
 */
final class StageSampler implements Runnable {
    private static final int LONGEST_PAUSE_MS = 3;

    private final Thread watched;
    private final long[] seen = new long[Stage.values().length];
    private volatile boolean over;

    private StageSampler(Thread watched) {
        this.watched = watched;
    }

    /** Runs at least so long and at least once, and gives the share of each stage in the time, together 1. */
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
            // What was counted until now is what there is; the caller sees the interruption.
            Thread.currentThread().interrupt();
        }
    }

    @Override
    public void run() {
        // Pauses of different length keep it from walking in step with the work.
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

    /** From counts by ordinal; empty where nothing was seen. */
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
