package io.github.sofas.flow.search;

import io.github.sofas.event.SensorSize;
import io.github.sofas.flow.fit.MetricFit;
import io.github.sofas.flow.fit.VelocityTop;
import io.github.sofas.flow.motion.Motion;
import java.util.Arrays;

/**
 * Finds the surroundings of a structure that move as the structure does. A search finds one part of a texture first,
 * and the rest need not be found part by part. Instead, each neighbour of the tiles on which the part lies is asked
 * whether its own events are sharpest near the part's velocity. If so, its neighbours are asked, too. For a structure
 * that is already tracked, asking begins with the tiles in and around its box.
 *
 * <p>A tile around a dense region is asked for less: it moves alike unless its events are sharper, by a standard
 * deviation, near the region's velocity than along it. A region shows its velocity by more events than a tile has, and
 * earlier.
 *
 * <p>Ours: a wall before a camera has hundreds of parts. Finding one costs a hundred times what asking it does, and
 * each part found is tracked by itself until it merges. The whole wall may have a million events. These are gone
 * through a few at a time, so that no event that comes in the meantime waits for all of them.
 */
final class Surroundings {
    /** Tiles have sides of 2^this px. An event is on the tile where the structure would have it now. */
    private static final int TILE_BITS = 5;
    private static final int SIDE_PX = 1 << TILE_BITS;
    /** Tiles beyond each border of the sensor, for what has left it. */
    private static final int BORDER = 1;
    /** Travel over which tiles are asked, in px: as little as shows a velocity. */
    private static final double TRAVEL_PX = 4;
    /** Most events with which a tile is asked. */
    private static final int SAMPLE_EVENTS = 500;
    /** Largest distance of the top of the metric from the velocity, in px at the ends of the window. */
    private static final double NEAR_PX = 0.7;
    /** Distance of the projections that look for the top, in px at the ends of the window. */
    private static final double STEP_PX = 1.5;

    /** Least metric per event of a tile: events that hardly meet show no velocity. */
    private static final double LEAST_DENSITY = 0.7;
    /**
     * Least metric per event along the structure's motion, lower than at the top near it. Most tiles are decided by
     * this alone.
     */
    private static final double LEAST_DENSITY_HERE = 0.8 * LEAST_DENSITY;

    /**
     * Least share of the metric that a shift of both ends of the window by one pixel must cost. Where the top lies
     * beyond the reach of the projections, these are all about equally good.
     */
    private static final double LEAST_SHARPNESS = 0.1;

    /** Events that are gone through at a time, and the number of events that cost as much as a vote of a fit. */
    static final int AT_ONCE = 256;
    static final int EVENTS_PER_VOTE = 2;

    private static final byte UNKNOWN = 0;
    private static final byte ASKED = 1;
    private static final byte ALIKE = 2;

    /** What is surrounded: a new structure that a piece or a dense region shows, or one that is tracked. */
    private enum Of { PIECE, REGION, TRACKED }

    private enum Stage { COUNTING, SORTING, ASKING, ASKED }

    private final RecentEvents events;
    private final MetricFit fit;
    private final int columns;
    private final int rows;
    private final byte[] state;
    private final int[] starts;
    private final int[] queue;
    /** Numbers of the recent events by tile, in order of time within each tile. */
    private final int[] sorted;
    /** Tile of each recent event when it was counted, indexed by event number modulo the capacity. */
    private final short[] tiles;
    private Stage stage = Stage.ASKED;
    private int queued;
    /** The next event to go through, and the next tile of the queue. */
    private int next;
    private int asked;

    // the structure and its motion
    private Of of = Of.PIECE;
    private final Motion motion = new Motion();
    private long nowUs;
    /** The events with which tiles are asked: from the first to before the last. */
    private int first;
    private int last;
    private double window;

    Surroundings(SensorSize sensor, RecentEvents events, MetricFit fit) {
        this.events = events;
        this.fit = fit;
        columns = side(sensor.width());
        rows = side(sensor.height());
        state = new byte[columns * rows];
        starts = new int[columns * rows + 1];
        queue = new int[columns * rows];
        sorted = new int[RecentEvents.capacity(sensor)];
        tiles = new short[sorted.length];
    }

    private static int side(int sensorSide) {
        return (sensorSide - 1 >> TILE_BITS) + 1 + 2 * BORDER;
    }

    /** Bytes of its arrays. */
    static long bytes(SensorSize sensor) {
        return ((long) Integer.BYTES + Short.BYTES) * RecentEvents.capacity(sensor)
            + (1 + 2L * Integer.BYTES) * side(sensor.width()) * side(sensor.height());
    }

