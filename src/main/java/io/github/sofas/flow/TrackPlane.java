package io.github.sofas.flow;

import io.github.sofas.event.SensorSize;

/**
 * A structure that is tracked (paper, section Track Plane): its live events, the contour that they draw, and its
 * motion, which is measured again and again as the top of the metric of 3 x 3 projections.
 *
 * <p>Ours, because hits alone leave the velocity a tenth off: the metric is compared, not hits counted; neighbours are
 * spaced by what is known along each axis instead of halved and doubled; and the motion has an acceleration and a
 * rotation, so that the velocity is that of now and not of the middle of the window.
 */
final class TrackPlane {
    /** Fewer events than this have no motion. */
    private static final int LEAST_EVENTS = 12;
    /** Measurements that ask all nine projections: the first ones, and some to follow what turns. */
    private static final int LEAST_FULL = 3;
    private static final int FULL_EVERY = 4;
    /**
     * A sample has at least this part of the live events: measurements are the rarer the more there are, so that it
     * costs no more an event, and what is weakly known, the velocity along edges, needs many.
     */
    private static final int SAMPLE_PART = 3;
    /** Events that a structure must have had to be waited for while it is hidden. */
    private static final int LEAST_HIDDEN = 200;
    /** Mean polarity beyond which a structure is an edge that is dark or bright. */
    private static final double ONE_SIDED = 0.7;
    /** Travel after which the other edges of a structure should have been found. */
    private static final double SETTLED_PX = 8;

    private SofasParameters p;
    private LiveEvents live = new LiveEvents();
    private final Contour contour;
    private final Motion motion = new Motion();
    private final Shape shape;

    private int id;
    private long firstUs;
    private long lastUs;
    private long events;

    private double lifetimePx;
    private long lifetimeUs;
    private int sinceMeasured;
    private long measuredUs;
    private int measurements;
    private double usualSize;
    private boolean hidden;
    private long hiddenUs;

    // what the last measurement knew of the velocity: metric, and its loss per (px/s)²
    private double metric;
    private double lossXx;
    private double lossXy;
    private double lossYy;
    /** Direction in which the velocity is known best, a unit vector. */
    private double axisX;
    private double axisY;
    private boolean known;
    /** Metric an event of all live events. */
    private double density;
    private double widen;
    // changes of motion as measured, before what may be noise is left out
    private double rawAlong;
    private double rawAcross;
    private double rawOmega;
    /** The change across as far as it is known. */
    private double shownAcross;

    TrackPlane(int sensorWidth, int sensorHeight, SofasParameters p) {
        this.p = p;
        contour = new Contour(sensorWidth, sensorHeight, p.contourShare());
        shape = new Shape(sensorWidth, sensorHeight);
    }

    /** Begins with the velocity of a new structure; its events are to be added. */
    void start(int newId, long nowUs, double vx, double vy) {
        id = newId;
        firstUs = nowUs;
        lastUs = nowUs;
        events = 0;
        live.clear();
        motion.set(nowUs, vx, vy);
        contour.project(live, motion);
        shape.start(motion);
        lifetimePx = p.lifetimePx();
        lifetimeUs = lifetime();
        sinceMeasured = 0;
        measuredUs = nowUs;
        measurements = 0;
        usualSize = 0;
        hidden = false;
        known = false;
        density = 0;
        widen = 1;
        rawAlong = 0;
        rawAcross = 0;
        rawOmega = 0;
        shownAcross = 0;
    }

    int id() {
        return id;
    }

    int size() {
        return live.size();
    }

    Motion motion() {
        return motion;
    }

    /** Support of an event by the contour; at least {@link #threshold} where it belongs. */
    int support(int x, int y, long timeUs, int polarity) {
        return contour.support(x, y, timeUs, polarity);
    }

    int threshold() {
        return contour.threshold();
    }

    long lifetimeUs() {
        return lifetimeUs;
    }

    /** How many of the cells around an event the structure was seen on not long ago; 0 where they are too few. */
    int remembered(int x, int y, long timeUs) {
        return shape.remembered(x, y, timeUs);
    }

    /** Adds an event of the structure's past, before its motion is measured for the first time. */
    void addPast(int x, int y, long timeUs, int polarity) {
        append(x, y, timeUs, polarity, false, false);
    }

