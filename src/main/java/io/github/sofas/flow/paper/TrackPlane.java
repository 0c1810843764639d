package io.github.sofas.flow.paper;

import io.github.sofas.event.SensorSize;
import io.github.sofas.flow.PixelConsumer;
import io.github.sofas.flow.Segment;
import io.github.sofas.flow.motion.Projection;
import java.util.Arrays;

/**
 * The paper's track plane (section Track Plane): 3 x 3 projections of the live events, neighbours h degrees apart. The
 * occupied cells of the central one are the contour; an event on it belongs to the plane. The first projection whose
 * hits pass a share of its cells becomes the centre.
 */
public final class TrackPlane {
    private static final int SIDE = 3;
    private static final int MIDDLE = SIDE / 2;
    private static final int CENTRE = SIDE * SIDE / 2;
    /** Most live events, so that no cell overflows; where there are more, the oldest go early. */
    static final int MOST_EVENTS = Short.MAX_VALUE;
    /** Length of arrays that is always enough: full at most half, they are moved to the front seldom. */
    private static final int LONGEST = 2 * (MOST_EVENTS + 1);

    private Numbers p;
    private final int maskX;
    private final int maskY;
    private final int shift;
    private final int shiftY;
    /** Live events per cell, one accumulator a projection. */
    private final short[][] accumulator;
    private final int[] cells = new int[SIDE * SIDE];
    private final int[] hits = new int[SIDE * SIDE];
    /** Velocities of the columns of projections along x, and of the rows along y. */
    private final int[] fixedVx = new int[SIDE];
    private final int[] fixedVy = new int[SIDE];
    private final int[] cell = new int[SIDE * SIDE];
    /** What events that missed the contour have raised: how often, and which of the cells that fold to one. */
    private final short[] raised;
    private final int[] raisedFold;
    private int[] raisedCells = new int[64];
    private int raisedCount;

    private long[] time = new long[256];
    private short[] x = new short[256];
    private short[] y = new short[256];
    /** Where each live event falls in the columns and in the rows of projections, until the next centre. */
    private short[][] column = new short[SIDE][256];
    private short[][] row = new short[SIDE][256];
    private int head;
    private int tail;

