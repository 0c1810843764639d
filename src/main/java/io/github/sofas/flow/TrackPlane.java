package io.github.sofas.flow;

/** One structure that is tracked. */
final class TrackPlane {
    static final int MARGIN = 24;
    private static final int HISTORY = 64;

    final SofasParameters p;
    final int gw;
    final int gh;
    /** Live events a cell: ON in the low half, OFF in the high half. */
    final int[] support;

    // live events, a ring in order of time
    final long[] time;
    final short[] x;
    final short[] y;
    final byte[] sign;
    /** Whether two planes claimed the event: it shows nothing of the velocity of either. */
    final boolean[] shared;
    final int[] cell;
    final int mask;
    int head;
    int tail;

    int id;
    long firstUs;
    long lastUs;
    long events;

    /** Reference time of contour and motion. */
    long t0;
    // motion at t0
    double vx;
    double vy;
    double ax;
    double ay;
    double omega;
    private double rawAlong;
    private double rawAcross;
    private double rawOmega;
    /** Centre of rotation, on the sensor at t0. */
    double centreX;
    double centreY;
    private int vxQ;
    private int vyQ;
    /** Distance of the live events from the centre, root of the mean square, in px. */
    double radius;

    double meanSupport;
    int threshold;
    double lifetimePx;
    long lifetimeUs;
    double widen;
    private int sharedInSample;
    private boolean known;
    int sinceFit;
    long lastFitUs;
    int fits;
    // box of the contour on the grid
    int minX;
    int minY;
    int maxX;
    int maxY;
    // knowledge of the velocity
    double metric;
    double lossXx;
    double lossXy;
    double lossYy;
    /** Metric an event of all live events. */
    double density;
    double typicalLive;

