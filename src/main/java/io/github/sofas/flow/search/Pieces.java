package io.github.sofas.flow.search;

import java.util.Arrays;
import java.util.BitSet;

/**
 * The pieces of a projection, each of which may be a structure. A piece consists of the cells that stand out and the
 * occupied cells connected to them (paper, section Flow Plane), with the events that fall on these cells.
 */
final class Pieces {
    private static final int LEAST_STRONG = 3;
    private static final int LEAST_OCCUPIED = 2;

    /**
     * Side of the parts into which a piece of texture is cut, in cells: 48 px. The second value is the share of its box
     * that texture fills at least, more than an outline does. Seen by a camera that turns or moves forward, texture has
     * one velocity only within parts; parts of one motion merge at once.
     */
    private static final int PART_CELLS = 24;
    private static final double LEAST_FILL = 0.2;
    /** Most parts along an axis: those of the largest accumulator. */
    private static final int PARTS = 128;
    private final FlowPlane plane;
    private final int n;
    private final int columnBits;
    /** Range of the cells that are looked through. */
    private final HeldCells held;
    private final int[] label;
    private final int[] fill;
    private int filled;
    /** Piece number of each part that was met, 0 for the others. */
    private final int[] partOf = new int[PARTS * PARTS];
    // numbers of the events on pieces: sorted by piece, and in order of time with the piece of each
    private int[] events = new int[4096];
    private int[] came = new int[4096];
    private int[] pieceOf = new int[4096];
    private int[] starts = new int[256];
    /** Pieces that are parts of texture. */
    private final BitSet texture = new BitSet();

    /** Most bytes of the arrays: two marks per cell, and three numbers per event. */
    static long mostBytes(long cells) {
        // and up to two counts per cell; arrays of events may have grown to twice the number held
        return Integer.BYTES * (4 * cells + 3 * 2L * FlowPlaneEvents.MOST_HELD);
    }

    Pieces(FlowPlane plane) {
        this.plane = plane;
        n = plane.projections().n();
        columnBits = plane.projections().columnBits();
        held = new HeldCells(1 << columnBits, plane.projections().cells() >> columnBits);
        label = new int[plane.projections().cells()];
        fill = new int[plane.projections().cells()];
    }

    /**
     * Finds the pieces of a projection.
     *
     * @param thresholdSd standard deviations above the mean of the occupied cells that a cell must reach to stand out
     * @return the number of pieces
     */
    int find(int k, double thresholdSd) {
        plane.catchUp(k / n);
        plane.findHeld(k, held);
        int pieces = connect(plane.accumulator(k), plane.metric(k), thresholdSd);
        sort(k, pieces);
        for (int i = 0; i < filled; i++) {
            label[fill[i]] = 0;
        }
        return pieces;
    }

    /** Whether a piece is a part into which texture was cut. */
    boolean isTexture(int piece) {
        return texture.get(piece);
    }

    /** Numbers of the events of all pieces, piece by piece, each piece's in order of time. */
    int[] events() {
        return events;
    }

    /** Place where the events of a piece begin, and those of the piece before end. */
    int start(int piece) {
        return starts[piece];
    }

    /** Numbers the pieces from 1 on, and returns how many there are. */
    private int connect(short[] f, long squares, double thresholdSd) {
        // counts are whole numbers: they reach the threshold where they reach the next whole number
        int threshold = (int) Math.ceil(threshold(f, squares, thresholdSd));
        int pieces = 0;
        filled = 0;
        texture.clear();
        for (int row = 0; row < f.length >> columnBits; row++) {
            if (held.hasRow(row)) {
                int c = row << columnBits;
                pieces = connect(f, c, c + held.untilColumn(), threshold, pieces);
                pieces = connect(f, c + held.fromColumn(), c + held.endColumn(), threshold, pieces);
            }
        }
        return pieces;
    }

    /** Numbers the pieces that begin in a range of cells, after those already known; returns the last number. */
    private int connect(short[] f, int from, int to, int threshold, int known) {
        int pieces = known;
        for (int c = from; c < to; c++) {
            if (Math.abs(f[c]) < threshold || label[c] != 0) {
                continue;
            }
            pieces++;
            int first = filled;
            flood(f, c, pieces);
            if (isFilled(c, first)) {
                int last = cut(first, pieces);
                texture.set(pieces, last + 1);
                pieces = last;
            }
        }
        return pieces;
    }

