package io.github.sofas.flow.search;

import io.github.sofas.event.SensorSize;
import java.util.Arrays;

/**
 * The squares of 64 px into which the sensor is divided, and which of them have so many events that no track plane took
 * that they may show a velocity by themselves. A region is due each time that it has 1.4 times as many events as the
 * last time.
 *
 * <p>Ours: where texture fills a region, the number of its events is a clock of its travel, whatever its speed.
 */
final class DenseRegions {
    /** Regions have sides of 2^this px. */
    private static final int SIDE_BITS = 6;
    static final int SIDE_PX = 1 << SIDE_BITS;
    private static final int AREA = SIDE_PX * SIDE_PX;
    /** Events with which a region is due first: texture of strong edges gives so many in a px of travel. */
    private static final int FIRST = 3 * AREA / 20;
    /** How many times more events a region has when it is due again. */
    private static final double MORE = 1.4;
    /** Most events of a region: more than texture gives in 5 px of travel. Then the region begins anew. */
    private static final int MOST = 3 * AREA;
    /** Longest time for which a region gathers events: in a longer one, a swing to and fro looks like a drift. */
    static final long LONGEST_US = 200_000;

    private final RecentEvents events;
    private final int columns;
    /** By region, how many events it has, since when, and with how many it is due. */
    private final int[] count;
    private final long[] sinceUs;
    private final int[] dueWith;
    /** By region, the number of its newest event; by event modulo the capacity, the number of the one before it. */
    private final int[] newest;
    private final int[] before;
    /** The regions that are due, first come first served, and whether a region is one of them. */
    private final int[] queue;
    private final boolean[] isQueued;
    private int first;
    private int waiting;

    DenseRegions(SensorSize sensor, RecentEvents events) {
        this.events = events;
        columns = side(sensor.width());
        int regions = regions(sensor);
        count = new int[regions];
        sinceUs = new long[regions];
        dueWith = new int[regions];
        newest = new int[regions];
        before = new int[RecentEvents.capacity(sensor)];
        queue = new int[regions];
        isQueued = new boolean[regions];
    }

    private static int side(int sensorSide) {
        return (sensorSide - 1 >> SIDE_BITS) + 1;
    }

    private static int regions(SensorSize sensor) {
        return side(sensor.width()) * side(sensor.height());
    }

    /** Bytes of its arrays. */
    static long bytes(SensorSize sensor) {
        return (long) Integer.BYTES * RecentEvents.capacity(sensor)
            + (4L * Integer.BYTES + Long.BYTES + 1) * regions(sensor);
    }

    /** Adds the newest of the recent events. */
    void add(int x, int y, long timeUs) {
        int region = (y >> SIDE_BITS) * columns + (x >> SIDE_BITS);
        int event = events.head() - 1;
        if (count[region] == 0 || timeUs - sinceUs[region] > LONGEST_US) {
            count[region] = 0;
            sinceUs[region] = timeUs;
            dueWith[region] = FIRST;
        }
        before[event & before.length - 1] = newest[region];
        newest[region] = event;
        count[region]++;
        if (count[region] >= dueWith[region] && !isQueued[region]) {
            isQueued[region] = true;
            queue[(first + waiting++) % queue.length] = region;
        }
    }

    /** Whether any region is due. */
    boolean isAnyDue() {
        return waiting > 0;
    }

    /** Takes the next region that is due. */
    int next() {
        int region = queue[first];
        first = (first + 1) % queue.length;
        waiting--;
        isQueued[region] = false;
        dueWith[region] = (int) (MORE * count[region]);
        return region;
    }

    /** Number of events of a region, of which the recent events still hold most or all. */
    int count(int region) {
        return count[region];
    }

    /** Time of the first event of a region, in µs. */
    long sinceUs(int region) {
        return sinceUs[region];
    }

    /** Number of the newest event of a region. */
    int newest(int region) {
        return newest[region];
    }

    /** Number of the event of the same region before another one. */
    int before(int event) {
        return before[event & before.length - 1];
    }

    /** Leftmost column of a region. */
    int left(int region) {
        return region % columns << SIDE_BITS;
    }

    /** Topmost row of a region. */
    int top(int region) {
        return region / columns << SIDE_BITS;
    }

    /** Has a region begin anew. */
    void forget(int region) {
        count[region] = 0;
    }

    /** Has a region begin anew if it has as many events as a region can have. */
    void forgetIfFull(int region) {
        if (count[region] > MOST) {
            forget(region);
        }
    }

    /** Forgets all events. */
    void clear() {
        Arrays.fill(count, 0);
        Arrays.fill(isQueued, false);
        first = 0;
        waiting = 0;
    }
}
