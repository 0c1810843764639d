package io.github.sofas.flow.paper;

import io.github.sofas.event.SensorSize;
import io.github.sofas.flow.PixelConsumer;
import io.github.sofas.flow.Segment;
import io.github.sofas.flow.motion.Projection;

/**
 * The track plane of the paper (section Track Plane), which follows one structure. It has 3 x 3 projections of the live
 * events, neighbours h degrees apart. The occupied cells of the central projection are the contour; an event on the
 * contour belongs to the plane. The first projection whose hits pass a share of its cells becomes the centre.
 *
 * <p>This class is longer than others, because it states the whole life of a track plane, in the order of the paper.
 * {@link Accumulators}, {@link LiveEvents}, {@link Hits} and {@link RaisedCells} keep the counts.
 */
public final class TrackPlane {
    private static final int SIDE = LiveEvents.SIDE;
    private static final int MIDDLE = SIDE / 2;
    private static final int CENTRE = SIDE * SIDE / 2;

    private Numbers p;
    private final int maskX;
    private final int maskY;
    private final int shift;
    private final int shiftY;
    private final Accumulators accumulators;
    private final Hits hits = new Hits();
    /** Fixed-point velocity along x of each column of projections, and along y of each row. */
    private final int[] fixedVx = new int[SIDE];
    private final int[] fixedVy = new int[SIDE];
    private final int[] cell = new int[SIDE * SIDE];
    private final RaisedCells raised;
    private final LiveEvents live = new LiveEvents();

    private double angleX;
    private double angleY;
    private double h;
    private long referenceUs;
    private long lifetimeUs;
    private long checkedUs;
    private int sinceCheck;

    int id;
    long firstUs;
    long lastUs;
    long events;
    float vxPxPerS;
    float vyPxPerS;
    // box of the live events on the sensor, as of the last centring
    int minX;
    int minY;
    int maxX;
    int maxY;

    TrackPlane(int width, int height, Numbers p) {
        this.p = p;
        int sizeX = side(width, p);
        int sizeY = side(height, p);
        maskX = sizeX - 1;
        maskY = sizeY - 1;
        shift = Integer.numberOfTrailingZeros(sizeX);
        shiftY = Integer.numberOfTrailingZeros(sizeY);
        accumulators = new Accumulators(shift, sizeX * sizeY);
        raised = new RaisedCells(sizeX * sizeY);
    }

    /** Upper bound of the bytes that the arrays take. */
    static long mostBytes(SensorSize sensor, Numbers p) {
        long cells = (long) side(sensor.width(), p) * side(sensor.height(), p);
        return Accumulators.bytes(cells) + RaisedCells.mostBytes(cells) + LiveEvents.mostBytes();
    }

    /** Side of a torus on which live events share a cell only if they fall on the same cell of the plane. */
    static int side(int sensorSide, Numbers p) {
        return FlowPlane.side(sensorSide + Math.ceil(farthestTravel(p)));
    }

    /**
     * Longest travel of a projection within the lifetime, along one axis, in px. The lifetime follows from the speed of
     * the centre, and a neighbour may be steeper by the greatest h. With the centre at angle a, the neighbour travels
     * L tan(a + h) / tan(a), where L is the travel of a lifetime. Below the speed at which the lifetime reaches its
     * maximum T, the neighbour travels T tan(a + h) times the velocity scale. The first is greatest at one of its ends,
     * the second where it meets the first.
     */
    private static double farthestTravel(Numbers p) {
        double longestS = p.maxLifetimeUs() * 1e-6;
        double slow = Math.toDegrees(StrictMath.atan(p.lifetimePx() / longestS / p.velocityScalePxPerS()));
        double steep = Math.max(slow, Angles.STEEPEST_DEG - p.maxPerturbationDeg());
        return Math.max(travel(p, slow, longestS), travel(p, steep, longestS));
    }

    private static double travel(Numbers p, double angleDeg, double longestS) {
        double lifetimeS = Math.min(longestS, p.lifetimePx() / Angles.velocity(angleDeg, p));
        return Angles.velocity(Angles.limited(angleDeg + p.maxPerturbationDeg()), p) * lifetimeS;
    }

    /** Continues with other parameters, which must leave the velocity scale and the accumulators' size as they are. */
    void setParameters(Numbers next) {
        p = next;
    }

