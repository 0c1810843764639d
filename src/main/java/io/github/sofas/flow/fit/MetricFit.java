package io.github.sofas.flow.fit;

import java.util.Arrays;

/**
 * Finds the motion under which a set of events is sharpest (paper, section Structure Detection): the metric of 3 x 3
 * projections around a motion, a quadratic through the nine values, and one step to its top.
 *
 * <p>Longer than other classes, because all that it fits, velocity, acceleration, rotation and growth, shares the
 * events that are laid out here.
 */
public final class MetricFit {
    /** Side of the cells that votes are given to: cells as large as pixels favour whole pixels of travel. */
    public static final double CELL_PX = 1.3;
    /** Share of the metric that neighbouring projections are to lose: an edge is sharp across and flat along. */
    public static final double NEIGHBOUR_LOSS = 0.04;
    /** Smallest distance of neighbouring projections over half the window: closer ones differ by noise only. */
    public static final double MIN_STEP_PX = 0.5;
    /** Greatest distance of neighbouring projections over half the window. */
    public static final double MAX_STEP_PX = 4;
    /** Standard deviations of the metric that neighbours must lose for a direction to take a step. */
    public static final double FLAT_SIGMAS = 2;

    /** Standard deviations of the metric that a change of motion must be curved by to take a step to its top. */
    private static final double CHANGE_SIGMAS = 0.5;
    private static final int EVENT_BYTES = 12 * Integer.BYTES + Byte.BYTES;

    /** Side of a tile in px, and tiles along each axis; those at the border take what lies beyond. */
    private static final float TILE_PX = 32;
    private static final int TILES = 64;

    /** Events, projected along the motion to be improved. */
    private final BilinearAccumulator grid;
    // of each event: time from the reference in s, and place from the centre of rotation in px
    private final float[] tau;
    private final float[] fromX;
    private final float[] fromY;
    /** Shifts a unit of the parameters that are being fitted. */
    private final float[] along;
    private final ShiftProfile time;
    /** For an acceleration in any direction, and whether it is that of the events that were fitted last. */
    private final ShiftProfile square;
    private boolean squared;
    private final ShiftProfile alongX;
    private final ShiftProfile alongY;
    private final double[] m = new double[9];
    // tiles of the events: which one each lies on, and their middles
    private final int[] tile;
    private final float[] tileX = new float[TILES * TILES];
    private final float[] tileY = new float[TILES * TILES];
    private final int[] tileSize = new int[TILES * TILES];

    // frame of the projections: direction of the first axis, distances along both in px/s
    private double frameX = 1;
    private double frameY;
    private double h1;
    private double h2;

    // what the last fit found
    private double metric;
    private double lossXx;
    private double lossXy;
    private double lossYy;
    private double axisX;
    private double axisY;
    private double stepX;
    private double stepY;
    private double steps;
    private boolean flat;
    private double step;
    private double loss;

    /** Makes a fit for up to a number of events, of which so many vote on two grids. */
    public MetricFit(int sensorWidth, int sensorHeight, double cellPx, int capacity, int mostOnBoth) {
        grid = new BilinearAccumulator(sensorWidth, sensorHeight, cellPx, capacity, mostOnBoth);
        tau = new float[capacity];
        fromX = new float[capacity];
        fromY = new float[capacity];
        along = new float[capacity];
        tile = new int[capacity];
        time = new ShiftProfile(capacity);
        square = new ShiftProfile(capacity);
        alongX = new ShiftProfile(capacity);
        alongY = new ShiftProfile(capacity);
    }

    /** Bytes of the arrays of a fit for up to a number of events, all of which vote on two grids. */
    public static long bytes(int sensorWidth, int sensorHeight, double cellPx, int capacity) {
        return Integer.BYTES * BilinearAccumulator.cells(sensorWidth, sensorHeight, cellPx)
            + (long) capacity * EVENT_BYTES;
    }

    /** The most events that fit. */
    public int capacity() {
        return grid.capacity();
    }

    /** How many events are fitted. */
    public int size() {
        return grid.size();
    }

    /** Votes given since the start, a measure of work. */
    public long votes() {
        return grid.votes();
    }

    /** Forgets all events. */
    public void clear() {
        grid.clear();
    }

