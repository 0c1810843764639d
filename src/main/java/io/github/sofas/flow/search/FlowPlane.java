package io.github.sofas.flow.search;

import io.github.sofas.event.SensorSize;
import io.github.sofas.flow.SofasParameters;
import java.util.Arrays;

/**
 * The flow plane (paper, section Flow Plane): projections of the events that no track plane takes, each with an
 * accumulator of signed votes and its metric, kept incrementally.
 *
 * <p>Ours: the n x n projections are n speeds, evenly spaced in logarithm, by n directions; each holds the events of
 * the time in which its own velocity travels a number of pixels, so that slow and fast structures are looked for at
 * once and on equal terms; and cells are 2 x 2 px, which makes neighbouring velocities overlap and lets an accumulator
 * stay in the first-level cache. Events are added in blocks ({@link VoteBlock}), projection by projection, for the same
 * reason.
 *
 * <p>Longer than other classes, because its events and its rings go in step: each ring holds a stretch of the events.
 */
public final class FlowPlane {
    /** Most events, and longest time, between two settlings: how late a structure may be found. */
    private static final int SETTLING = 256;
    private static final long SETTLING_US = 2_000;
    private static final int BLOCK = VoteBlock.CAPACITY;
    /**
     * Travel after which an event leaves a projection: one lifespan for all speeds is too long for fast and too short
     * for slow objects.
     */
    static final double TRAVEL_PX = 6;
    /** Events that its arrays have room for at most. */
    static final int MOST_HELD = 1 << 20;
    /** Part of a ring's window after which it takes its events in, where they are no block yet. */
    private static final int WINDOW_PARTS = 16;
    /** A ring's time is in ticks in which it travels at most this part of a pixel, where a µs is not longer. */
    private static final double TICK_PX = 1.0 / 256;

    /**
     * Most events that a ring holds, less what it takes in at a time; where more come, the oldest go early. Enough for
     * 700,000 events per second that no track plane takes; memory is to be bounded.
     */
    private static final int MOST_EVENTS = MOST_HELD - 2 * BLOCK;
    private static final int EVENT_BYTES = Long.BYTES + 2 * Short.BYTES + Byte.BYTES + 2 * Integer.BYTES;

    private final int n;
    private final double[] speed;
    private final long[] windowUs;
    /** Ticks of a ring: 2^this µs. */
    private final int[] tickBits;
    // units a tick
    private final int[] vx;
    private final int[] vy;
    // accumulators are tori larger than the sensor and the travel, so that live events never meet across the seam
    private final int columnBits;
    private final int rowBits;
    private final short[][] f;
    private final long[] metric;
    /** Events held by the projections of a speed. */
    private final int[] count;
    /** Number of the oldest event held by the projections of a speed. */
    private final int[] oldest;
    /** Number after the newest event held by the projections of a speed, and when it was taken in. */
    private final int[] end;
    private final long[] settledUs;

    // events by number, modulo the capacity
    private long[] timeUs = new long[1 << 14];
    private short[] x = new short[1 << 14];
    private short[] y = new short[1 << 14];
    private byte[] sign = new byte[1 << 14];
    /** Rings that the event was taken out of, a bit each. */
    private int[] takenOut = new int[1 << 14];
    /** Rings in which the event was looked at in vain, a bit each. */
    private int[] refused = new int[1 << 14];
    private int mask = timeUs.length - 1;
    private int head;
    /** Number of the oldest event held by any projection. */
    private int first;
    /** Number after the newest event that the last settling saw. */
    private int settled;
    private long epochUs;
    /** Time of the oldest event since. */
    private long waitingUs;
    private long total;
    private boolean started;

    private final VoteBlock block;

    /** Makes an empty plane for a sensor of so many px. */
    public FlowPlane(int sensorWidth, int sensorHeight, SofasParameters.Search p) {
        n = p.flowProjections();
        columnBits = bits(sensorWidth);
        rowBits = bits(sensorHeight);
        block = new VoteBlock(columnBits, rowBits);
        speed = new double[n];
        windowUs = new long[n];
        tickBits = new int[n];
        vx = new int[n * n];
        vy = new int[n * n];
        f = new short[n * n][1 << columnBits + rowBits];
        metric = new long[n * n];
        count = new int[n];
        oldest = new int[n];
        end = new int[n];
        settledUs = new long[n];
        double range = p.fastestPxPerS() / p.slowestPxPerS();
        for (int i = 0; i < n; i++) {
            speed[i] = p.slowestPxPerS() * StrictMath.pow(range, i / (n - 1.0));
            windowUs[i] = (long) Math.min(p.lifespanUs(), TRAVEL_PX / speed[i] * 1e6);
            tickBits[i] = Math.max(0, Math.getExponent(TICK_PX / speed[i] * 1e6));
            double pxPerTick = speed[i] * 1e-6 * (1L << tickBits[i]);
            for (int j = 0; j < n; j++) {
                // every other ring is turned by half a step, to fill the gaps
                double angle = 2 * Math.PI * (j + 0.5 * (i & 1)) / n;
                vx[i * n + j] = (int) Math.rint(pxPerTick * StrictMath.cos(angle) * VoteBlock.unitsPerPx(columnBits));
                vy[i * n + j] = (int) Math.rint(pxPerTick * StrictMath.sin(angle) * VoteBlock.unitsPerPx(rowBits));
            }
        }
    }

