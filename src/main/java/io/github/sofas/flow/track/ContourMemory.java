package io.github.sofas.flow.track;

import io.github.sofas.event.SensorSize;
import io.github.sofas.flow.motion.Gradient;
import io.github.sofas.flow.motion.Motion;
import java.util.Arrays;

/**
 * Remembers what a structure has looked like: where its contour was seen, for a while after its live events have gone.
 * The coordinates travel, turn, grow and are deformed with the structure, but for perspective. Ours, because an edge
 * that was hidden, or that moved along itself, would otherwise come back as a structure of its own.
 *
 * <p>Also knows which places belong to the structure, and which to the texture behind it.
 *
 * <p>Cells are 2 x 2 px, on a torus that is larger than the sensor. Each cell holds the time at which it was last seen.
 * Each group of four cells holds a lead: how much farther edges came there along the structure's motion than along the
 * motion of the texture behind.
 */
final class ContourMemory {
    /** A tick is 1,024 µs. */
    private static final int TICK_BITS = 10;
    /** Twelve days. After this time all cells are forgotten, and ticks start at 0 again. */
    private static final int LAST_TICK = 1 << 30;
    private static final int NEVER = Integer.MIN_VALUE / 2;
    /** Cells that must be remembered, of the four around an event: an edge passes through two. */
    private static final int LEAST_CELLS = 2;
    /** Least side of a tile: 2^this cells, that is 8 px. Below, the number of tiles across a large sensor. */
    private static final int LEAST_TILE_BITS = 2;
    private static final int TILES = 40;
    /** Number of events over which the lead of a place fades. */
    private static final float LEAD_EVENTS = 64;

    private final int columnBits;
    /** Tiles have 2^this cells along a side. */
    private final int tileBits;
    private final int maskX;
    private final int maskY;
    /** Tick at which each cell was last seen. */
    private final int[] seen;
    /** Lead of each group of 2 x 2 cells. */
    private final float[] lead;
    private int leadPlace;
    private final Motion motion = new Motion();
    // origin of the structure's coordinates at the motion's reference
    private double originX;
    private double originY;
    // matrix from an offset to the origin, in px at the motion's reference, back to the structure's coordinates
    private double toXx;
    private double toXy;
    private double toYx;
    private double toYy;
    /** Whether the structure has never turned, grown or been deformed, and does not now. */
    private boolean isShiftedOnly;
    private final Gradient step = new Gradient();
    private final Gradient exponential = new Gradient();
    private int memoryTicks;
    private long epochUs;
    // box of all cells ever seen
    private int minX;
    private int minY;
    private int maxX;
    private int maxY;
    // place located last, in cells
    private double cellX;
    private double cellY;

    ContourMemory(int sensorWidth, int sensorHeight) {
        columnBits = bits(sensorWidth);
        // events that cross a tile's border bias the thinned events towards the motion that was assumed
        tileBits = Math.max(LEAST_TILE_BITS,
            Integer.SIZE - 1 - Integer.numberOfLeadingZeros(Math.max(1, sensorWidth / 2 / TILES)));
        maskX = (1 << columnBits) - 1;
        maskY = (1 << bits(sensorHeight)) - 1;
        seen = new int[(maskX + 1) * (maskY + 1)];
        lead = new float[seen.length / 4];
    }

    /** Bytes that the arrays take. */
    static long bytes(SensorSize sensor) {
        long cells = 1L << bits(sensor.width()) + bits(sensor.height());
        return Integer.BYTES * cells + Float.BYTES * cells / 4;
    }

    /** Returns the number of cells along an axis, as a power of two: those of the sensor and a few around it. */
    private static int bits(int side) {
        return Integer.SIZE - Integer.numberOfLeadingZeros(side / 2 + 7);
    }

    /** Starts with nothing seen. */
    void start(Motion now) {
        Arrays.fill(seen, NEVER);
        Arrays.fill(lead, 0);
        motion.copyFrom(now);
        originX = 0;
        originY = 0;
        memoryTicks = 0;
        toXx = 1;
        toXy = 0;
        toYx = 0;
        toYy = 1;
        isShiftedOnly = shiftsOnly(now);
        epochUs = now.referenceUs;
        minX = Integer.MAX_VALUE;
        minY = Integer.MAX_VALUE;
        maxX = Integer.MIN_VALUE;
        maxY = Integer.MIN_VALUE;
    }

    /**
     * Moves the coordinates on to the reference of a motion, which they follow from then on.
     *
     * @param memoryUs time for which cells are remembered
     */
    void follow(Motion now, long memoryUs) {
        double dt = (now.referenceUs - motion.referenceUs) * 1e-6;
        // for the time in between, too, the new motion is known better than the old one
        double travelX = (now.vx - 0.5 * now.ax * dt) * dt;
        double travelY = (now.vy - 0.5 * now.ay * dt) * dt;
        double rx = originX - (now.centreX - travelX);
        double ry = originY - (now.centreY - travelY);
        exponential.take(now, dt);
        originX = now.centreX + exponential.x(rx, ry);
        originY = now.centreY + exponential.y(rx, ry);
        exponential.take(now, -dt);
        double xx = toXx;
        double yx = toYx;
        toXx = xx * exponential.xx + toXy * exponential.yx;
        toXy = xx * exponential.xy + toXy * exponential.yy;
        toYx = yx * exponential.xx + toYy * exponential.yx;
        toYy = yx * exponential.xy + toYy * exponential.yy;
        goOn(now, memoryUs);
    }

