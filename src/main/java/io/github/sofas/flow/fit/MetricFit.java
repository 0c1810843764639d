package io.github.sofas.flow.fit;

import io.github.sofas.flow.motion.Motion;

/**
 * Finds the motion under which a set of events is sharpest (paper, section Structure Detection). A fit computes the
 * metric of 3 x 3 projections around a velocity, lays a quadratic through the nine values, and takes one step to its
 * top. After that, each change of the motion is fitted separately ({@link ChangeFit}). Once the motion is about known,
 * a single vote of the events shows the slopes of the metric by all parameters ({@link TimedVotes}). Slopes are more
 * exact than projections beside the motion and cost less, but serve only as far as neighbouring cells differ.
 */
public final class MetricFit {
    /** Side, in px, of the cells that events vote for: cells as large as pixels favour whole pixels of travel. */
    public static final double CELL_PX = 1.3;
    /** Share of the metric that neighbouring projections should lose: an edge is sharp across and flat along. */
    public static final double NEIGHBOUR_LOSS = 0.04;
    /** Standard deviations of the metric that they should lose where that is more, up to a share of the metric. */
    private static final double NEIGHBOUR_SIGMAS = 2.5;
    private static final double MOST_NEIGHBOUR_LOSS = 0.4;
    /** Smallest distance of neighbouring projections over half the window: closer ones differ by noise only. */
    private static final double MIN_STEP_PX = 0.5;
    /** Greatest distance of neighbouring projections over half the window. */
    private static final double MAX_STEP_PX = 4;
    /** Standard deviations of the metric that neighbours must lose for a step in their direction. */
    public static final double FLAT_SIGMAS = 2;

    /**
     * Distance of neighbouring projections over half the window, in px, above which the metric is computed at them:
     * along an edge, a neighbouring cell differs only by what happens to lie there.
     */
    private static final double BROAD_PX = 1.4;

    /** The middle one of the nine projections. */
    private static final int CENTRE = 4;

    /** Distance from the border of the sensor, in px, within which the border may hide a part of an edge. */
    private static final int BORDER_PX = 2;

    private final int width;
    private final int height;
    private final Metric metric;
    private final ProjectionFrame frame = new ProjectionFrame();
    private final double[] m = new double[9];
    /**
     * Metric at the velocity that was last fitted around or asked for; that velocity; and whether both are of these
     * events.
     */
    private double here;
    private double knownVx;
    private double knownVy;
    private boolean known;
    private final VelocityTop velocity = new VelocityTop();
    private final MetricSlopes slopes = new MetricSlopes();
    private final PlaneSlopes plane = new PlaneSlopes();
    private final SlopedChange sloped = new SlopedChange(slopes);
    private final ProjectedChange projected;
    /** Whether the last velocity fit was by slopes, so that fits of changes are, too. */
    private boolean bySlopes;
    // slope and curvature along the last axis, in units of the frame; and the greatest metric of a fit so far
    private double gradient;
    private double curvature;
    private double greatest;

    /** Makes a fit for up to {@code capacity} events; up to {@code mostOnBoth} events vote on two grids. */
    public MetricFit(int sensorWidth, int sensorHeight, double cellPx, int capacity, int mostOnBoth) {
        width = sensorWidth;
        height = sensorHeight;
        metric = new Metric(sensorWidth, sensorHeight, cellPx, capacity, mostOnBoth);
        projected = new ProjectedChange(metric);
    }

    /** Bytes of the arrays of a fit for up to a number of events. */
    public static long bytes(int sensorWidth, int sensorHeight, double cellPx, int capacity) {
        return Metric.bytes(sensorWidth, sensorHeight, cellPx, capacity);
    }

    /** The most events that fit. */
    public int capacity() {
        return metric.capacity();
    }

    /** Number of events. */
    public int size() {
        return metric.size();
    }

    /** Votes given since the start, a measure of work. */
    public long votes() {
        return metric.votes();
    }

    /** Forgets all events. */
    public void clear() {
        metric.clear();
    }