    /** Begins to track a new structure, with its events and velocity. */
    void start(int newId, Refinement structure) {
        id = newId;
        events = 0;
        sinceCheck = 0;
        for (int i = 0; i < structure.loaded(); i++) {
            if (structure.contains(i)) {
                live.put(structure.x(i), structure.y(i), structure.timeUs(i));
                live.head++;
            }
        }
        firstUs = live.newestUs();
        lastUs = firstUs;
        checkedUs = firstUs;
        // the spacing of the last refining cycle
        double spacing = p.rangeDeg() / StrictMath.pow(p.refinement(), p.cycles() - 1) / p.flowProjections();
        h = Math.min(p.maxPerturbationDeg(), Math.max(p.minPerturbationDeg(), spacing));
        centre(structure.angleX(), structure.angleY());
    }

    /**
     * Offers an event, which the plane takes if it falls on the contour.
     *
     * @return whether it belongs to this plane
     */
    boolean offer(int eventX, int eventY, long timeUs) {
        expire(timeUs);
        if (live.size() == LiveEvents.MOST) {
            removeOldest();
        }
        live.put(eventX, eventY, timeUs);
        project(live.head, live.head + 1);
        for (int k = 0; k < cell.length; k++) {
            cell[k] = accumulators.cell(k, live, live.head);
            if (accumulators.isOccupied(k, cell[k])) {
                hits.add(k);
            }
        }
        int c = cell[CENTRE];
        boolean belongs = accumulators.isOccupied(CENTRE, c) || raise(c, eventX, eventY, timeUs);
        if (belongs) {
            live.head++;
            for (int k = 0; k < cell.length; k++) {
                accumulators.add(k, cell[k]);
            }
            events++;
            sinceCheck++;
            lastUs = timeUs;
        }
        // without live events there are no cells of which a share could be hit
        if (!live.isEmpty() && hits.haveABest(p.hitShare(), accumulators.cells())) {
            recentre();
        }
        return belongs;
    }

    private void project(int from, int to) {
        for (int a = 0; a < SIDE; a++) {
            live.project(a, fixedVx[a], fixedVy[a], maskX, maskY, referenceUs, from, to);
        }
    }

    /** Raises the cell of an event that missed the contour; returns whether the cell is contour now. */
    private boolean raise(int c, int eventX, int eventY, long timeUs) {
        long dt = timeUs - referenceUs;
        int foldX = eventX - Projection.travelled(fixedVx[MIDDLE], dt) >> shift;
        int foldY = eventY - Projection.travelled(fixedVy[MIDDLE], dt) >> shiftY;
        return raised.raise(c, foldX << 16 | foldY & 0xffff, p.contourThreshold());
    }

    private void recentre() {
        double step = h;
        h = hits.bestX() == 0 && hits.bestY() == 0 ? Math.max(p.minPerturbationDeg(), h / 2)
            : Math.min(p.maxPerturbationDeg(), h * 2);
        centre(angleX + hits.bestX() * step, angleY + hits.bestY() * step);
    }

    /** Sets the velocity, and projects the live events anew with the time of the newest event as the reference time. */
    private void centre(double newAngleX, double newAngleY) {
        empty();
        angleX = Angles.limited(newAngleX);
        angleY = Angles.limited(newAngleY);
        for (int a = 0; a < SIDE; a++) {
            fixedVx[a] = Projection.fixed(Angles.velocity(Angles.limited(angleX + (a - MIDDLE) * h), p));
            fixedVy[a] = Projection.fixed(Angles.velocity(Angles.limited(angleY + (a - MIDDLE) * h), p));
        }
        double vx = Angles.velocity(angleX, p);
        double vy = Angles.velocity(angleY, p);
        vxPxPerS = (float) vx;
        vyPxPerS = (float) vy;
        double speed = Math.max(StrictMath.hypot(vx, vy), 1e-6);
        lifetimeUs = (long) Math.min(p.maxLifetimeUs(), p.lifetimePx() / speed * 1e6);
        referenceUs = live.newestUs();
        while (!live.isEmpty() && live.timeUs[live.tail] < referenceUs - lifetimeUs) {
            live.tail++;
        }
        project(live.tail, live.head);
        accumulators.fill(live);
        minX = Integer.MAX_VALUE;
        minY = Integer.MAX_VALUE;
        maxX = 0;
        maxY = 0;
        for (int i = live.tail; i < live.head; i++) {
            minX = Math.min(minX, live.x[i]);
            minY = Math.min(minY, live.y[i]);
            maxX = Math.max(maxX, live.x[i]);
            maxY = Math.max(maxY, live.y[i]);
        }
    }

