package io.github.sofas.flow;

import java.util.Arrays;

/** Searches the events that no track plane takes for a velocity that many of them share. */
final class FlowPlane {
    private static final int BLOCK = 256;
    private static final int CELL_BITS = 9; // cells of 2 px, positions in 1/256 px

    /** A structure found. */
    interface Found {
        void structure(FlowPlane plane, int[] members, int n, MetricFit fit);
    }

    final SofasParameters p;
    final int n;
    final int dimX;
    final int dimY;
    final int shiftX;
    final int[] vxQ;
    final int[] vyQ;
    final double[] speed;
    final long[] windowUs;
    final short[][] acc;
    final long[] metric;
    final int[] count; // events in the window of a speed
    final int[] from; // oldest event in the window of a speed
    final int[] settledTo;

    long[] time;
    short[] ex;
    short[] ey;
    byte[] sign; // 0 once taken
    int mask;
    int head;
    int settled;
    long epoch;
    boolean started;
    long blockStart;

    private final int[] bx = new int[BLOCK];
    private final int[] by = new int[BLOCK];
    private final long[] bt = new long[BLOCK];
    private final int[] bs = new int[BLOCK];

    // search
    private final long[] refusedUntil;
    private long total;
    private long nextSearch;
    private final int[] label;
    private int[] queue;
    private int[] occupied;
    private int[] members = new int[4096];
    final MetricFit fit;
    double foundVx;
    double foundVy;
    int attempts;
    int successes;

    FlowPlane(int width, int height, SofasParameters p, MetricFit fit) {
        this.p = p;
        this.fit = fit;
        n = p.flowProjections();
        int cw = width / 2 + (int) p.flowTravelPx() / 2 + 3;
        int ch = height / 2 + (int) p.flowTravelPx() / 2 + 3;
        dimX = Integer.highestOneBit(cw - 1) << 1;
        dimY = Integer.highestOneBit(ch - 1) << 1;
        shiftX = Integer.numberOfTrailingZeros(dimX);
        vxQ = new int[n * n];
        vyQ = new int[n * n];
        speed = new double[n];
        windowUs = new long[n];
        acc = new short[n * n][dimX * dimY];
        metric = new long[n * n];
        count = new int[n];
        from = new int[n];
        settledTo = new int[n];
        for (int i = 0; i < n; i++) {
            speed[i] = p.slowestPxPerS() * Math.pow(p.fastestPxPerS() / p.slowestPxPerS(), i / (n - 1.0));
            windowUs[i] = Math.min(p.lifespanUs(), (long) (p.flowTravelPx() / speed[i] * 1e6));
            for (int j = 0; j < n; j++) {
                double a = 2 * Math.PI * (j + 0.5 * (i & 1)) / n;
                vxQ[i * n + j] = (int) Math.round(speed[i] * Math.cos(a) * 256 / 1e6 * (1 << 20));
                vyQ[i * n + j] = (int) Math.round(speed[i] * Math.sin(a) * 256 / 1e6 * (1 << 20));
            }
        }
        int cap = 1 << 14;
        time = new long[cap];
        ex = new short[cap];
        ey = new short[cap];
        sign = new byte[cap];
        mask = cap - 1;
        refusedUntil = new long[n * n];
        label = new int[dimX * dimY];
        queue = new int[dimX * dimY];
        occupied = new int[dimX * dimY];
    }

    void add(int x, int y, long t, int s) {
        if (!started) {
            started = true;
            epoch = t;
            blockStart = t;
        }
        if (head == settled) {
            blockStart = t;
        }
        int oldest = from[0];
        if (head - oldest > mask) {
            grow();
        }
        int i = head++ & mask;
        time[i] = t;
        ex[i] = (short) x;
        ey[i] = (short) y;
        sign[i] = (byte) s;
    }

    boolean blockFull(long now) {
        return head - settled >= BLOCK || head != settled && now - blockStart > 2000;
    }