    /**
     * Adds an event, which all later fits and metrics include.
     *
     * @param x projected column in px
     * @param y projected row in px
     * @param tauS time from the reference in s
     * @param rx column from the centre of rotation in px
     * @param ry row from the centre of rotation in px
     */
    public void add(float x, float y, float tauS, float rx, float ry, int polarity) {
        metric.add(x, y, tauS, rx, ry, polarity);
        known = false;
    }

    /**
     * Adds an event of a structure where it lies in the middle of the window.
     *
     * @param x column in px, projected along the motion except for its deformation, and y the row
     * @param tauS time from the middle in s
     */
    public void add(Motion along, double x, double y, double tauS, int polarity) {
        double rx = x - along.centreX;
        double ry = y - along.centreY;
        if (!along.deformation.isNone()) {
            // a shift of far less than a pixel, which does not change the deformation at the place
            double vx = along.deformation.vx(rx, ry);
            ry -= tauS * along.deformation.vy(rx, ry);
            rx -= tauS * vx;
        }
        add((float) (along.centreX + rx), (float) (along.centreY + ry), (float) tauS, (float) rx, (float) ry, polarity);
    }

    /** Whether an event is so near the border of the sensor that the border may hide where it comes from or goes to. */
    public boolean isAtBorder(int x, int y) {
        return Math.min(x, y) < BORDER_PX || x >= width - BORDER_PX || y >= height - BORDER_PX;
    }

    /**
     * Accounts for a border that cuts off the events, until they are forgotten: cells in sight for only a part of the
     * window count by so much more.
     *
     * @param vx velocity that the events were projected along, in px/s, and vy
     * @param half half the window in s
     */
    public void cutOff(double vx, double vy, double half) {
        metric.cutOff(vx, vy, half);
        known = false;
    }

    /**
     * Measures growth from a place beside the centre, until the events are forgotten; slopes stay about the centre.
     *
     * @param x column from the centre of rotation in px, and y the row
     */
    void growFrom(double x, double y) {
        metric.growFrom(x, y);
    }

    /** Whether the events meet more often where they were projected than moved back by velocity (vx, vy). */
    public boolean isSharperAtRest(double vx, double vy) {
        double moved = metric(vx, vy);
        return metric.size() > 0 && metric.atVelocity(0, 0) > moved;
    }

    /** Metric of the events as they were projected; 0 of none. */
    public double metric() {
        return metric(0, 0);
    }

    /** Metric of the events moved back by velocity (vx, vy); 0 of none. */
    public double metric(double vx, double vy) {
        if (metric.size() == 0) {
            return 0;
        }
        if (!known || vx != knownVx || vy != knownVy) {
            metric.lay();
            here = metric.atVelocity(vx, vy);
            known = true;
            knownVx = vx;
            knownVy = vy;
        }
        return here;
    }

    /** The same, whatever the border cuts off: chance meetings that count for more show nothing. */
    public double metricAsSeen(double vx, double vy) {
        return metric.isCutOff() ? metric.asSeen(vx, vy) : metric(vx, vy);
    }

    /** Sets an upright frame of projections with equal distances in px/s. */
    public void frame(double h) {
        frame.set(h);
    }

    /**
     * Turns the frame of the projections to the principal axes of the loss, and spaces the projections so that each
     * neighbour loses about the same share of the metric: an edge is sharp across and flat along.
     *
     * @param xx loss of the metric per (px/s)²; xx, xy and yy are the entries of a symmetric matrix
     * @param px velocity in px/s that shifts both ends of the window by one pixel
     */
    public void frame(double ofMetric, double xx, double xy, double yy, double share, double px) {
        frame.set(ofMetric, xx, xy, yy, share, MIN_STEP_PX * px, MAX_STEP_PX * px);
    }

    /** The same from the result of a fit. */
    public void frame(VelocityTop top, double share, double px) {
        frame(top.metric(), top.lossXx(), top.lossXy(), top.lossYy(), share, px);
    }

    /**
     * {@return the share of the metric that neighbours must lose to show a top} Few events lose as little by noise: if
     * a metric of less than 2,500 had to lose only {@link #NEIGHBOUR_LOSS}, no step would ever be taken.
     *
     * @param metric of the events
     */
    public static double neighbourLoss(double metric) {
        return Math.max(NEIGHBOUR_LOSS, Math.min(MOST_NEIGHBOUR_LOSS, NEIGHBOUR_SIGMAS / sd(metric)));
    }

