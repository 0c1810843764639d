package io.github.sofas.flow.fit;

import java.util.Arrays;

/**
 * A set of events that vote on a grid of cells, and the metric of their votes (paper, section Structure Detection). The
 * events vote anew under each motion that is tried.
 *
 * <p>Two differences from the paper's metric are ours, because they decide the accuracy. First, an event votes for the
 * four cells around its projection, weighted by nearness (bilinear); nearest cells leave a plateau of ties a tenth of
 * the velocity wide. Second, the metric leaves out what an event adds by meeting itself, the w² of 2 w f + w². That
 * part says nothing about the velocity, and rewards projections that put events on whole pixels, zero velocity above
 * all.
 */
final class BilinearAccumulator {
    /** Positions are in sixteenths of a cell. */
    static final int SUB = 16;
    static final int SUB_BITS = 4;
    /** Bits below the cell in the key of an event: a flag for no vote, a flag for OFF, and the place in the cell. */
    static final int KEY_BITS = 2 * SUB_BITS + 2;
    static final int KEYS = 1 << KEY_BITS;
    static final int NONE = 1 << 2 * SUB_BITS + 1;
    static final int OFF = 1 << 2 * SUB_BITS;
    // votes for the four cells around a place, by key; 0 for keys without a vote
    static final int[] VOTE_00 = new int[KEYS];
    static final int[] VOTE_10 = new int[KEYS];
    static final int[] VOTE_01 = new int[KEYS];
    static final int[] VOTE_11 = new int[KEYS];

    static {
        for (int k = 0; k < NONE; k++) {
            int fx = k % SUB;
            int fy = k / SUB % SUB;
            int one = (k & OFF) == 0 ? 1 : -1;
            VOTE_00[k] = one * (SUB - fx) * (SUB - fy);
            VOTE_10[k] = one * fx * (SUB - fy);
            VOTE_01[k] = one * (SUB - fx) * fy;
            VOTE_11[k] = one * fx * fy;
        }
    }

    /** Most cells beside the events, for their shifts: twice the greatest distance of projections and a step. */
    private static final int MOST_BORDER = 20;
    /** Shifts are computed in parts of a position, of 2^-{@value} each. */
    private static final int PART_BITS = 21;
    private static final int HALF = 1 << PART_BITS - 1;
    /** Most parts in a shift of 1: 64 cells for the event that is shifted most, which is far off the grid. */
    private static final double MOST_PARTS = (1 << 31 - ShiftProfile.BITS) - 1;
    /** Most cells per event for which {@link DenseVotes} is used: scanning more cells costs what the voting saves. */
    private static final int DENSE_CELLS = 4;
    /** Most places that a structure tensor is summed over, in whole rows: about as many as a sample has events. */
    private static final int MOST_PLACES = 4096;

    /** Positions per pixel. */
    private final float scale;
    private final int mostOnBoth;
    // events: position, and vote
    private final int[] placeX;
    private final int[] placeY;
    /** 0 of an ON event, {@link #OFF} of an OFF event. */
    private final int[] sign;
    private int size;
    private long votes;
    // shifted positions; then the first array holds keys instead: cell, sign and place in the cell
    private final int[] at;
    private final int[] atY;

    private final int width;
    private final int height;
    private final int[] f;
    private final DenseVotes dense = new DenseVotes();
    private final TimedVotes timed;
    private final InSight inSight;
    /** Votes of every other event, where the events make two pictures. */
    private final int[] others;
    // box of the events
    private int lowX;
    private int lowY;
    private int highX;
    private int highY;
    // the part of the grid that is used: where it lies, and its size
    private int originX;
    private int originY;
    private int columns;
    private int rows;

    /**
     * Makes a grid.
     *
     * @param mostOnBoth most events that vote on two grids half a cell apart. On one grid alone, an edge thinner than a
     *     cell has up to twice the metric in the middle of a cell that it has between two cells, and its true velocity
     *     may look worst. The places of many events average out.
     */
    BilinearAccumulator(int sensorWidth, int sensorHeight, double cellPx, int capacity, int mostOnBoth) {
        this.mostOnBoth = mostOnBoth;
        scale = (float) (SUB / cellPx);
        placeX = new int[capacity];
        placeY = new int[capacity];
        at = new int[capacity];
        atY = new int[capacity];
        sign = new int[capacity];
        width = side(sensorWidth, cellPx);
        height = side(sensorHeight, cellPx);
        f = new int[width * height];
        others = new int[width * height];
        timed = new TimedVotes(width * height);
        inSight = new InSight(sensorWidth, sensorHeight, width, height);
    }

    private static int side(int sensorSide, double cellPx) {
        return (int) (sensorSide / cellPx) + 3 + 2 * MOST_BORDER;
    }

    /** Bytes of the grids. */
    static long bytes(int sensorWidth, int sensorHeight, double cellPx) {
        long cells = (long) side(sensorWidth, cellPx) * side(sensorHeight, cellPx);
        return 2L * Integer.BYTES * cells + DenseVotes.BYTES + TimedVotes.bytes(cells) + InSight.bytes(cells);
    }