    private double angleX;
    private double angleY;
    private double h;
    /** Where the best projection lies from the centre, in distances of projections. */
    private double bestX;
    private double bestY;
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
    // box of the live events on the sensor
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
        accumulator = new short[SIDE * SIDE][sizeX * sizeY];
        raised = new short[sizeX * sizeY];
        raisedFold = new int[sizeX * sizeY];
    }

    /** The most bytes that its arrays take. */
    static long mostBytes(SensorSize sensor, Numbers p) {
        long cells = (long) side(sensor.width(), p) * side(sensor.height(), p);
        // nine accumulators, raised counts, their folds, and the list of raised cells, as long as it may have grown
        return cells * (10 * Short.BYTES + 3 * Integer.BYTES)
            + (long) LONGEST * (Long.BYTES + (2 + 2 * SIDE) * Short.BYTES);
    }

    /** Side of a torus that no two live events of different cells share a cell of. */
    static int side(int sensorSide, Numbers p) {
        return FlowPlane.side(sensorSide + Math.ceil(farthestTravel(p)));
    }

    /**
     * Longest way, along one axis, that a projection goes during the lifetime, in px. The lifetime follows from the
     * centre's speed, and a neighbour may be faster by the greatest distance h: at angle a it goes
     * L tan(a + h) / tan(a), or, below the speed whose lifetime is the longest, T tan(a + h). The first is greatest at
     * one of its ends, the second where it meets the first.
     */
    private static double farthestTravel(Numbers p) {
        double longestS = p.maxLifetimeUs() * 1e-6;
        double slow = Math.toDegrees(Math.atan(p.lifetimePx() / longestS / p.velocityScalePxPerS()));
        double steep = Math.max(slow, Angles.STEEPEST_DEG - p.maxPerturbationDeg());
        return Math.max(travel(p, slow, longestS), travel(p, steep, longestS));
    }

    private static double travel(Numbers p, double angleDeg, double longestS) {
        double lifetimeS = Math.min(longestS, p.lifetimePx() / Angles.velocity(angleDeg, p));
        return Angles.velocity(Angles.limited(angleDeg + p.maxPerturbationDeg()), p) * lifetimeS;
    }

    /** Tracks on with other parameters that leave the velocity scale and the accumulators' size as they are. */
    void setParameters(Numbers next) {
        p = next;
    }

    /** Begins with the events and the velocity of a new structure. */
    void start(int newId, Refinement structure) {
        id = newId;
        events = 0;
        sinceCheck = 0;
        for (int i = 0; i < structure.loaded(); i++) {
            if (structure.contains(i)) {
                put(structure.x(i), structure.y(i), structure.timeUs(i));
                head++;
            }
        }
        firstUs = time[head - 1];
        lastUs = firstUs;
        checkedUs = firstUs;
        // the spacing of the last refining cycle
        double spacing = p.rangeDeg() / StrictMath.pow(p.refinement(), p.cycles() - 1) / p.flowProjections();
        h = Math.min(p.maxPerturbationDeg(), Math.max(p.minPerturbationDeg(), spacing));
        centre(structure.angleX(), structure.angleY());
    }

    /**
     * Offers an event.
     *
     * @return whether it belongs to this plane
     */
    boolean offer(int eventX, int eventY, long timeUs) {
        expire(timeUs);
        if (head - tail == MOST_EVENTS) {
            removeOldest();
        }
        put(eventX, eventY, timeUs);
        project(head, head + 1);
        for (int k = 0; k < hits.length; k++) {
            cell[k] = row[k / SIDE][head] << shift | column[k % SIDE][head];
            if (accumulator[k][cell[k]] > 0) {
                hits[k]++;
            }
        }
        int c = cell[CENTRE];
        boolean belongs = accumulator[CENTRE][c] > 0 || raise(c, eventX, eventY, timeUs);
        if (belongs) {
            head++;
            for (int k = 0; k < hits.length; k++) {
                if (accumulator[k][cell[k]]++ == 0) {
                    cells[k]++;
                }
            }
            events++;
            sinceCheck++;
            lastUs = timeUs;
        }
        // without live events there are no cells of which a share could be hit
        if (head != tail && someoneIsBest()) {
            recentre();
        }
        return belongs;
    }

    /** Finds where events [from, to) fall: nine projections need three shifts along each axis only. */
    private void project(int from, int to) {
        for (int a = 0; a < SIDE; a++) {
            project(x, fixedVx[a], maskX, column[a], from, to);
            project(y, fixedVy[a], maskY, row[a], from, to);
        }
    }

    private void project(short[] position, int velocity, int mask, short[] projected, int from, int to) {
        for (int i = from; i < to; i++) {
            projected[i] = (short) (position[i] - Projection.travelled(velocity, time[i] - referenceUs) & mask);
        }
    }

    /**
     * Raises a cell that was missed; past the threshold it is contour. Raised cells have no lifetime, so that a later
     * one may fold to the same place. Time and velocity only lead on: the earlier one is then off the sensor for good,
     * and the later one starts anew.
     */
    private boolean raise(int c, int eventX, int eventY, long timeUs) {
        long dt = timeUs - referenceUs;
        int foldX = eventX - Projection.travelled(fixedVx[MIDDLE], dt) >> shift;
        int foldY = eventY - Projection.travelled(fixedVy[MIDDLE], dt) >> shiftY;
        int fold = foldX << 16 | foldY & 0xffff;
        if (raised[c] == 0) {
            if (raisedCount == raisedCells.length) {
                raisedCells = Arrays.copyOf(raisedCells, 2 * raisedCount);
            }
            raisedCells[raisedCount++] = c;
        } else if (raisedFold[c] != fold) {
            raised[c] = 0;
        }
        raisedFold[c] = fold;
        if (raised[c] <= p.contourThreshold()) {
            raised[c]++;
        }
        return raised[c] > p.contourThreshold();
    }

    /**
     * Whether a projection's hits pass the share of its cells. Of several that pass at one event the one with the
     * greatest share is best; of equal ones the centre, else their mean: taking the first would lean all velocities
     * one way.
     */
    private boolean someoneIsBest() {
        int best = -1;
        for (int k = 0; k < hits.length; k++) {
            if (hits[k] > p.hitShare() * cells[k]
                    && (best < 0 || (long) hits[k] * cells[best] > (long) hits[best] * cells[k])) {
                best = k;
            }
        }
        if (best < 0) {
            return false;
        }
        bestX = 0;
        bestY = 0;
        int equals = 0;
        for (int k = 0; k < hits.length; k++) {
            if ((long) hits[k] * cells[best] == (long) hits[best] * cells[k]) {
                bestX += k % SIDE - 1;
                bestY += k / SIDE - 1;
                equals++;
                if (k == CENTRE) {
                    bestX = 0;
                    bestY = 0;
                    return true;
                }
            }
        }
        bestX /= equals;
        bestY /= equals;
        return true;
    }

    private void recentre() {
        double step = h;
        h = bestX == 0 && bestY == 0 ? Math.max(p.minPerturbationDeg(), h / 2)
            : Math.min(p.maxPerturbationDeg(), h * 2);
        centre(angleX + bestX * step, angleY + bestY * step);
    }

    /** Sets the velocity and projects the live events anew, seen from the newest one's time. */
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
        referenceUs = time[head - 1];
        while (tail != head && time[tail] < referenceUs - lifetimeUs) {
            tail++;
        }
        project(tail, head);
        for (int k = 0; k < cells.length; k++) {
            cells[k] = fill(accumulator[k], column[k % SIDE], row[k / SIDE]);
        }
        minX = Integer.MAX_VALUE;
        minY = Integer.MAX_VALUE;
        maxX = 0;
        maxY = 0;
        for (int i = tail; i < head; i++) {
            minX = Math.min(minX, x[i]);
            minY = Math.min(minY, y[i]);
            maxX = Math.max(maxX, x[i]);
            maxY = Math.max(maxY, y[i]);
        }
    }

    /** Puts the live events on an empty accumulator, and returns how many cells they occupy. */
    private int fill(short[] live, short[] columns, short[] rows) {
        int occupied = 0;
        for (int i = tail; i < head; i++) {
            int c = rows[i] << shift | columns[i];
            int before = live[c];
            live[c] = (short) (before + 1);
            occupied += before == 0 ? 1 : 0;
        }
        return occupied;
    }

    private void empty() {
        for (int k = 0; k < cells.length; k++) {
            clear(accumulator[k], column[k % SIDE], row[k / SIDE]);
        }
        for (int i = 0; i < raisedCount; i++) {
            raised[raisedCells[i]] = 0;
        }
        raisedCount = 0;
        Arrays.fill(cells, 0);
        Arrays.fill(hits, 0);
    }

    private void clear(short[] live, short[] columns, short[] rows) {
        for (int i = tail; i < head; i++) {
            live[rows[i] << shift | columns[i]] = 0;
        }
    }

    private void expire(long nowUs) {
        long oldestUs = nowUs - lifetimeUs;
        while (tail != head && time[tail] < oldestUs) {
            removeOldest();
        }
    }

    private void removeOldest() {
        for (int k = 0; k < cells.length; k++) {
            if (--accumulator[k][row[k / SIDE][tail] << shift | column[k % SIDE][tail]] == 0) {
                cells[k]--;
            }
        }
        tail++;
    }

    /** Puts an event behind the live ones; it is one of them once {@link #head} has passed it. */
    private void put(int eventX, int eventY, long timeUs) {
        if (head == time.length) {
            moveToFront(head - tail > time.length / 2 ? Math.min(2 * time.length, LONGEST) : time.length);
        }
        time[head] = timeUs;
        x[head] = (short) eventX;
        y[head] = (short) eventY;
    }

    /** Moves the live events to the front of arrays of some length. */
    private void moveToFront(int length) {
        long[] newTime = length == time.length ? time : new long[length];
        System.arraycopy(time, tail, newTime, 0, head - tail);
        time = newTime;
        x = moved(x, length);
        y = moved(y, length);
        for (int a = 0; a < SIDE; a++) {
            column[a] = moved(column[a], length);
            row[a] = moved(row[a], length);
        }
        head -= tail;
        tail = 0;
    }

    private short[] moved(short[] from, int length) {
        short[] to = length == from.length ? from : new short[length];
        System.arraycopy(from, tail, to, 0, head - tail);
        return to;
    }

    /**
     * Whether the plane got fewer events than expected since the last check: an event for each cell of the contour in
     * the time that it takes to cross the lifetime's pixels.
     */
    boolean isStarved(long nowUs) {
        expire(nowUs);
        if (head == tail) {
            return true;
        }
        if (nowUs - checkedUs < lifetimeUs) {
            return false;
        }
        boolean starved = sinceCheck < p.minShare() * cells[CENTRE];
        checkedUs = nowUs;
        sinceCheck = 0;
        return starved;
    }

    /** Whether another plane describes the same structure: similar velocity and touching boxes. */
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
        int mine = head - tail;
        int theirs = other.head - other.tail;
        long[] newTime = new long[Math.max(time.length, mine + theirs)];
        short[] newX = new short[newTime.length];
        short[] newY = new short[newTime.length];
        int a = tail;
        int b = other.tail;
        for (int i = 0; i < mine + theirs; i++) {
            boolean own = b == other.head || a != head && time[a] <= other.time[b];
            newTime[i] = own ? time[a] : other.time[b];
            newX[i] = own ? x[a] : other.x[b];
            newY[i] = own ? y[a++] : other.y[b++];
        }
        time = newTime;
        x = newX;
        y = newY;
        column = new short[SIDE][time.length];
        row = new short[SIDE][time.length];
        tail = Math.max(0, mine + theirs - MOST_EVENTS);
        head = mine + theirs;
        events += other.events;
        sinceCheck += other.sinceCheck;
        lastUs = Math.max(lastUs, other.lastUs);
        if (head > 0) {
            centre(angleX, angleY);
        }
    }

    /** Id of its segment. */
    public int id() {
        return id;
    }

    /** Velocity in px/s. */
    public float vxPxPerS() {
        return vxPxPerS;
    }

    /** Velocity in px/s, positive down. */
    public float vyPxPerS() {
        return vyPxPerS;
    }

    /** What is known of the structure. */
    Segment segment(Segment.Fate fate, int mergedInto) {
        return new Segment(id, firstUs, lastUs, events, vxPxPerS, vyPxPerS, minX, minY, maxX, maxY, fate, mergedInto);
    }

    /** Lets all events go, so that the plane can serve another structure. */
    void clear() {
        empty();
        head = 0;
        tail = 0;
    }

    /** Shows the cells of the central projection that live events occupy, carried on to a time. */
    void contour(long nowUs, SensorSize sensor, PixelConsumer pixels) {
        int travelX = Projection.travelled(fixedVx[MIDDLE], nowUs - referenceUs);
        int travelY = Projection.travelled(fixedVy[MIDDLE], nowUs - referenceUs);
        for (int i = tail; i < head; i++) {
            int shownX = x[i] - Projection.travelled(fixedVx[MIDDLE], time[i] - referenceUs) + travelX;
            int shownY = y[i] - Projection.travelled(fixedVy[MIDDLE], time[i] - referenceUs) + travelY;
            if (sensor.contains(shownX, shownY)) {
                pixels.accept(shownX, shownY);
            }
        }
    }

    /** Live events. */
    int live() {
        return head - tail;
    }

    /** Angle between neighbouring projections, h, in degrees. */
    double perturbationDeg() {
        return h;
    }

    /** Occupied cells of a projection, for tests and pictures. */
    int cells(int i, int j) {
        return cells[j * SIDE + i];
    }
}
