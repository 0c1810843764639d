package io.github.sofas.flow.paper;

import io.github.sofas.flow.motion.Projection;
import java.util.Arrays;

/**
 * The refining cycles of the flow plane (paper, section Flow Plane). Each cycle takes the events associated with the
 * best projection, projects them again around it over a range narrower by the factor q, and associates them again.
 *
 * <p>Association selects the events on cells whose |f| exceeds mean + w sd over the occupied cells, and on all occupied
 * cells connected to these by a side or a corner.
 */
final class Refinement {
    private final Numbers p;
    private final int n;

    private long[] time = new long[0];
    private short[] x;
    private short[] y;
    private byte[] sign;
    private int from;
    private int size;
    /** Whether each event still belongs to the structure. */
    private boolean[] member = new boolean[0];
    private int[] cell = new int[0];
    private int members;

    private int[] f = new int[0];
    private boolean[] taken = new boolean[0];
    private int[] fill = new int[0];
    private int minX;
    private int minY;
    private int columns;
    private int rows;
    private double angleX;
    private double angleY;

    Refinement(Numbers p) {
        this.p = p;
        n = p.flowProjections();
    }

    /** Loads events [tail, head) of arrays, which still belong to the caller. */
    void load(long[] timeUs, short[] eventX, short[] eventY, byte[] polarity, int tail, int head) {
        time = timeUs;
        x = eventX;
        y = eventY;
        sign = polarity;
        from = tail;
        size = head - tail;
        if (member.length < size) {
            member = new boolean[timeUs.length];
            cell = new int[timeUs.length];
        }
        for (int i = 0; i < size; i++) {
            member[i] = true;
        }
        members = size;
    }

    /** Runs the cycles from projection (i, j) of the widest range. */
    void refine(int i, int j) {
        double range = p.rangeDeg();
        angleX = Angles.at(i, n, range);
        angleY = Angles.at(j, n, range);
        associate();
        for (int cycle = 1; cycle < p.cycles() && members > 0; cycle++) {
            range /= p.refinement();
            double centreX = angleX;
            double centreY = angleY;
            long most = -1;
            double slowest = 0;
            for (int b = 0; b < n; b++) {
                for (int a = 0; a < n; a++) {
                    double ax = Angles.limited(centreX + Angles.at(a, n, range));
                    double ay = Angles.limited(centreY + Angles.at(b, n, range));
                    double vx = Angles.velocity(ax, p);
                    double vy = Angles.velocity(ay, p);
                    long metric = project(vx, vy);
                    double speed = vx * vx + vy * vy;
                    if (metric > most || metric == most && speed < slowest) {
                        most = metric;
                        slowest = speed;
                        angleX = ax;
                        angleY = ay;
                    }
                }
            }
            associate();
        }
    }

    /** Projects the members and returns the metric, or -1 if they fall too far apart for a plane of bounded size. */
    private long project(double velocityX, double velocityY) {
        int vx = Projection.fixed(velocityX);
        int vy = Projection.fixed(velocityY);
        long t0 = time[from];
        int loX = Integer.MAX_VALUE;
        int hiX = Integer.MIN_VALUE;
        int loY = Integer.MAX_VALUE;
        int hiY = Integer.MIN_VALUE;
        for (int i = 0; i < size; i++) {
            if (member[i]) {
                int cx = x[from + i] - Projection.travelled(vx, time[from + i] - t0);
                int cy = y[from + i] - Projection.travelled(vy, time[from + i] - t0);
                loX = Math.min(loX, cx);
                hiX = Math.max(hiX, cx);
                loY = Math.min(loY, cy);
                hiY = Math.max(hiY, cy);
            }
        }
        if (Math.max(hiX - loX, hiY - loY) >= FlowPlane.LONGEST_SIDE) {
            return -1;
        }
        // with a border of one empty cell around, for the flood fill
        minX = loX - 1;
        minY = loY - 1;
        columns = hiX - loX + 3;
        rows = hiY - loY + 3;
        int cells = columns * rows;
        if (f.length < cells) {
            f = new int[cells];
            taken = new boolean[cells];
            fill = new int[cells];
        }
        Arrays.fill(f, 0, cells, 0);
        long metric = 0;
        for (int i = 0; i < size; i++) {
            if (member[i]) {
                int cx = x[from + i] - Projection.travelled(vx, time[from + i] - t0) - minX;
                int cy = y[from + i] - Projection.travelled(vy, time[from + i] - t0) - minY;
                int c = cy * columns + cx;
                cell[i] = c;
                int w = sign[from + i];
                metric += 2 * w * f[c] + 1;
                f[c] += w;
            }
        }
        return metric;
    }

    /** Keeps those members that lie on strong cells or on occupied cells connected to these. */
    private void associate() {
        if (project(Angles.velocity(angleX, p), Angles.velocity(angleY, p)) < 0) {
            members = 0;
            return;
        }
        int cells = columns * rows;
        long sum = 0;
        long squares = 0;
        int occupied = 0;
        for (int c = 0; c < cells; c++) {
            taken[c] = false;
            if (f[c] != 0) {
                int v = Math.abs(f[c]);
                sum += v;
                squares += (long) v * v;
                occupied++;
            }
        }
        if (occupied == 0) {
            members = 0;
            return;
        }
        double mean = (double) sum / occupied;
        double sd = Math.sqrt(Math.max(0, (double) squares / occupied - mean * mean));
        double threshold = mean + p.thresholdSd() * sd;
        int end = 0;
        for (int c = 0; c < cells; c++) {
            if (Math.abs(f[c]) > threshold) {
                taken[c] = true;
                fill[end++] = c;
            }
        }
        for (int q = 0; q < end; q++) {
            int c = fill[q];
            for (int row = c - columns; row <= c + columns; row += columns) {
                for (int d = row - 1; d <= row + 1; d++) {
                    if (f[d] != 0 && !taken[d]) {
                        taken[d] = true;
                        fill[end++] = d;
                    }
                }
            }
        }
        members = 0;
        for (int i = 0; i < size; i++) {
            member[i] = member[i] && taken[cell[i]];
            if (member[i]) {
                members++;
            }
        }
    }

    /** Number of events loaded. */
    int loaded() {
        return size;
    }

    /** Time of event i, counted from the first loaded, in µs. */
    long timeUs(int i) {
        return time[from + i];
    }

    /** Column of event i. */
    int x(int i) {
        return x[from + i];
    }

    /** Row of event i. */
    int y(int i) {
        return y[from + i];
    }

    /** Polarity of event i, +1 or -1. */
    int polarity(int i) {
        return sign[from + i];
    }

    /** Number of events that belong to the structure. */
    int size() {
        return members;
    }

    /** Whether event i, counted from the first loaded, belongs to the structure. */
    boolean contains(int i) {
        return member[i];
    }

    /** Angle of the structure's projection in x, in degrees. */
    double angleX() {
        return angleX;
    }

    /** Angle of the structure's projection in y, in degrees. */
    double angleY() {
        return angleY;
    }
}
