package io.github.sofas.baseline;

import io.github.sofas.event.SensorSize;
import java.util.Arrays;

/**
 * Number of events of each pixel and polarity within a maximum age. These counts are the image that
 * {@link LucasKanade} differentiates.
 */
final class EventCounts {
    private final int width;
    private final int pixels;
    private final long maxAgeUs;
    private final int[] counts;
    // The counted events in a ring buffer, in order of time; the length of the ring is a power of two.
    private long[] ringTimeUs = new long[1024];
    private int[] ringCell = new int[1024];
    private int oldest;
    private int size;

    EventCounts(SensorSize sensor, long maxAgeUs) {
        width = sensor.width();
        pixels = sensor.width() * sensor.height();
        this.maxAgeUs = maxAgeUs;
        counts = new int[2 * pixels];
    }

    /** Counts an event, and forgets the events that are older than this event by more than the maximum age. */
    void add(long timeUs, int x, int y, int polarity) {
        int mask = ringCell.length - 1;
        while (size > 0 && timeUs - ringTimeUs[oldest] > maxAgeUs) {
            counts[ringCell[oldest]]--;
            oldest = (oldest + 1) & mask;
            size--;
        }
        if (size == ringCell.length) {
            grow();
            mask = ringCell.length - 1;
        }
        int cell = cell(x, y, polarity);
        int end = (oldest + size) & mask;
        ringTimeUs[end] = timeUs;
        ringCell[end] = cell;
        size++;
        counts[cell]++;
    }

    /** Index into {@link #counts()}; the next column is 1 further, and the next row is one sensor width further. */
    int cell(int x, int y, int polarity) {
        return (polarity > 0 ? pixels : 0) + y * width + x;
    }

    int[] counts() {
        return counts;
    }

    void reset() {
        Arrays.fill(counts, 0);
        oldest = 0;
        size = 0;
    }

    private void grow() {
        int length = ringCell.length;
        long[] times = new long[2 * length];
        int[] cells = new int[2 * length];
        System.arraycopy(ringTimeUs, oldest, times, 0, length - oldest);
        System.arraycopy(ringTimeUs, 0, times, length - oldest, oldest);
        System.arraycopy(ringCell, oldest, cells, 0, length - oldest);
        System.arraycopy(ringCell, 0, cells, length - oldest, oldest);
        ringTimeUs = times;
        ringCell = cells;
        oldest = 0;
    }
}