    /**
     * Takes an event that lies on the contour, and measures the motion when enough have come.
     *
     * @param shared whether another plane claims it too
     * @param remembered whether it lies where the contour was, and no live event is near
     */
    void take(int x, int y, long timeUs, int polarity, boolean shared, boolean remembered, MetricFit fit) {
        append(x, y, timeUs, polarity, shared, remembered);
        events++;
        lastUs = timeUs;
        sinceMeasured++;
        if (sinceMeasured >= Math.max(40, Math.max(sample() / 4, live.size() / 12))) {
            recentre(fit, timeUs);
        }
    }

    private void append(int x, int y, long timeUs, int polarity, boolean shared, boolean remembered) {
        if (live.isFull()) {
            dropOldest();
        }
        contour.add(live, live.add(x, y, timeUs, polarity, shared, remembered));
    }

    private void dropOldest() {
        int i = live.index(0);
        if (live.cell[i] >= 0 && !live.remembered[i]) {
            shape.see(contour.column(live.cell[i]), contour.row(live.cell[i]), live.timeUs[i]);
        }
        contour.remove(live, i);
        live.removeOldest();
    }

    private void expire(long nowUs) {
        long oldestUs = nowUs - lifetimeUs;
        while (live.size() > 0 && live.oldestUs() < oldestUs) {
            dropOldest();
        }
    }

    /** Time in which the structure travels its lifetime's pixels. */
    private long lifetime() {
        return (long) Math.min(p.maxLifetimeUs(), lifetimePx / Math.max(motion.speed(contour.radius()), 1e-3) * 1e6);
    }

    /**
     * Whether the plane got too few events: its live events are those of the time in which it travels a number of
     * pixels, so that they stay as many while it moves, whatever its speed.
     */
    private boolean isStarved(long nowUs) {
        expire(nowUs);
        usualSize = Math.max(live.size(), usualSize * 0.999 + live.size() * 0.001);
        return live.size() < Math.max(LEAST_EVENTS, p.minShare() * usualSize);
    }

    /**
     * Whether the structure is no longer to be tracked: its plane is starved, and it was too small to be waited for, is
     * hidden for longer than it remembers its contour, or has left the sensor.
     */
    boolean isGone(long nowUs, SensorSize sensor) {
        if (!isStarved(nowUs)) {
            hidden = false;
            return false;
        }
        if (!hidden) {
            hidden = true;
            hiddenUs = nowUs;
        }
        double x = travelX(nowUs);
        double y = travelY(nowUs);
        return events < LEAST_HIDDEN || nowUs - hiddenUs >= memoryUs()
            || contour.right() + x < 0 || contour.left() + x >= sensor.width()
            || contour.bottom() + y < 0 || contour.top() + y >= sensor.height();
    }

    /** Measures the motion of a structure that gets few events and would else wait long. */
    void measureIfLate(MetricFit fit, long nowUs) {
        long since = nowUs - measuredUs;
        if (sinceMeasured > 0 && since > 20_000 && since > lifetimeUs / 4) {
            recentre(fit, nowUs);
        }
    }

    /** Measures the motion over the live events, and projects them anew along it. */
    void recentre(MetricFit fit, long nowUs) {
        expire(nowUs);
        sinceMeasured = 0;
        measuredUs = nowUs;
        if (live.size() == 0) {
            return;
        }
        if (live.size() >= LEAST_EVENTS && nowUs - live.oldestUs() > 10) {
            double half = (nowUs - live.oldestUs()) * 0.5e-6;
            motion.moveReference(live.oldestUs() + (nowUs - live.oldestUs()) / 2);
            int shared = load(fit);
            if (fit.size() >= LEAST_EVENTS) {
                measure(fit, half, (double) shared / (shared + fit.size()));
            }
        }
        motion.moveReference(nowUs);
        contour.project(live, motion);
        motion.moveCentre(contour.centreX(), contour.centreY());
        lifetimeUs = lifetime();
        shape.follow(contour.motion(), memoryUs());
        expire(nowUs);
    }

    /** Time in which the structure travels the pixels that it remembers its contour for. */
    private long memoryUs() {
        return (long) Math.min(p.maxMemoryUs(), p.memoryPx() / Math.max(motion.speed(contour.radius()), 1e-3) * 1e6);
    }

