package io.github.sofas.flow;

import java.util.Arrays;

/**
 * The paper's flow plane: n x n projections, evenly spaced in angle, each with an accumulator of signed votes and its
 * metric; a structure is found when the greatest metric has stayed with one projection for p events (section Flow
 * Plane).
 */
final class PaperFlowPlane {
    /**
     * Longest side of an accumulator. Parameters that let live events travel farther than that fold the plane: cells
     * that far apart then count as one, which costs a little noise, where memory would grow without bounds.
     */
    static final int LONGEST_SIDE = 4096;
    /** Most events that wait for a structure, so that no cell overflows; where there are more, the oldest go early. */
    static final int MOST_EVENTS = Short.MAX_VALUE;

    private SofasParameters p;
    private final int n;
    private final int[] vx;
    private final int[] vy;
    private final short[][] accumulator;
    private final int[] maskX;
    private final int[] maskY;
    private final int[] shift;
    private final long[] metric;
    /** Projections from the slowest to the fastest: of equal metrics the first in this order is the greatest. */
    private final int[] bySpeed;
    private PaperRefinement refinement;

    private long[] time = new long[1024];
    private short[] x = new short[1024];
    private short[] y = new short[1024];
    private byte[] sign = new byte[1024];
    private int head;
    private int tail;
    private long referenceUs;
    private int best = -1;
    private int constantFor;

    PaperFlowPlane(int width, int height, SofasParameters p) {
        this.p = p;
        n = p.flowProjections();
        vx = new int[n * n];
        vy = new int[n * n];
        accumulator = new short[n * n][];
        maskX = new int[n * n];
        maskY = new int[n * n];
        shift = new int[n * n];
        metric = new long[n * n];
        for (int j = 0; j < n; j++) {
            for (int i = 0; i < n; i++) {
                int k = j * n + i;
                vx[k] = velocity(i, p);
                vy[k] = velocity(j, p);
                int sizeX = side(width, vx[k], p);
                int sizeY = side(height, vy[k], p);
                maskX[k] = sizeX - 1;
                maskY[k] = sizeY - 1;
                shift[k] = Integer.numberOfTrailingZeros(sizeX);
                accumulator[k] = new short[sizeX * sizeY];
            }
        }
        bySpeed = slowestFirst(vx, vy);
        refinement = new PaperRefinement(p);
    }

    /** Velocity of the i-th projection along an axis. */
    static int velocity(int i, SofasParameters p) {
        return Projection.fixed(p.velocityAt(SofasParameters.angleAt(i, p.flowProjections(), p.rangeDeg())));
    }

    /** Side of a torus that no two live events of different cells share a cell of. */
    static int side(int sensorSide, int velocity, SofasParameters p) {
        return side(sensorSide + 2 + Math.abs(Projection.travelled(velocity, p.lifespanUs())));
    }

    /** Side of a torus that is to hold at least so many cells: a power of two, and at most {@value #LONGEST_SIDE}. */
    static int side(double least) {
        int side = 2;
        while (side < least && side < LONGEST_SIDE) {
            side *= 2;
        }
        return side;
    }

    private static int[] slowestFirst(int[] vx, int[] vy) {
        Integer[] order = new Integer[vx.length];
        for (int k = 0; k < order.length; k++) {
            order[k] = k;
        }
        Arrays.sort(order, (a, b) -> Long.compare((long) vx[a] * vx[a] + (long) vy[a] * vy[a],
            (long) vx[b] * vx[b] + (long) vy[b] * vy[b]));
        int[] slowestFirst = new int[order.length];
        for (int k = 0; k < order.length; k++) {
            slowestFirst[k] = order[k];
        }
        return slowestFirst;
    }

    /**
     * Adds an event to all projections.
     *
     * @return whether a structure was found, whose projection has stayed the greatest for p events; it is to be read
     *     from {@link #structure} and then taken out by {@link #release}
     */
    boolean add(int eventX, int eventY, long timeUs, int polarity) {
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
        head++;
        int greatest = greatest();
        if (greatest == best) {
            constantFor++;
        } else {
            best = greatest;
            constantFor = 1;
        }
        if (constantFor < p.constantEvents()) {
            return false;
        }
        constantFor = 0;
        refinement.load(time, x, y, sign, tail, head);
        refinement.refine(best % n, best / n);
        return refinement.size() >= p.minEvents();
    }

    /** Looks on with other parameters that leave the projections and the lifespan as they are. */
    void setParameters(SofasParameters next) {
        p = next;
        refinement = new PaperRefinement(p);
    }

    /** The structure found last, with its events. */
    PaperRefinement structure() {
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

    /** Adds a vote w to the event's cell of every projection: the metric rises by 2 w f + w^2. */
    private void vote(int i, int w) {
        long dt = time[i] - referenceUs;
        int ex = x[i];
        int ey = y[i];
        for (int k = 0; k < metric.length; k++) {
            int cx = ex - Projection.travelled(vx[k], dt) & maskX[k];
            int cy = ey - Projection.travelled(vy[k], dt) & maskY[k];
            short[] f = accumulator[k];
            int c = cy << shift[k] | cx;
            int before = f[c];
            metric[k] += 2 * w * before + 1;
            f[c] = (short) (before + w);
        }
    }

    private int greatest() {
        int found = bySpeed[0];
        long most = metric[found];
        for (int a = 1; a < bySpeed.length; a++) {
            int k = bySpeed[a];
            if (metric[k] > most) {
                most = metric[k];
                found = k;
            }
        }
        return found;
    }

    /** Takes the structure's events out, and projects the rest into the emptied plane. */
    void release() {
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
        best = -1;
    }

    /** How many events wait for a structure. */
    int size() {
        return head - tail;
    }

    /** Metric of a projection, for tests and pictures. */
    long metric(int i, int j) {
        return metric[j * n + i];
    }

    MetricArray metricArray() {
        float[] perEvent = new float[n * n];
        for (int k = 0; k < perEvent.length && size() > 0; k++) {
            perEvent[k] = (float) metric[k] / size();
        }
        return new MetricArray(SofasParameters.Preset.PAPER, n, perEvent);
    }

    void reset() {
        for (int i = tail; i < head; i++) {
            vote(i, -sign[i]);
        }
        head = 0;
        tail = 0;
        best = -1;
        constantFor = 0;
    }
}