    private static boolean shiftsOnly(Motion now) {
        return now.omega == 0 && now.growth == 0 && now.deformation.isNone();
    }

    private void goOn(Motion now, long memoryUs) {
        motion.copyFrom(now);
        isShiftedOnly &= shiftsOnly(now);
        memoryTicks = (int) Math.min(memoryUs >> TICK_BITS, LAST_TICK / 2);
        if (now.referenceUs - epochUs >> TICK_BITS > LAST_TICK) {
            Arrays.fill(seen, NEVER);
            epochUs = now.referenceUs;
        }
    }

    /** Locates a point of the sensor at a time dt s after the reference, into {@link #cellX} and {@link #cellY}. */
    private void locate(double x, double y, double dt) {
        double rx = x - originX - motion.vx * dt;
        double ry = y - originY - motion.vy * dt;
        if (isShiftedOnly) {
            cellX = rx * 0.5;
            cellY = ry * 0.5;
            return;
        }
        // the origin moves with the structure, about the centre
        step.takeFirstOrder(motion, dt);
        double ox = originX - motion.centreX;
        double oy = originY - motion.centreY;
        rx -= step.x(ox, oy);
        ry -= step.y(ox, oy);
        double thenX = rx - step.x(rx, ry);
        double thenY = ry - step.y(rx, ry);
        cellX = 0.5 * (toXx * thenX + toXy * thenY);
        cellY = 0.5 * (toYx * thenX + toYy * thenY);
    }

    /** Returns the hash of the tile of the structure that an event lies on. */
    int tile(int x, int y, long timeUs) {
        locate(x, y, (timeUs - motion.referenceUs) * 1e-6);
        return tile((int) Math.floor(cellX), (int) Math.floor(cellY));
    }

    private int tile(int cx, int cy) {
        int hash = (cx >> tileBits) * 0x9E3779B1 ^ (cy >> tileBits) * 0x85EBCA6B;
        hash = (hash ^ hash >>> 15) * 0x2C1B3C6D;
        return hash ^ hash >>> 13;
    }

    /** Remembers the place of an event as a place of the structure; returns the hash of its tile. */
    int see(int x, int y, long timeUs) {
        locate(x, y, (timeUs - motion.referenceUs) * 1e-6);
        return seeLocated(timeUs);
    }

    /** The same for the event whose tile was asked for last. */
    int seeLocated(long timeUs) {
        int cx = (int) Math.floor(cellX);
        int cy = (int) Math.floor(cellY);
        minX = Math.min(minX, cx);
        maxX = Math.max(maxX, cx);
        minY = Math.min(minY, cy);
        maxY = Math.max(maxY, cy);
        seen[(cy & maskY) << columnBits | cx & maskX] = tick(timeUs);
        return tile(cx, cy);
    }

    private int tick(long timeUs) {
        return (int) (timeUs - epochUs >> TICK_BITS);
    }

    /** Returns how many of the four cells around an event are remembered; 0 if they are too few. */
    int remembered(int x, int y, long timeUs) {
        locate(x, y, (timeUs - motion.referenceUs) * 1e-6);
        // the four cells nearest
        int cx = (int) Math.floor(cellX - 0.5);
        int cy = (int) Math.floor(cellY - 0.5);
        if (cx < minX - 1 || cx > maxX || cy < minY - 1 || cy > maxY) {
            return 0;
        }
        int since = tick(timeUs) - memoryTicks;
        int row = (cy & maskY) << columnBits;
        int next = (cy + 1 & maskY) << columnBits;
        int left = cx & maskX;
        int right = cx + 1 & maskX;
        int cells = 0;
        cells += seen[row | left] > since ? 1 : 0;
        cells += seen[row | right] > since ? 1 : 0;
        cells += seen[next | left] > since ? 1 : 0;
        cells += seen[next | right] > since ? 1 : 0;
        return cells >= LEAST_CELLS ? cells : 0;
    }

    /**
     * Returns the lead at the place of an event: how much farther edges came there along the structure's motion than
     * along that of the texture behind, as a difference of traces. The mean over the last events; 0 at a new place.
     */
    double lead(int x, int y, long timeUs) {
        locate(x, y, (timeUs - motion.referenceUs) * 1e-6);
        int cx = (int) Math.floor(cellX) & maskX;
        int cy = (int) Math.floor(cellY) & maskY;
        leadPlace = cy >> 1 << columnBits - 1 | cx >> 1;
        return lead[leadPlace];
    }

    /** Takes the lead of the last event asked for into the mean, with the weight of some events; returns the mean. */
    double takeLead(int farther, int events) {
        lead[leadPlace] += (farther - lead[leadPlace]) * events / LEAD_EVENTS;
        return lead[leadPlace];
    }
}
