package io.github.sofas.flow;

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
    /** Greatest of the nine metrics, in votes squared. */
    double metric;
    /** Loss of metric per (px/s)^2, symmetric: what is known of the velocity. */
    double lxx;
    double lxy;
    double lyy;
    /** Length of the step in distances of projections. */
    double step;
    /** Step in px/s. */
    double dx;
    double dy;
    // frame of the projections: direction of the first axis, distances along both in px/s
    double frameX = 1;
    double frameY;
    double h1;
    double h2;

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
            // 2 w f without the w^2 of the metric's step: what an event adds by meeting others, not by itself
            sum += (long) w00 * a + (long) w10 * b + (long) w01 * d + (long) w11 * e;
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
        return sum / 32768.0;
    }

    /** Sets an upright frame with equal distances. */
    void frame(double h) {
        frameX = 1;
        frameY = 0;
        h1 = h;
        h2 = h;
    }

    /**
     * Turns the frame to the axes of what is known, and spaces the projections so that each neighbour loses about the
     * same share of the metric.
     */
    void frame(double metric0, double mxx, double mxy, double myy, double share, double least, double most) {
        double mean = (mxx + myy) / 2;
        double dif = (mxx - myy) / 2;
        double root = Math.sqrt(dif * dif + mxy * mxy);
        double angle = 0.5 * Math.atan2(2 * mxy, mxx - myy);
        frameX = Math.cos(angle);
        frameY = Math.sin(angle);
        h1 = spacing(metric0 * share, mean + root, least, most);
        h2 = spacing(metric0 * share, mean - root, least, most);
    }

    private static double spacing(double loss, double curvature, double least, double most) {
        return curvature * most * most <= loss ? most : Math.max(least, Math.sqrt(loss / curvature));
    }

    /**
     * One fit around (vx0, vy0) with the projections of the frame.
     *
     * @param flat a direction that loses less than this share of the metric at its neighbours takes no step
     */
    void fit(double vx0, double vy0, double flat) {
        for (int j = 0; j < 3; j++) {
            for (int i = 0; i < 3; i++) {
                double a = (i - 1) * h1;
                double b = (j - 1) * h2;
                m[j * 3 + i] = metricAt(vx0 + a * frameX - b * frameY, vy0 + a * frameY + b * frameX);
            }
        }
        double ga = (m[2] + m[5] + m[8] - m[0] - m[3] - m[6]) / 6;
        double gb = (m[6] + m[7] + m[8] - m[0] - m[1] - m[2]) / 6;
        double haa = (m[0] + m[2] + m[3] + m[5] + m[6] + m[8] - 2 * (m[1] + m[4] + m[7])) / 3;
        double hbb = (m[0] + m[1] + m[2] + m[6] + m[7] + m[8] - 2 * (m[3] + m[4] + m[5])) / 3;
        double hab = (m[0] + m[8] - m[2] - m[6]) / 4;
        metric = 0;
        for (double v : m) {
            metric = Math.max(metric, v);
        }
        // eigenvectors of the Hessian in the frame; a step along each that is curved enough
        double mean = (haa + hbb) / 2;
        double dif = (haa - hbb) / 2;
        double root = Math.sqrt(dif * dif + hab * hab);
        double angle = 0.5 * Math.atan2(-2 * hab, -(haa - hbb));
        double ca = Math.cos(angle);
        double sa = Math.sin(angle);
        double floor = -2 * flat * metric;
        double s1 = step(mean - root, ga * ca + gb * sa, floor);
        double s2 = step(mean + root, gb * ca - ga * sa, floor);
        double a = (s1 * ca - s2 * sa) * h1;
        double b = (s1 * sa + s2 * ca) * h2;
        step = Math.sqrt(s1 * s1 + s2 * s2);
        dx = a * frameX - b * frameY;
        dy = a * frameY + b * frameX;
        vx = vx0 + dx;
        vy = vy0 + dy;
        // only curvature that falls away is knowledge
        double c1 = -Math.min(mean - root, 0) / 2;
        double c2 = -Math.min(mean + root, 0) / 2;
        double laa = (c1 * ca * ca + c2 * sa * sa) / (h1 * h1);
        double lbb = (c1 * sa * sa + c2 * ca * ca) / (h2 * h2);
        double lab = (c1 - c2) * sa * ca / (h1 * h2);
        lxx = laa * frameX * frameX - 2 * lab * frameX * frameY + lbb * frameY * frameY;
        lyy = laa * frameY * frameY + 2 * lab * frameX * frameY + lbb * frameX * frameX;
        lxy = (laa - lbb) * frameX * frameY + lab * (frameX * frameX - frameY * frameY);
    }

    private static double step(double curvature, double gradient, double floor) {
        if (curvature > floor) {
            // not a top: uphill only where the slope is clear
            return Math.abs(gradient) > -floor ? Math.signum(gradient) : 0;
        }
        return Math.max(-1.5, Math.min(1.5, -gradient / curvature));
    }

}
