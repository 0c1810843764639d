package io.github.sofas.flow.paper;

import io.github.sofas.event.SensorSize;
import io.github.sofas.flow.motion.Projection;

/**
 * The flow plane of the paper, which finds new structures (section Flow Plane). It has n x n projections, evenly spaced
 * in angle, each with an accumulator of signed votes and a metric. A structure is found when the greatest metric has
 * stayed with one projection for p events. Events that belong to no structure leave after a lifespan.
 */
public final class FlowPlane {
    /**
     * Longest side of an accumulator. Parameters that allow live events to travel farther fold the plane: cells that
     * far apart then count as one. That costs a little noise, but otherwise memory would grow without bounds.
     */
    static final int LONGEST_SIDE = 4096;
    /** Greatest number of events held, so that no cell overflows; beyond it, the oldest events leave early. */
    static final int MOST_EVENTS = Short.MAX_VALUE;

    private Numbers p;
    private final int n;
    private final Votes votes;
    /** Indices of the waiting votes by which events arrive; after each of these, the greatest metric is evaluated. */
    private final int[] arrival = new int[Votes.BLOCK];
    private int arrivals;
    private Refinement refinement;

    private long[] time = new long[1024];
    private short[] x = new short[1024];
    private short[] y = new short[1024];
    private byte[] sign = new byte[1024];
    private int head;
    private int tail;
    private long referenceUs;
    private int best = -1;
    private int constantFor;

    /** Makes an empty plane for a sensor of so many px. */
    public FlowPlane(int width, int height, Numbers p) {
        this.p = p;
        n = p.flowProjections();
        votes = new Votes(width, height, p);
        refinement = new Refinement(p);
    }

    /** Upper bound of the bytes that the arrays of the plane and of its {@link Refinement} take. */
    public static long mostBytes(SensorSize sensor, Numbers p) {
        long columns = 0;
        long rows = 0;
        for (int i = 0; i < p.flowProjections(); i++) {
            int velocity = velocity(i, p);
            columns += side(sensor.width(), velocity, p);
            rows += side(sensor.height(), velocity, p);
        }
        double farthest = Angles.velocity(Angles.STEEPEST_DEG, p) * p.lifespanUs() * 1e-6;
        long refined = (long) (Math.min(LONGEST_SIDE, sensor.width() + farthest + 1) + 2)
            * (long) (Math.min(LONGEST_SIDE, sensor.height() + farthest + 1) + 2);
        // arrays of events: they double only while more than half full
        return columns * rows * Short.BYTES + refined * (2 * Integer.BYTES + 1)
            + 2L * (MOST_EVENTS + 1) * (Long.BYTES + 2 * Short.BYTES + 2 * Byte.BYTES + Integer.BYTES)
            + 2L * p.flowProjections() * Votes.BLOCK * Integer.BYTES;
    }

    /** Velocity of the i-th projection along an axis, in fixed-point px/µs. */
    static int velocity(int i, Numbers p) {
        return Projection.fixed(Angles.velocity(Angles.at(i, p.flowProjections(), p.rangeDeg()), p));
    }

    /** Side of a torus on which live events share a cell only if they fall on the same cell of the plane. */
    static int side(int sensorSide, int velocity, Numbers p) {
        return side(sensorSide + 2 + Math.abs(Projection.travelled(velocity, p.lifespanUs())));
    }

    /** Side of a torus of at least so many cells: a power of two, and at most {@value #LONGEST_SIDE}. */
    static int side(double least) {
        int side = 2;
        while (side < least && side < LONGEST_SIDE) {
            side *= 2;
        }
        return side;
    }

