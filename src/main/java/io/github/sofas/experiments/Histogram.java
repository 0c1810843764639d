package io.github.sofas.experiments;

/**
 * The distribution of errors by their size. The bins are equally wide, from -limit to limit; errors beyond that range
 * are counted separately.
 *
 * @param limit half the width of the range that the bins cover
 * @param counts number of errors in each bin
 * @param below number of errors under -limit
 * @param above number of errors of limit and over
 */
record Histogram(double limit, long[] counts, long below, long above) {

    /** Lower bound of a bin, inclusive; the upper bound, one width above, is exclusive. */
    double from(int bin) {
        return -limit + bin * width();
    }

    double width() {
        return 2 * limit / counts.length;
    }

    double middle(int bin) {
        return from(bin) + width() / 2;
    }

    long total() {
        long total = below + above;
        for (long count : counts) {
            total += count;
        }
        return total;
    }

    /** Share of all errors that lie in a bin, in %; 0 if there are no errors. */
    double percent(int bin) {
        long total = total();
        return total == 0 ? 0 : 100.0 * counts[bin] / total;
    }

    /** Counts errors one by one. */
    static final class Gatherer {
        private final double limit;
        private final long[] counts;
        private long below;
        private long above;

        Gatherer(double limit, int bins) {
            this.limit = limit;
            counts = new long[bins];
        }

        void add(double value) {
            int bin = (int) Math.floor((value + limit) * counts.length / (2 * limit));
            if (bin < 0) {
                below++;
            } else if (bin >= counts.length) {
                above++;
            } else {
                counts[bin]++;
            }
        }

        Histogram histogram() {
            return new Histogram(limit, counts.clone(), below, above);
        }
    }
}