    /**
     * How many live events a measurement needs: thinning them thins their meetings by the square, so that many events
     * that meet seldom are taken whole.
     */
    private int sample() {
        int n = live.size();
        int least = Math.max(p.sampleEvents(), live.size() / SAMPLE_PART);
        return n <= least ? n : (int) Math.max(least, Math.min(n, n * p.sampleDensity() / Math.max(density, 1e-3)));
    }

    /** Projects a sample of the live events to the motion's reference; returns how many of it were shared. */
    private int load(MetricFit fit) {
        fit.clear();
        int want = sample();
        long stride = ((long) live.size() << 16) / want;
        int shared = 0;
        for (int k = 0; k < want; k++) {
            // anywhere within its share of the ring: an even stride would beat with periodic events
            long place = k * stride + ((k * 0x9E3779B1L & 0xffff) * stride >> 16);
            int i = live.index((int) (place >> 16));
            if (live.shared[i]) {
                shared++;
                continue;
            }
            if (live.remembered[i]) {
                continue;
            }
            motion.project(live.x[i], live.y[i], live.timeUs[i]);
            fit.add((float) motion.x, (float) motion.y, (live.timeUs[i] - motion.referenceUs) * 1e-6f,
                (float) (motion.x - motion.centreX), (float) (motion.y - motion.centreY), live.sign[i]);
        }
        return shared;
    }

    /** Improves the motion, whose reference is the middle of the window. */
    private void measure(MetricFit fit, double half, double crossing) {
        double px = 1 / half; // velocity that shifts both ends of the window by one pixel
        if (measurements == 0) {
            fit.frame(px);
        } else {
            fit.frame(metric, lossXx, lossXy, lossYy, p.neighbourLoss(), p.minStepPx() * px, p.maxStepPx() * px);
            fit.widen(widen);
        }
        if (measurements < LEAST_FULL || measurements % FULL_EVERY == 0) {
            fit.fit(0, 0, p.flatSigmas());
        } else {
            fit.fitCross(p.flatSigmas());
        }
        // in a thinned sample events meet by so much less
        density = fit.metric() / fit.size() * live.size() / fit.size();
        metric = fit.metric();
        lossXx = fit.lossXx();
        lossXy = fit.lossXy();
        lossYy = fit.lossYy();
        axisX = fit.axisX();
        axisY = fit.axisY();
        known = Math.max(lossXx, lossYy) * px * px > 0.01 * metric;
        widen = fit.steps() > 1 ? Math.min(3, widen * 1.5) : Math.max(1, widen * 0.7);
        double moved = step(fit, px, crossing) / px;
        if (crossing > p.maxShared()) {
            forgetChange();
        } else if (measurements >= 2 && moved < 1) {
            measureChange(fit, half);
            double bend = StrictMath.hypot(rawAlong, shownAcross) * half * half / 2;
            if (bend > p.maxBendPx()) {
                lifetimePx = Math.max(p.lifetimePx(), lifetimePx * 0.75);
            } else if (moved < p.steadyPx() && bend < 0.7 * p.maxBendPx()) {
                lifetimePx = Math.min(p.maxLifetimePx(), lifetimePx * 1.08);
            }
        }
        if (moved > 3 * p.steadyPx()) {
            lifetimePx = Math.max(p.lifetimePx(), lifetimePx * 0.8);
        }
        measurements++;
    }

    /**
     * Takes the step of the fit: (L + S)^-1 L of it, L the loss and S a stiffness the same all round, so that what is
     * weakly known moves slowly. Along a straight edge, where nothing is known, back towards the normal flow.
     *
     * @return its length in px/s
     */
    private double step(MetricFit fit, double px, double crossing) {
        double stepX = fit.stepX();
        double stepY = fit.stepY();
        if (measurements > 0) {
            double stiff = p.stiffness() * (1 + 10 * crossing) * metric / (px * px);
            double xx = lossXx + stiff;
            double yy = lossYy + stiff;
            double det = xx * yy - lossXy * lossXy;
            double rx = lossXx * stepX + lossXy * stepY;
            double ry = lossXy * stepX + lossYy * stepY;
            stepX = det > 0 ? (yy * rx - lossXy * ry) / det : 0;
            stepY = det > 0 ? (xx * ry - lossXy * rx) / det : 0;
        }
        motion.vx += stepX;
        motion.vy += stepY;
        if (fit.isFlat()) {
            double along = (motion.vy * axisX - motion.vx * axisY) * p.flatDecay();
            motion.vx += along * axisY;
            motion.vy -= along * axisX;
        }
        return StrictMath.hypot(stepX, stepY);
    }

