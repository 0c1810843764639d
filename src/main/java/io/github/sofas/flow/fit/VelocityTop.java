package io.github.sofas.flow.fit;

/**
 * The top of the metric over velocities, by a quadratic through the projections around a velocity. It gives the step to
 * the top, and how much metric other velocities would lose, which is what is known of the velocity. Each fit replaces
 * the previous one.
 */
public final class VelocityTop {
    private double metric;
    private double lossXx;
    private double lossXy;
    private double lossYy;
    private double axisX;
    private double axisY;
    private double stepX;
    private double stepY;
    private double steps;
    private double slopeSigmas;
    private boolean flat;

    /**
     * Finds the top.
     *
     * @param greatest of the metrics that the quadratic goes through
     * @param ga gradient along the first axis of the frame; like the Hessian, in units of the frame
     * @param sigmas no step is taken in a direction in which neighbours lose less than this many standard deviations of
     *     the metric, which counts about as many meetings
     */
    VelocityTop of(ProjectionFrame frame, double greatest, double ga, double gb, double haa, double hbb, double hab,
                   double sigmas) {
        metric = greatest;
        // eigenvectors of the Hessian in the frame; a step along each that is curved enough
        double mean = (haa + hbb) / 2;
        double dif = (haa - hbb) / 2;
        double root = Math.sqrt(dif * dif + hab * hab);
        double angle = 0.5 * StrictMath.atan2(-2 * hab, hbb - haa);
        double ca = StrictMath.cos(angle);
        double sa = StrictMath.sin(angle);
        double floor = Parabola.floor(metric, sigmas);
        double g1 = ga * ca + gb * sa;
        double g2 = gb * ca - ga * sa;
        double s1 = Parabola.stepTo(mean - root, g1, floor);
        double s2 = Parabola.stepTo(mean + root, g2, floor);
        slopeSigmas = Math.max(Math.abs(g1), Math.abs(g2)) / MetricFit.sd(metric);
        double a = s1 * ca - s2 * sa;
        double b = s1 * sa + s2 * ca;
        steps = Math.sqrt(s1 * s1 + s2 * s2);
        // the less known direction took no step, and had no slope for one
        flat = s2 == 0;
        stepX = frame.vx(0, a, b);
        stepY = frame.vy(0, a, b);
        // only downward curvature is knowledge
        double c1 = -Math.min(mean - root, 0) / 2;
        double c2 = -Math.min(mean + root, 0) / 2;
        know(frame, c1 * ca * ca + c2 * sa * sa, (c1 - c2) * sa * ca, c1 * sa * sa + c2 * ca * ca);
        return this;
    }

    /** Converts the losses along the axes of the frame to those along the axes of the sensor. */
    private void know(ProjectionFrame frame, double aa, double ab, double bb) {
        double x = frame.directionX();
        double y = frame.directionY();
        double laa = aa / (frame.h1() * frame.h1());
        double lbb = bb / (frame.h2() * frame.h2());
        double lab = ab / (frame.h1() * frame.h2());
        lossXx = laa * x * x - 2 * lab * x * y + lbb * y * y;
        lossYy = laa * y * y + 2 * lab * x * y + lbb * x * x;
        lossXy = (laa - lbb) * x * y + lab * (x * x - y * y);
        double best = 0.5 * StrictMath.atan2(2 * lossXy, lossXx - lossYy);
        axisX = StrictMath.cos(best);
        axisY = StrictMath.sin(best);
    }

    /** Greatest of the metrics fitted, in votes squared; 0 where all are less. */
    public double metric() {
        return metric;
    }

    /** Loss of metric per (px/s)², an entry of a symmetric matrix: what is known of the velocity. */
    public double lossXx() {
        return lossXx;
    }

    /** The same, for both axes. */
    public double lossXy() {
        return lossXy;
    }

    /** The same, along y. */
    public double lossYy() {
        return lossYy;
    }

    /** Loss of metric per (px/s)² along the best known direction. */
    public double bestLoss() {
        return (lossXx + lossYy) / 2 + unevenness(lossXx, lossXy, lossYy);
    }

    /** Loss of metric per (px/s)² along the direction that is known least. */
    public double leastLoss() {
        return (lossXx + lossYy) / 2 - unevenness(lossXx, lossXy, lossYy);
    }

    /** Half of the difference between the losses along the best known direction and across it. */
    static double unevenness(double xx, double xy, double yy) {
        double dif = (xx - yy) / 2;
        return Math.sqrt(dif * dif + xy * xy);
    }

    /** Direction in which the velocity is known best, x of a unit vector. */
    public double axisX() {
        return axisX;
    }

    /** The same, y. */
    public double axisY() {
        return axisY;
    }

    /** Step to the top in px/s. */
    public double stepX() {
        return stepX;
    }

    /** The same, downwards. */
    public double stepY() {
        return stepY;
    }

    /** Length of the step in distances of projections. */
    public double steps() {
        return steps;
    }

    /**
     * How clearly the top lies elsewhere: the rise of the metric from the middle to a neighbour, along the axis on
     * which it rises more, in standard deviations of the metric. Noise has 0.5, whatever the number of events.
     */
    public double slopeSigmas() {
        return slopeSigmas;
    }

    /** Whether the metric does not determine the velocity across the best known direction. */
    public boolean isFlat() {
        return flat;
    }
}