    /**
     * Begins with the velocity of a new structure in px/s. Its places are to be added next; asking begins with these.
     */
    void begin(double structureVx, double structureVy, long atUs) {
        beginNew(Of.PIECE, structureVx, structureVy, Double.POSITIVE_INFINITY, atUs);
    }

    /** Begins with the velocity of a dense region in px/s, found in a window of time. Asking begins with its tiles. */
    void begin(double regionVx, double regionVy, double windowS, int left, int top, long atUs) {
        beginNew(Of.REGION, regionVx, regionVy, windowS, atUs);
        for (int y = top; y < top + DenseRegions.SIDE_PX; y += SIDE_PX) {
            for (int x = left; x < left + DenseRegions.SIDE_PX; x += SIDE_PX) {
                addPlace(x, y, atUs);
            }
        }
    }

    private void beginNew(Of kind, double vx, double vy, double longestS, long atUs) {
        motion.set(atUs, vx, vy);
        begin(kind, Math.min(longestS, TRAVEL_PX / Math.sqrt(vx * vx + vy * vy)), atUs);
    }

    /** Begins with a tracked structure that moves. Asking begins with the tiles in its box and around it. */
    void begin(Structures.Structure structure, long atUs) {
        structure.copyMotion(motion);
        begin(Of.TRACKED, TRAVEL_PX / structure.speed(), atUs);
        for (int tile = 0; tile < state.length; tile++) {
            if (structure.isAround(centreX(tile), centreY(tile), SIDE_PX, nowUs)) {
                enqueue(tile);
            }
        }
    }

    private void begin(Of kind, double windowS, long atUs) {
        of = kind;
        nowUs = atUs;
        window = windowS;
        first = events.first(nowUs - (long) (window * 1e6));
        last = events.head();
        next = first;
        queued = 0;
        asked = 0;
        stage = Stage.COUNTING;
        Arrays.fill(state, UNKNOWN);
        Arrays.fill(starts, 0);
    }

    private int centreX(int tile) {
        return (tile % columns - BORDER << TILE_BITS) + SIDE_PX / 2;
    }

    private int centreY(int tile) {
        return (tile / columns - BORDER << TILE_BITS) + SIDE_PX / 2;
    }

    /**
     * Tile on which an event lies after moving with the structure until now, as if it were of it; -1 far off the
     * sensor.
     */
    private int tile(int x, int y, long timeUs) {
        double dt = (nowUs - timeUs) * 1e-6;
        int column = ((int) (x + motion.vxAt(x, y, timeUs) * dt + (BORDER << TILE_BITS))) >> TILE_BITS;
        int row = ((int) (y + motion.vyAt(x, y, timeUs) * dt + (BORDER << TILE_BITS))) >> TILE_BITS;
        return column < 0 || row < 0 || column >= columns || row >= rows ? -1 : row * columns + column;
    }

    /** Adds a place of the structure. */
    void addPlace(int x, int y, long timeUs) {
        enqueue(tile(x, y, timeUs));
    }

    private void enqueue(int tile) {
        if (tile >= 0 && state[tile] == UNKNOWN) {
            state[tile] = ASKED;
            queue[queued++] = tile;
        }
    }

    /** Whether the structure is new, and a piece of the flow plane. */
    boolean isOfPiece() {
        return of == Of.PIECE;
    }

    /** Whether the structure is already tracked, not new. */
    boolean isOfTracked() {
        return of == Of.TRACKED;
    }

    /** Whether all tiles have been asked. */
    boolean isAsked() {
        return stage == Stage.ASKED;
    }

    /**
     * Continues to find the tiles that move alike, around the places or the box: by some events, or by the next tile.
     *
     * @param fewest least number of events of a tile that is asked
     * @return the cost in votes
     */
    long ask(int fewest) {
        long before = fit.votes();
        int from = next;
        switch (stage) {
            case COUNTING:
                count();
                break;
            case SORTING:
                sort();
                break;
            case ASKING:
                askNext(fewest);
                break;
            default:
        }
        return 1 + fit.votes() - before + Math.abs(next - from) / EVENTS_PER_VOTE;
    }

