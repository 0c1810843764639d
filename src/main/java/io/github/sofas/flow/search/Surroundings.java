package io.github.sofas.flow.search;

import io.github.sofas.event.SensorSize;
import io.github.sofas.flow.fit.MetricFit;
import io.github.sofas.flow.fit.VelocityTop;
import java.util.Arrays;

/**
 * What moves as a new structure does, all around it: of texture, a search finds a part first, and the rest of it need
 * not be found part by part. From the tiles that the part lies on, each neighbour is asked whether its own events are
 * sharpest near the part's velocity, and if so its neighbours.
 *
 * <p>Ours: a wall before a camera is hundreds of parts, each of which cost a hundred times what asking it does, and
 * were tracked by themselves until they merged.
 */
final class Surroundings {
    /** Tiles have sides of 2^this px, where the structure is now. */
    private static final int TILE_BITS = 5;
    private static final int SIDE_PX = 1 << TILE_BITS;
    /** Tiles around the sensor, for what has left it. */
    private static final int BORDER = 1;
    /** Travel over which tiles are asked, in px: as little as shows a velocity. */
    private static final double TRAVEL_PX = 4;
    /** Events that a tile is asked with. */
    private static final int SAMPLE_EVENTS = 500;
    /** How far the top of the metric may lie from the velocity, in px at the ends of the window. */
    private static final double NEAR_PX = 0.7;
    /** Distance of the projections that look for it, in px at the ends of the window. */
    private static final double STEP_PX = 1.5;

    /** Metric per event of a tile at least: events that hardly meet show no velocity. */
    private static final double LEAST_DENSITY = 0.7;

    /**
     * Share of the metric that a shift of both ends of the window by a pixel costs at least: where the top lies farther
     * away than the projections reach, they are as good as each other.
     */
    private static final double LEAST_SHARPNESS = 0.1;

    private static final byte UNKNOWN = 0;
    private static final byte ASKED = 1;
    private static final byte ALIKE = 2;

    private final RecentEvents events;
    private final MetricFit fit;
    private final int columns;
    private final int rows;
    private final byte[] state;
    private final int[] starts;
    private final int[] queue;
    /** Numbers of the recent events by tile, each tile's in order of time. */
    private final int[] sorted;
    private int queued;

    // the structure: one that is tracked, or null and the velocity of a new one
    private Structures.Structure tracked;
    private double vx;
    private double vy;
    private long nowUs;
    private int first;
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
    }

    private static int side(int sensorSide) {
        return (sensorSide - 1 >> TILE_BITS) + 1 + 2 * BORDER;
    }

    /** Bytes of its arrays. */
    static long bytes(SensorSize sensor) {
        return (long) Integer.BYTES * RecentEvents.capacity(sensor)
            + (1 + 2L * Integer.BYTES) * side(sensor.width()) * side(sensor.height());
    }

    /** Begins with the velocity of a new structure in px/s; places of it are to be added, then to be spread from. */
    void begin(double structureVx, double structureVy, long atUs) {
        vx = structureVx;
        vy = structureVy;
        tracked = null;
        begin(Math.sqrt(vx * vx + vy * vy), atUs);
    }

    /** Begins with a structure that is tracked, and moves. */
    void begin(Structures.Structure structure, long atUs) {
        tracked = structure;
        begin(structure.speed(), atUs);
    }

    private void begin(double speed, long atUs) {
        nowUs = atUs;
        window = TRAVEL_PX / speed;
        first = events.first(nowUs - (long) (window * 1e6));
        queued = 0;
        Arrays.fill(state, UNKNOWN);
        Arrays.fill(starts, 0);
    }

    /** Velocity to the right that the structure has, or would have, at a place of the sensor. */
    private double vxAt(int x, int y, long timeUs) {
        return tracked == null ? vx : tracked.vxAt(x, y, timeUs);
    }

    private double vyAt(int x, int y, long timeUs) {
        return tracked == null ? vy : tracked.vyAt(x, y, timeUs);
    }

    private int centreX(int tile) {
        return (tile % columns - BORDER << TILE_BITS) + SIDE_PX / 2;
    }

    private int centreY(int tile) {
        return (tile / columns - BORDER << TILE_BITS) + SIDE_PX / 2;
    }

    /** Tile that an event lies on as the structure is now, or would if it were of it; -1 far off the sensor. */
    private int tile(int x, int y, long timeUs) {
        double dt = (nowUs - timeUs) * 1e-6;
        int column = ((int) (x + vxAt(x, y, timeUs) * dt + (BORDER << TILE_BITS))) >> TILE_BITS;
        int row = ((int) (y + vyAt(x, y, timeUs) * dt + (BORDER << TILE_BITS))) >> TILE_BITS;
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

    /**
     * Finds the tiles around the places that move alike.
     *
     * @param fewest events of a tile that is asked
     */
    void spread(int fewest) {
        sort();
        spreadOn(fewest);
    }

    /**
     * Finds the tiles that move alike in the box of the structure that is tracked, and around it.
     *
     * @param fewest events of a tile that is asked
     */
    void spreadAround(int fewest) {
        sort();
        for (int tile = 0; tile < state.length; tile++) {
            if (starts[tile + 1] - starts[tile] >= fewest
                    && tracked.isAround(centreX(tile), centreY(tile), SIDE_PX, nowUs)) {
                enqueue(tile);
            }
        }
        spreadOn(fewest);
    }

    private void spreadOn(int fewest) {
        for (int next = 0; next < queued; next++) {
            int tile = queue[next];
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
    }

    private void sort() {
        for (int e = first; e != events.head(); e++) {
            int tile = free(e);
            if (tile >= 0) {
                starts[tile]++;
            }
        }
        int end = 0;
        for (int tile = 0; tile < starts.length; tile++) {
            end += starts[tile];
            starts[tile] = end;
        }
        // from the last on, so that each start ends where it belongs
        for (int e = events.head() - 1; e - first >= 0; e--) {
            int tile = free(e);
            if (tile >= 0) {
                sorted[--starts[tile]] = e;
            }
        }
    }

    /** Tile of an event that no structure has taken, -1 of any other. */
    private int free(int event) {
        return events.sign(event) == 0 ? -1 : tile(events.x(event), events.y(event), events.timeUs(event));
    }

    /** Whether the events of a tile are sharpest near the velocity. */
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
        double tileVx = vxAt(centreX(tile), centreY(tile), nowUs);
        double tileVy = vyAt(centreX(tile), centreY(tile), nowUs);
        if (fit.isSharperAtRest(tileVx, tileVy)) {
            return false;
        }
        double px = 2 / window;
        fit.frame(STEP_PX * px);
        VelocityTop top = fit.fitCross(tileVx, tileVy, MetricFit.FLAT_SIGMAS);
        // in a sample events meet by so much less
        double density = top.metric() / want * size / want;
        return density >= LEAST_DENSITY && top.steps() * STEP_PX < NEAR_PX
            && top.bestLoss() * px * px >= LEAST_SHARPNESS * top.metric();
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

    /** Hands the events of the tiles that move alike to a structure, in order of time. */
    void hand(Structures.Structure structure) {
        for (int e = first; e != events.head(); e++) {
            int tile = free(e);
            if (tile >= 0 && state[tile] == ALIKE) {
                if (tracked == null) {
                    structure.addPast(events.x(e), events.y(e), events.timeUs(e), events.sign(e));
                } else {
                    structure.see(events.x(e), events.y(e), events.timeUs(e), events.sign(e), nowUs);
                }
                events.take(e);
            }
        }
    }
}
