package io.github.sofas.benchmark;

import io.github.sofas.flow.SofasParameters;

/**
 * How a recording is measured.
 *
 * @param parameters of the engine
 * @param runs how often each part is timed, at least {@value #FEWEST_RUNS}
 * @param warmUps how often each part runs before, uncounted, at least 1
 * @param warmUpMs how long each part runs before, uncounted, to the end of a run: a short recording needs many runs
 *     until its code is compiled
 * @param mostEvents how many events of a recording are used at most, at least 1: all are held in memory
 * @param sampledMs how long the stages of whole runs are sampled, to the end of a run; at least one run is
 */
public record BenchmarkOptions(SofasParameters parameters, int runs, int warmUps, int warmUpMs,
                               int mostEvents, int sampledMs) {
    /** A median of fewer says little. */
    public static final int FEWEST_RUNS = 5;

    /** Checks every component. */
    public BenchmarkOptions {
        requireAtLeast("runs", FEWEST_RUNS, runs);
        requireAtLeast("warmUps", 1, warmUps);
        requireAtLeast("warmUpMs", 0, warmUpMs);
        requireAtLeast("mostEvents", 1, mostEvents);
        requireAtLeast("sampledMs", 0, sampledMs);
    }

    private static void requireAtLeast(String name, int least, int value) {
        if (value < least) {
            throw new IllegalArgumentException(name + " must be at least " + least + " but was " + value);
        }
    }
}
