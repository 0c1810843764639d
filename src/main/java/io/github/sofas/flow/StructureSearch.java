package io.github.sofas.flow;

import java.util.Arrays;

/**
 * Finds structures in the flow plane: the best projection, the cells that stand out in it and what is connected to them
 * (paper, section Flow Plane), and the motion of each connected piece.
 *
 * <p>Ours, because sliding an edge along itself at any speed is rewarded while counts are small: a piece is accepted
 * only when it has travelled enough to be told from one that stands still, and meets itself often enough; and of
 * velocities that are about as good the slowest is taken. And because several structures may share the best projection
 * roughly, each connected piece is refined by itself; pieces of one structure are merged by the stack.
 */
final class StructureSearch {
    /** Unmatched events between two looks. */
    private static final int EVERY = 128;
    /** Standard deviations by which a metric must pass what chance gives. */
    private static final double CHANCE_SIGMAS = 6;
    private static final int LEAST_STRONG = 3;
    private static final int LEAST_OCCUPIED = 2;
    private static final int MOST_FITS = 8;
    /** Share of the evidence below which a piece is given up after three fits. */
    private static final double HOPELESS = 0.75;
    /** Votes after which a look ends with the piece that it is at, about a millisecond; the next look goes on. */
    private static final int MOST_VOTES = 200_000;
    /**
     * Time until the next look for each vote that one took: about twice what it costs, so that labelling catches up
     * where events come as fast as they are labelled. Time of the events, so that results do not depend on the machine.
     */
    private static final double REST_US_PER_VOTE = 0.01;
    /** Share of its events that a piece must not have been looked at with before, in vain. */
    private static final double NEWS = 0.25;

    private final FlowPlane plane;
    private final int n;
    private final long[] refusedUntil;
    private SofasParameters p;
    private MetricFit fit;
    private long nextLook;
    private long restsUntilUs = Long.MIN_VALUE;
    /** Votes that the look has given and taken back. */
    private long votes;

    private final int[] label;
    private final int[] fill;
    private int filled;
    // events of the best projection by piece, as numbers of the flow plane; and the piece that is looked at
    private int[] events = new int[4096];
    private int[] pieceOf = new int[4096];
    private int[] starts = new int[256];
    private int from;
    private int size;
    private double vx;
    private double vy;

    StructureSearch(FlowPlane plane, SofasParameters p, MetricFit fit) {
        this.plane = plane;
        this.p = p;
        this.fit = fit;
        n = plane.n();
        refusedUntil = new long[n * n];
        label = new int[plane.cells()];
        fill = new int[plane.cells()];
    }

    /** Looks on with other parameters that leave the flow plane as it is. */
    void setParameters(SofasParameters next, MetricFit nextFit) {
        p = next;
        fit = nextFit;
    }

    /** Looks at the best projection, if there are new events enough, and hands what it finds to the stack. */
    void run(TrackPlaneStack stack, long nowUs) {
        long total = plane.total();
        if (total < nextLook || nowUs < restsUntilUs) {
            return;
        }
        votes = 0;
        nextLook = total + EVERY;
        int best = best();
        if (best < 0) {
            return;
        }
        if (extract(best, stack)) {
            nextLook = total;
        } else {
            int held = plane.count(best / n);
            refusedUntil[best] = total + Math.max(64, held / 4);
            nextLook = total + Math.max(EVERY, held / 8);
        }
        restsUntilUs = nowUs + (long) (REST_US_PER_VOTE * votes);
    }

    /**
     * The projection whose metric gains most over chance in a time: signed votes at random places give one an event.
     * Per time, because slow projections hold events longer.
     */
    private int best() {
        int best = -1;
        double most = 0;
        for (int i = 0; i < n; i++) {
            int held = plane.count(i);
            if (held < p.minEvents()) {
                continue;
            }
            double least = Math.max(CHANCE_SIGMAS * held * Math.sqrt(2.0 / plane.cells()),
                p.evidence() * p.minEvents());
            for (int k = i * n; k < i * n + n; k++) {
                double gain = plane.metric(k) - held;
                if (gain >= least && gain * plane.speed(i) > most && plane.total() >= refusedUntil[k]) {
                    most = gain * plane.speed(i);
                    best = k;
                }
            }
        }
        return best;
    }

