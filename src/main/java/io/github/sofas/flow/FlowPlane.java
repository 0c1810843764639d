package io.github.sofas.flow;

import java.util.Arrays;

/**
 * The flow plane (paper, section Flow Plane): projections of the events that no track plane takes, each with an
 * accumulator of signed votes and its metric, kept incrementally.
 *
 * <p>Ours: the n x n projections are n speeds, evenly spaced in logarithm, by n directions; each holds the events of
 * the time in which its own velocity travels a number of pixels, so that slow and fast structures are looked for at
 * once and on equal terms; and cells are 2 x 2 px, which makes neighbouring velocities overlap and lets an accumulator
 * stay in the first-level cache. Events are added in blocks, projection by projection, for the same reason.
 */
final class FlowPlane {
    /** Most events of a block, and its longest time: how late a structure may be found. */
    private static final int BLOCK = 256;
    private static final long BLOCK_US = 2_000;
    /** Positions are in 1/256 px, cells 512 of those. */
    private static final int POSITION_BITS = 8;
    private static final int CELL_BITS = POSITION_BITS + 1;
    private static final int SHIFT = Projection.BITS - POSITION_BITS;

    private final int n;
    private final double[] speed;
    private final long[] windowUs;
    private final int[] vx;
    private final int[] vy;
    // accumulators are tori larger than the sensor and the travel, so that live events never meet across the seam
    private final int maskX;
    private final int maskY;
    private final int rowBits;
    private final short[][] f;
    private final long[] metric;
    /** Events held by the projections of a speed. */
    private final int[] count;
    /** Number of the oldest event held by the projections of a speed. */
    private final int[] oldest;

    // events by number, modulo the capacity
    private long[] timeUs = new long[1 << 14];
    private short[] x = new short[1 << 14];
    private short[] y = new short[1 << 14];
    /** +1, -1, or 0 once taken out. */
    private byte[] sign = new byte[1 << 14];
    private int mask = timeUs.length - 1;
    private int head;
    private int settled;
    private long epochUs;
    private long blockStartUs;
    private long total;
    private boolean started;

    // a block, gathered
    private final int[] blockX = new int[BLOCK];
    private final int[] blockY = new int[BLOCK];
    private final long[] blockUs = new long[BLOCK];
    private final int[] blockSign = new int[BLOCK];

    FlowPlane(int sensorWidth, int sensorHeight, SofasParameters p) {
        n = p.flowProjections();
        int sizeX = powerOfTwo(sensorWidth / 2 + (int) p.flowTravelPx() / 2 + 3);
        int sizeY = powerOfTwo(sensorHeight / 2 + (int) p.flowTravelPx() / 2 + 3);
        maskX = sizeX - 1;
        maskY = sizeY - 1;
        rowBits = Integer.numberOfTrailingZeros(sizeX);
        speed = new double[n];
        windowUs = new long[n];
        vx = new int[n * n];
        vy = new int[n * n];
        f = new short[n * n][sizeX * sizeY];
        metric = new long[n * n];
        count = new int[n];
        oldest = new int[n];
        double range = p.fastestPxPerS() / p.slowestPxPerS();
        for (int i = 0; i < n; i++) {
            speed[i] = p.slowestPxPerS() * StrictMath.pow(range, i / (n - 1.0));
            windowUs[i] = (long) Math.min(p.lifespanUs(), p.flowTravelPx() / speed[i] * 1e6);
            for (int j = 0; j < n; j++) {
                // every other ring is turned by half a step, to fill the gaps
                double angle = 2 * Math.PI * (j + 0.5 * (i & 1)) / n;
                vx[i * n + j] = Projection.fixed(speed[i] * StrictMath.cos(angle));
                vy[i * n + j] = Projection.fixed(speed[i] * StrictMath.sin(angle));
            }
        }
    }

    private static int powerOfTwo(int least) {
        return Integer.highestOneBit(least - 1) << 1;
    }

    /** Adds an event to the block. */
    void add(int eventX, int eventY, long eventUs, int polarity) {
        if (!started) {
            started = true;
            epochUs = eventUs;
        }
        if (head == settled) {
            blockStartUs = eventUs;
        }
        if (head - oldest[0] > mask) {
            grow();
        }
        int i = head++ & mask;
        timeUs[i] = eventUs;
        x[i] = (short) eventX;
        y[i] = (short) eventY;
        sign[i] = (byte) polarity;
    }

    private void grow() {
        int capacity = 2 * timeUs.length;
        long[] newUs = new long[capacity];
        short[] newX = new short[capacity];
        short[] newY = new short[capacity];
        byte[] newSign = new byte[capacity];
        for (int i = oldest[0]; i != head; i++) {
            int from = i & mask;
            int to = i & capacity - 1;
            newUs[to] = timeUs[from];
            newX[to] = x[from];
            newY[to] = y[from];
            newSign[to] = sign[from];
        }
        timeUs = newUs;
        x = newX;
        y = newY;
        sign = newSign;
        mask = capacity - 1;
    }