    /** The most events that fit. */
    int capacity() {
        return placeX.length;
    }

    int size() {
        return size;
    }

    /** Votes given since the start, a measure of work. */
    long votes() {
        return votes;
    }

    /** Forgets all events. */
    void clear() {
        size = 0;
        inSight.clear();
    }

    /** How long each cell is in sight: all of the window, unless a border cuts events off. */
    InSight inSight() {
        return inSight;
    }

    /** Adds an event at a place in px. */
    void add(float x, float y, int polarity) {
        int i = size++;
        placeX[i] = (int) (x * scale + 32768.5f) - 32768;
        placeY[i] = (int) (y * scale + 32768.5f) - 32768;
        sign[i] = polarity > 0 ? 0 : OFF;
    }

    /** Column of an event in px, rounded to a part of a cell. */
    double x(int i) {
        return placeX[i] / scale;
    }

    /** The same for the row. */
    double y(int i) {
        return placeY[i] / scale;
    }

    /** Finds the box of the events, around which the grid is laid. */
    void lay() {
        lowX = Integer.MAX_VALUE;
        lowY = Integer.MAX_VALUE;
        highX = Integer.MIN_VALUE;
        highY = Integer.MIN_VALUE;
        for (int i = 0; i < size; i++) {
            lowX = Math.min(lowX, placeX[i]);
            highX = Math.max(highX, placeX[i]);
            lowY = Math.min(lowY, placeY[i]);
            highY = Math.max(highY, placeY[i]);
        }
    }

    /**
     * Lays the grid around the events, with as much room as their shifts need: a small grid is quick to empty, and
     * stays in the first-level cache.
     */
    private void layWith(int borderX, int borderY) {
        originX = (lowX & -SUB) - borderX * SUB;
        originY = (lowY & -SUB) - borderY * SUB;
        columns = Math.min(width, (highX - lowX) / SUB + 3 + 2 * borderX);
        rows = Math.min(height, (highY - lowY) / SUB + 3 + 2 * borderY);
    }

    /** Number of cells that hold a shift by some parts of a profile, and half a cell. */
    private static int border(ShiftProfile along, int parts) {
        long positions = Math.abs((long) parts) * along.most() + HALF >> PART_BITS;
        return (int) Math.min(MOST_BORDER, positions / SUB + 2);
    }

    /**
     * Metric of the events moved back by sx times one profile and sy times another, in px: 2 w f summed over all votes.
     * For few events, it is the mean over two grids.
     */
    double metric(ShiftProfile alongX, double sx, ShiftProfile alongY, double sy) {
        return metric(alongX, sx, alongY, sy, 0, 0);
    }

    /**
     * The same where the shift is that of a velocity of (vx, vy) px/s beside the events' own, which determines how long
     * cells are in sight.
     */
    double metric(ShiftProfile alongX, double sx, ShiftProfile alongY, double sy, double vx, double vy) {
        int partsX = parts(alongX, sx);
        int partsY = parts(alongY, sy);
        layWith(border(alongX, partsX), border(alongY, partsY));
        locate(alongX.shift, partsX, alongY.shift, partsY, 0);
        double one = metric(0, vx, vy);
        if (size > mostOnBoth) {
            return one;
        }
        locate(alongX.shift, partsX, alongY.shift, partsY, SUB / 2);
        return (one + metric(SUB / 2, vx, vy)) / 2;
    }

    private int parts(ShiftProfile along, double s) {
        double parts = s * along.unit() * scale * (1 << PART_BITS);
        return (int) Math.rint(Math.max(-MOST_PARTS, Math.min(MOST_PARTS, parts)));
    }

    /** The metric of located events on a grid shifted by some parts of a cell. */
    private double metric(int offset, double vx, double vy) {
        long met;
        if (inSight.isCutOff()) {
            inSight.weigh(columns, rows, (originX - offset) / scale, (originY - offset) / scale, SUB / scale, vx, vy);
            Arrays.fill(f, 0, columns * rows, 0);
            met = inSight.vote(at, size, f, columns);
        } else {
            boolean isDense = columns * rows <= Math.min(DenseVotes.MOST_CELLS, DENSE_CELLS * size);
            met = isDense ? dense.vote(at, size, columns, rows) : vote();
        }
        return met * (2.0 / (SUB * SUB * SUB * SUB));
    }

    /**
     * Slopes of the metric of the events where they are; for few events the mean over two grids.
     *
     * @param time of each event from the reference in s
     * @param centreX column of the centre of rotation and growth in px, and centreY its row
     */
    void slopes(ShiftProfile time, double centreX, double centreY, MetricSlopes to) {
        layWith(2, 2);
        to.clear();
        addSlopes(time, centreX, centreY, 0, to);
        if (size <= mostOnBoth) {
            addSlopes(time, centreX, centreY, SUB / 2, to);
            to.multiply(0.5);
        }
    }

