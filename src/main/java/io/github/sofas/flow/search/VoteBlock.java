package io.github.sofas.flow.search;

/**
 * Events that vote together in projections of the flow plane, one projection after the other, so that an accumulator
 * stays in the first-level cache.
 *
 * <p>An accumulator is a torus whose width and height are 2^32 units of position each. An {@code int} wraps as the
 * torus does, and projecting a block is plain {@code int} arithmetic, which the compiler vectorises. ON events lie at
 * the front of the arrays and OFF events at the back, so that all events of one loop vote with the same weight. This
 * takes a quarter less time than looking up the weight of each event. The order of votes makes no difference to the
 * metric.
 */
final class VoteBlock {
    /** Most events of a block. */
    static final int CAPACITY = 1024;

    private final int columnBits;
    private final int rowBits;
    private final int[] x = new int[CAPACITY];
    private final int[] y = new int[CAPACITY];
    private final long[] timeUs = new long[CAPACITY];
    private final int[] ticks = new int[CAPACITY];
    private final int[] cells = new int[CAPACITY];
    /** Number of ON events, and place where the OFF events begin. */
    private int on;
    private int off = CAPACITY;

    /** Creates a block for accumulators of 2^columnBits by 2^rowBits cells, each of 2 x 2 px. */
    VoteBlock(int columnBits, int rowBits) {
        this.columnBits = columnBits;
        this.rowBits = rowBits;
    }

    /** Units of position per pixel, where the accumulator has 2^bits cells along an axis. */
    static int unitsPerPx(int bits) {
        return 1 << Integer.SIZE - 1 - bits;
    }

    void clear() {
        on = 0;
        off = CAPACITY;
    }

    int size() {
        return on + CAPACITY - off;
    }

    boolean isFull() {
        return on == off;
    }

    /** Adds an event, of sign +1 or -1; there must be room. */
    void add(int eventX, int eventY, long eventUs, int sign) {
        int i = sign > 0 ? on++ : --off;
        x[i] = eventX * unitsPerPx(columnBits);
        y[i] = eventY * unitsPerPx(rowBits);
        timeUs[i] = eventUs;
    }

    /** Converts the times of the events to ticks of 2^bits µs. */
    void tick(int bits) {
        tick(bits, 0, on);
        tick(bits, off, CAPACITY);
    }

    private void tick(int bits, int from, int to) {
        for (int i = from; i < to; i++) {
            ticks[i] = (int) (timeUs[i] >> bits);
        }
    }

    /**
     * Adds the events to the accumulator of a projection, or takes them out again with weight -1.
     *
     * @param vx velocity in units per tick
     * @param vy the same, downwards
     * @return the change of the metric, 2 w f + w² per event
     */
    int vote(short[] accumulator, int vx, int vy, int weight) {
        project(vx, vy, 0, on);
        project(vx, vy, off, CAPACITY);
        int change = 2 * weight * (add(accumulator, 0, on, weight) - add(accumulator, off, CAPACITY, -weight));
        // taking out an event that added w changes the metric by -2 w f + w²: the same expression with -w
        return size() + change;
    }

    private void project(int vx, int vy, int from, int to) {
        int[] px = x;
        int[] py = y;
        int[] t = ticks;
        int[] c = cells;
        int toColumn = Integer.SIZE - columnBits;
        int toRow = Integer.SIZE - rowBits;
        int bits = columnBits;
        for (int i = from; i < to; i++) {
            c[i] = (py[i] - vy * t[i] >>> toRow) << bits | px[i] - vx * t[i] >>> toColumn;
        }
    }

    /** Adds w to the cells, and returns the sum of their counts before. */
    private int add(short[] accumulator, int from, int to, int w) {
        int[] c = cells;
        int sum = 0;
        for (int i = from; i < to; i++) {
            int before = accumulator[c[i]];
            sum += before;
            accumulator[c[i]] = (short) (before + w);
        }
        return sum;
    }
}
