package io.github.sofas.evaluate;

import java.util.Arrays;

/**
 * Summary of a set of numbers, such as the errors of all events. All components are 0 if the set is empty.
 *
 * <p>The quantile p is the sorted number at position p (n + 1), counted from 1. A position between two numbers is
 * interpolated linearly, and positions are clamped to the first and the last number (definition 6 of Hyndman and Fan
 * 1996, as in jAER).
 *
 * @param count how many numbers there are, n
 * @param mean mean of the numbers
 * @param sd standard deviation with n - 1; 0 for a single number
 * @param lowerQuartile quantile 1/4
 * @param median quantile 1/2
 * @param upperQuartile quantile 3/4
 */
public record Distribution(long count, double mean, double sd, double lowerQuartile, double median,
                           double upperQuartile) {
    private static final Distribution NONE = new Distribution(0, 0, 0, 0, 0, 0);

    /** Gathers numbers one by one, all of which are kept until the summary is made. */
    static final class Gatherer {
        private double[] values = new double[256];
        private int size;

        void add(double value) {
            if (size == values.length) {
                values = Arrays.copyOf(values, 2 * size);
            }
            values[size++] = value;
        }

        Distribution distribution() {
            if (size == 0) {
                return NONE;
            }
            double[] sorted = Arrays.copyOf(values, size);
            Arrays.sort(sorted);
            double sum = 0;
            for (double value : sorted) {
                sum += value;
            }
            double mean = sum / size;
            double squares = 0;
            for (double value : sorted) {
                squares += (value - mean) * (value - mean);
            }
            double sd = size == 1 ? 0 : Math.sqrt(squares / (size - 1));
            return new Distribution(size, mean, sd, quantile(sorted, 0.25), quantile(sorted, 0.5),
                    quantile(sorted, 0.75));
        }

        private static double quantile(double[] sorted, double share) {
            int n = sorted.length;
            double position = share * (n + 1);
            int below = (int) Math.floor(position);
            if (below < 1) {
                return sorted[0];
            }
            if (below >= n) {
                return sorted[n - 1];
            }
            return sorted[below - 1] + (position - below) * (sorted[below] - sorted[below - 1]);
        }
    }
}