    /** {@return the standard deviation of a metric, which counts about as many meetings; 1 for a metric below 1} */
    public static double sd(double metric) {
        return Math.sqrt(Math.max(1, metric));
    }

    /**
     * {@return how far something shows, 0 to 1}
     *
     * @param value of what shows; where this is not positive, nothing shows
     * @param half value at which one half shows
     */
    public static double shown(double value, double half) {
        double ratio = half / value;
        return value > 0 ? 1 / (1 + ratio * ratio) : 0;
    }

    /** Spreads the frame after a step that left it. */
    public void widen(double factor) {
        frame.widen(factor);
    }

    /**
     * Fits the velocity around (vx0, vy0), which is added to the motion that the events were projected along.
     *
     * @param sigmas no step is taken in a direction in which neighbours lose less than this many standard deviations of
     *     the metric, which counts about as many meetings
     * @return the top, valid until the next fit of a velocity
     */
    public VelocityTop fit(double vx0, double vy0, double sigmas) {
        bySlopes = false;
        greatest = Math.max(0, metric(vx0, vy0));
        for (int k = 0; k < m.length; k++) {
            m[k] = k == CENTRE ? here : beside(vx0, vy0, k % 3 - 1, k / 3 - 1);
            greatest = Math.max(greatest, m[k]);
        }
        double ga = (m[2] + m[5] + m[8] - m[0] - m[3] - m[6]) / 6;
        double gb = (m[6] + m[7] + m[8] - m[0] - m[1] - m[2]) / 6;
        double haa = (m[0] + m[2] + m[3] + m[5] + m[6] + m[8] - 2 * (m[1] + m[4] + m[7])) / 3;
        double hbb = (m[0] + m[1] + m[2] + m[6] + m[7] + m[8] - 2 * (m[3] + m[4] + m[5])) / 3;
        double hab = (m[0] + m[8] - m[2] - m[6]) / 4;
        return velocity.of(frame, greatest, ga, gb, haa, hbb, hab, sigmas);
    }

    /**
     * The same from the centre and its four nearest neighbours, in half the time. In a frame along the principal axes
     * of the loss, the corners show how the axes have turned, and little else.
     */
    public VelocityTop fitCross(double vx0, double vy0, double sigmas) {
        bySlopes = false;
        metric(vx0, vy0);
        greatest = Math.max(0, here);
        ask(vx0, vy0, 1, 0, here);
        double ga = gradient;
        double haa = curvature;
        ask(vx0, vy0, 0, 1, here);
        return velocity.of(frame, greatest, ga, gradient, haa, curvature, 0, sigmas);
    }

    /** Finds slope and curvature of the metric at a velocity from its two neighbours along an axis of the frame. */
    private void ask(double vx0, double vy0, int a, int b, double middle) {
        double less = beside(vx0, vy0, -a, -b);
        double more = beside(vx0, vy0, a, b);
        gradient = (more - less) / 2;
        curvature = less + more - 2 * middle;
        greatest = Math.max(greatest, Math.max(less, more));
    }

    /**
     * Whether neighbouring projections lie so far apart that only their corners show how to turn the frame.
     *
     * @param px velocity in px/s that shifts both ends of the window by one pixel
     */
    public boolean isBroad(double px) {
        return Math.max(frame.h1(), frame.h2()) > BROAD_PX * px;
    }

    /**
     * Fits the velocity around the motion itself by the slopes of the metric. Along a broad axis, the two neighbours
     * serve instead, and the frame is then assumed to lie along the principal axes of the loss. If the border cuts off
     * events, the fit is that of {@link #fitCross}, because slopes do not account for the time in sight.
     *
     * @param px velocity in px/s that shifts both ends of the window by one pixel
     * @param sigmas as for {@link #fit}
     * @return the top, valid until the next fit of a velocity
     */
    public VelocityTop fitSlopes(double px, double sigmas) {
        return fitSlopes(px, sigmas, 0);
    }

