package io.github.sofas.flow.fit;

import io.github.sofas.event.SensorSize;
import io.github.sofas.flow.motion.PixelBox;
import java.util.Arrays;

/**
 * A picture of events that were moved to one time, and how often they meet in it. Each event votes for the four pixels
 * around its place, weighted by nearness. Votes are whole numbers, so that an event can be removed without a remainder.
 */
public final class MeetingPicture {
    /** Places are in parts of a pixel, 2^{@value} of them. */
    static final int SUB_BITS = 6;
    private static final int SUB = 1 << SUB_BITS;
    /** Bits below the unit of a meeting, which is a product of two votes, each of two coordinates. */
    public static final int MET_BITS = 4 * SUB_BITS;
    /** Number of places along each axis at which {@link #addMeets} looks. */
    public static final int BESIDE = 3;
    /** Margin around the sensor for events that are moved off it, in px. */
    private static final int BORDER = 12;

    private final int width;
    private final int height;
    private final int[] votes;
    /** Box of the pixels that may have votes. */
    private final PixelBox box = new PixelBox();

    /** Makes a picture without events. */
    public MeetingPicture(SensorSize sensor) {
        width = sensor.width() + 2 * BORDER;
        height = sensor.height() + 2 * BORDER;
        votes = new int[width * height];
    }

    /** Bytes of the arrays. */
    public static long bytes(SensorSize sensor) {
        return Integer.BYTES * (sensor.width() + 2L * BORDER) * (sensor.height() + 2L * BORDER);
    }

    /** Forgets all events. */
    public void clear() {
        for (int row = box.top; row <= box.bottom + 1; row++) {
            Arrays.fill(votes, row * width + box.left, row * width + box.right + 2, 0);
        }
        box.clear();
    }

    /** Place of a coordinate in px. */
    public static int place(double px) {
        return shift(px + BORDER);
    }

    /** Difference of two places that are so many px apart. */
    public static int shift(double px) {
        return (int) Math.rint(px * SUB);
    }

    /**
     * Adds an event at a place; events farther off the sensor than the margin have no votes.
     *
     * @param weight its polarity; where polarities do not count, 1, or -1 to remove the event again
     */
    public void add(int x, int y, int weight) {
        int column = x >> SUB_BITS;
        int row = y >> SUB_BITS;
        if (isOutside(column, row)) {
            return;
        }
        box.add(column, row);
        int k = row * width + column;
        int right = x & SUB - 1;
        int left = (SUB - right) * weight;
        int below = y & SUB - 1;
        int above = SUB - below;
        right *= weight;
        votes[k] += left * above;
        votes[k + 1] += right * above;
        votes[k + width] += left * below;
        votes[k + width + 1] += right * below;
    }

    private boolean isOutside(int column, int row) {
        return column < 0 || row < 0 || column >= width - 1 || row >= height - 1;
    }

    /**
     * Adds how many events an event at a place would meet, weighted by nearness: at the place, and at places -1, 0 and
     * 1 px to the right of it, in three rows from top to bottom. Units are 2^-{@value #MET_BITS}.
     */
    public void addMeets(int x, int y, long[] met) {
        int column = x >> SUB_BITS;
        int row = y >> SUB_BITS;
        if (isOutside(column - 1, row - 1) || isOutside(column + 1, row + 1)) {
            return;
        }
        int right = x & SUB - 1;
        int left = SUB - right;
        int below = y & SUB - 1;
        int above = SUB - below;
        int k = (row - 1) * width + column - 1;
        long a = across(k, left, right);
        long b = across(k + 1, left, right);
        long c = across(k + 2, left, right);
        for (int m = 0; m < met.length; m += BESIDE) {
            k += width;
            long nextA = across(k, left, right);
            long nextB = across(k + 1, left, right);
            long nextC = across(k + 2, left, right);
            met[m] += above * a + below * nextA;
            met[m + 1] += above * b + below * nextB;
            met[m + 2] += above * c + below * nextC;
            a = nextA;
            b = nextB;
            c = nextC;
        }
    }

    /**
     * How many other events are met by an event that was added at a place, weighted by nearness; those of the other
     * polarity count negatively. Units are 2^-{@value #MET_BITS}.
     */
    public long met(int x, int y, int polarity) {
        int column = x >> SUB_BITS;
        int row = y >> SUB_BITS;
        if (isOutside(column, row)) {
            return 0;
        }
        int right = x & SUB - 1;
        int left = SUB - right;
        int below = y & SUB - 1;
        int above = SUB - below;
        int k = row * width + column;
        long own = (long) (left * left + right * right) * (above * above + below * below);
        return polarity * (above * across(k, left, right) + below * across(k + width, left, right)) - own;
    }

    private long across(int k, int left, int right) {
        return (long) left * votes[k] + (long) right * votes[k + 1];
    }
}