    /** Gives a cell, and all occupied cells connected to it, the number of a piece as label. */
    private void flood(short[] f, int c, int piece) {
        int columns = (1 << columnBits) - 1;
        int rows = f.length / (columns + 1) - 1;
        int next = filled;
        fill[filled++] = c;
        label[c] = piece;
        while (next < filled) {
            int d = fill[next++];
            int x = d & columns;
            int y = d >> columnBits;
            for (int dy = -1; dy <= 1; dy++) {
                for (int dx = -1; dx <= 1; dx++) {
                    int e = (y + dy & rows) << columnBits | x + dx & columns;
                    if (label[e] == 0 && Math.abs(f[e]) >= LEAST_OCCUPIED) {
                        label[e] = piece;
                        fill[filled++] = e;
                    }
                }
            }
        }
    }

    /**
     * Whether the cells of a piece, from a place on, fill a box that is longer than a part along both axes: texture,
     * not an outline.
     */
    private boolean isFilled(int c, int first) {
        int columns = 1 << columnBits;
        int rows = label.length / columns;
        int left = 0;
        int right = 0;
        int up = 0;
        int down = 0;
        for (int i = first; i < filled; i++) {
            // relative to the seed, because the accumulator is a torus
            int dx = Math.floorMod((fill[i] & columns - 1) - (c & columns - 1) + columns / 2, columns) - columns / 2;
            int dy = (fill[i] >> columnBits) - (c >> columnBits);
            dy = Math.floorMod(dy + rows / 2, rows) - rows / 2;
            left = Math.min(left, dx);
            right = Math.max(right, dx);
            up = Math.min(up, dy);
            down = Math.max(down, dy);
        }
        int width = right - left + 1;
        int height = down - up + 1;
        return Math.min(width, height) > PART_CELLS && filled - first > LEAST_FILL * width * height;
    }

    /** Cuts a piece into parts; returns the number of the last one. */
    private int cut(int first, int piece) {
        int columns = 1 << columnBits;
        Arrays.fill(partOf, 0);
        int last = piece - 1;
        for (int i = first; i < filled; i++) {
            int part = (fill[i] >> columnBits) / PART_CELLS * PARTS + (fill[i] & columns - 1) / PART_CELLS;
            if (partOf[part] == 0) {
                partOf[part] = ++last;
            }
            label[fill[i]] = partOf[part];
        }
        return last;
    }

    /** Mean + w sd of the occupied cells; the squares of these add up to the metric. */
    private double threshold(short[] f, long squares, double thresholdSd) {
        long sum = 0;
        int occupied = 0;
        for (int row = 0; row < f.length >> columnBits; row++) {
            if (held.hasRow(row)) {
                int c = row << columnBits;
                long both = look(f, c, c + held.untilColumn()) + look(f, c + held.fromColumn(), c + held.endColumn());
                sum += both >>> Integer.SIZE;
                occupied += (int) both;
            }
        }
        if (occupied == 0) {
            return Double.POSITIVE_INFINITY;
        }
        double mean = (double) sum / occupied;
        double sd = Math.sqrt(Math.max(0, (double) squares / occupied - mean * mean));
        return Math.max(LEAST_STRONG, mean + thresholdSd * sd);
    }

    /** Sum of the absolute counts of some cells in the high half, and the number of occupied ones in the low half. */
    private static long look(short[] f, int from, int to) {
        int sum = 0;
        int occupied = 0;
        for (int c = from; c < to; c++) {
            int v = Math.abs(f[c]);
            sum += v;
            occupied += oneUnlessZero(v);
        }
        return ((long) sum << Integer.SIZE) + occupied;
    }

    /** 1 for a count other than 0, without a branch: half of the cells are occupied, irregularly scattered. */
    private static int oneUnlessZero(int count) {
        return -count >>> Integer.SIZE - 1;
    }

    /** Sorts the events of a projection by the piece on which they fall, in order of time within each piece. */
    private void sort(int k, int pieces) {
        if (starts.length < pieces + 2) {
            starts = new int[2 * pieces];
        }
        Arrays.fill(starts, 0, pieces + 2, 0);
        int ring = k / n;
        int to = plane.end(ring);
        int held = to - plane.oldest(ring);
        if (events.length < held) {
            events = new int[2 * held];
            came = new int[2 * held];
            pieceOf = new int[2 * held];
        }
        FlowPlaneEvents of = plane.events();
        int found = 0;
        for (int e = of.left(plane.oldest(ring)); e - to < 0; e = of.left(e + 1)) {
            int piece = label[plane.cell(k, e)];
            came[found] = e;
            pieceOf[found] = piece;
            starts[piece]++;
            found += oneUnlessZero(piece);
        }
        starts[0] = 0;
        int end = 0;
        for (int piece = 0; piece <= pieces + 1; piece++) {
            int its = starts[piece];
            starts[piece] = end;
            end += its;
        }
        for (int i = 0; i < found; i++) {
            events[starts[pieceOf[i]]++] = came[i];
        }
        // each start has moved to that of the next piece
        System.arraycopy(starts, 0, starts, 1, pieces + 1);
        starts[0] = 0;
    }
}
