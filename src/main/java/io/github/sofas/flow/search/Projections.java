package io.github.sofas.flow.search;

import io.github.sofas.event.SensorSize;
import io.github.sofas.flow.SofasParameters;

/**
 * The n x n projections of the flow plane: n rings of one speed each, evenly spaced in logarithm, by n directions, and
 * the cells of their accumulators.
 *
 * <p>Ours: cells are 2 x 2 px, which makes neighbouring velocities overlap and lets an accumulator stay in the
 * first-level cache. Accumulators are tori larger than the sensor and the travel, so that events which are held
 * together never meet across the seam.
 */
final class Projections {
    /**
     * Travel after which an event leaves a projection: one lifespan for all speeds is too long for fast and too short
     * for slow objects.
     */
    static final double TRAVEL_PX = 6;
    /** A ring's time is in ticks in which it travels at most this part of a pixel, where a µs is not longer. */
    private static final double TICK_PX = 1.0 / 256;

    private final int n;
    private final double[] speed;
    private final long[] windowUs;
    /** Ticks of a ring: 2^this µs. */
    private final int[] tickBits;
    // units a tick
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

    /** Cells of an accumulator. */
    static long cells(SensorSize sensor) {
        return 1L << bits(sensor.width()) + bits(sensor.height());
    }

    /** Cells along an axis, as a power of two. */
    private static int bits(int sensorSide) {
        int least = sensorSide / 2 + (int) TRAVEL_PX / 2 + 3;
        return Integer.SIZE - Integer.numberOfLeadingZeros(least - 1);
    }

    /** Projections along each axis; number k is the direction k % n of the ring k / n. */
    int n() {
        return n;
    }

    /** Cells of an accumulator: columns in the low {@link #columnBits} bits of an index, rows above. */
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

    /** Time for which a ring holds an event. */
    long windowUs(int ring) {
        return windowUs[ring];
    }

    /** Ticks of a ring are 2^this µs. */
    int tickBits(int ring) {
        return tickBits[ring];
    }

    /** Velocity of a projection in units of a vote block a tick of its ring. */
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
     * @param sinceUs time from the one at which all projections show the sensor as it is
     */
    int cell(int k, int x, int y, long sinceUs) {
        int ticks = (int) (sinceUs >> tickBits[k / n]);
        int px = x * VoteBlock.unitsPerPx(columnBits) - vx[k] * ticks;
        int py = y * VoteBlock.unitsPerPx(rowBits) - vy[k] * ticks;
        return py >>> Integer.SIZE - rowBits << columnBits | px >>> Integer.SIZE - columnBits;
    }

    /**
     * Finds the cells that events of a sensor fall on in a projection.
     *
     * @param fromUs time of the first event from the one at which all projections show the sensor as it is
     * @param untilUs time of the last event
     */
    void findHeld(int k, long fromUs, long untilUs, SensorSize sensor, HeldCells held) {
        int from = (int) (fromUs >> tickBits[k / n]);
        int ticks = (int) (untilUs >> tickBits[k / n]) - from;
        int x = first(vx[k], from, ticks);
        int y = first(vy[k], from, ticks);
        held.set(x >>> Integer.SIZE - columnBits, count(x, vx[k], ticks, sensor.width(), columnBits),
            y >>> Integer.SIZE - rowBits, count(y, vy[k], ticks, sensor.height(), rowBits));
    }

    /** The least position of the sensor's first pixels, in units of a vote block: it moves against the velocity. */
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