    /**
     * Adds an event to all projections. Its vote may wait for those of later events until it can make a difference.
     *
     * @return whether a structure was found, after one projection has had the greatest metric for p events; the caller
     *     reads the structure from {@link #structure} and then removes it by {@link #release}
     */
    public boolean add(int eventX, int eventY, long timeUs, int polarity) {
        if (head == tail) {
            head = 0;
            tail = 0;
            referenceUs = timeUs;
        }
        flush(timeUs - p.lifespanUs());
        if (head - tail == MOST_EVENTS) {
            removeOldest();
        }
        if (head == time.length) {
            makeRoom();
        }
        time[head] = timeUs;
        x[head] = (short) eventX;
        y[head] = (short) eventY;
        sign[head] = (byte) polarity;
        vote(head, polarity);
        arrival[arrivals++] = votes.waiting() - 1;
        head++;
        // a projection must stay the greatest for that many more events: before, nothing can be found
        if (arrivals < p.constantEvents() - constantFor) {
            return false;
        }
        settle();
        if (constantFor < p.constantEvents()) {
            return false;
        }
        constantFor = 0;
        refinement.load(time, x, y, sign, tail, head);
        refinement.refine(best % n, best / n);
        return refinement.size() >= p.minEvents();
    }

    /** Continues with other parameters, which must leave the projections and the lifespan as they are. */
    public void setParameters(Numbers next) {
        settle();
        p = next;
        refinement = new Refinement(p);
    }

    /** The structure found last, with its events. */
    public Refinement structure() {
        return refinement;
    }

    private void flush(long oldestUs) {
        while (tail != head && time[tail] < oldestUs) {
            removeOldest();
        }
    }

    private void removeOldest() {
        vote(tail, -sign[tail]);
        tail++;
    }

    private void makeRoom() {
        int live = head - tail;
        int capacity = live > time.length / 2 ? time.length * 2 : time.length;
        long[] newTime = capacity == time.length ? time : new long[capacity];
        short[] newX = capacity == x.length ? x : new short[capacity];
        short[] newY = capacity == y.length ? y : new short[capacity];
        byte[] newSign = capacity == sign.length ? sign : new byte[capacity];
        System.arraycopy(time, tail, newTime, 0, live);
        System.arraycopy(x, tail, newX, 0, live);
        System.arraycopy(y, tail, newY, 0, live);
        System.arraycopy(sign, tail, newSign, 0, live);
        time = newTime;
        x = newX;
        y = newY;
        sign = newSign;
        tail = 0;
        head = live;
    }

    private void vote(int i, int w) {
        if (votes.waiting() == Votes.BLOCK) {
            settle();
        }
        votes.add(x[i], y[i], time[i] - referenceUs, w);
    }

    /** Casts the waiting votes, and follows the greatest metric from event to event. */
    private void settle() {
        votes.settle();
        for (int a = 0; a < arrivals; a++) {
            int greatest = votes.greatestAfter(arrival[a]);
            constantFor = greatest == best ? constantFor + 1 : 1;
            best = greatest;
        }
        arrivals = 0;
    }

    /** Removes the events of the structure, and projects the remaining events into the emptied plane. */
    public void release() {
        for (int i = tail; i < head; i++) {
            vote(i, -sign[i]);
        }
        int kept = 0;
        int from = tail;
        for (int i = from; i < head; i++) {
            if (!refinement.contains(i - from)) {
                time[kept] = time[i];
                x[kept] = x[i];
                y[kept] = y[i];
                sign[kept] = sign[i];
                kept++;
            }
        }
        tail = 0;
        head = kept;
        if (kept > 0) {
            referenceUs = time[0];
        }
        for (int i = 0; i < kept; i++) {
            vote(i, sign[i]);
        }
        settle();
        best = -1;
    }

    /** Number of events that belong to no structure yet. */
    int size() {
        return head - tail;
    }

    /** Metric of a projection, for tests and pictures. */
    long metric(int i, int j) {
        settle();
        return votes.metric(j * n + i);
    }

    /** Metric per event of each projection, for display; 0 while the plane is empty. */
    public float[] metricsPerEvent() {
        settle();
        float[] perEvent = new float[n * n];
        for (int k = 0; k < perEvent.length && size() > 0; k++) {
            perEvent[k] = (float) votes.metric(k) / size();
        }
        return perEvent;
    }

    /** Forgets all events. */
    public void reset() {
        for (int i = tail; i < head; i++) {
            vote(i, -sign[i]);
        }
        settle();
        head = 0;
        tail = 0;
        best = -1;
        constantFor = 0;
    }
}
