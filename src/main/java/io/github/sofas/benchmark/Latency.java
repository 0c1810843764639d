package io.github.sofas.benchmark;

import java.util.Arrays;

/**
 * Percentiles of the times that packets took, in ns. A percentile is the smallest of these times that at least the
 * given share of the packets did not exceed (nearest rank).
 *
 * @param packets number of packets
 * @param p50Ns time for half of the packets
 * @param p99Ns time for 99 in a hundred packets
 * @param p999Ns time for 999 in a thousand packets
 * @param maxNs longest time
 */
public record Latency(int packets, long p50Ns, long p99Ns, long p999Ns, long maxNs) {

    /** Summarises the times, and sorts the array. All components are 0 if the array is empty. */
    static Latency of(long[] nanos) {
        Arrays.sort(nanos);
        return new Latency(nanos.length, percentile(nanos, 500), percentile(nanos, 990), percentile(nanos, 999),
            percentile(nanos, 1000));
    }

    /** Takes the share per mille, as a whole number: 0.999 times a thousand is not exact in floating point. */
    private static long percentile(long[] sorted, long perMille) {
        int n = sorted.length;
        return n == 0 ? 0 : sorted[(int) ((perMille * n + 999) / 1000) - 1];
    }
}