    private void grow() {
        int oldCap = mask + 1;
        int cap = oldCap * 2;
        int newMask = cap - 1;
        long[] t2 = new long[cap];
        short[] x2 = new short[cap];
        short[] y2 = new short[cap];
        byte[] s2 = new byte[cap];
        for (int i = from[0]; i != head; i++) {
            t2[i & newMask] = time[i & mask];
            x2[i & newMask] = ex[i & mask];
            y2[i & newMask] = ey[i & mask];
            s2[i & newMask] = sign[i & mask];
        }
        time = t2;
        ex = x2;
        ey = y2;
        sign = s2;
        mask = newMask;
    }

    private int cellOf(int k, int i) {
        long dt = time[i] - epoch;
        int cx = (int) ((((long) ex[i] << 8) - ((vxQ[k] * dt) >> 20)) >> CELL_BITS) & dimX - 1;
        int cy = (int) ((((long) ey[i] << 8) - ((vyQ[k] * dt) >> 20)) >> CELL_BITS) & dimY - 1;
        return cy << shiftX | cx;
    }

    /** Projects the block of new events and lets the old ones go. */
    void settle(long now) {
        int newHead = head;
        if (newHead != settled) {
            int b = gather(settled, newHead);
            for (int i = 0; i < n; i++) {
                for (int j = 0; j < n; j++) {
                    metric[i * n + j] += addAll(i * n + j, b);
                }
                count[i] += b;
            }
            total += newHead - settled;
            settled = newHead;
        }
        for (int i = 0; i < n; i++) {
            long limit = now - windowUs[i];
            int a = from[i];
            while (a != settled && time[a & mask] < limit) {
                int e = a;
                int stop = a + BLOCK;
                while (e != settled && e != stop && time[e & mask] < limit) {
                    e++;
                }
                int b = gather(a, e);
                for (int j = 0; j < n; j++) {
                    metric[i * n + j] += removeAll(i * n + j, b);
                }
                count[i] -= b;
                a = e;
            }
            from[i] = a;
        }
    }

    private int gather(int a, int e) {
        int b = 0;
        for (int i = a; i != e; i++) {
            int k = i & mask;
            if (sign[k] != 0) {
                bx[b] = ex[k] << 8;
                by[b] = ey[k] << 8;
                bt[b] = time[k] - epoch;
                bs[b] = sign[k];
                b++;
            }
        }
        return b;
    }

    private long addAll(int k, int b) {
        short[] f = acc[k];
        long vx = vxQ[k];
        long vy = vyQ[k];
        int mx = dimX - 1;
        int my = dimY - 1;
        int sx = shiftX;
        long m = b;
        for (int i = 0; i < b; i++) {
            long t = bt[i];
            int cx = (int) ((bx[i] - ((vx * t) >> 20)) >> CELL_BITS) & mx;
            int cy = (int) ((by[i] - ((vy * t) >> 20)) >> CELL_BITS) & my;
            int c = cy << sx | cx;
            int s = bs[i];
            int v = f[c];
            m += 2 * s * v;
            f[c] = (short) (v + s);
        }
        return m;
    }

    private long removeAll(int k, int b) {
        short[] f = acc[k];
        long vx = vxQ[k];
        long vy = vyQ[k];
        int mx = dimX - 1;
        int my = dimY - 1;
        int sx = shiftX;
        long m = b;
        for (int i = 0; i < b; i++) {
            long t = bt[i];
            int cx = (int) ((bx[i] - ((vx * t) >> 20)) >> CELL_BITS) & mx;
            int cy = (int) ((by[i] - ((vy * t) >> 20)) >> CELL_BITS) & my;
            int c = cy << sx | cx;
            int s = bs[i];
            int v = f[c];
            m -= 2 * s * v;
            f[c] = (short) (v - s);
        }
        return m;
    }

