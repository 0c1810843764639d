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

    private final FlowPlane plane;
    private final SofasParameters p;
    private final MetricFit fit;
    private final int n;
    private final long[] refusedUntil;
    private long nextLook;

    private final int[] label;
    private final int[] fill;
    private int filled;
    private int[] events = new int[4096];
    private int[] sizes = new int[256];
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

    /** Looks at the best projection, if there are new events enough, and hands what it finds to the stack. */
    void run(TrackPlaneStack stack) {
        long total = plane.total();
        if (total < nextLook) {
            return;
        }
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

    private boolean extract(int k, TrackPlaneStack stack) {
        int pieces = connect(plane.accumulator(k));
        boolean found = false;
        if (pieces > 0) {
            countEvents(k, pieces);
            for (int piece = 1; piece <= pieces && !stack.isFull(); piece++) {
                if (sizes[piece] >= p.minEvents()) {
                    int size = collect(k, piece);
                    if (refine(k, size)) {
                        track(size, stack);
                        found = true;
                    }
                }
            }
        }
        for (int i = 0; i < filled; i++) {
            label[fill[i]] = 0;
        }
        return found;
    }

    /** Numbers the pieces: cells above mean + w sd of the occupied ones, and occupied cells connected to them. */
    private int connect(short[] f) {
        double threshold = threshold(f);
        int columns = (1 << plane.rowBits()) - 1;
        int rows = f.length / (columns + 1) - 1;
        int pieces = 0;
        filled = 0;
        for (int c = 0; c < f.length; c++) {
            if (label[c] != 0 || Math.abs(f[c]) < threshold) {
                continue;
            }
            pieces++;
            int next = filled;
            fill[filled++] = c;
            label[c] = pieces;
            while (next < filled) {
                int d = fill[next++];
                int x = d & columns;
                int y = d >> plane.rowBits();
                for (int dy = -1; dy <= 1; dy++) {
                    for (int dx = -1; dx <= 1; dx++) {
                        int e = (y + dy & rows) << plane.rowBits() | x + dx & columns;
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

    private double threshold(short[] f) {
        long sum = 0;
        long squares = 0;
        int occupied = 0;
        for (short value : f) {
            int v = Math.abs(value);
            if (v != 0) {
                occupied++;
                sum += v;
                squares += (long) v * v;
            }
        }
        if (occupied == 0) {
            return Double.POSITIVE_INFINITY;
        }
        double mean = (double) sum / occupied;
        double sd = Math.sqrt(Math.max(0, (double) squares / occupied - mean * mean));
        return Math.max(LEAST_STRONG, mean + p.thresholdSd() * sd);
    }

    private void countEvents(int k, int pieces) {
        if (sizes.length <= pieces) {
            sizes = new int[2 * pieces];
        }
        Arrays.fill(sizes, 0, pieces + 1, 0);
        for (int e = plane.oldest(k / n); e != plane.end(); e++) {
            if (plane.sign(e) != 0) {
                sizes[label[plane.cell(k, e)]]++;
            }
        }
    }

    private int collect(int k, int piece) {
        if (sizes[piece] > events.length) {
            events = new int[2 * sizes[piece]];
        }
        int size = 0;
        for (int e = plane.oldest(k / n); e != plane.end(); e++) {
            if (plane.sign(e) != 0 && label[plane.cell(k, e)] == piece) {
                events[size++] = e;
            }
        }
        return size;
    }

    /** Whether the piece collected is a structure; its velocity is left in (vx, vy). */
    private boolean refine(int k, int size) {
        long firstUs = plane.timeUs(events[0]);
        long lastUs = plane.timeUs(events[size - 1]);
        double window = (lastUs - firstUs) * 1e-6;
        if (window <= 0) {
            return false;
        }
        load(size, (firstUs + lastUs) >> 1);
        climb(plane.vx(k), plane.vy(k), window);
        // the slowest of what is about as good: without the velocity along the edge
        double bestX = vx;
        double bestY = vy;
        double bestMetric = fit.metric();
        double axisX = fit.axisX();
        double axisY = fit.axisY();
        double across = vx * axisX + vy * axisY;
        double along = vy * axisX - vx * axisY;
        if (Math.abs(along) > 0.1 * Math.abs(across)) {
            climb(across * axisX, across * axisY, window);
            if (fit.metric() < (1 - p.slowestWithin()) * bestMetric
                    || vx * vx + vy * vy > bestX * bestX + bestY * bestY) {
                climb(bestX, bestY, window);
            }
        }
        // travel counts where it is seen: in the directions that would lose by standing still
        double loss = fit.lossXx() * vx * vx + 2 * fit.lossXy() * vx * vy + fit.lossYy() * vy * vy;
        double travelPx = Math.sqrt(Math.max(0, loss / fit.bestLoss())) * window;
        double density = fit.metric() / fit.size() * size / fit.size();
        return travelPx > 0.6 * p.flowTravelPx() && density >= p.evidence();
    }

    private void load(int size, long referenceUs) {
        fit.clear();
        int want = Math.min(size, Math.min(fit.capacity(), 2 * p.sampleEvents()));
        long stride = ((long) size << 16) / want;
        for (int a = 0; a < want; a++) {
            int e = events[(int) (a * stride >> 16)];
            fit.add(plane.x(e), plane.y(e), (plane.timeUs(e) - referenceUs) * 1e-6f, 0, 0, plane.sign(e));
        }
    }

    /** Climbs to the nearest top of the metric, from coarse to fine: the paper's refining cycles. */
    private void climb(double fromVx, double fromVy, double window) {
        vx = fromVx;
        vy = fromVy;
        double px = 2 / window;
        fit.frame(2 * px);
        for (int i = 0; i < MOST_FITS; i++) {
            fit.fit(vx, vy, p.flatSigmas());
            vx += fit.stepX();
            vy += fit.stepY();
            if (i >= 2 && fit.steps() < 0.3) {
                return;
            }
            fit.frame(fit.metric(), fit.lossXx(), fit.lossXy(), fit.lossYy(), p.neighbourLoss(), p.minStepPx() * px,
                p.maxStepPx() * px);
        }
    }

    private void track(int size, TrackPlaneStack stack) {
        long lastUs = plane.timeUs(events[size - 1]);
        TrackPlane found = stack.create(lastUs, vx, vy);
        for (int a = 0; a < size; a++) {
            int e = events[a];
            found.addPast(plane.x(e), plane.y(e), plane.timeUs(e), plane.sign(e));
        }
        stack.begin(found, lastUs);
        plane.takeOut(events, size);
    }

    void reset() {
        Arrays.fill(refusedUntil, 0);
        nextLook = 0;
    }
}
