package io.github.sofas.flow;

import io.github.sofas.event.SensorSize;
import java.util.ArrayList;
import java.util.List;
import java.util.function.Consumer;

/** The structures that are tracked. */
final class TrackPlaneStack implements FlowPlane.Found {
    private final SofasParameters p;
    private final SensorSize sensor;
    private final MetricFit fit;
    private final Consumer<Segment> ended;
    private final TrackPlane[] planes;
    private int size;
    private final List<TrackPlane> free = new ArrayList<>();
    private int nextId = 1;
    private boolean claimedTwice;
    private long nextCheck = Long.MIN_VALUE;

    TrackPlaneStack(SensorSize sensor, SofasParameters p, MetricFit fit, Consumer<Segment> ended) {
        this.sensor = sensor;
        this.p = p;
        this.fit = fit;
        this.ended = ended;
        planes = new TrackPlane[p.maxTrackPlanes()];
    }

    TrackPlane match(int x, int y, long t, int s) {
        TrackPlane best = null;
        double bestScore = 0;
        double secondScore = 0;
        for (int i = 0; i < size; i++) {
            TrackPlane a = planes[i];
            int v = a.supportOf(x, y, t, s);
            if (v >= a.threshold) {
                double score = (double) v / a.lifetimeUs;
                if (score > bestScore) {
                    secondScore = bestScore;
                    best = a;
                    bestScore = score;
                } else if (score > secondScore) {
                    secondScore = score;
                }
            }
        }
        claimedTwice = secondScore > p.sharedScore() * bestScore;
        return best;
    }

    void assign(TrackPlane a, int x, int y, long t, int s) {
        a.add(x, y, t, s, claimedTwice);
        a.events++;
        a.sinceFit++;
        if (a.sinceFit >= Math.max(40, Math.max(a.sample() / 4, a.live() / 12))) {
            a.recentre(fit, t);
        }
    }

    /** Prunes and merges from time to time. */
    void advance(long t) {
        if (t < nextCheck) {
            return;
        }
        nextCheck = t + 5000;
        for (int i = size - 1; i >= 0; i--) {
            TrackPlane a = planes[i];
            a.expire(t);
            a.typicalLive = Math.max(a.live(), a.typicalLive * 0.999 + a.live() * 0.001);
            if (a.live() < Math.max(12, p.minShare() * a.typicalLive)) {
                end(i, Segment.Fate.REMOVED, 0);
            } else if (t - a.lastFitUs > 20_000 && a.sinceFit > 0 && t - a.lastFitUs > a.lifetimeUs / 4) {
                a.recentre(fit, t);
            }
        }
        for (int i = 0; i < size; i++) {
            for (int j = size - 1; j > i; j--) {
                if (same(planes[i], planes[j], t)) {
                    merge(i, j, t);
                }
            }
        }
    }

    private boolean same(TrackPlane a, TrackPlane b, long t) {
        double gap = Math.max(4, p.mergeGapShare() * Math.max(a.extent(), b.extent()));
        double ta = (t - a.t0) * 1e-6;
        double tb = (t - b.t0) * 1e-6;
        double ax = a.vx * ta;
        double ay = a.vy * ta;
        double bx = b.vx * tb;
        double by = b.vy * tb;
        if (a.minX + ax > b.maxX + bx + gap || b.minX + bx > a.maxX + ax + gap
            || a.minY + ay > b.maxY + by + gap || b.minY + by > a.maxY + ay + gap) {
            return false;
        }
        if (a.fits == 0 || b.fits == 0) {
            return false;
        }
        if (!near(a, b) || !near(b, a)) {
            return false;
        }
        // the velocity that serves both best, and what each loses by it
        double hxx = a.lossXx + b.lossXx;
        double hxy = a.lossXy + b.lossXy;
        double hyy = a.lossYy + b.lossYy;
        double det = hxx * hyy - hxy * hxy;
        if (!(det > 0)) {
            return false;
        }
        double rx = a.lossXx * a.vx + a.lossXy * a.vy + b.lossXx * b.vx + b.lossXy * b.vy;
        double ry = a.lossXy * a.vx + a.lossYy * a.vy + b.lossXy * b.vx + b.lossYy * b.vy;
        double cx = (hyy * rx - hxy * ry) / det;
        double cy = (hxx * ry - hxy * rx) / det;
        return loss(a, cx, cy) < p.mergeLoss() * a.metric && loss(b, cx, cy) < p.mergeLoss() * b.metric;
    }