    /** Whether the block is to be settled. */
    boolean isBlockFull(long nowUs) {
        return head - settled == BLOCK || head != settled && nowUs - blockStartUs > BLOCK_US;
    }

    /** Projects the events of the block, and lets those go that each projection has held long enough. */
    void settle(long nowUs) {
        int size = gather(settled, head);
        for (int k = 0; k < n * n; k++) {
            metric[k] += vote(k, size, 1);
        }
        for (int i = 0; i < n; i++) {
            count[i] += size;
        }
        total += head - settled;
        settled = head;
        for (int i = 0; i < n; i++) {
            release(i, nowUs - windowUs[i]);
        }
    }

    private void release(int ring, long limitUs) {
        int from = oldest[ring];
        while (from != settled && timeUs[from & mask] < limitUs) {
            int end = from;
            while (end != settled && end - from < BLOCK && timeUs[end & mask] < limitUs) {
                end++;
            }
            int size = gather(from, end);
            for (int k = ring * n; k < ring * n + n; k++) {
                metric[k] += vote(k, size, -1);
            }
            count[ring] -= size;
            from = end;
        }
        oldest[ring] = from;
    }

    private int gather(int from, int end) {
        int size = 0;
        for (int e = from; e != end; e++) {
            int i = e & mask;
            if (sign[i] != 0) {
                blockX[size] = x[i] << POSITION_BITS;
                blockY[size] = y[i] << POSITION_BITS;
                blockUs[size] = timeUs[i] - epochUs;
                blockSign[size] = sign[i];
                size++;
            }
        }
        return size;
    }

    /**
     * Adds the gathered events to an accumulator, or takes them out again with weight -1.
     *
     * @return change of its metric: 2 w f + w² an event
     */
    private long vote(int k, int size, int weight) {
        short[] cells = f[k];
        long vxk = vx[k];
        long vyk = vy[k];
        int mx = maskX;
        int my = maskY;
        int bits = rowBits;
        long change = size;
        for (int i = 0; i < size; i++) {
            long dt = blockUs[i];
            int cx = (int) ((blockX[i] - (vxk * dt >> SHIFT)) >> CELL_BITS) & mx;
            int cy = (int) ((blockY[i] - (vyk * dt >> SHIFT)) >> CELL_BITS) & my;
            int c = cy << bits | cx;
            int w = blockSign[i] * weight;
            int before = cells[c];
            change += 2 * w * before;
            cells[c] = (short) (before + w);
        }
        // an event taken out changes the metric by -2 w f + w² of what it added: the same expression with -w
        return change;
    }

    /** Takes events out of all projections, by number. */
    void takeOut(int[] events, int size) {
        for (int a = 0; a < size; a++) {
            if (gather(events[a], events[a] + 1) == 0) {
                continue;
            }
            for (int i = 0; i < n; i++) {
                if (events[a] - oldest[i] >= 0) {
                    for (int k = i * n; k < i * n + n; k++) {
                        metric[k] += vote(k, 1, -1);
                    }
                    count[i]--;
                }
            }
            sign[events[a] & mask] = 0;
        }
    }

    /** Cell of an event in a projection. */
    int cell(int k, int event) {
        int i = event & mask;
        long dt = timeUs[i] - epochUs;
        int cx = (int) (((x[i] << POSITION_BITS) - (vx[k] * dt >> SHIFT)) >> CELL_BITS) & maskX;
        int cy = (int) (((y[i] << POSITION_BITS) - (vy[k] * dt >> SHIFT)) >> CELL_BITS) & maskY;
        return cy << rowBits | cx;
    }

    /** Projections along each axis. */
    int n() {
        return n;
    }

    /** Cells of an accumulator: columns in the low {@link #rowBits} bits of an index, rows above. */
    int cells() {
        return f[0].length;
    }

    int rowBits() {
        return rowBits;
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
        return vx[k] * 1e6 / (1L << Projection.BITS);
    }

    double vy(int k) {
        return vy[k] * 1e6 / (1L << Projection.BITS);
    }

    /** Number of the oldest event that the projections of a speed hold. */
    int oldest(int ring) {
        return oldest[ring];
    }

    /** Number after the newest event that is projected. */
    int end() {
        return settled;
    }

    /** How many events were ever projected. */
    long total() {
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

    /** +1 or -1; 0 once taken out. */
    int sign(int event) {
        return sign[event & mask];
    }

    void reset() {
        for (short[] cells : f) {
            Arrays.fill(cells, (short) 0);
        }
        Arrays.fill(metric, 0);
        Arrays.fill(count, 0);
        Arrays.fill(oldest, 0);
        head = 0;
        settled = 0;
        total = 0;
        started = false;
    }
}