    /**
     * Measures how the motion changes over the window: acceleration along and across the axis that is known best, and
     * rotation. The velocity at the reference, the middle of the window, stays.
     */
    private void measureChange(MetricFit fit, double half) {
        double bestKnown = Math.max(lossXx, lossYy) / (half * half);
        double acceleration = 2 / (half * half); // shifts both ends of the window by one pixel
        double h = acceleration * p.changePx();
        fit.fitAcceleration(axisX, axisY, h);
        double along = motion.ax * axisX + motion.ay * axisY + fit.step();
        rawAlong += p.changeGain() * (along - rawAlong);
        // measured in the middle of the window, half of it ago: by now some of it is over
        along = p.foresight() * believe(rawAlong, acceleration);
        double flatness = fit.flatness();
        fit.fitAcceleration(-axisY, axisX, h);
        double across = motion.ay * axisX - motion.ax * axisY + fit.step();
        rawAcross += p.changeGain() * (across - rawAcross);
        // along a straight edge nothing is known, of acceleration still less than of velocity
        double shown = shareOf(flatness, flatness + p.flatChange());
        shownAcross = rawAcross * shown;
        across = p.foresight() * believe(rawAcross, acceleration) * shown;
        motion.ax = along * axisX - across * axisY;
        motion.ay = along * axisY + across * axisX;
        double radius = contour.radius();
        if (p.rotation() && radius > 1) {
            double rotation = 1 / (half * radius); // shifts both ends by one pixel at the radius
            fit.fitRotation(rotation * p.changePx());
            rawOmega += p.changeGain() * (motion.omega + fit.step() - rawOmega);
            // nor is the rotation of a disc known
            double loss = fit.loss() * rotation * rotation;
            motion.omega = believe(rawOmega, rotation) * shareOf(loss, loss + p.flatChange() * bestKnown);
        }
    }

    /** A change that shifts the ends of the window by no more than the noise is none. */
    private double believe(double value, double perPx) {
        double px = value / perPx;
        return value * shareOf(px * px, px * px + p.bendPx() * p.bendPx());
    }

    /** A share of what is known; where nothing is known, none. */
    private static double shareOf(double part, double whole) {
        return whole > 0 ? part / whole : 0;
    }

    /** While another structure crosses, the motion is held steady. */
    private void forgetChange() {
        rawAlong *= 0.8;
        rawAcross *= 0.8;
        shownAcross *= 0.8;
        rawOmega *= 0.8;
        motion.ax *= 0.8;
        motion.ay *= 0.8;
        motion.omega *= 0.8;
    }

    /**
     * Whether another plane describes the same structure: boxes that touch or nearly do, and one velocity that serves
     * both with little loss of metric.
     */
    boolean describesSameAs(TrackPlane other, long nowUs) {
        if (live.size() + other.live.size() == 0) {
            return false;
        }
        double gap = Math.max(4, p.mergeGapShare() * Math.min(contour.extent(), other.contour.extent()));
        if (isPairedWith(other) && isSettled(nowUs) && other.isSettled(nowUs)) {
            gap = Math.max(gap, p.pairGapShare() * Math.max(contour.extent(), other.contour.extent()));
        }
        return isNear(other, nowUs, gap) && agrees(other) && other.agrees(this) && sharesVelocity(other);
    }

    /** Whether one is dark and the other bright, as the front and the back of an object are. */
    private boolean isPairedWith(TrackPlane other) {
        return contour.polarity() * other.contour.polarity() < -ONE_SIDED * ONE_SIDED;
    }

    private boolean isSettled(long nowUs) {
        return (nowUs - firstUs) * 1e-6 * motion.speed(contour.radius()) > SETTLED_PX;
    }

