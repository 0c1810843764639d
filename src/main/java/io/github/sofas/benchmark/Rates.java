package io.github.sofas.benchmark;

import java.util.Arrays;

/**
 * How fast some runs were over the same events.
 *
 * @param runs how many were timed
 * @param events how many events each run handled
 * @param minPerS events per second of the slowest run
 * @param medianPerS events per second of the middle run; the mean of the middle two where their number is even
 * @param maxPerS events per second of the fastest run
 * @param cpuNsPerEvent time per event takes of the processor in the middle run, without what other programs took
 * @param checksum of the result, equal for all runs, as 16 hexadecimal digits
 */
public record Rates(int runs, long events, double minPerS, double medianPerS, double maxPerS,
                    double cpuNsPerEvent, String checksum) {

    /**
     * Sums up.
     *
     * @param nanos how long each run took, in any order; at least one
     * @param cpuNanos how much of the processor's time each run took, in any order
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

    /** Time an event takes in the middle run, in ns. */
    public double medianNsPerEvent() {
        return 1e9 / medianPerS;
    }
}