    /**
     * The same, which also finds the slopes of a plane.
     *
     * @param planeRadius radius of the structure in px; 0 where the slopes of a plane are not needed
     */
    public VelocityTop fitSlopes(double px, double sigmas, double planeRadius) {
        if (metric.isCutOff()) {
            return fitCross(0, 0, sigmas);
        }
        takeSlopes(planeRadius);
        bySlopes = true;
        greatest = Math.max(0, slopes.metric);
        look(1, 0, px);
        double ga = gradient;
        double haa = curvature;
        look(0, 1, px);
        double hab = isBroad(px) ? 0 : -2 * slopes.loss(frame.vx(0, 1, 0), frame.vy(0, 1, 0), frame.vx(0, 0, 1),
            frame.vy(0, 0, 1));
        return velocity.of(frame, greatest, ga, gradient, haa, curvature, hab, sigmas);
    }

    /**
     * Finds slope and curvature of the metric along an axis of the frame: by slopes, or by neighbours if the axis is
     * broad.
     */
    private void look(int a, int b, double px) {
        double x = frame.vx(0, a, b);
        double y = frame.vy(0, a, b);
        gradient = slopes.vx * x + slopes.vy * y;
        curvature = -2 * slopes.loss(x, y, x, y);
        if (x * x + y * y > BROAD_PX * BROAD_PX * px * px) {
            ask(0, 0, a, b, slopes.metric);
        }
    }

    /** Metric of the projection a and b distances along the axes of the frame from a velocity. */
    private double beside(double vx0, double vy0, int a, int b) {
        return metric.atVelocity(frame.vx(vx0, a, b), frame.vy(vy0, a, b));
    }

    /**
     * Slopes of the metric by all parameters of the flow of a plane, around the motion that the events were projected
     * along; valid until the next call.
     *
     * @param radius of the structure in px
     */
    PlaneSlopes planeSlopes(double radius) {
        if (!bySlopes || slopes.plane == null || plane.radius() != radius) {
            takeSlopes(radius);
        }
        return plane;
    }

    private void takeSlopes(double planeRadius) {
        slopes.plane = planeRadius > 0 ? plane : null;
        plane.begin(planeRadius);
        metric.slopes(slopes);
    }

    /** Whether the velocity was fitted by slopes. */
    boolean isSloped() {
        return bySlopes;
    }

    /**
     * Fits of the changes of the motion, by the method of the last velocity fit, which must have been around (0, 0).
     */
    ChangeFit changes() {
        return bySlopes ? sloped : projected.around(here);
    }

    /**
     * Takes a step towards the rotation and the growth by which the events meet most often.
     *
     * @param motion that the events were projected along
     * @param perPx rotation and growth that shift the far end of the structure by a pixel at the ends of the window
     */
    public void stepTurnAndGrowth(Motion motion, double perPx) {
        ChangeFit beside = projected.around(metric());
        motion.omega += beside.rotation(perPx * ChangeFit.APART_PX).step();
        motion.growth += beside.growth(perPx * ChangeFit.APART_PX).step();
    }

    /** The same towards the growth alone. */
    public void stepGrowth(Motion motion, double perPx) {
        motion.growth += projected.around(metric()).growth(perPx * ChangeFit.APART_PX).step();
    }

    /** Sums how the picture of the events changes with place; the structure has so many px of radius. */
    void structure(StructureTensor tensor, double radius) {
        metric.structure(tensor, radius);
    }

    /**
     * How clearly a rotation and a growth show within parts of the events, in standard deviations of the metric. The
     * comparison is with tiles that each move as their middle does, without rotation or growth. Two bodies side by side
     * agree with some rotation and growth, but neither of them turns. Call this after a velocity fit around (0, 0).
     *
     * @param dOmega rotation beyond that which the events were projected along, in rad/s
     * @param dGrowth the same for the growth, in 1/s
     */
    public double localEvidence(double omega, double growth, double dOmega, double dGrowth) {
        double whole = metric.atTurn(dOmega, dGrowth);
        double parts = metric.atTurn(dOmega, dGrowth, omega, growth);
        return (whole - parts) / sd(Math.max(whole, parts));
    }
}