    private boolean isNear(TrackPlane other, long nowUs, double gap) {
        double ax = travelX(nowUs);
        double ay = travelY(nowUs);
        double bx = other.travelX(nowUs);
        double by = other.travelY(nowUs);
        return contour.left() + ax <= other.contour.right() + bx + gap
            && other.contour.left() + bx <= contour.right() + ax + gap
            && contour.top() + ay <= other.contour.bottom() + by + gap
            && other.contour.top() + by <= contour.bottom() + ay + gap;
    }

    /** Travel since the contour was projected. */
    private double travelX(long nowUs) {
        return contour.motion().vx * (nowUs - contour.motion().referenceUs) * 1e-6;
    }

    private double travelY(long nowUs) {
        return contour.motion().vy * (nowUs - contour.motion().referenceUs) * 1e-6;
    }

    /** Whether the velocities agree along the axis that this plane knows best, and it knows that one well. */
    private boolean agrees(TrackPlane other) {
        double d = (motion.vx - other.motion.vx) * axisX + (motion.vy - other.motion.vy) * axisY;
        double speed = Math.max(motion.speed(contour.radius()), other.motion.speed(other.contour.radius()));
        return known && Math.abs(d) < p.mergeVelocity() * speed;
    }

    private boolean sharesVelocity(TrackPlane b) {
        // the velocity that serves both best, (L1 + L2)^-1 (L1 v1 + L2 v2), and what each loses by it
        double xx = lossXx + b.lossXx;
        double xy = lossXy + b.lossXy;
        double yy = lossYy + b.lossYy;
        double det = xx * yy - xy * xy;
        if (!(det > 0)) {
            return false;
        }
        double rx = lossXx * motion.vx + lossXy * motion.vy + b.lossXx * b.motion.vx + b.lossXy * b.motion.vy;
        double ry = lossXy * motion.vx + lossYy * motion.vy + b.lossXy * b.motion.vx + b.lossYy * b.motion.vy;
        double vx = (yy * rx - xy * ry) / det;
        double vy = (xx * ry - xy * rx) / det;
        return lossAt(vx, vy) < p.mergeLoss() * metric && b.lossAt(vx, vy) < p.mergeLoss() * b.metric;
    }

    private double lossAt(double vx, double vy) {
        double dx = motion.vx - vx;
        double dy = motion.vy - vy;
        return lossXx * dx * dx + 2 * lossXy * dx * dy + lossYy * dy * dy;
    }

    /**
     * Takes over the events of another plane, and measures the motion of both together.
     *
     * @param spare a ring to put them in
     * @return the ring that this plane used until now
     */
    LiveEvents merge(TrackPlane other, LiveEvents spare, MetricFit fit, long nowUs) {
        double mine = live.size();
        double theirs = other.live.size();
        motion.vx = (motion.vx * mine + other.motion.vx * theirs) / (mine + theirs);
        motion.vy = (motion.vy * mine + other.motion.vy * theirs) / (mine + theirs);
        spare.fillFrom(live, other.live);
        contour.clear(live);
        LiveEvents used = live;
        live = spare;
        contour.project(live, motion);
        motion.moveCentre(contour.centreX(), contour.centreY());
        events += other.events;
        usualSize = live.size();
        recentre(fit, nowUs);
        return used;
    }

    /** Tracks on with other parameters. */
    void setParameters(SofasParameters next) {
        p = next;
        contour.setShare(p.contourShare());
        lifetimePx = Math.max(p.lifetimePx(), Math.min(p.maxLifetimePx(), lifetimePx));
    }

    /** Lets all events go, so that the plane can serve another structure. */
    void clear() {
        contour.clear(live);
        live.clear();
    }

    /** Shows the contour as it is at a time. */
    void contour(long nowUs, PixelConsumer pixels) {
        contour.show(nowUs, pixels);
    }

    /** What is known of the structure. */
    Segment segment(int sensorWidth, int sensorHeight, Segment.Fate fate, int mergedInto) {
        return new Segment(id, firstUs, lastUs, events, motion.vxAt((int) motion.centreY, motion.referenceUs),
            motion.vyAt((int) motion.centreX, motion.referenceUs), clip(contour.left(), sensorWidth),
            clip(contour.top(), sensorHeight), clip(contour.right(), sensorWidth),
            clip(contour.bottom(), sensorHeight), fate, mergedInto);
    }

    private static int clip(int v, int size) {
        return Math.max(0, Math.min(size - 1, v));
    }
}