    /** Takes events out of all projections. */
    void take(int[] which, int count0) {
        for (int a = 0; a < count0; a++) {
            int i = which[a];
            int k = i & mask;
            if (sign[k] == 0) {
                continue;
            }
            bx[0] = ex[k] << 8;
            by[0] = ey[k] << 8;
            bt[0] = time[k] - epoch;
            bs[0] = sign[k];
            for (int s = 0; s < n; s++) {
                if (i - from[s] >= 0) {
                    for (int j = 0; j < n; j++) {
                        metric[s * n + j] += removeAll(s * n + j, 1);
                    }
                    count[s]--;
                }
            }
            sign[k] = 0;
        }
    }

    /** Looks for structures; each one found is handed over and its events taken out. */
    void search(long now, Found found) {
        if (total < nextSearch) {
            return;
        }
        nextSearch = total + 128;
        int best = -1;
        double bestRate = 0;
        double cells = (double) (dimX * dimY);
        for (int i = 0; i < n; i++) {
            int ni = count[i];
            if (ni < p.minEvents()) {
                continue;
            }
            double chance = 6 * ni * Math.sqrt(2 / cells);
            for (int j = 0; j < n; j++) {
                int k = i * n + j;
                double excess = metric[k] - ni;
                if (excess < chance || excess < p.evidence() * p.minEvents() || total < refusedUntil[k]) {
                    continue;
                }
                double rate = excess * speed[i];
                if (rate > bestRate) {
                    bestRate = rate;
                    best = k;
                }
            }
        }
        if (best >= 0) {
            attempts++;
            if (extract(best, now, found)) {
                successes++;
                nextSearch = total;
            } else {
                refusedUntil[best] = total + Math.max(64, count[best / n] / 4);
                nextSearch = total + Math.max(128, count[best / n] / 8);
            }
        }
    }

    private boolean extract(int k, long now, Found found) {
        int ring = k / n;
        short[] f = acc[k];
        int begin = from[ring];
        // threshold over occupied cells
        long sum = 0;
        long sq = 0;
        int occ = 0;
        for (int c = 0; c < f.length; c++) {
            int v = Math.abs(f[c]);
            if (v != 0) {
                occ++;
                sum += v;
                sq += (long) v * v;
            }
        }
        double mean = (double) sum / occ;
        double sd = Math.sqrt(Math.max(0, (double) sq / occ - mean * mean));
        int threshold = (int) Math.max(3, Math.ceil(mean + p.thresholdSd() * sd));
        // flood fill from strong cells through occupied ones
        int labels = 0;
        int touched = 0;
        for (int c = 0; c < f.length; c++) {
            if (label[c] != 0 || Math.abs(f[c]) < threshold) {
                continue;
            }
            labels++;
            int q = touched;
            queue[touched++] = c;
            label[c] = labels;
            while (q < touched) {
                int d = queue[q++];
                int x = d & dimX - 1;
                int y = d >> shiftX;
                for (int dy = -1; dy <= 1; dy++) {
                    for (int dx = -1; dx <= 1; dx++) {
                        int e = ((y + dy) & dimY - 1) << shiftX | (x + dx) & dimX - 1;
                        if (label[e] == 0 && Math.abs(f[e]) >= 2) {
                            label[e] = labels;
                            queue[touched++] = e;
                        }
                    }
                }
            }
        }
        boolean any = false;
        if (labels > 0) {
            int[] size = new int[labels + 1];
            for (int i = begin; i != settled; i++) {
                if (sign[i & mask] != 0) {
                    size[label[cellOf(k, i & mask)]]++;
                }
            }
            for (int l = 1; l <= labels; l++) {
                if (size[l] < p.minEvents()) {
                    continue;
                }
                if (size[l] > members.length) {
                    members = new int[size[l] * 2];
                }
                int m = 0;
                for (int i = begin; i != settled; i++) {
                    if (sign[i & mask] != 0 && label[cellOf(k, i & mask)] == l) {
                        members[m++] = i;
                    }
                }
                any |= piece(k, members, m, found);
            }
        }
        for (int i = 0; i < touched; i++) {
            label[queue[i]] = 0;
        }
        return any;
    }