    TrackPlane(int width, int height, SofasParameters p) {
        this.p = p;
        gw = width + 2 * MARGIN;
        gh = height + 2 * MARGIN;
        support = new int[gw * gh];
        int cap = 1 << 15;
        time = new long[cap];
        x = new short[cap];
        y = new short[cap];
        sign = new byte[cap];
        shared = new boolean[cap];
        cell = new int[cap];
        mask = cap - 1;
    }

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
        omega = 0;
        rawAlong = 0;
        rawAcross = 0;
        rawOmega = 0;
        radius = 0;
        widen = 1;
        density = 0;
        lifetimePx = p.lifetimePx();
        sinceFit = 0;
        fits = 0;
        meanSupport = 0;
        threshold = 4;
        typicalLive = 0;
        lastFitUs = now;
        lifetimeUs = lifetime();
        t0 = now;
        fix();
        emptyBox();
    }

    /** Speed of the contour, root of the mean square. */
    double speed() {
        return Math.sqrt(vx * vx + vy * vy + omega * omega * radius * radius);
    }

    private long lifetime() {
        return (long) Math.min(p.maxLifetimeUs(), lifetimePx / Math.max(speed(), 1e-3) * 1e6);
    }

    private void fix() {
        vxQ = Projection.fixed(vx);
        vyQ = Projection.fixed(vy);
    }

    float vxAt(int ex, int ey, long t) {
        double dt = (t - t0) * 1e-6;
        return (float) (vx + ax * dt - omega * (ey - centreY - vy * dt));
    }

    float vyAt(int ex, int ey, long t) {
        double dt = (t - t0) * 1e-6;
        return (float) (vy + ay * dt + omega * (ex - centreX - vx * dt));
    }

    /** Support of an event by the contour, in live events of the neighbourhood. */
    int supportOf(int ex, int ey, long t, int s) {
        long dt = t - t0;
        int cx = ex + MARGIN - Projection.travelled(vxQ, dt);
        int cy = ey + MARGIN - Projection.travelled(vyQ, dt);
        if (omega != 0) {
            double turn = omega * dt * 1e-6;
            double rx = cx - MARGIN - centreX;
            double ry = cy - MARGIN - centreY;
            cx += (int) Math.rint(turn * ry);
            cy -= (int) Math.rint(turn * rx);
        }
        if (cx < minX || cx > maxX || cy < minY || cy > maxY) {
            return 0;
        }
        int c = cy * gw + cx;
        int[] g = support;
        int sum = g[c - gw - 1] + g[c - gw] + g[c - gw + 1] + g[c - 1] + g[c] + g[c + 1]
            + g[c + gw - 1] + g[c + gw] + g[c + gw + 1];
        int on = sum & 0xffff;
        int off = sum >>> 16;
        return s > 0 ? 2 * on - off : 2 * off - on;
    }

    /** Adds an event at the newest end. */
    void add(int ex, int ey, long t, int s, boolean claimedTwice) {
        if (head - tail > mask) {
            drop();
        }
        int i = head++ & mask;
        time[i] = t;
        x[i] = (short) ex;
        y[i] = (short) ey;
        sign[i] = (byte) s;
        shared[i] = claimedTwice;
        place(i);
        lastUs = t;
    }

    private void place(int i) {
        double dt = (time[i] - t0) * 1e-6;
        double px = x[i] - (vx + 0.5 * ax * dt) * dt;
        double py = y[i] - (vy + 0.5 * ay * dt) * dt;
        if (omega != 0) {
            double turn = omega * dt;
            double rx = px - centreX;
            double ry = py - centreY;
            px += turn * ry - 0.5 * turn * turn * rx;
            py -= turn * rx + 0.5 * turn * turn * ry;
        }
        int cx = (int) (px + (MARGIN + 0.5));
        int cy = (int) (py + (MARGIN + 0.5));
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

    private void emptyBox() {
        minX = gw;
        minY = gh;
        maxX = 0;
        maxY = 0;
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

    /** Whether the last measurement had a clear top. */
    boolean isKnown() {
        return known;
    }

    int live() {
        return head - tail;
    }

    /** Moves the reference to now, and projects the live events anew. */
    private void rebuild(long now) {
        for (int i = tail; i != head; i++) {
            int c = cell[i & mask];
            if (c >= 0) {
                support[c] = 0;
            }
        }
        double dt = (now - t0) * 1e-6;
        centreX += (vx + 0.5 * ax * dt) * dt;
        centreY += (vy + 0.5 * ay * dt) * dt;
        vx += ax * dt;
        vy += ay * dt;
        t0 = now;
        fix();
        emptyBox();
        for (int i = tail; i != head; i++) {
            place(i & mask);
        }
        measureSupport();
    }

    private void measureSupport() {
        long sum = 0;
        int n = 0;
        double sx = 0;
        double sy = 0;
        double sq = 0;
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
            sum += sign[i & mask] > 0 ? 2 * on - off : 2 * off - on;
            int px = c % gw - MARGIN;
            int py = c / gw - MARGIN;
            sx += px;
            sy += py;
            sq += px * px + py * py;
            n++;
        }
        meanSupport = n == 0 ? 0 : (double) sum / n;
        threshold = Math.max(4, (int) (p.contourShare() * meanSupport));
        if (n > 0) {
            // the motion of the new centre is what the rotation about the old one gives it
            double nx = sx / n;
            double ny = sy / n;
            vx -= omega * (ny - centreY);
            vy += omega * (nx - centreX);
            fix();
            centreX = nx;
            centreY = ny;
            radius = Math.sqrt(Math.max(0, sq / n - nx * nx - ny * ny));
        }
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

    /** Projects a sample of the live events along the motion to the reference time. */
    private void load(MetricFit fit, long ref) {
        fit.clear();
        int n = live();
        int want = sample();
        long step = ((long) n << 16) / want;
        long at = 0;
        sharedInSample = 0;
        double refS = (ref - t0) * 1e-6;
        double cx = centreX + (vx + 0.5 * ax * refS) * refS;
        double cy = centreY + (vy + 0.5 * ay * refS) * refS;
        double mx = vx + ax * refS;
        double my = vy + ay * refS;
        for (int k = 0; k < want; k++, at += step) {
            // anywhere within its share of the ring: an even stride would beat with periodic events
            int i = (tail + (int) (at + (k * 0x9E3779B1L & 0xffff) * step / 0x10000 >> 16)) & mask;
            if (shared[i]) {
                sharedInSample++;
                continue;
            }
            double tau = (time[i] - ref) * 1e-6;
            double px = x[i] - (mx + 0.5 * ax * tau) * tau;
            double py = y[i] - (my + 0.5 * ay * tau) * tau;
            double rx = px - cx;
            double ry = py - cy;
            if (omega != 0) {
                double turn = omega * tau;
                px += turn * ry - 0.5 * turn * turn * rx;
                py -= turn * rx + 0.5 * turn * turn * ry;
            }
            fit.add((float) px, (float) py, (float) tau, (float) rx, (float) ry, sign[i]);
        }
    }

    /** Re-centres: measures the motion over the live events. */
    void recentre(MetricFit fit, long now) {
        expire(now);
        sinceFit = 0;
        lastFitUs = now;
        int n = live();
        if (n >= 12) {
            long oldest = time[tail & mask];
            double window = (now - oldest) * 1e-6;
            if (window > 1e-5) {
                long ref = (now + oldest) >> 1;
                load(fit, ref);
                if (fit.size >= 12) {
                    measure(fit, window, n, ref);
                }
            }
        }
        rebuild(now);
        lifetimeUs = lifetime();
        expire(now);
    }

    private void measure(MetricFit fit, double window, int n, long ref) {
        double half = window / 2;
        double px = 1 / half;
        if (fits == 0) {
            fit.frame(px);
        } else {
            fit.frame(metric, lossXx, lossXy, lossYy, p.neighbourLoss(), p.minStepPx() * px, p.maxStepPx() * px);
            fit.widen(widen);
        }
        fit.fit(0, 0, p.flatSigmas());
        double sharp = Math.max(fit.lossXx, fit.lossYy) * px * px;
        known = sharp > 0.01 * fit.metric;
        // in a thinned sample events meet by so much less
        density = fit.metric / fit.size * n / fit.size;
        metric = fit.metric;
        lossXx = fit.lossXx;
        lossXy = fit.lossXy;
        lossYy = fit.lossYy;
        // what is weakly known moves slowly: (L + S)^-1 L (v - v0), with a stiffness S the same all round
        double crossing = (double) sharedInSample / (sharedInSample + fit.size);
        double stiff = p.stiffness() * (1 + 10 * crossing) * metric / (px * px);
        double sxx = lossXx + stiff;
        double syy = lossYy + stiff;
        double det = sxx * syy - lossXy * lossXy;
        double rx = lossXx * fit.stepX + lossXy * fit.stepY;
        double ry = lossXy * fit.stepX + lossYy * fit.stepY;
        double stepX = fits == 0 ? fit.stepX : (syy * rx - lossXy * ry) / det;
        double stepY = fits == 0 ? fit.stepY : (sxx * ry - lossXy * rx) / det;
        widen = fit.steps > 1 ? Math.min(3, widen * 1.5) : Math.max(1, widen * 0.7);
        double moved = Math.hypot(stepX, stepY) / px;
        vx += stepX;
        vy += stepY;
        if (fit.flat) {
            // along a straight edge: back to the normal flow
            double along = (vy * fit.axisX() - vx * fit.axisY()) * p.flatDecay();
            vx += along * fit.axisY();
            vy -= along * fit.axisX();
        }
        if (crossing > p.maxShared()) {
            rawAlong *= 0.8;
            rawAcross *= 0.8;
            rawOmega *= 0.8;
            double keepX = ax * 0.2;
            double keepY = ay * 0.2;
            ax -= keepX;
            ay -= keepY;
            double since = (t0 - ref) * 1e-6;
            vx -= keepX * since;
            vy -= keepY * since;
            omega *= 0.8;
        } else if (fits >= 2 && moved < 1) {
            measureChange(fit, half, (t0 - ref) * 1e-6);
            double bend = Math.hypot(rawAlong, rawAcross) * half * half / 2;
            if (bend > p.maxBendPx()) {
                lifetimePx = Math.max(p.lifetimePx(), lifetimePx * 0.75);
            } else if (moved < p.steadyPx() && bend < 0.7 * p.maxBendPx()) {
                lifetimePx = Math.min(p.maxLifetimePx(), lifetimePx * 1.08);
            }
        }
        if (moved > 3 * p.steadyPx()) {
            lifetimePx = Math.max(p.lifetimePx(), lifetimePx * 0.8);
        }
        fits++;
    }

    /**
     * Measures how the motion changes over the window: acceleration along and across the path, and rotation.
     *
     * @param half half of the window in s
     * @param sinceMiddle time of the reference after the middle of the window, in s
     */
    private void measureChange(MetricFit fit, double half, double sinceMiddle) {
        double dirX = fit.axisX();
        double dirY = fit.axisY();
        double known = fit.flatness();
        double unit = 2 / (half * half);
        double unitPx = 1 / half;
        double h = unit * p.changePx();
        fit.fitAcceleration(dirX, dirY, h, 0.5);
        double along = ax * dirX + ay * dirY + fit.step;
        fit.fitAcceleration(-dirY, dirX, h, 0.5);
        double across = ay * dirX - ax * dirY + fit.step;
        rawAlong += p.changeGain() * (along - rawAlong);
        rawAcross += p.changeGain() * (across - rawAcross);
        // measured in the middle of the window, half of it ago: by now some of it is over
        along = p.foresight() * believe(rawAlong, unit);
        // along a straight edge nothing is known, of acceleration still less than of velocity
        across = p.foresight() * believe(rawAcross, unit) * known / (known + p.flatChange());
        double oldX = ax;
        double oldY = ay;
        ax = along * dirX - across * dirY;
        ay = along * dirY + across * dirX;
        // the velocity in the middle of the window stays
        vx += (ax - oldX) * sinceMiddle;
        vy += (ay - oldY) * sinceMiddle;
        if (p.rotation() && radius > 1) {
            double perPx = 1 / (half * radius);
            fit.fitRotation(perPx * p.changePx(), 0.5);
            rawOmega += p.changeGain() * (omega + fit.step - rawOmega);
            // nor is the rotation of a disc
            double shown = fit.loss * perPx * perPx;
            double best = Math.max(lossXx, lossYy) * unitPx * unitPx;
            omega = believe(rawOmega, perPx) * shown / (shown + p.flatChange() * best);
        }
    }

    /** A change that moves the end of the window by no more than the noise is none. */
    private double believe(double value, double perPx) {
        double px = value / perPx;
        return value * px * px / (px * px + p.bendPx() * p.bendPx());
    }
}
