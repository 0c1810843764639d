package io.github.sofas.flow;

/** One structure that is tracked. */
final class TrackPlane {
    static final int MARGIN = 24;
    private static final int HISTORY = 64;

    final SofasParameters p;
    final int width;
    final int height;
    final int gw;
    final int gh;
    /** Live events a cell: ON in the low half, OFF in the high half. */
    final int[] support;

    // live events, a ring in order of time
    final long[] time;
    final int[] x16;
    final int[] y16;
    final byte[] sign;
    final int[] cell;
    final int mask;
    int head;
    int tail;

    int id;
    long firstUs;
    long lastUs;
    long events;
    double vx;
    double vy;
    double ax;
    double ay;
    /** Reference time of the contour. */
    long t0;
    int vxQ;
    int vyQ;
    double meanSupport;
    double lifetimePx;
    double widen;
    /** Metric an event of all live events. */
    double density;
    long lifetimeUs;
    int sinceFit;
    long lastFitUs;
    int fits;
    int steady;
    // box of the contour in contour coordinates
    int minX;
    int minY;
    int maxX;
    int maxY;
    // knowledge of the velocity
    double metric;
    double lxx;
    double lxy;
    double lyy;
    // history of velocity for path and acceleration
    final long[] histT = new long[HISTORY];
    final double[] histVx = new double[HISTORY];
    final double[] histVy = new double[HISTORY];
    final double[] histPath = new double[HISTORY];
    int hist;
    double path;
    double typicalLive;

    TrackPlane(SensorShape s, SofasParameters p) {
        this.p = p;
        width = s.width();
        height = s.height();
        gw = width + 2 * MARGIN;
        gh = height + 2 * MARGIN;
        support = new int[gw * gh];
        int cap = 1 << 15;
        time = new long[cap];
        x16 = new int[cap];
        y16 = new int[cap];
        sign = new byte[cap];
        cell = new int[cap];
        mask = cap - 1;
    }

    record SensorShape(int width, int height) { }

    void start(int newId, long now, double v0x, double v0y) {
        id = newId;
        firstUs = now;
        lastUs = now;
        events = 0;
        head = 0;
        tail = 0;
        vx = v0x;
        vy = v0y;
        ax = 0;
        ay = 0;
        widen = 1;
        density = 0;
        lifetimePx = p.lifetimePx();
        steady = 0;
        sinceFit = 0;
        fits = 0;
        hist = 0;
        path = 0;
        meanSupport = 0;
        typicalLive = 0;
        lastFitUs = now;
        lifetimeUs = lifetimeFromSpeed();
        setReference(now);
        remember(now);
    }

    private long lifetimeFromSpeed() {
        double speed = Math.hypot(vx, vy);
        return (long) Math.min(p.maxLifetimeUs(), lifetimePx / Math.max(speed, 1e-3) * 1e6);
    }

    void setReference(long now) {
        t0 = now;
        vxQ = (int) Math.round(vx * (1 << 28) / 1e6);
        vyQ = (int) Math.round(vy * (1 << 28) / 1e6);
    }

    /** Support of an event by the contour, in live events of the neighbourhood. */
    int supportOf(int x, int y, long t, int s) {
        long dt = t - t0;
        int cx = x + MARGIN - (int) ((vxQ * dt + (1L << 27)) >> 28);
        int cy = y + MARGIN - (int) ((vyQ * dt + (1L << 27)) >> 28);
        if (cx < minX || cx > maxX || cy < minY || cy > maxY) {
            return 0;
        }
        int c = cy * gw + cx;
        int[] g = support;
        int sum = g[c - gw - 1] + g[c - gw] + g[c - gw + 1] + g[c - 1] + g[c] + g[c + 1]
            + g[c + gw - 1] + g[c + gw] + g[c + gw + 1];
        int on = sum & 0xffff;
        int off = sum >>> 16;
        return s > 0 ? 2 * on + off : 2 * off + on;
    }

    int threshold() {
        return Math.max(4, (int) (p.contourShare() * meanSupport));
    }

    /** Adds an event at the newest end. */
    void add(int ex16, int ey16, long t, int s) {
        if (head - tail > mask) {
            drop();
        }
        int i = head++ & mask;
        time[i] = t;
        x16[i] = ex16;
        y16[i] = ey16;
        sign[i] = (byte) s;
        place(i);
        lastUs = t;
    }

    private void place(int i) {
        double dt = (time[i] - t0) * 1e-6;
        int cx = (int) Math.floor(x16[i] / 16.0 - (vx + 0.5 * ax * dt) * dt + 0.5) + MARGIN;
        int cy = (int) Math.floor(y16[i] / 16.0 - (vy + 0.5 * ay * dt) * dt + 0.5) + MARGIN;
        if (cx < 1 || cy < 1 || cx >= gw - 1 || cy >= gh - 1) {
            cell[i] = -1;
            return;
        }
        int c = cy * gw + cx;
        cell[i] = c;
        support[c] += sign[i] > 0 ? 1 : 0x10000;
        if (cx <= minX) {
            minX = Math.max(1, cx - 1);
        }
        if (cx >= maxX) {
            maxX = Math.min(gw - 2, cx + 1);
        }
        if (cy <= minY) {
            minY = Math.max(1, cy - 1);
        }
        if (cy >= maxY) {
            maxY = Math.min(gh - 2, cy + 1);
        }
    }

