package io.github.sofas.flow;

import java.util.Arrays;

/**
 * Finds the velocity under which a set of events is sharpest: the metric of 3 x 3 projections around a velocity, a
 * quadratic through the nine values, and one step to its top.
 */
final class MetricFit {
    static final int SUB = 16;
    private static final int MARGIN = 40;

    /** Sampled events: position in 1/16 cells, time from the reference in seconds, vote. */
    final int[] x16;
    final int[] y16;
    final float[] tau;
    final int[] vote;
    int n;

    private final int width;
    private final int height;
    private final int[] f;
    private final int[] touched;
    private final double[] m = new double[9];

    // result of the last fit
    double vx;
    double vy;
    /** Metric at the centre, in votes squared. */
    double metric;
    /** Loss of metric per (px/s)^2: the negative Hessian / 2, symmetric. */
    double lxx;
    double lxy;
    double lyy;
    /** Whether the centre was the best of the nine. */
    boolean centreBest;
    double stepPx;

    MetricFit(int sensorWidth, int sensorHeight, int capacity) {
        x16 = new int[capacity];
        y16 = new int[capacity];
        tau = new float[capacity];
        vote = new int[capacity];
        touched = new int[capacity];
        width = sensorWidth + 2 * MARGIN;
        height = sensorHeight + 2 * MARGIN;
        f = new int[width * height];
    }

    int capacity() {
        return x16.length;
    }

    void clear() {
        n = 0;
    }

    void add(int px16, int py16, float tauS, int s) {
        x16[n] = px16;
        y16[n] = py16;
        tau[n] = tauS;
        vote[n] = s;
        n++;
    }

    /** Metric of one projection; 1 for a single event that falls on one cell. */
    double metricAt(double velX, double velY) {
        float sx = (float) (velX * SUB);
        float sy = (float) (velY * SUB);
        int[] grid = f;
        int w = width;
        int maxX = (width - 2) * SUB;
        int maxY = (height - 2) * SUB;
        long sum = 0;
        int used = 0;
        for (int i = 0; i < n; i++) {
            float t = tau[i];
            int px = x16[i] + MARGIN * SUB - (int) (sx * t + 32768.5f) + 32768;
            int py = y16[i] + MARGIN * SUB - (int) (sy * t + 32768.5f) + 32768;
            if (px < 0 || py < 0 || px >= maxX || py >= maxY) {
                continue;
            }
            int c = (py >> 4) * w + (px >> 4);
            int fx = px & 15;
            int fy = py & 15;
            int s = vote[i];
            int w11 = fx * fy * s;
            int w10 = fx * SUB * s - w11;
            int w01 = fy * SUB * s - w11;
            int w00 = SUB * SUB * s - w11 - w10 - w01;
            int a = grid[c];
            int b = grid[c + 1];
            int d = grid[c + w];
            int e = grid[c + w + 1];
            sum += (long) w00 * (2 * a + w00) + (long) w10 * (2 * b + w10)
                + (long) w01 * (2 * d + w01) + (long) w11 * (2 * e + w11);
            grid[c] = a + w00;
            grid[c + 1] = b + w10;
            grid[c + w] = d + w01;
            grid[c + w + 1] = e + w11;
            touched[used++] = c;
        }
        for (int i = 0; i < used; i++) {
            int c = touched[i];
            grid[c] = 0;
            grid[c + 1] = 0;
            grid[c + w] = 0;
            grid[c + w + 1] = 0;
        }
        return sum / 65536.0;
    }

    /**
     * One fit around (vx0, vy0).
     *
     * @param h distance of neighbouring projections in px/s
     * @param flat a direction whose curvature is below this share of the metric per h^2 takes no step
     */
    void fit(double vx0, double vy0, double h, double flat) {
        for (int j = 0; j < 3; j++) {
            for (int i = 0; i < 3; i++) {
                m[j * 3 + i] = metricAt(vx0 + (i - 1) * h, vy0 + (j - 1) * h);
            }
        }
        double centre = m[4];
        double gx = (m[2] + m[5] + m[8] - m[0] - m[3] - m[6]) / 6;
        double gy = (m[6] + m[7] + m[8] - m[0] - m[1] - m[2]) / 6;
        double hxx = (m[0] + m[2] + m[3] + m[5] + m[6] + m[8] - 2 * (m[1] + m[4] + m[7])) / 3;
        double hyy = (m[0] + m[1] + m[2] + m[6] + m[7] + m[8] - 2 * (m[3] + m[4] + m[5])) / 3;
        double hxy = (m[0] + m[8] - m[2] - m[6]) / 4;
        int best = 4;
        for (int k = 0; k < 9; k++) {
            if (m[k] > m[best]) {
                best = k;
            }
        }
        centreBest = best == 4;
        metric = m[best];
        // eigenvectors of the Hessian; a step along each that is curved enough
        double mean = (hxx + hyy) / 2;
        double dif = (hxx - hyy) / 2;
        double root = Math.sqrt(dif * dif + hxy * hxy);
        double l1 = mean - root; // most negative
        double l2 = mean + root;
        double angle = 0.5 * Math.atan2(-2 * hxy, -(hxx - hyy));
        double e1x = Math.cos(angle);
        double e1y = Math.sin(angle);
        double stepX = 0;
        double stepY = 0;
        double g1 = gx * e1x + gy * e1y;
        double g2 = -gx * e1y + gy * e1x;
        double floor = -flat * centre;
        double d1 = step(l1, g1, floor);
        double d2 = step(l2, g2, Math.min(floor, 0.05 * l1));
        stepX = d1 * e1x - d2 * e1y;
        stepY = d1 * e1y + d2 * e1x;
        stepPx = Math.sqrt(stepX * stepX + stepY * stepY);
        vx = vx0 + stepX * h;
        vy = vy0 + stepY * h;
        double norm = -0.5 / (h * h);
        // only curvature that falls away counts as knowledge
        double c1 = Math.min(l1, 0) * norm;
        double c2 = Math.min(l2, 0) * norm;
        lxx = c1 * e1x * e1x + c2 * e1y * e1y;
        lyy = c1 * e1y * e1y + c2 * e1x * e1x;
        lxy = (c1 - c2) * e1x * e1y;
    }

    private static double step(double curvature, double gradient, double floor) {
        if (curvature > floor) {
            // not a top: walk uphill only where the slope is clear
            return Math.abs(gradient) > -2 * floor ? Math.signum(gradient) : 0;
        }
        return Math.max(-1.5, Math.min(1.5, -gradient / curvature));
    }

    void reset() {
        Arrays.fill(f, 0);
        n = 0;
    }
}
