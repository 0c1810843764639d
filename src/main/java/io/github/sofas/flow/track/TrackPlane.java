package io.github.sofas.flow.track;

import io.github.sofas.event.SensorSize;
import io.github.sofas.flow.PixelConsumer;
import io.github.sofas.flow.Segment;
import io.github.sofas.flow.SofasParameters;
import io.github.sofas.flow.fit.CommonMotion;
import io.github.sofas.flow.fit.MetricFit;
import io.github.sofas.flow.fit.MotionChange;
import io.github.sofas.flow.fit.MotionLoss;
import io.github.sofas.flow.motion.Motion;
import io.github.sofas.flow.motion.SteppedProjection;

/**
 * A structure that is tracked (paper, section Track Plane): its live events, the contour that they draw, and its
 * motion, which is measured again and again as the top of the metric of 3 x 3 projections.
 *
 * <p>Ours, because hits alone leave the velocity a tenth off: the metric is compared, not hits counted; neighbours are
 * spaced by what is known along each axis instead of halved and doubled; and the motion has an acceleration and a
 * rotation, so that the velocity is that of now and not of the middle of the window.
 */
public final class TrackPlane {
    /** Fewer events than this have no motion. */
    private static final int LEAST_EVENTS = 12;
    /** Measurements that ask all nine projections: the first ones, and some to follow what turns. */
    private static final int LEAST_FULL = 3;
    private static final int FULL_EVERY = 4;
    /**
     * A sample has at least this part of the live events: measurements are the rarer the more there are, so that it
     * costs no more an event, and what is weakly known, the velocity along edges, needs many.
     */
    private static final int SAMPLE_PART = 4;
    /** Fewest events between two measurements, and live events of which a quarter must be new. */
    private static final int LEAST_NEWS = 40;
    private static final int FEW_EVENTS = 2000;
    /**
     * Stretches of the window that a sample is made of, from its beginning to its end. Events of one stretch meet as
     * often as if all were taken, and those of two lie so far apart in time that they show the velocity; events that
     * follow each other at once do not, and those of real pixels make it look too fast.
     */
    private static final int STRETCHES = 4;
    /** Events that a structure must have had to be waited for while it is hidden. */
    private static final int LEAST_HIDDEN = 200;
    /** Events are projected to be measured in steps of this part of a pixel: less than positions are told apart by. */
    private static final double STEP_PX = 1.0 / 64;
    /** Longest lifetime: what stands still would keep its events for ever. */
    private static final long MAX_LIFETIME_US = 1_000_000;
    /** Longest time for which the contour is remembered: what stands still would haunt its place. */
    private static final long MAX_MEMORY_US = 2_000_000;
    /** Events that a velocity is measured from where they meet often: 1,000 reach half a percent. */
    private static final int SAMPLE_EVENTS = 1000;
    /** Metric an event below which a sample is enlarged: thinning events thins their meetings by the square. */
    private static final double SAMPLE_DENSITY = 1.5;
    /** Correction over half the window below which a velocity is steady. */
    private static final double STEADY_PX = 0.15;
    /** Shift at the end of the window by an acceleration above which the lifetime shrinks: it soon ends. */
    private static final double MAX_BEND_PX = 0.25;
    /** Share of events that two planes claim above which no change of motion is measured: they pull at each other. */
    private static final double MAX_SHARED = 0.15;
    /** Share of the metric per px that a weakly known direction must lose to follow at half the step. */
    private static final double STIFFNESS = 0.002;
    /** Share of the velocity along a straight edge that is dropped at each measurement: it would drift. */
    private static final double FLAT_DECAY = 0.05;
    /** Share of the metric that two planes may lose by one common motion: an edge knows a part of its velocity only. */
    private static final double MERGE_LOSS = 0.02;
    /** Gap between boxes that may merge, as a share of the shorter of their longer sides. */
    private static final double MERGE_GAP_SHARE = 0.8;

    private SofasParameters.Track p;
    private LiveEvents live = new LiveEvents();
    private final Contour contour;
    private final Motion motion = new Motion();
    private final SteppedProjection stepped = new SteppedProjection();
    private final ContourMemory shape;
    private final MotionChange change = new MotionChange();

    private int id;
    private long firstUs;
    private long lastUs;
    private long events;