    private void empty() {
        accumulators.clear(live);
        raised.clear();
        hits.clear();
    }

    private void expire(long nowUs) {
        long oldestUs = nowUs - lifetimeUs;
        while (!live.isEmpty() && live.timeUs[live.tail] < oldestUs) {
            removeOldest();
        }
    }

    private void removeOldest() {
        accumulators.remove(live, live.tail);
        live.tail++;
    }

    /**
     * Whether the plane got less than the required share of the expected events since the last check, or has no live
     * events. One event per cell of the contour is expected in each lifetime, the time in which the contour crosses p
     * pixels.
     */
    boolean isStarved(long nowUs) {
        expire(nowUs);
        if (live.isEmpty()) {
            return true;
        }
        if (nowUs - checkedUs < lifetimeUs) {
            return false;
        }
        boolean starved = sinceCheck < p.minShare() * accumulators.cells()[CENTRE];
        checkedUs = nowUs;
        sinceCheck = 0;
        return starved;
    }

    /** Whether another plane describes the same structure: the velocities are similar and the boxes touch. */
    boolean describesSameAs(TrackPlane other) {
        double dvx = vxPxPerS - other.vxPxPerS;
        double dvy = vyPxPerS - other.vyPxPerS;
        double speed = Math.max(StrictMath.hypot(vxPxPerS, vyPxPerS), StrictMath.hypot(other.vxPxPerS, other.vyPxPerS));
        return StrictMath.hypot(dvx, dvy) <= p.mergeVelocity() * speed
            && minX <= other.maxX + 1 && other.minX <= maxX + 1 && minY <= other.maxY + 1 && other.minY <= maxY + 1;
    }

    /** Takes over the events of another plane. */
    void merge(TrackPlane other) {
        empty();
        live.merge(other.live);
        events += other.events;
        sinceCheck += other.sinceCheck;
        lastUs = Math.max(lastUs, other.lastUs);
        if (live.head > 0) {
            centre(angleX, angleY);
        }
    }

    /** Id of the segment. */
    public int id() {
        return id;
    }

    /** Velocity in px/s, positive to the right. */
    public float vxPxPerS() {
        return vxPxPerS;
    }

    /** Velocity in px/s, positive down. */
    public float vyPxPerS() {
        return vyPxPerS;
    }

    /** Returns what is known of the structure as a segment. */
    Segment segment(Segment.Fate fate, int mergedInto) {
        return new Segment(id, firstUs, lastUs, events, vxPxPerS, vyPxPerS, 0, 0, minX, minY, maxX, maxY,
            fate, mergedInto);
    }

    /** Forgets all events, so that the plane can serve another structure. */
    void clear() {
        empty();
        live.clear();
    }

    /** Passes on the pixels of the contour, the occupied cells of the central projection, as they lie at a time. */
    void contour(long nowUs, SensorSize sensor, PixelConsumer pixels) {
        int travelX = Projection.travelled(fixedVx[MIDDLE], nowUs - referenceUs);
        int travelY = Projection.travelled(fixedVy[MIDDLE], nowUs - referenceUs);
        for (int i = live.tail; i < live.head; i++) {
            long dt = live.timeUs[i] - referenceUs;
            int shownX = live.x[i] - Projection.travelled(fixedVx[MIDDLE], dt) + travelX;
            int shownY = live.y[i] - Projection.travelled(fixedVy[MIDDLE], dt) + travelY;
            if (sensor.contains(shownX, shownY)) {
                pixels.accept(shownX, shownY);
            }
        }
    }

    /** Number of live events. */
    int live() {
        return live.size();
    }

    /** Angle between neighbouring projections, h, in degrees. */
    double perturbationDeg() {
        return h;
    }

    /** Number of occupied cells of a projection, for tests and pictures. */
    int cells(int i, int j) {
        return accumulators.cells()[j * SIDE + i];
    }
}