    private void drop() {
        int i = tail++ & mask;
        int c = cell[i];
        if (c >= 0) {
            support[c] -= sign[i] > 0 ? 1 : 0x10000;
        }
    }

    void expire(long now) {
        long oldest = now - lifetimeUs;
        while (tail != head && time[tail & mask] < oldest) {
            drop();
        }
    }

    /** Longer side of the box of the contour, in px. */
    int extent() {
        return Math.max(maxX - minX, maxY - minY) - 2;
    }

    int live() {
        return head - tail;
    }

    /** Re-projects the live events with the velocity of now. */
    void rebuild(long now) {
        for (int i = tail; i != head; i++) {
            int c = cell[i & mask];
            if (c >= 0) {
                support[c] = 0;
            }
        }
        setReference(now);
        minX = gw;
        minY = gh;
        maxX = 0;
        maxY = 0;
        for (int i = tail; i != head; i++) {
            place(i & mask);
        }
        // mean support seen by live events
        long sum = 0;
        int n = 0;
        int stride = Math.max(1, live() / 256);
        for (int i = tail; i < head; i += stride) {
            int c = cell[i & mask];
            if (c < 0) {
                continue;
            }
            int s9 = 0;
            for (int dy = -gw; dy <= gw; dy += gw) {
                s9 += support[c + dy - 1] + support[c + dy] + support[c + dy + 1];
            }
            int on = s9 & 0xffff;
            int off = s9 >>> 16;
            sum += sign[i & mask] > 0 ? 2 * on + off : 2 * off + on;
            n++;
        }
        meanSupport = n == 0 ? 0 : (double) sum / n;
    }

    /** Forgets everything, leaving the grid empty for the next use. */
    void clear() {
        while (tail != head) {
            drop();
        }
    }

    /**
     * How many live events a measurement needs: thinning them thins their meetings by the square, so that many events
     * that meet seldom are taken whole.
     */
    int sample() {
        int n = live();
        int least = p.sampleEvents();
        return n <= least ? n : (int) Math.max(least, Math.min(n, n * p.sampleDensity() / Math.max(density, 1e-3)));
    }

    void loadSample(MetricFit fit, long ref) {
        fit.clear();
        int n = live();
        int want = sample();
        // evenly spread over the ring
        long step = ((long) n << 16) / want;
        long at = 0;
        for (int k = 0; k < want; k++, at += step) {
            int i = (tail + (int) (at >> 16)) & mask;
            float tau = (time[i] - ref) * 1e-6f;
            double q = 0.5 * tau * tau * 16;
            fit.add(x16[i] - (int) Math.round(ax * q), y16[i] - (int) Math.round(ay * q), tau, sign[i]);
        }
    }

    /** Re-centres: measures the velocity over the live events. */
    void recentre(MetricFit fit, long now) {
        expire(now);
        sinceFit = 0;
        lastFitUs = now;
        int n = live();
        if (n >= 12) {
            long oldest = time[tail & mask];
            double window = (now - oldest) * 1e-6;
            long ref = (now + oldest) >> 1;
            if (window > 1e-5) {
                loadSample(fit, ref);
                // velocity in the middle of the window
                double back = (now - ref) * 1e-6;
                double midX = vx - ax * back;
                double midY = vy - ay * back;
                double px = 2 / window;
                if (fits == 0) {
                    fit.frame(px);
                } else {
                    fit.frame(metric, lxx, lxy, lyy, p.neighbourLoss(), p.minStepPx() * px, p.maxStepPx() * px);
                    fit.h1 *= widen;
                    fit.h2 *= widen;
                }
                fit.fit(midX, midY, p.flatShare());
                // in a thinned sample events meet by so much less
                density = fit.metric / fit.n * n / fit.n;
                metric = fit.metric;
                lxx = fit.lxx;
                lxy = fit.lxy;
                lyy = fit.lyy;
                vx += fit.dx;
                vy += fit.dy;
                widen = fit.step > 1 ? Math.min(3, widen * 1.5) : Math.max(1, widen * 0.7);
                double moved = Math.sqrt(Math.max(0, (lxx * fit.dx * fit.dx + 2 * lxy * fit.dx * fit.dy
                    + lyy * fit.dy * fit.dy) / Math.max(lxx, lyy))) / px;
                if (moved < p.steadyPx()) {
                    lifetimePx = Math.min(p.maxLifetimePx(), lifetimePx * 1.08);
                } else if (moved > 3 * p.steadyPx()) {
                    lifetimePx = Math.max(p.lifetimePx(), lifetimePx * 0.8);
                }
                fits++;
            }
        }
        remember(now);
        lifetimeUs = lifetimeFromSpeed();
        expire(now);
        rebuild(now);
    }

    private void remember(long now) {
        if (hist > 0) {
            path += Math.hypot(vx, vy) * (now - histT[(hist - 1) % HISTORY]) * 1e-6;
        }
        int i = hist++ % HISTORY;
        histT[i] = now;
        histVx[i] = vx;
        histVy[i] = vy;
        histPath[i] = path;
    }
}