    private double lifetimePx;
    private long lifetimeUs;
    private int sinceMeasured;
    private long measuredUs;
    private int measurements;
    /** Live events per px of the lifetime: as many at any speed. */
    private double usualDensity;
    private boolean hidden;
    private long hiddenUs;

    private final MotionLoss loss = new MotionLoss();
    /** Metric an event of all live events. */
    private double density;
    private double widen;

    TrackPlane(int sensorWidth, int sensorHeight, SofasParameters.Track p) {
        this.p = p;
        contour = new Contour(sensorWidth, sensorHeight);
        shape = new ContourMemory(sensorWidth, sensorHeight);
    }

    /** The most bytes that its arrays take. */
    static long mostBytes(SensorSize sensor) {
        return Integer.BYTES * (sensor.width() + 2L * Contour.MARGIN) * (sensor.height() + 2L * Contour.MARGIN)
            + ((long) Integer.BYTES << ContourMemory.bits(sensor.width()) + ContourMemory.bits(sensor.height()))
            + LiveEvents.BYTES;
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
        change.restart();
        lifetimePx = p.lifetimePx();
        lifetimeUs = lifetime();
        sinceMeasured = 0;
        measuredUs = nowUs;
        measurements = 0;
        usualDensity = 0;
        hidden = false;
        loss.clear();
        density = 0;
        widen = 1;
    }

    /** Id of its segment. */
    public int id() {
        return id;
    }

    int size() {
        return live.size();
    }

    /** Its motion, read only. */
    public Motion motion() {
        return motion;
    }

    /** Support of an event by the contour; at least {@link #threshold} where it belongs. */
    public int support(int x, int y, long timeUs, int polarity) {
        return contour.support(x, y, timeUs, polarity);
    }

