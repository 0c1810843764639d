package io.github.sofas.benchmark;

import java.util.Arrays;

/**
 * Rates of several runs over the same events.
 *
 * @param runs number of timed runs
 * @param events number of events that each run handled
 * @param minPerS events per second of the slowest run
 * @param medianPerS median of the events per second; the mean of the middle two runs if the number of runs is even
 * @param maxPerS events per second of the fastest run
 * @param cpuNsPerEvent median of the processor time per event in ns, without the time that other programs took
 * @param checksum checksum of the result, equal for all runs, as 16 hexadecimal digits
 */
public record Rates(int runs, long events, double minPerS, double medianPerS, double maxPerS,
                    double cpuNsPerEvent, String checksum) {

    /**
     * Summarises the times of the runs.
     *
     * @param nanos time that each run took, in any order; at least one run
     * @param cpuNanos processor time that each run took, in any order
     */
    static Rates of(long events, long[] nanos, long[] cpuNanos, long checksum) {
        double[] perS = Arrays.stream(nanos).mapToDouble(ns -> events * 1e9 / Math.max(1, ns)).sorted().toArray();
        double[] cpuNs = Arrays.stream(cpuNanos).mapToDouble(ns -> (double) ns / events).sorted().toArray();
        return new Rates(perS.length, events, perS[0], median(perS), perS[perS.length - 1], median(cpuNs),
            String.format("%016x", checksum));
    }

    private static double median(double[] sorted) {
        int n = sorted.length;
        return (sorted[(n - 1) / 2] + sorted[n / 2]) / 2;
    }

    /** Time per event at the median rate, in ns. */
    public double medianNsPerEvent() {
        return 1e9 / medianPerS;
    }
}
