package io.github.sofas.flow.search;

import io.github.sofas.event.SensorSize;
import io.github.sofas.flow.SofasParameters;

/**
 * The n x n projections of the flow plane and the cells of their accumulators. There are n rings of one speed each,
 * evenly spaced in logarithm, and n directions per ring.
 *
 * <p>Ours: cells are 2 x 2 px, so that neighbouring velocities overlap and an accumulator stays in the first-level
 * cache. An accumulator is a torus larger than the sensor and the travel together, so that events which are held
 * together never meet across the seam.
 */
final class Projections {
    /**
     * Travel in px after which an event leaves a projection. One lifespan for all speeds would be too long for fast and
     * too short for slow objects.
     */
    static final double TRAVEL_PX = 6;
    /** Most travel of a ring per tick of its time, in px. Where a ring travels farther in a µs, its tick is a µs. */
    private static final double TICK_PX = 1.0 / 256;

    private final int n;
    private final double[] speed;
    private final long[] windowUs;
    /** A tick of a ring lasts 2^this µs. */
    private final int[] tickBits;
    // velocity of each projection, in units of a vote block per tick
    private final int[] vx;
    private final int[] vy;
    private final int columnBits;
    private final int rowBits;

    Projections(int sensorWidth, int sensorHeight, SofasParameters.Search p) {
        n = p.flowProjections();
        columnBits = bits(sensorWidth);
        rowBits = bits(sensorHeight);
        speed = new double[n];
        windowUs = new long[n];
        tickBits = new int[n];
        vx = new int[n * n];
        vy = new int[n * n];
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

    /** Number of cells of an accumulator. */
    static long cells(SensorSize sensor) {
        return 1L << bits(sensor.width()) + bits(sensor.height());
    }

    /** Number of cells along an axis, as an exponent of 2. */
    private static int bits(int sensorSide) {
        int least = sensorSide / 2 + (int) TRAVEL_PX / 2 + 3;
        return Integer.SIZE - Integer.numberOfLeadingZeros(least - 1);
    }

    /** Number of projections along each axis. Projection k has the direction k % n in the ring k / n. */
    int n() {
        return n;
    }

    /**
     * Number of cells of an accumulator. An index has the column in its low {@link #columnBits} bits, and the row
     * above.
     */
    int cells() {
        return 1 << columnBits + rowBits;
    }

    int columnBits() {
        return columnBits;
    }

    int rowBits() {
        return rowBits;
    }

    /** Speed of a ring in px/s. */
    double speed(int ring) {
        return speed[ring];
    }

    /** Time for which a ring holds an event, in µs. */
    long windowUs(int ring) {
        return windowUs[ring];
    }

    /** A tick of a ring lasts 2^this µs. */
    int tickBits(int ring) {
        return tickBits[ring];
    }

    /** Velocity of a projection, in units of a vote block per tick of its ring. */
    int unitsPerTickX(int k) {
        return vx[k];
    }

    int unitsPerTickY(int k) {
        return vy[k];
    }

    /** Velocity of a projection in px/s. */
    double vx(int k) {
        return vx[k] / (double) VoteBlock.unitsPerPx(columnBits) / (1L << tickBits[k / n]) * 1e6;
    }

    double vy(int k) {
        return vy[k] / (double) VoteBlock.unitsPerPx(rowBits) / (1L << tickBits[k / n]) * 1e6;
    }

    /**
     * Cell of an event in a projection.
     *
     * @param sinceUs time since the moment at which all projections show the sensor as it is, in µs
     */
    int cell(int k, int x, int y, long sinceUs) {
        int ticks = (int) (sinceUs >> tickBits[k / n]);
        int px = x * VoteBlock.unitsPerPx(columnBits) - vx[k] * ticks;
        int py = y * VoteBlock.unitsPerPx(rowBits) - vy[k] * ticks;
        return py >>> Integer.SIZE - rowBits << columnBits | px >>> Integer.SIZE - columnBits;
    }

    /**
     * Finds the cells of a projection on which events of a sensor fall.
     *
     * @param fromUs time of the first event since the moment at which all projections show the sensor as it is
     * @param untilUs the same of the last event
     */
    void findHeld(int k, long fromUs, long untilUs, SensorSize sensor, HeldCells held) {
        int from = (int) (fromUs >> tickBits[k / n]);
        int ticks = (int) (untilUs >> tickBits[k / n]) - from;
        int x = first(vx[k], from, ticks);
        int y = first(vy[k], from, ticks);
        held.set(x >>> Integer.SIZE - columnBits, count(x, vx[k], ticks, sensor.width(), columnBits),
            y >>> Integer.SIZE - rowBits, count(y, vy[k], ticks, sensor.height(), rowBits));
    }

    /**
     * Least projected position of the sensor's first column or row, in units of a vote block. Projected positions move
     * against the velocity.
     */
    private static int first(int velocity, int fromTick, int ticks) {
        return -velocity * fromTick - Math.max(0, velocity * ticks);
    }

    private static int count(int first, int velocity, int ticks, int sensorSide, int bits) {
        int toCell = Integer.SIZE - bits;
        long within = first & (1L << toCell) - 1;
        long units = Math.abs((long) velocity * ticks) + (sensorSide - 1L) * VoteBlock.unitsPerPx(bits);
        return (int) Math.min(1 << bits, (within + units >> toCell) + 1);
    }
}