    private void askNext(int fewest) {
        if (asked == queued) {
            stage = Stage.ASKED;
            next = first;
            return;
        }
        int tile = queue[asked++];
        if (starts[tile + 1] - starts[tile] >= fewest && isAlike(tile)) {
            state[tile] = ALIKE;
            int column = tile % columns;
            int row = tile / columns;
            for (int dy = -1; dy <= 1; dy++) {
                for (int dx = -1; dx <= 1; dx++) {
                    if (column + dx >= 0 && column + dx < columns && row + dy >= 0 && row + dy < rows) {
                        enqueue(tile + dy * columns + dx);
                    }
                }
            }
        }
    }

    private void count() {
        for (int end = next + Math.min(AT_ONCE, last - next); next != end; next++) {
            int tile = free(next);
            tiles[next & tiles.length - 1] = (short) tile;
            if (tile >= 0) {
                starts[tile]++;
            }
        }
        if (next == last) {
            stage = Stage.SORTING;
            int end = 0;
            for (int tile = 0; tile < starts.length; tile++) {
                end += starts[tile];
                starts[tile] = end;
            }
        }
    }

    /** Sorts some events by tile, from the last event backwards, so that each start ends where it belongs. */
    private void sort() {
        for (int end = next - Math.min(AT_ONCE, next - first); next != end; next--) {
            int tile = tiles[next - 1 & tiles.length - 1];
            if (tile >= 0) {
                sorted[--starts[tile]] = next - 1;
            }
        }
        if (next == first) {
            stage = Stage.ASKING;
        }
    }

    /** Tile of an event that no structure has taken; -1 for any other event. */
    private int free(int event) {
        return events.sign(event) == 0 ? -1 : tile(events.x(event), events.y(event), events.timeUs(event));
    }

    /** Whether the events of a tile are sharpest near the velocity of the structure. */
    private boolean isAlike(int tile) {
        int from = starts[tile];
        int size = starts[tile + 1] - from;
        int want = Math.min(size, SAMPLE_EVENTS);
        long middleUs = nowUs - (long) (window * 0.5e6);
        fit.clear();
        for (int a = 0; a < want; a++) {
            int e = sorted[from + (int) ((long) a * size / want)];
            fit.add(events.x(e), events.y(e), (events.timeUs(e) - middleUs) * 1e-6f, 0, 0, events.sign(e));
        }
        double tileVx = motion.vxAt(centreX(tile), centreY(tile), nowUs);
        double tileVy = motion.vyAt(centreX(tile), centreY(tile), nowUs);
        // in a sample, events meet less often in proportion
        double ofAll = (double) size / want / want;
        double here = fit.metric(tileVx, tileVy);
        if (here * ofAll < LEAST_DENSITY_HERE || fit.isSharperAtRest(tileVx, tileVy)) {
            return false;
        }
        double px = 2 / window;
        fit.frame(STEP_PX * px);
        VelocityTop top = fit.fitCross(tileVx, tileVy, MetricFit.FLAT_SIGMAS);
        if (of == Of.REGION) {
            return here >= top.metric() - MetricFit.sd(top.metric());
        }
        return top.metric() * ofAll >= LEAST_DENSITY && top.steps() * STEP_PX < NEAR_PX
            && top.bestLoss() * px * px >= LEAST_SHARPNESS * top.metric();
    }

    /** Time from which on events may belong to the tiles: that of twice the travel over which the tiles were asked. */
    long seenFromUs() {
        return nowUs - (long) (2 * window * 1e6);
    }

    /** Whether any tile moves alike. */
    boolean isAny() {
        for (int i = 0; i < queued; i++) {
            if (state[queue[i]] == ALIKE) {
                return true;
            }
        }
        return false;
    }

    /** Whether an event lies on a tile that moves alike. */
    boolean has(int x, int y, long timeUs) {
        int tile = tile(x, y, timeUs);
        return tile >= 0 && state[tile] == ALIKE;
    }

    /** Whether all events have been gone through, including those that came in the meantime. */
    boolean isHanded() {
        return next == events.head();
    }

    /**
     * Continues to hand the events of the tiles that move alike to a structure, in order of time.
     *
     * @return the number of events gone through
     */
    int hand(Structures.Structure structure) {
        if (next - events.oldest() < 0) {
            next = events.oldest();
        }
        int from = next;
        for (int end = next + Math.min(AT_ONCE, events.head() - next); next != end; next++) {
            int tile = free(next);
            if (tile >= 0 && state[tile] == ALIKE) {
                if (of == Of.TRACKED) {
                    structure.see(events.x(next), events.y(next), events.timeUs(next), events.sign(next),
                        events.newestUs());
                } else {
                    structure.addPast(events.x(next), events.y(next), events.timeUs(next), events.sign(next));
                }
                events.take(next);
            }
        }
        return next - from;
    }
}
