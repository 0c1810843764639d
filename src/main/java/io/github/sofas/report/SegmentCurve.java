package io.github.sofas.report;

import java.util.Arrays;

/** The mean velocity of one segment in each time bin in which the segment lived. */
final class SegmentCurve {
    final int id;
    private long widthUs;
    private int first;
    private int[] events = new int[8];
    private double[] vx = new double[8];
    private double[] vy = new double[8];
    private int used;
    private long all;

    SegmentCurve(int id, long widthUs, int first) {
        this.id = id;
        this.widthUs = widthUs;
        this.first = first;
    }

    /** Takes an event. The bins may have become wider since the last one. */
    void add(int place, long newWidthUs, double vxPxPerS, double vyPxPerS) {
        widenTo(newWidthUs);
        int i = place - first;
        if (i >= events.length) {
            int capacity = Math.max(i + 1, 2 * events.length);
            events = Arrays.copyOf(events, capacity);
            vx = Arrays.copyOf(vx, capacity);
            vy = Arrays.copyOf(vy, capacity);
        }
        used = Math.max(used, i + 1);
        events[i]++;
        vx[i] += vxPxPerS;
        vy[i] += vyPxPerS;
        all++;
    }

    void widenTo(long newWidthUs) {
        while (widthUs < newWidthUs) {
            int newFirst = first / 2;
            for (int i = 0; i < used; i++) {
                int to = (first + i) / 2 - newFirst;
                move(i, to);
            }
            used = used == 0 ? 0 : (first + used - 1) / 2 - newFirst + 1;
            first = newFirst;
            widthUs *= 2;
        }
    }

    /**
     * Adds the sums of one place to another. The other place is never later; it was emptied before, or it is the same
     * place.
     */
    private void move(int from, int to) {
        if (from == to) {
            return;
        }
        events[to] += events[from];
        vx[to] += vx[from];
        vy[to] += vy[from];
        events[from] = 0;
        vx[from] = 0;
        vy[from] = 0;
    }

    long events() {
        return all;
    }

    int first() {
        return first;
    }

    int used() {
        return used;
    }

    /** Speed in px/s; NaN if there is no event. */
    double speed(int i) {
        return events[i] == 0 ? Double.NaN : Math.hypot(vx[i], vy[i]) / events[i];
    }

    /** Direction in degrees, from right (0) to down (90): y points down, as in all result files. */
    double directionDeg(int i) {
        return events[i] == 0 ? Double.NaN : Math.toDegrees(Math.atan2(vy[i], vx[i]));
    }
}