    /** The same for a grid shifted by some parts of a cell. */
    private void addSlopes(ShiftProfile time, double centreX, double centreY, int offset, MetricSlopes to) {
        locate(time.shift, 0, time.shift, 0, offset);
        timed.addSlopes(at, size, time, columns, rows, (originX - offset) / scale - centreX,
            (originY - offset) / scale - centreY, SUB / scale, to);
    }

    /** Finds the cells of the shifted events. */
    private void locate(int[] alongX, int partsX, int[] alongY, int partsY, int offset) {
        shift(placeX, alongX, partsX, offset - originX, at);
        shift(placeY, alongY, partsY, offset - originY, atY);
        votes += size;
        locate();
    }

    /** Shifts the events along one axis; separate from voting, because the compiler then vectorises it. */
    private void shift(int[] place, int[] along, int parts, int offset, int[] at) {
        int n = size;
        for (int i = 0; i < n; i++) {
            at[i] = place[i] + offset - (parts * along[i] + HALF >> PART_BITS);
        }
    }

    /** Finds the cells of the shifted positions; separate for the same reason. */
    private void locate() {
        int[] x = at;
        int[] y = atY;
        int[] signs = sign;
        int w = columns;
        int lastX = (columns - 1) * SUB - 1;
        int lastY = (rows - 1) * SUB - 1;
        int n = size;
        for (int i = 0; i < n; i++) {
            int px = x[i];
            int py = y[i];
            int key = (py >> SUB_BITS) * w + (px >> SUB_BITS) << KEY_BITS | signs[i]
                | (py & SUB - 1) << SUB_BITS | px & SUB - 1;
            // an event off the grid meets no other: all bits are set where any of the four is negative
            int off = (px | py | lastX - px | lastY - py) >> 31;
            x[i] = key & ~off | NONE & off;
        }
    }

    private long vote() {
        int[] keys = at;
        int[] grid = f;
        int w = columns;
        Arrays.fill(grid, 0, columns * rows, 0);
        long sum = 0;
        int n = size;
        for (int i = 0; i < n; i++) {
            int c = keys[i] >>> KEY_BITS;
            int k = keys[i] & KEYS - 1;
            int w00 = VOTE_00[k];
            int w10 = VOTE_10[k];
            int w01 = VOTE_01[k];
            int w11 = VOTE_11[k];
            int a = grid[c];
            int b = grid[c + 1];
            int d = grid[c + w];
            int e = grid[c + w + 1];
            // the votes of an event add up to 256, cells to 256 per event at most: the products fit an int
            sum += w00 * a + w10 * b + w01 * d + w11 * e;
            grid[c] = a + w00;
            grid[c + 1] = b + w10;
            grid[c + w] = d + w01;
            grid[c + w + 1] = e + w11;
        }
        return sum;
    }

    /**
     * Sums how the picture of the events changes with place, where they are. Every other event makes one picture, the
     * rest make another.
     *
     * @param centreX column of the centre of rotation and growth in px, and centreY its row
     * @param radius of the structure in px
     */
    void structure(StructureTensor tensor, double centreX, double centreY, double radius) {
        layWith(2, 2);
        int w = columns;
        Arrays.fill(f, 0, w * rows, 0);
        Arrays.fill(others, 0, w * rows, 0);
        for (int i = 0; i < size; i++) {
            draw((i & 1) == 0 ? f : others, placeX[i] - originX, placeY[i] - originY, sign[i] == 0 ? 1 : -1);
        }
        votes += size;
        double perCell = SUB / (scale * radius);
        double x0 = (originX / scale - centreX) / radius;
        double y0 = (originY / scale - centreY) / radius;
        int every = 1 + w * rows / MOST_PLACES;
        tensor.begin();
        for (int row = 1; row < rows - 1; row += every) {
            for (int column = 1; column < w - 1; column++) {
                int c = row * w + column;
                int gx = slope(f, c, 1, w);
                int gy = slope(f, c, w, 1);
                int hx = slope(others, c, 1, w);
                int hy = slope(others, c, w, 1);
                if ((gx | gy) != 0 && (hx | hy) != 0) {
                    tensor.add(gx, gy, hx, hy, x0 + column * perCell, y0 + row * perCell);
                }
            }
        }
        tensor.end();
    }

    private void draw(int[] grid, int px, int py, int sign) {
        if ((px | py) < 0 || px >= (columns - 1) * SUB || py >= (rows - 1) * SUB) {
            return;
        }
        int c = (py >> SUB_BITS) * columns + (px >> SUB_BITS);
        int fx = px & SUB - 1;
        int below = (py & SUB - 1) * sign;
        int above = SUB * sign - below;
        grid[c] += (SUB - fx) * above;
        grid[c + 1] += fx * above;
        grid[c + columns] += (SUB - fx) * below;
        grid[c + columns + 1] += fx * below;
    }

    /** Slope along one axis by the Sobel operator, a mean over three cells across the axis. */
    private static int slope(int[] grid, int c, int along, int across) {
        return 2 * (grid[c + along] - grid[c - along]) + grid[c + along + across] - grid[c - along + across]
            + grid[c + along - across] - grid[c - along - across];
    }
}