    /** Whether a structure was found, or pieces are left to look at. */
    private boolean extract(int k, TrackPlaneStack stack) {
        int pieces = connect(plane.accumulator(k), plane.metric(k));
        boolean found = false;
        if (pieces > 0) {
            sort(k, pieces);
            for (int piece = 1; piece <= pieces && votes < MOST_VOTES && !stack.isFull(); piece++) {
                from = starts[piece];
                size = starts[piece + 1] - from;
                if (size >= p.minEvents() && isNews(k / n)) {
                    long before = fit.votes();
                    if (refine(k)) {
                        track(stack);
                        found = true;
                        votes += (long) size * n * n;
                    } else {
                        refuse(k / n);
                    }
                    votes += fit.votes() - before;
                }
            }
            found |= votes >= MOST_VOTES;
        }
        for (int i = 0; i < filled; i++) {
            label[fill[i]] = 0;
        }
        return found;
    }

    /** Numbers the pieces: cells above mean + w sd of the occupied ones, and occupied cells connected to them. */
    private int connect(short[] f, long squares) {
        double threshold = threshold(f, squares);
        int columns = (1 << plane.columnBits()) - 1;
        int rows = f.length / (columns + 1) - 1;
        int pieces = 0;
        filled = 0;
        for (int c = 0; c < f.length; c++) {
            if (Math.abs(f[c]) < threshold || label[c] != 0) {
                continue;
            }
            pieces++;
            int next = filled;
            fill[filled++] = c;
            label[c] = pieces;
            while (next < filled) {
                int d = fill[next++];
                int x = d & columns;
                int y = d >> plane.columnBits();
                for (int dy = -1; dy <= 1; dy++) {
                    for (int dx = -1; dx <= 1; dx++) {
                        int e = (y + dy & rows) << plane.columnBits() | x + dx & columns;
                        if (label[e] == 0 && Math.abs(f[e]) >= LEAST_OCCUPIED) {
                            label[e] = pieces;
                            fill[filled++] = e;
                        }
                    }
                }
            }
        }
        return pieces;
    }

    /** Mean + w sd of the occupied cells, whose squares add up to the metric. */
    private double threshold(short[] f, long squares) {
        long sum = 0;
        int occupied = 0;
        // without a branch: half of the cells are occupied, here and there
        for (short value : f) {
            int v = Math.abs(value);
            sum += v;
            occupied += -v >>> Integer.SIZE - 1;
        }
        if (occupied == 0) {
            return Double.POSITIVE_INFINITY;
        }
        double mean = (double) sum / occupied;
        double sd = Math.sqrt(Math.max(0, (double) squares / occupied - mean * mean));
        return Math.max(LEAST_STRONG, mean + p.thresholdSd() * sd);
    }

    /** Sorts the events of a projection by the pieces that they fall on, in order of time. */
    private void sort(int k, int pieces) {
        if (starts.length < pieces + 2) {
            starts = new int[2 * pieces];
        }
        Arrays.fill(starts, 0, pieces + 2, 0);
        int ring = k / n;
        int held = plane.end(ring) - plane.oldest(ring);
        if (events.length < held) {
            events = new int[2 * held];
            pieceOf = new int[2 * held];
        }
        for (int i = 0; i < held; i++) {
            int e = plane.oldest(ring) + i;
            pieceOf[i] = plane.sign(e) == 0 ? 0 : label[plane.cell(k, e)];
            starts[pieceOf[i]]++;
        }
        int end = 0;
        for (int piece = 0; piece <= pieces + 1; piece++) {
            int its = starts[piece];
            starts[piece] = end;
            end += its;
        }
        for (int i = 0; i < held; i++) {
            events[starts[pieceOf[i]]++] = plane.oldest(ring) + i;
        }
        // each start moved to the next one's
        System.arraycopy(starts, 0, starts, 1, pieces + 1);
        starts[0] = 0;
    }

    /** Whether enough of the piece was not looked at in vain before. */
    private boolean isNews(int ring) {
        int old = 0;
        for (int a = from; a < from + size; a++) {
            if (plane.wasRefused(ring, events[a])) {
                old++;
            }
        }
        return old <= (1 - NEWS) * size;
    }

