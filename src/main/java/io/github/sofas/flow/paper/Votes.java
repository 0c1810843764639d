package io.github.sofas.flow.paper;

import io.github.sofas.flow.motion.Projection;
import java.util.Arrays;

/**
 * The accumulators of the paper's flow plane and their metrics: n x n projections of signed votes, with the greatest
 * metric after every single vote.
 *
 * <p>Votes wait in a block until their effect is asked for, and are then cast projection by projection. All
 * accumulators together are far larger than the cache of a core, but the part of one that a block touches is not. The
 * n² shifts of an event are n along x and n along y, computed once for all projections. Adding w to a cell raises the
 * metric by 2 w f + w².
 *
 * <p>The greatest metric after each vote is kept in one number: the metric in the high bits, and the rank of the
 * projection in the low bits. The slowest projection has the highest rank. One maximum, taken over the projections in
 * any order, thus finds both.
 */
final class Votes {
    /** Greatest number of waiting votes. */
    static final int BLOCK = 512;
    /** Bits of a rank. A metric takes at most 30 bits, because no more than 32,767 votes are held. */
    private static final int RANK_BITS = 10;
    private static final int RANK_MASK = (1 << RANK_BITS) - 1;

    private final int n;
    /** Fixed-point velocity of column i of the projections along x, and of row i along y. */
    private final int[] velocity;
    private final int[] maskX;
    private final int[] maskY;
    private final int[] shift;
    private final short[][] accumulator;
    private final long[] metric;
    /** Rank of each projection, and the projection of each rank. */
    private final int[] rank;
    private final int[] byRank;

    // waiting votes: their cell column and row in each column and row of the projections, and their weight
    private final int[][] column;
    private final int[][] row;
    private final int[] weight = new int[BLOCK];
    private int size;
    /** Greatest metric, with its rank, after each vote of the block settled last. */
    private final long[] greatest = new long[BLOCK];
    /** Sum of what was read ahead. It is kept because the compiler would otherwise remove the reads. */
    private int fetched;

    Votes(int width, int height, Numbers p) {
        n = p.flowProjections();
        velocity = new int[n];
        maskX = new int[n];
        maskY = new int[n];
        shift = new int[n];
        for (int i = 0; i < n; i++) {
            velocity[i] = FlowPlane.velocity(i, p);
            maskX[i] = FlowPlane.side(width, velocity[i], p) - 1;
            maskY[i] = FlowPlane.side(height, velocity[i], p) - 1;
            shift[i] = Integer.bitCount(maskX[i]);
        }
        accumulator = new short[n * n][];
        for (int k = 0; k < n * n; k++) {
            accumulator[k] = new short[(maskX[k % n] + 1) * (maskY[k / n] + 1)];
        }
        metric = new long[n * n];
        byRank = fastestFirst();
        rank = new int[n * n];
        for (int r = 0; r < byRank.length; r++) {
            rank[byRank[r]] = r;
        }
        column = new int[n][BLOCK];
        row = new int[n][BLOCK];
    }

    /** Projections from the fastest to the slowest; of equally fast ones, the later comes first. */
    private int[] fastestFirst() {
        Integer[] order = new Integer[n * n];
        for (int k = 0; k < order.length; k++) {
            order[k] = order.length - 1 - k;
        }
        Arrays.sort(order, (a, b) -> Long.compare(squaredSpeed(b), squaredSpeed(a)));
        int[] fastestFirst = new int[order.length];
        for (int r = 0; r < order.length; r++) {
            fastestFirst[r] = order[r];
        }
        return fastestFirst;
    }

    private long squaredSpeed(int k) {
        return (long) velocity[k % n] * velocity[k % n] + (long) velocity[k / n] * velocity[k / n];
    }

    /** Adds a vote of weight w to those that wait; there must be room. */
    void add(int x, int y, long sinceReferenceUs, int w) {
        int at = size++;
        weight[at] = w;
        for (int i = 0; i < n; i++) {
            int travelled = Projection.travelled(velocity[i], sinceReferenceUs);
            column[i][at] = x - travelled & maskX[i];
            row[i][at] = y - travelled & maskY[i];
        }
    }

    /** Number of waiting votes. */
    int waiting() {
        return size;
    }

    /** Casts the waiting votes in all projections. */
    void settle() {
        Arrays.fill(greatest, 0, size, 0);
        for (int k = 0; k < metric.length; k++) {
            fetched += fetch(accumulator[k], column[k % n], row[k / n], shift[k % n]);
            vote(k, accumulator[k], column[k % n], row[k / n], shift[k % n]);
        }
        size = 0;
    }

    /**
     * Reads the cells that a block is about to change, so that they are in the cache. Memory serves many independent
     * reads at once, whereas votes follow one after the other. All in all, this is a third faster.
     */
    private int fetch(short[] f, int[] columns, int[] rows, int rowShift) {
        int sum = 0;
        for (int i = 0; i < size; i++) {
            sum += f[rows[i] << rowShift | columns[i]];
        }
        return sum;
    }

    private void vote(int k, short[] f, int[] columns, int[] rows, int rowShift) {
        int[] weights = weight;
        long[] most = greatest;
        long ranked = metric[k] << RANK_BITS | rank[k];
        for (int i = 0; i < size; i++) {
            int c = rows[i] << rowShift | columns[i];
            int w = weights[i];
            int before = f[c];
            f[c] = (short) (before + w);
            ranked += (long) (2 * w * before + 1) << RANK_BITS;
            // the greater of both, without a branch: a wrong prediction would stop loads from f that wait for memory
            long more = ranked - most[i];
            most[i] += more & ~(more >> 63);
        }
        metric[k] = ranked >> RANK_BITS;
    }

    /** The projection with the greatest metric after a vote of the block settled last; of equal ones, the slowest. */
    int greatestAfter(int vote) {
        return byRank[(int) greatest[vote] & RANK_MASK];
    }

    /** Metric of a projection, without the waiting votes. */
    long metric(int k) {
        return metric[k];
    }
}