    /** Checks one connected piece: its own best velocity, its travel and sharpness. */
    private boolean piece(int k, int[] which, int m, Found found) {
        long first = time[which[0] & mask];
        long last = time[which[m - 1] & mask];
        double window = (last - first) * 1e-6;
        if (window <= 0) {
            return false;
        }
        long ref = (first + last) >> 1;
        fit.clear();
        int want = Math.min(m, Math.min(fit.capacity(), 4 * p.sampleEvents()));
        long step = ((long) m << 16) / want;
        for (int a = 0; a < want; a++) {
            int i = which[(int) (a * step >> 16)] & mask;
            fit.add(ex[i], ey[i], (time[i] - ref) * 1e-6f, 0, 0, sign[i]);
        }
        double vx = vxQ[k] / 256.0 * 1e6 / (1 << 20);
        double vy = vyQ[k] / 256.0 * 1e6 / (1 << 20);
        climb(vx, vy, window);
        double bestX = foundVx;
        double bestY = foundVy;
        double bestMetric = fit.metric;
        // a straight edge slides along itself at any speed: the slowest of what is about as good is right
        double l1 = larger(fit.lossXx, fit.lossXy, fit.lossYy);
        double angle = 0.5 * Math.atan2(2 * fit.lossXy, fit.lossXx - fit.lossYy);
        double ex1 = Math.cos(angle);
        double ey1 = Math.sin(angle);
        double across = bestX * ex1 + bestY * ey1;
        double along = bestY * ex1 - bestX * ey1;
        if (Math.abs(along) > 0.1 * Math.abs(across)) {
            climb(across * ex1, across * ey1, window);
            if (fit.metric < (1 - p.slowestWithin()) * bestMetric
                    || Math.hypot(foundVx, foundVy) > Math.hypot(bestX, bestY)) {
                climb(bestX, bestY, window);
            }
            l1 = larger(fit.lossXx, fit.lossXy, fit.lossYy);
        }
        // travel counts where it is seen: in the directions that would lose by standing still
        double seen = fit.lossXx * foundVx * foundVx + 2 * fit.lossXy * foundVx * foundVy
            + fit.lossYy * foundVy * foundVy;
        double travel = Math.sqrt(Math.max(0, seen / l1)) * window;
        double density = fit.metric / want * m / want;
        if (!(travel > 0.6 * p.flowTravelPx()) || density < p.evidence()) {
            return false;
        }
        found.structure(this, which, m, fit);
        take(which, m);
        return true;
    }

    /** Climbs to the nearest top of the metric, from coarse to fine. */
    private void climb(double vx0, double vy0, double window) {
        double vx = vx0;
        double vy = vy0;
        double px = 2 / window;
        fit.frame(2 * px);
        for (int c = 0; c < 8; c++) {
            fit.fit(vx, vy, p.flatSigmas());
            vx += fit.stepX;
            vy += fit.stepY;
            if (c >= 2 && fit.steps < 0.3) {
                break;
            }
            fit.frame(fit.metric, fit.lossXx, fit.lossXy, fit.lossYy, p.neighbourLoss(), p.minStepPx() * px,
                p.maxStepPx() * px);
        }
        foundVx = vx;
        foundVy = vy;
    }

    private static double larger(double xx, double xy, double yy) {
        double d = (xx - yy) / 2;
        return (xx + yy) / 2 + Math.sqrt(d * d + xy * xy);
    }

    void reset() {
        for (short[] f : acc) {
            Arrays.fill(f, (short) 0);
        }
        Arrays.fill(metric, 0);
        Arrays.fill(count, 0);
        Arrays.fill(from, 0);
        Arrays.fill(refusedUntil, 0);
        head = 0;
        settled = 0;
        total = 0;
        nextSearch = 0;
        started = false;
    }
}
