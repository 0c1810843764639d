package io.github.sofas.flow.smooth;

import io.github.sofas.event.SensorSize;
import io.github.sofas.flow.motion.Chance;
import java.util.Arrays;

/**
 * Records when events fall on each pixel once they are moved along one motion: one bit per part of the time, by
 * polarity, and by whose the events are. Along the true motion of an event, nearly all parts have events; along another
 * motion, only as many as chance puts there.
 */
final class TraceMap {
    /** Parts of the time that are distinguished. */
    static final int PARTS = 20;
    /** Events of the segment whose motion it is; of no segment; of another segment. */
    static final int OWN = 0;
    static final int NOBODYS = 1;
    static final int OTHERS = 2;

    /** Score of an event on the nearest pixel, in addition to the 1 for an event within a pixel. */
    private static final int NEAREST = 2;
    /** Pixels around a place on which an event counts. */
    private static final int AROUND = 4;
    /** Pixels around the sensor. */
    private static final int BORDER = 8;
    private static final long ALL = (1L << PARTS) - 1;

    private final int width;
    private final int height;
    private final long[] on;
    private final long[] off;
    private int top;
    private int bottom;

    TraceMap(SensorSize sensor) {
        width = sensor.width() + 2 * BORDER;
        height = sensor.height() + 2 * BORDER;
        on = new long[width * height];
        off = new long[width * height];
        top = height;
    }

    /** Bytes of its arrays. */
    static long bytes(SensorSize sensor) {
        return 2L * Long.BYTES * (sensor.width() + 2 * BORDER) * (sensor.height() + 2 * BORDER);
    }

    /** Forgets all events. */
    void clear() {
        if (top < bottom) {
            Arrays.fill(on, top * width, bottom * width, 0);
            Arrays.fill(off, top * width, bottom * width, 0);
        }
        top = height;
        bottom = 0;
    }

    /**
     * Adds an event.
     *
     * @param x moved column in px
     * @param y moved row in px
     * @param part of the time in which it happened
     * @param whose {@link #OWN}, {@link #NOBODYS} or {@link #OTHERS}
     */
    void add(double x, double y, boolean isOn, int part, int whose) {
        int column = (int) (x + (BORDER + 0.5));
        int row = (int) (y + (BORDER + 0.5));
        if (isInside(column, row)) {
            (isOn ? on : off)[row * width + column] |= 1L << part + whose * PARTS;
            top = Math.min(top, row);
            bottom = Math.max(bottom, row + 1);
        }
    }

    private boolean isInside(int column, int row) {
        return column > 0 && column < width - 1 && row > 0 && row < height - 1;
    }

    /**
     * How well the events of the wanted parts agree with an event at a place. Each part scores 1 if it has an event on
     * one of the four pixels around the place, and {@value #NEAREST} more if it has one on the pixel nearest to the
     * place.
     *
     * @param nobodys weight of events of no segment, up to 1
     * @param others weight of events of another segment, up to 1
     */
    double claim(double x, double y, boolean isOn, long wanted, double nobodys, double others) {
        int column = (int) (x + BORDER);
        int row = (int) (y + BORDER);
        if (!isInside(column, row)) {
            return 0;
        }
        long[] map = isOn ? on : off;
        int k = row * width + column;
        long around = map[k] | map[k + 1] | map[k + width] | map[k + width + 1];
        int nearest = (int) (y + (BORDER + 0.5)) * width + (int) (x + (BORDER + 0.5));
        return score(around, wanted, nobodys, others) + NEAREST * score(map[nearest], wanted, nobodys, others);
    }

    /** Number of wanted parts with events; those with events of nobody or of others only count less. */
    private static double score(long known, long wanted, double nobodys, double others) {
        long own = known & wanted;
        long free = known >> PARTS & wanted & ~own;
        long taken = known >> 2 * PARTS & wanted & ~own & ~free;
        return Long.bitCount(own) + nobodys * Long.bitCount(free) + others * Long.bitCount(taken);
    }

    /** Probability of an event on one of the four pixels around a place where so many are expected on each pixel. */
    static double chance(double expected) {
        return Chance.share(AROUND * expected);
    }

    /**
     * Score of so many parts that noise seldom reaches: 1 for a part with noise on one of four pixels, and
     * {@value #NEAREST} more for noise on the nearest one.
     *
     * @param expected noise events of a pixel and polarity in a part of the time
     * @param sigmas standard deviations above the mean
     */
    static double byNoise(double expected, int parts, double sigmas) {
        double around = chance(expected);
        double nearest = Chance.share(expected);
        double mean = around + NEAREST * nearest;
        double square = around + ((1 + NEAREST) * (1 + NEAREST) - 1) * nearest;
        return Chance.most(parts, mean, square, sigmas);
    }

    /** The parts from one to before another, as bits. */
    static long parts(int from, int until) {
        return (1L << Math.min(until, PARTS)) - (1L << Math.max(0, from)) & ALL;
    }
}