    /** Whether the velocities agree along the direction that a plane knows best, and it knows that one well. */
    private boolean near(TrackPlane a, TrackPlane b) {
        double angle = 0.5 * Math.atan2(2 * a.lossXy, a.lossXx - a.lossYy);
        double d = (a.vx - b.vx) * Math.cos(angle) + (a.vy - b.vy) * Math.sin(angle);
        return Math.abs(d) < p.mergeVelocity() * Math.max(a.speed(), b.speed()) && a.isKnown();
    }

    private static double loss(TrackPlane a, double cx, double cy) {
        double dx = a.vx - cx;
        double dy = a.vy - cy;
        return a.lossXx * dx * dx + 2 * a.lossXy * dx * dy + a.lossYy * dy * dy;
    }

    private void merge(int i, int j, long t) {
        TrackPlane a = planes[i];
        TrackPlane b = planes[j];
        if (a.id > b.id) {
            TrackPlane c = a;
            a = b;
            b = c;
            planes[i] = a;
            planes[j] = b;
        }
        // velocity weighed by events
        double wa = a.live();
        double wb = b.live();
        a.vx = (a.vx * wa + b.vx * wb) / (wa + wb);
        a.vy = (a.vy * wa + b.vy * wb) / (wa + wb);
        int n = a.live();
        int m = b.live();
        long[] tt = new long[n + m];
        short[] xx = new short[n + m];
        short[] yy = new short[n + m];
        byte[] ss = new byte[n + m];
        boolean[] sh = new boolean[n + m];
        int ia = a.tail;
        int ib = b.tail;
        for (int k = 0; k < n + m; k++) {
            boolean fromA = ib == b.head || ia != a.head && a.time[ia & a.mask] <= b.time[ib & b.mask];
            TrackPlane c = fromA ? a : b;
            int q = (fromA ? ia++ : ib++) & c.mask;
            tt[k] = c.time[q];
            xx[k] = c.x[q];
            yy[k] = c.y[q];
            ss[k] = c.sign[q];
            sh[k] = c.shared[q];
        }
        a.clear();
        for (int k = 0; k < n + m; k++) {
            a.add(xx[k], yy[k], tt[k], ss[k], sh[k]);
        }
        a.events += b.events;
        a.typicalLive = a.live();
        a.recentre(fit, t);
        end(j, Segment.Fate.MERGED, a.id);
    }

    private void end(int i, Segment.Fate fate, int into) {
        TrackPlane a = planes[i];
        ended.accept(segment(a, fate, into));
        a.clear();
        free.add(a);
        planes[i] = planes[--size];
        planes[size] = null;
    }

    @Override
    public void structure(FlowPlane plane, int[] members, int n, MetricFit found) {
        if (size == planes.length) {
            return;
        }
        TrackPlane a = free.isEmpty() ? new TrackPlane(sensor.width(), sensor.height(), p)
            : free.remove(free.size() - 1);
        long last = plane.time[members[n - 1] & plane.mask];
        a.start(nextId++, last, plane.foundVx, plane.foundVy);
        for (int k = 0; k < n; k++) {
            int i = members[k] & plane.mask;
            a.add(plane.ex[i], plane.ey[i], plane.time[i], plane.sign[i], false);
        }
        a.lastUs = last;
        a.firstUs = last;
        a.recentre(found, last);
        planes[size++] = a;
    }

    private Segment segment(TrackPlane a, Segment.Fate fate, int into) {
        int m = TrackPlane.MARGIN;
        return new Segment(a.id, a.firstUs, a.lastUs, a.events, (float) a.vx, (float) a.vy,
            clip(a.minX - m, sensor.width()), clip(a.minY - m, sensor.height()),
            clip(a.maxX - m, sensor.width()), clip(a.maxY - m, sensor.height()), fate, into);
    }

    private static int clip(int v, int size) {
        return Math.max(0, Math.min(size - 1, v));
    }

    List<Segment> segments() {
        List<Segment> list = new ArrayList<>();
        for (int i = 0; i < size; i++) {
            list.add(segment(planes[i], Segment.Fate.ALIVE, 0));
        }
        return list;
    }

    void reset() {
        while (size > 0) {
            end(size - 1, Segment.Fate.REMOVED, 0);
        }
        nextId = 1;
        nextCheck = Long.MIN_VALUE;
    }
}