    /** Least support of an event that belongs to it. */
    public int threshold() {
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
    public void addPast(int x, int y, long timeUs, int polarity) {
        append(x, y, timeUs, polarity, false, false);
    }

    /**
     * Takes an event that lies on the contour, and measures the motion when enough have come.
     *
     * @param shared whether another plane claims it too
     * @param remembered whether it lies where the contour was, and no live event is near
     */
    void take(int x, int y, long timeUs, int polarity, boolean shared, boolean remembered, MetricFit fit) {
        events++;
        lastUs = timeUs;
        append(x, y, timeUs, polarity, shared, remembered);
        sinceMeasured++;
        if (sinceMeasured >= newsNeeded()) {
            recentre(fit, timeUs);
        }
    }

    /** Events until the motion is measured anew: a quarter of few, a twelfth of many, more where all are needed. */
    private int newsNeeded() {
        int n = live.size();
        return Math.max(LEAST_NEWS, Math.max(Math.max(sample(), Math.min(n, FEW_EVENTS)) / 4, n / 12));
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

    /** Time in which the structure travels its lifetime's pixels, from a stand too if it speeds up. */
    private long lifetime() {
        double speed = motion.speed(contour.radius());
        double gained = StrictMath.hypot(motion.ax, motion.ay) * lifetimePx / 2;
        return (long) Math.min(MAX_LIFETIME_US,
            lifetimePx / Math.max(Math.sqrt(speed * speed + gained), 1e-3) * 1e6);
    }

    /**
     * Whether the plane has fewer events than a share of the usual: its live events are those of the time in which it
     * travels a number of pixels, so that they stay as many a pixel while it moves, whatever its speed.
     */
    private boolean hasFewerThan(double share) {
        double now = eventsPerPx();
        usualDensity = Math.max(now, usualDensity * 0.999 + now * 0.001);
        return live.size() < LEAST_EVENTS || now < share * usualDensity;
    }

    /** Live events per px of travel; a full ring has let those go that were older than its oldest. */
    private double eventsPerPx() {
        double px = lifetimePx;
        if (live.isFull()) {
            px *= Math.min(1, (live.newestUs() - live.oldestUs() + 1.0) / lifetimeUs);
        }
        return live.size() / px;
    }

    /**
     * Whether the structure is no longer to be tracked: its plane is starved, and it was too small to be waited for, is
     * hidden for longer than it remembers its contour, or has left the sensor.
     */
    boolean isGone(long nowUs, SensorSize sensor) {
        expire(nowUs);
        if (!hasFewerThan(p.minShare())) {
            hidden = false;
            return false;
        }
        if (!hidden) {
            hidden = true;
            hiddenUs = nowUs;
        }
        return events < LEAST_HIDDEN || nowUs - hiddenUs >= memoryUs() || hasLeft(nowUs, sensor);
    }

    private boolean hasLeft(long nowUs, SensorSize sensor) {
        double x = contour.travelX(nowUs);
        double y = contour.travelY(nowUs);
        return contour.right() + x < 0 || contour.left() + x >= sensor.width()
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
        if (hasFewerThan(p.minShare())) {
            // what is left is noise, or too little: the motion is held
            change.hold(motion);
        } else if (nowUs - live.oldestUs() > 10) {
            double half = (nowUs - live.oldestUs()) * 0.5e-6;
            motion.moveReference(live.oldestUs() + (nowUs - live.oldestUs()) / 2);
            int shared = load(fit);
            if (fit.size() >= LEAST_EVENTS) {
                measure(fit, half, (double) shared / (shared + fit.size()));
            }
        }
        carryOn(nowUs);
    }

    /** Projects the live events to now, along the motion as it is known. */
    private void carryOn(long nowUs) {
        motion.moveReference(nowUs);
        contour.project(live, motion);
        motion.moveCentre(contour.centreX(), contour.centreY());
        lifetimeUs = lifetime();
        shape.follow(contour.motion(), memoryUs());
        expire(nowUs);
    }

    /** Time in which the structure travels the pixels that it remembers its contour for. */
    private long memoryUs() {
        return (long) Math.min(MAX_MEMORY_US, p.memoryPx() / Math.max(motion.speed(contour.radius()), 1e-3) * 1e6);
    }

    /**
     * How many live events a measurement needs: thinning them thins their meetings by the square, so that many events
     * that meet seldom are taken whole.
     */
    private int sample() {
        int n = live.size();
        int least = Math.max(SAMPLE_EVENTS, live.size() / SAMPLE_PART);
        return n <= least ? n : (int) Math.max(least, Math.min(n, n * SAMPLE_DENSITY / Math.max(density, 1e-3)));
    }

    /** Projects a sample of the live events to the motion's reference; returns how many of it were shared. */
    private int load(MetricFit fit) {
        fit.clear();
        int want = sample();
        int left = live.size() - want;
        int shared = 0;
        stepped.begin(motion, motion.referenceUs - live.oldestUs(), 2 * contour.radius(), STEP_PX);
        for (int k = 0; k < want; k++) {
            int i = live.index(k + left * (k * STRETCHES / want) / (STRETCHES - 1));
            if (live.shared[i]) {
                shared++;
                continue;
            }
            if (live.remembered[i]) {
                continue;
            }
            stepped.advance(live.timeUs[i]);
            double x = stepped.x(live.x[i], live.y[i]);
            double y = stepped.y(live.x[i], live.y[i]);
            fit.add((float) x, (float) y, (live.timeUs[i] - motion.referenceUs) * 1e-6f,
                (float) (x - motion.centreX), (float) (y - motion.centreY), live.sign[i]);
        }
        return shared;
    }

    /** Improves the motion, whose reference is the middle of the window. */
    private void measure(MetricFit fit, double half, double crossing) {
        double px = 1 / half; // velocity that shifts both ends of the window by one pixel
        if (measurements == 0) {
            fit.frame(px);
        } else {
            fit.frame(loss.metric, loss.xx, loss.xy, loss.yy, MetricFit.NEIGHBOUR_LOSS, MetricFit.MIN_STEP_PX * px,
                MetricFit.MAX_STEP_PX * px);
            fit.widen(widen);
        }
        if (measurements < LEAST_FULL || measurements % FULL_EVERY == 0) {
            fit.fit(0, 0, MetricFit.FLAT_SIGMAS);
        } else {
            fit.fitCross(0, 0, MetricFit.FLAT_SIGMAS);
        }
        // in a thinned sample events meet by so much less
        density = fit.metric() / fit.size() * live.size() / fit.size();
        loss.take(fit);
        widen = fit.steps() > 1 ? Math.min(3, widen * 1.5) : Math.max(1, widen * 0.7);
        double moved = step(fit, px, crossing) / px;
        if (crossing > MAX_SHARED) {
            change.hold(motion);
        } else if (measurements >= 2 && moved < 1) {
            change.measure(fit, motion, loss, half, contour.radius(), p);
            double bend = change.bendPx(half);
            if (bend > MAX_BEND_PX) {
                lifetimePx = Math.max(p.lifetimePx(), lifetimePx * 0.75);
            } else if (moved < STEADY_PX && bend < 0.7 * MAX_BEND_PX) {
                lifetimePx = Math.min(p.maxLifetimePx(), lifetimePx * 1.08);
            }
        }
        if (moved > 3 * STEADY_PX) {
            lifetimePx = Math.max(p.lifetimePx(), lifetimePx * 0.8);
        }
        double radius = contour.radius();
        // as well known as turning would be that shows a little, so that not everything may be one body
        loss.turn = change.turnLoss() + MotionChange.FLAT_CHANGE * loss.best() * radius * radius;
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
            double stiff = STIFFNESS * (1 + 10 * crossing) * loss.metric / (px * px);
            double xx = loss.xx + stiff;
            double yy = loss.yy + stiff;
            double det = xx * yy - loss.xy * loss.xy;
            double rx = loss.xx * stepX + loss.xy * stepY;
            double ry = loss.xy * stepX + loss.yy * stepY;
            stepX = det > 0 ? (yy * rx - loss.xy * ry) / det : 0;
            stepY = det > 0 ? (xx * ry - loss.xy * rx) / det : 0;
        }
        motion.vx += stepX;
        motion.vy += stepY;
        if (fit.isFlat()) {
            double along = (motion.vy * loss.axisX - motion.vx * loss.axisY) * FLAT_DECAY;
            motion.vx += along * loss.axisY;
            motion.vy -= along * loss.axisX;
        }
        return StrictMath.hypot(stepX, stepY);
    }

    /**
     * Whether another plane describes the same structure: boxes that touch or nearly do, and one motion that serves
     * both with little loss of metric.
     *
     * @param common is left with that motion
     */
    boolean describesSameAs(TrackPlane other, CommonMotion common, long nowUs) {
        if (live.size() + other.live.size() == 0) {
            return false;
        }
        double gap = Math.max(4, MERGE_GAP_SHARE * Math.min(contour.extent(), other.contour.extent()));
        return isNear(other, nowUs, gap)
            && (sharesVelocity(other, common, nowUs) || sharesMotion(other, common, nowUs));
    }

    private boolean sharesVelocity(TrackPlane other, CommonMotion common, long nowUs) {
        return common.fitVelocity(motion, loss, other.motion, other.loss, nowUs) && common.lost() < MERGE_LOSS;
    }

    /** Of a new structure it is not known yet whether it turns. */
    private boolean sharesMotion(TrackPlane other, CommonMotion common, long nowUs) {
        return measurements > LEAST_FULL && other.measurements > LEAST_FULL
            && common.fit(motion, loss, other.motion, other.loss, nowUs) && common.lost() < MERGE_LOSS;
    }

    MotionLoss loss() {
        return loss;
    }

    private boolean isNear(TrackPlane other, long nowUs, double gap) {
        double ax = contour.travelX(nowUs);
        double ay = contour.travelY(nowUs);
        double bx = other.contour.travelX(nowUs);
        double by = other.contour.travelY(nowUs);
        return contour.left() + ax <= other.contour.right() + bx + gap
            && other.contour.left() + bx <= contour.right() + ax + gap
            && contour.top() + ay <= other.contour.bottom() + by + gap
            && other.contour.top() + by <= contour.bottom() + ay + gap;
    }

    /**
     * Takes over the events of another plane; the motion of all is measured with the next event.
     *
     * @param common the motion that serves both
     * @param spare a ring to put them in
     * @return the ring that this plane used until now
     */
    LiveEvents merge(TrackPlane other, Motion common, LiveEvents spare, long nowUs) {
        motion.copyFrom(common);
        change.setOmega(motion.omega);
        spare.fillFrom(live, other.live);
        contour.clear(live);
        LiveEvents used = live;
        live = spare;
        events += other.events;
        carryOn(nowUs);
        usualDensity = eventsPerPx();
        // enough to be measured with the next event, once for all planes that merge now
        sinceMeasured = live.size();
        return used;
    }

    /** Tracks on with other parameters. */
    void setParameters(SofasParameters.Track next) {
        p = next;
        lifetimePx = Math.max(p.lifetimePx(), Math.min(p.maxLifetimePx(), lifetimePx));
    }

    /** Lets all events go, so that the plane can serve another structure. */
    void clear() {
        contour.wipe();
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
