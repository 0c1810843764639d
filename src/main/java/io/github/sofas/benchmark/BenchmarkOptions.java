package io.github.sofas.benchmark;

import io.github.sofas.flow.SofasParameters;

/**
 * Options that determine how a {@link Benchmark} measures a recording.
 *
 * @param parameters parameters of the engine
 * @param runs number of timed runs of each part, at least {@value #FEWEST_RUNS}
 * @param warmUps least number of runs of each part before the timed ones, at least 1
 * @param warmUpMs least time in ms for which each part runs before the timed runs, up to the end of a run: a short
 *     recording needs many runs until its code is compiled
 * @param mostEvents greatest number of events of a recording to use, at least 1; all of them are held in memory
 * @param sampledMs least time in ms for which the stages of whole runs are sampled, up to the end of a run; at least
 *     one run is sampled
 */
public record BenchmarkOptions(SofasParameters parameters, int runs, int warmUps, int warmUpMs,
                               int mostEvents, int sampledMs) {
    /** Smallest number of timed runs; the median of fewer runs says little. */
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