    private void refuse(int ring) {
        for (int a = from; a < from + size; a++) {
            plane.refuse(ring, events[a]);
        }
    }

    /** Whether the piece is a structure; its velocity is left in (vx, vy). */
    private boolean refine(int k) {
        long firstUs = plane.timeUs(events[from]);
        long lastUs = plane.timeUs(events[from + size - 1]);
        double window = (lastUs - firstUs) * 1e-6;
        if (window <= 0) {
            return false;
        }
        load(firstUs + (lastUs - firstUs) / 2);
        if (!climb(plane.vx(k), plane.vy(k), window, HOPELESS * p.evidence()) || !isEvident(window)) {
            return false;
        }
        // the slowest of what is about as good: without the velocity along the edge
        double bestX = vx;
        double bestY = vy;
        double bestMetric = fit.metric();
        double axisX = fit.axisX();
        double axisY = fit.axisY();
        double across = vx * axisX + vy * axisY;
        double along = vy * axisX - vx * axisY;
        if (Math.abs(along) > 0.1 * Math.abs(across)) {
            climb(across * axisX, across * axisY, window, 0);
            if (fit.metric() < (1 - p.slowestWithin()) * bestMetric
                    || vx * vx + vy * vy > bestX * bestX + bestY * bestY) {
                climb(bestX, bestY, window, 0);
            }
        }
        return isEvident(window);
    }

    /** Whether what was fitted last has travelled enough, and meets itself enough. */
    private boolean isEvident(double window) {
        // travel counts where it is seen: in the directions that would lose by standing still
        double loss = fit.lossXx() * vx * vx + 2 * fit.lossXy() * vx * vy + fit.lossYy() * vy * vy;
        double travelPx = Math.sqrt(Math.max(0, loss / fit.bestLoss())) * window;
        return travelPx > 0.6 * p.flowTravelPx() && density() >= p.evidence();
    }

    /** Metric an event of the whole piece; in a thinned sample events meet by so much less. */
    private double density() {
        return fit.metric() / fit.size() * size / fit.size();
    }

    private void load(long referenceUs) {
        fit.clear();
        int want = Math.min(size, Math.min(fit.capacity(), 2 * p.sampleEvents()));
        long stride = ((long) size << 16) / want;
        for (int a = 0; a < want; a++) {
            int e = events[from + (int) (a * stride >> 16)];
            fit.add(plane.x(e), plane.y(e), (plane.timeUs(e) - referenceUs) * 1e-6f, 0, 0, plane.sign(e));
        }
    }

    /**
     * Climbs to the nearest top of the metric, from coarse to fine: the paper's refining cycles.
     *
     * @return whether it got there; not where the density is still below a least one after three fits
     */
    private boolean climb(double fromVx, double fromVy, double window, double leastDensity) {
        vx = fromVx;
        vy = fromVy;
        double px = 2 / window;
        fit.frame(2 * px);
        for (int i = 0; i < MOST_FITS; i++) {
            fit.fit(vx, vy, p.flatSigmas());
            vx += fit.stepX();
            vy += fit.stepY();
            if (i == 2 && density() < leastDensity) {
                return false;
            }
            if (i >= 2 && fit.steps() < 0.3) {
                return true;
            }
            fit.frame(fit.metric(), fit.lossXx(), fit.lossXy(), fit.lossYy(), p.neighbourLoss(), p.minStepPx() * px,
                p.maxStepPx() * px);
        }
        return true;
    }

    private void track(TrackPlaneStack stack) {
        long lastUs = plane.timeUs(events[from + size - 1]);
        TrackPlane found = stack.create(lastUs, vx, vy);
        for (int a = from; a < from + size; a++) {
            int e = events[a];
            found.addPast(plane.x(e), plane.y(e), plane.timeUs(e), plane.sign(e));
        }
        stack.begin(found, lastUs);
        plane.takeOut(events, from, size);
    }

    void reset() {
        Arrays.fill(refusedUntil, 0);
        nextLook = 0;
        restsUntilUs = Long.MIN_VALUE;
    }
}