    /**
     * Adds an event.
     *
     * @param x projected column in px
     * @param y projected row in px
     * @param tauS time from the reference in s
     * @param rx column from the centre of rotation in px
     * @param ry row from the centre of rotation in px
     */
    public void add(float x, float y, float tauS, float rx, float ry, int polarity) {
        int i = grid.size();
        grid.add(x, y, polarity);
        tau[i] = tauS;
        fromX[i] = rx;
        fromY[i] = ry;
    }

    /** Metric of the events moved back by velocity (vx, vy). */
    private double metricAt(double vx, double vy) {
        return grid.metric(time, vx, time, vy);
    }

    /** Whether the events meet more often where they are than moved back by velocity (vx, vy). */
    public boolean isSharperAtRest(double vx, double vy) {
        prepare();
        return metricAt(0, 0) > metricAt(vx, vy);
    }

    private void prepare() {
        grid.lay();
        time.take(tau, grid.size());
        squared = false;
    }

    /** Sets an upright frame with equal distances. */
    public void frame(double h) {
        frameX = 1;
        frameY = 0;
        h1 = h;
        h2 = h;
    }

    /**
     * Turns the frame to the axes of what is known, and spaces the projections so that each neighbour loses about the
     * same share of the metric: an edge is sharp across and flat along.
     */
    public void frame(double ofMetric, double xx, double xy, double yy, double share, double least, double most) {
        double mean = (xx + yy) / 2;
        double dif = (xx - yy) / 2;
        double root = Math.sqrt(dif * dif + xy * xy);
        double angle = 0.5 * StrictMath.atan2(2 * xy, xx - yy);
        frameX = StrictMath.cos(angle);
        frameY = StrictMath.sin(angle);
        h1 = spacing(ofMetric * share, mean + root, least, most);
        h2 = spacing(ofMetric * share, mean - root, least, most);
    }

    private static double spacing(double loss, double curvature, double least, double most) {
        return curvature * most * most <= loss ? most : Math.max(least, Math.sqrt(loss / curvature));
    }

    /** Spreads the frame after a step that left it. */
    public void widen(double factor) {
        h1 *= factor;
        h2 *= factor;
    }

    /**
     * Fits the velocity around (vx0, vy0), which is added to the motion that the events were projected along.
     *
     * @param sigmas a direction takes no step that loses less metric at its neighbours than this many standard
     *     deviations of the metric, which counts about as many meetings
     */
    public void fit(double vx0, double vy0, double sigmas) {
        prepare();
        metric = 0;
        for (int j = 0; j < 3; j++) {
            for (int i = 0; i < 3; i++) {
                double a = (i - 1) * h1;
                double b = (j - 1) * h2;
                double v = metricAt(vx0 + a * frameX - b * frameY, vy0 + a * frameY + b * frameX);
                m[j * 3 + i] = v;
                metric = Math.max(metric, v);
            }
        }
        double ga = (m[2] + m[5] + m[8] - m[0] - m[3] - m[6]) / 6;
        double gb = (m[6] + m[7] + m[8] - m[0] - m[1] - m[2]) / 6;
        double haa = (m[0] + m[2] + m[3] + m[5] + m[6] + m[8] - 2 * (m[1] + m[4] + m[7])) / 3;
        double hbb = (m[0] + m[1] + m[2] + m[6] + m[7] + m[8] - 2 * (m[3] + m[4] + m[5])) / 3;
        double hab = (m[0] + m[8] - m[2] - m[6]) / 4;
        solve(ga, gb, haa, hbb, hab, sigmas);
    }

    /**
     * The same from the centre and its four nearest neighbours, in half the time: in a frame along the
     * axes of what is known, the corners tell how it has turned, and little else.
     */
    public void fitCross(double vx0, double vy0, double sigmas) {
        prepare();
        double here = metricAt(vx0, vy0);
        double less1 = metricAt(vx0 - h1 * frameX, vy0 - h1 * frameY);
        double more1 = metricAt(vx0 + h1 * frameX, vy0 + h1 * frameY);
        double less2 = metricAt(vx0 + h2 * frameY, vy0 - h2 * frameX);
        double more2 = metricAt(vx0 - h2 * frameY, vy0 + h2 * frameX);
        m[4] = here;
        metric = Math.max(0, Math.max(here, Math.max(Math.max(less1, more1), Math.max(less2, more2))));
        solve((more1 - less1) / 2, (more2 - less2) / 2, less1 + more1 - 2 * here, less2 + more2 - 2 * here, 0, sigmas);
    }