    /** The most bytes that its arrays take. */
    static long mostBytes(SensorSize sensor, SofasParameters.Search p) {
        return cells(sensor) * p.flowProjections() * p.flowProjections() * Short.BYTES
            + (long) EVENT_BYTES * MOST_HELD;
    }

    /** Cells of an accumulator. */
    static long cells(SensorSize sensor) {
        return 1L << bits(sensor.width()) + bits(sensor.height());
    }

    /** Cells along an axis, as a power of two. */
    private static int bits(int sensorSide) {
        int least = sensorSide / 2 + (int) TRAVEL_PX / 2 + 3;
        return Integer.SIZE - Integer.numberOfLeadingZeros(least - 1);
    }

    /** Adds an event, which waits to be projected. */
    public void add(int eventX, int eventY, long eventUs, int polarity) {
        if (!started) {
            started = true;
            epochUs = eventUs;
            Arrays.fill(settledUs, eventUs);
        }
        if (head == settled) {
            waitingUs = eventUs;
        }
        if (head - first > mask) {
            grow();
        }
        int i = head++ & mask;
        timeUs[i] = eventUs;
        x[i] = (short) eventX;
        y[i] = (short) eventY;
        sign[i] = (byte) polarity;
        takenOut[i] = 0;
        refused[i] = 0;
    }

    private void grow() {
        int capacity = 2 * timeUs.length;
        long[] newUs = new long[capacity];
        short[] newX = new short[capacity];
        short[] newY = new short[capacity];
        byte[] newSign = new byte[capacity];
        int[] newTakenOut = new int[capacity];
        int[] newRefused = new int[capacity];
        for (int i = first; i != head; i++) {
            int from = i & mask;
            int to = i & capacity - 1;
            newUs[to] = timeUs[from];
            newX[to] = x[from];
            newY[to] = y[from];
            newSign[to] = sign[from];
            newTakenOut[to] = takenOut[from];
            newRefused[to] = refused[from];
        }
        timeUs = newUs;
        x = newX;
        y = newY;
        sign = newSign;
        takenOut = newTakenOut;
        refused = newRefused;
        mask = capacity - 1;
    }

    /** Whether events wait to be projected, enough of them or long enough. */
    public boolean isToSettle(long nowUs) {
        return head - settled == SETTLING || head != settled && nowUs - waitingUs > SETTLING_US;
    }

    /**
     * Lets each ring take in the events that came, and those go that it has held long enough; a slow ring not at each
     * block, because few events at a time are dear: each accumulator has to come into the cache first.
     */
    public void settle(long nowUs) {
        total += head - settled;
        settled = head;
        for (int i = 0; i < n; i++) {
            if (head - end[i] >= BLOCK || (nowUs - settledUs[i]) * WINDOW_PARTS >= windowUs[i]) {
                settledUs[i] = nowUs;
                while (end[i] != head) {
                    int to = end[i] + Math.min(BLOCK, head - end[i]);
                    gather(i, end[i], to);
                    vote(i, 1);
                    end[i] = to;
                }
                release(i, nowUs - windowUs[i]);
            }
        }
        first = oldest[0];
        for (int number : oldest) {
            first = number - first < 0 ? number : first;
        }
    }

    private void release(int ring, long limitUs) {
        int from = oldest[ring];
        while (from != end[ring] && isOver(from, limitUs)) {
            int to = from;
            while (to != end[ring] && to - from < BLOCK && isOver(to, limitUs)) {
                to++;
            }
            gather(ring, from, to);
            vote(ring, -1);
            from = to;
        }
        oldest[ring] = from;
    }

    private boolean isOver(int event, long limitUs) {
        return timeUs[event & mask] < limitUs || head - event > MOST_EVENTS;
    }

    private void gather(int ring, int from, int to) {
        for (int e = from; e != to; e++) {
            gather(ring, e);
        }
    }

