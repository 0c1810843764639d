package io.github.sofas.flow.paper;

import io.github.sofas.flow.motion.Projection;
import java.util.Arrays;

/**
 * The accumulators of the paper's flow plane and their metrics: n x n projections of signed votes, with the greatest
 * metric after every single vote.
 *
 * <p>Votes wait until they are asked for, and are then given projection by projection: the accumulators together are
 * far larger than a core's cache, the part of one that a block touches is not. The n² shifts of an event are n along x
 * and n along y, computed once for all projections. Adding w to a cell raises the metric by 2 w f + w².
 *
 * <p>The greatest metric after each vote is kept as a number that orders as wanted: the metric, and below it the rank
 * of the projection, the slowest having the highest. So that one maximum finds both, in any order of projections.
 */
final class Votes {
    /** Most votes that wait. */
    static final int BLOCK = 512;
    /** Bits of a rank. A metric has at most 30: no more than 32,767 votes are held. */
    private static final int RANK_BITS = 10;
    private static final int RANK_MASK = (1 << RANK_BITS) - 1;

    private final int n;
    /** Velocity of column i of the projections along x, and of row i along y. */
    private final int[] velocity;
    private final int[] maskX;
    private final int[] maskY;
    private final int[] shift;
    private final short[][] accumulator;
    private final long[] metric;
    /** Rank of each projection, and the projection of each rank. */
    private final int[] rank;
    private final int[] byRank;

    // votes that wait: where they fall in each column and each row of the projections, and their weight
    private final int[][] column;
    private final int[][] row;
    private final int[] weight = new int[BLOCK];
    private int size;
    /** Of each vote settled last, the greatest metric after it, with its rank. */
    private final long[] greatest = new long[BLOCK];
    /** What was read ahead; kept, or the compiler would leave the reading out. */
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

    /** Projections from the fastest to the slowest; of equal ones the later first. */
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

    /** Adds a vote w, which waits; there must be room. */
    void add(int x, int y, long sinceReferenceUs, int w) {
        int at = size++;
        weight[at] = w;
        for (int i = 0; i < n; i++) {
            int travelled = Projection.travelled(velocity[i], sinceReferenceUs);
            column[i][at] = x - travelled & maskX[i];
            row[i][at] = y - travelled & maskY[i];
        }
    }

    /** How many votes wait. */
    int waiting() {
        return size;
    }

    /** Gives the votes that wait to all projections. */
    void settle() {
        Arrays.fill(greatest, 0, size, 0);
        for (int k = 0; k < metric.length; k++) {
            fetched += fetch(accumulator[k], column[k % n], row[k / n], shift[k % n]);
            vote(k, accumulator[k], column[k % n], row[k / n], shift[k % n]);
        }
        size = 0;
    }

    /**
     * Reads the cells that a block is to change, so that they are in the cache: memory delivers many at once to reads
     * that wait for nothing, where votes come at the pace of one after the other. All in all a third faster.
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
            // the greater of both, without a branch: where loads from f wait for memory, a wrong guess would stop them
            long more = ranked - most[i];
            most[i] += more & ~(more >> 63);
        }
        metric[k] = ranked >> RANK_BITS;
    }

    /** The projection whose metric was the greatest after a vote of those settled last; of equals the slowest. */
    int greatestAfter(int vote) {
        return byRank[(int) greatest[vote] & RANK_MASK];
    }

    /** Metric of a projection, without the votes that wait. */
    long metric(int k) {
        return metric[k];
    }
}