    /** Step and knowledge from the gradient and the Hessian in units of the frame. */
    private void solve(double ga, double gb, double haa, double hbb, double hab, double sigmas) {
        // eigenvectors of the Hessian in the frame; a step along each that is curved enough
        double mean = (haa + hbb) / 2;
        double dif = (haa - hbb) / 2;
        double root = Math.sqrt(dif * dif + hab * hab);
        double angle = 0.5 * StrictMath.atan2(-2 * hab, hbb - haa);
        double ca = StrictMath.cos(angle);
        double sa = StrictMath.sin(angle);
        double floor = floor(metric, sigmas);
        double s1 = stepTo(mean - root, ga * ca + gb * sa, floor);
        double s2 = stepTo(mean + root, gb * ca - ga * sa, floor);
        double a = (s1 * ca - s2 * sa) * h1;
        double b = (s1 * sa + s2 * ca) * h2;
        steps = Math.sqrt(s1 * s1 + s2 * s2);
        // the direction that is known less took no step, and had no slope to take one
        flat = s2 == 0;
        stepX = a * frameX - b * frameY;
        stepY = a * frameY + b * frameX;
        // only curvature that falls away is knowledge
        double c1 = -Math.min(mean - root, 0) / 2;
        double c2 = -Math.min(mean + root, 0) / 2;
        double laa = (c1 * ca * ca + c2 * sa * sa) / (h1 * h1);
        double lbb = (c1 * sa * sa + c2 * ca * ca) / (h2 * h2);
        double lab = (c1 - c2) * sa * ca / (h1 * h2);
        lossXx = laa * frameX * frameX - 2 * lab * frameX * frameY + lbb * frameY * frameY;
        lossYy = laa * frameY * frameY + 2 * lab * frameX * frameY + lbb * frameX * frameX;
        lossXy = (laa - lbb) * frameX * frameY + lab * (frameX * frameX - frameY * frameY);
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

    /** The same, of both axes. */
    public double lossXy() {
        return lossXy;
    }

    /** The same, along y. */
    public double lossYy() {
        return lossYy;
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

    /** Whether the metric leaves open the velocity across the best known direction. */
    public boolean isFlat() {
        return flat;
    }

    /** Step along the one parameter fitted last, in its unit. */
    double step() {
        return step;
    }

    /** Loss of metric per unit squared of the parameter fitted last. */
    double loss() {
        return loss;
    }

    /** Direction in which the velocity is known best, x of a unit vector; of the last fit. */
    public double axisX() {
        return axisX;
    }

    /** The same, y. */
    public double axisY() {
        return axisY;
    }

    /** Loss of metric per (px/s)² along the best known direction. */
    public double bestLoss() {
        return mean() + root();
    }

    /** What is known across the best direction, as a share of what is known along it: 0 for a straight edge. */
    double flatness() {
        return (mean() - root()) / Math.max(mean() + root(), Double.MIN_NORMAL);
    }

    private double mean() {
        return (lossXx + lossYy) / 2;
    }

    private double root() {
        double dif = (lossXx - lossYy) / 2;
        return Math.sqrt(dif * dif + lossXy * lossXy);
    }

    /** Curvature that so many standard deviations of a metric make; where votes only cancel, there are none. */
    private static double floor(double metric, double sigmas) {
        return -2 * sigmas * Math.sqrt(Math.max(0, metric));
    }

    private static double stepTo(double curvature, double gradient, double floor) {
        if (curvature >= floor) {
            // not a top, or no events that meet: uphill only where the slope is clear
            return Math.abs(gradient) > -floor ? Math.signum(gradient) : 0;
        }
        return Math.max(-1.5, Math.min(1.5, -gradient / curvature));
    }

    /** Fits the acceleration along (dirX, dirY) with neighbours h px/s² apart; after a velocity fit around (0, 0). */
    public void fitAcceleration(double dirX, double dirY, double h) {
        if (!squared) {
            for (int i = 0; i < grid.size(); i++) {
                along[i] = 0.5f * tau[i] * tau[i];
            }
            square.take(along, grid.size());
            squared = true;
        }
        fitAlong(square, dirX, square, dirY, h);
    }

    /** Fits the rotation with neighbours h rad/s apart; after a velocity fit around (0, 0). */
    public void fitRotation(double h) {
        fitRadial(fromY, -1, fromX, 1, false, h);
    }

    /** Fits the change of the rotation with neighbours h rad/s² apart; after a velocity fit around (0, 0). */
    public void fitSpin(double h) {
        fitRadial(fromY, -1, fromX, 1, true, h);
    }

    /** Fits the growth with neighbours h per s apart; after a velocity fit around (0, 0). */
    public void fitGrowth(double h) {
        fitRadial(fromX, 1, fromY, 1, false, h);
    }

    /**
     * How clearly a rotation and a growth show within parts of the events by themselves, in standard deviations of the
     * metric: against each tile going on as its middle does, without turning or growing. Two bodies side by side agree
     * with some rotation and growth, but neither of them turns. After a velocity fit around (0, 0).
     *
     * @param dOmega rotation beyond that which the events were projected along, in rad/s
     * @param dGrowth the same of the growth, in 1/s
     */
    public double localEvidence(double omega, double growth, double dOmega, double dGrowth) {
        findTiles();
        shiftBy(dOmega, dGrowth, 0, 0);
        double whole = grid.metric(alongX, 1, alongY, 1);
        shiftBy(dOmega, dGrowth, omega, growth);
        double parts = grid.metric(alongX, 1, alongY, 1);
        return (whole - parts) / Math.sqrt(Math.max(1, Math.max(whole, parts)));
    }

    /** Shifts events by a rotation and a growth about the centre, less one about the middles of their tiles. */
    private void shiftBy(double omega, double growth, double lessOmega, double lessGrowth) {
        for (int i = 0; i < grid.size(); i++) {
            double rx = fromX[i] - tileX[tile[i]];
            double ry = fromY[i] - tileY[tile[i]];
            along[i] = (float) ((growth * fromX[i] - omega * fromY[i] - lessGrowth * rx + lessOmega * ry) * tau[i]);
        }
        alongX.take(along, grid.size());
        for (int i = 0; i < grid.size(); i++) {
            double rx = fromX[i] - tileX[tile[i]];
            double ry = fromY[i] - tileY[tile[i]];
            along[i] = (float) ((growth * fromY[i] + omega * fromX[i] - lessGrowth * ry - lessOmega * rx) * tau[i]);
        }
        alongY.take(along, grid.size());
    }

    private void findTiles() {
        Arrays.fill(tileX, 0);
        Arrays.fill(tileY, 0);
        Arrays.fill(tileSize, 0);
        for (int i = 0; i < grid.size(); i++) {
            int column = Math.max(0, Math.min(TILES - 1, (int) (fromX[i] / TILE_PX + TILES / 2)));
            int row = Math.max(0, Math.min(TILES - 1, (int) (fromY[i] / TILE_PX + TILES / 2)));
            int k = row * TILES + column;
            tile[i] = k;
            tileX[k] += fromX[i];
            tileY[k] += fromY[i];
            tileSize[k]++;
        }
        for (int k = 0; k < tileSize.length; k++) {
            if (tileSize[k] > 0) {
                tileX[k] /= tileSize[k];
                tileY[k] /= tileSize[k];
            }
        }
    }

    /** Fits what shifts events by their places from the centre times the time, or half its square. */
    private void fitRadial(float[] placeX, float signX, float[] placeY, float signY, boolean isSquare, double h) {
        radial(placeX, signX, isSquare);
        alongX.take(along, grid.size());
        radial(placeY, signY, isSquare);
        alongY.take(along, grid.size());
        fitAlong(alongX, 1, alongY, 1, h);
    }

    private void radial(float[] place, float sign, boolean isSquare) {
        for (int i = 0; i < grid.size(); i++) {
            along[i] = sign * place[i] * tau[i] * (isSquare ? 0.5f * tau[i] : 1);
        }
    }

    private void fitAlong(ShiftProfile profileX, double x, ShiftProfile profileY, double y, double h) {
        double less = grid.metric(profileX, -h * x, profileY, -h * y);
        double here = m[4];
        double more = grid.metric(profileX, h * x, profileY, h * y);
        double curvature = less + more - 2 * here;
        double floor = floor(Math.max(here, Math.max(less, more)), CHANGE_SIGMAS);
        step = stepTo(curvature, (more - less) / 2, floor) * h;
        loss = -Math.min(curvature, 0) / 2 / (h * h);
    }
}