    /** Adds an event to the block unless it was taken out of the ring. */
    private void gather(int ring, int event) {
        int i = event & mask;
        if ((takenOut[i] >> ring & 1) == 0) {
            block.add(x[i], y[i], timeUs[i] - epochUs, sign[i]);
        }
    }

    /** Adds the gathered events to the accumulators of a ring, or takes them out again with weight -1. */
    private void vote(int ring, int weight) {
        block.tick(tickBits[ring]);
        for (int k = ring * n; k < ring * n + n; k++) {
            metric[k] += block.vote(f[k], vx[k], vy[k], weight);
        }
        count[ring] += weight * block.size();
        block.clear();
    }

    /** Takes events out of the projections of a speed, by number, or keeps them out of it where it has not come yet. */
    void takeOut(int ring, int[] events, int size) {
        for (int a = 0; a < size; a++) {
            int e = events[a];
            if (!holds(e)) {
                continue;
            }
            if (e - oldest[ring] >= 0 && e - end[ring] < 0) {
                gather(ring, e);
            }
            takenOut[e & mask] |= 1 << ring;
            if (block.isFull()) {
                vote(ring, -1);
            }
        }
        vote(ring, -1);
    }

    /** Whether any ring holds the event, or is to take it in yet. */
    boolean holds(int event) {
        return event - first >= 0;
    }

    /** Whether the event was taken out of any ring. */
    boolean isTakenOut(int event) {
        return takenOut[event & mask] != 0;
    }

    /** Notes that an event was looked at in vain, in a ring. */
    void refuse(int ring, int event) {
        refused[event & mask] |= 1 << ring;
    }

    boolean wasRefused(int ring, int event) {
        return (refused[event & mask] >> ring & 1) != 0;
    }

    /** Cell of an event in a projection. */
    int cell(int k, int event) {
        int i = event & mask;
        int ticks = (int) (timeUs[i] - epochUs >> tickBits[k / n]);
        int px = x[i] * VoteBlock.unitsPerPx(columnBits) - vx[k] * ticks;
        int py = y[i] * VoteBlock.unitsPerPx(rowBits) - vy[k] * ticks;
        return py >>> Integer.SIZE - rowBits << columnBits | px >>> Integer.SIZE - columnBits;
    }

    /** Projections along each axis. */
    int n() {
        return n;
    }

    /** Cells of an accumulator: columns in the low {@link #columnBits} bits of an index, rows above. */
    int cells() {
        return f[0].length;
    }

    int columnBits() {
        return columnBits;
    }

    /** Accumulator of a projection, read only. */
    short[] accumulator(int k) {
        return f[k];
    }

    long metric(int k) {
        return metric[k];
    }

    /** Events held by the projections of a speed. */
    int count(int ring) {
        return count[ring];
    }

    double speed(int ring) {
        return speed[ring];
    }

    /** Velocity of a projection in px/s. */
    double vx(int k) {
        return vx[k] / (double) VoteBlock.unitsPerPx(columnBits) / (1L << tickBits[k / n]) * 1e6;
    }

    double vy(int k) {
        return vy[k] / (double) VoteBlock.unitsPerPx(rowBits) / (1L << tickBits[k / n]) * 1e6;
    }

    /** Number of the oldest event that the projections of a speed hold. */
    int oldest(int ring) {
        return oldest[ring];
    }

    /** Number after the newest event that the projections of a speed hold. */
    int end(int ring) {
        return end[ring];
    }

    /** Number after the newest event. */
    int head() {
        return head;
    }

    /** How many events ever came. */
    public long total() {
        return total;
    }

    int x(int event) {
        return x[event & mask];
    }

    int y(int event) {
        return y[event & mask];
    }

    long timeUs(int event) {
        return timeUs[event & mask];
    }

    /** +1 or -1. */
    int sign(int event) {
        return sign[event & mask];
    }

    /** Metric an event held of each projection, to be shown; 0 where it holds none. */
    public float[] metricsPerEvent() {
        float[] perEvent = new float[n * n];
        for (int k = 0; k < perEvent.length; k++) {
            perEvent[k] = count[k / n] == 0 ? 0 : (float) metric[k] / count[k / n];
        }
        return perEvent;
    }

    /** Forgets all events. */
    public void reset() {
        for (short[] cells : f) {
            Arrays.fill(cells, (short) 0);
        }
        Arrays.fill(metric, 0);
        Arrays.fill(count, 0);
        Arrays.fill(oldest, 0);
        Arrays.fill(end, 0);
        head = 0;
        first = 0;
        settled = 0;
        total = 0;
        started = false;
    }
}
