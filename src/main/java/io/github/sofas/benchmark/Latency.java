package io.github.sofas.benchmark;

import java.util.Arrays;

/**
 * How long packets took, in ns. A percentile is the smallest time that at least that share of the packets did not
 * exceed (nearest rank).
 *
 * @param packets how many
 * @param p50Ns half
 * @param p99Ns 99 in a hundred
 * @param p999Ns 999 in a thousand
 * @param maxNs the longest
 */
public record Latency(int packets, long p50Ns, long p99Ns, long p999Ns, long maxNs) {

    /** Sums up; sorts the array. All are 0 where there is none. */
    static Latency of(long[] nanos) {
        Arrays.sort(nanos);
        return new Latency(nanos.length, percentile(nanos, 500), percentile(nanos, 990), percentile(nanos, 999),
            percentile(nanos, 1000));
    }

    /** Per mille and whole numbers: 0.999 times a thousand is not exact in floating point. */
    private static long percentile(long[] sorted, long perMille) {
        int n = sorted.length;
        return n == 0 ? 0 : sorted[(int) ((perMille * n + 999) / 1000) - 1];
    }
}
