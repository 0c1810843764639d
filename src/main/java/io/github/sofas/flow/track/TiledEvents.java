package io.github.sofas.flow.track;

import io.github.sofas.event.SensorSize;
import io.github.sofas.flow.fit.MeetingPicture;
import io.github.sofas.flow.motion.Motion;
import io.github.sofas.flow.motion.SteppedProjection;
import java.util.Arrays;

/**
 * The live events that a structure alone claims, projected along one motion or another to the middle of the structure's
 * window, and how often they meet in each tile of 8 x 8 px. The tile of an event is where it lies along the structure's
 * own motion. Ours, to determine which of several motions suits which part of a structure.
 */
final class TiledEvents {
    /** Side of a tile in px, as a power of two. */
    private static final int TILE_BITS = 3;
    /** Room around the sensor for events that are moved off it, in tiles. */
    private static final int MARGIN = 2;
    /** Step, in px, by which events are projected. */
    private static final double STEP_PX = 1.0 / 32;

    private final MeetingPicture picture;
    private final int columns;
    private final int rows;
    private LiveEvents live;
    private int size;
    // of each event: its index, where it was laid, its time from the middle of the window in s, its polarity, its tile
    private final int[] index = new int[Measurement.MOST_EVENTS];
    private final float[] x = new float[Measurement.MOST_EVENTS];
    private final float[] y = new float[Measurement.MOST_EVENTS];
    private final float[] tau = new float[Measurement.MOST_EVENTS];
    private final byte[] sign = new byte[Measurement.MOST_EVENTS];
    private final int[] tile = new int[Measurement.MOST_EVENTS];
    /** Places of the events in the picture. */
    private final int[] placeX = new int[Measurement.MOST_EVENTS];
    private final int[] placeY = new int[Measurement.MOST_EVENTS];
    /** Number of events of each tile. */
    private final int[] events;
    private final SteppedProjection stepped = new SteppedProjection();

    TiledEvents(SensorSize sensor) {
        picture = new MeetingPicture(sensor);
        columns = tiles(sensor.width());
        rows = tiles(sensor.height());
        events = new int[columns * rows];
    }

    private static int tiles(int px) {
        return (px - 1 >> TILE_BITS) + 1 + 2 * MARGIN;
    }

    /** Number of tiles for a sensor. */
    static int tiles(SensorSize sensor) {
        return tiles(sensor.width()) * tiles(sensor.height());
    }

    int tiles() {
        return events.length;
    }

    /** Bytes of its arrays. */
    static long bytes(SensorSize sensor) {
        return MeetingPicture.bytes(sensor) + (7L * Integer.BYTES + 1) * Measurement.MOST_EVENTS
            + (long) Integer.BYTES * tiles(sensor);
    }

    /**
     * Takes the events of a structure, projects them along its motion, and sorts them by tile.
     *
     * @param from no more events than can be measured at once
     * @param along the structure's motion, in the middle of the window
     * @param reach radius of the structure in px
     */
    void take(LiveEvents from, Motion along, double reach) {
        live = from;
        size = 0;
        for (int k = 0; k < live.size(); k++) {
            int i = live.index(k);
            if (live.claim(i) == Claim.OWN) {
                index[size] = i;
                tau[size] = (live.timeUs[i] - along.referenceUs) * 1e-6f;
                sign[size] = live.sign[i];
                size++;
            }
        }
        lay(along, reach);
        sortByTile();
    }

    /** Projects the same events along another motion; their tiles stay. */
    void lay(Motion motion, double reach) {
        stepped.begin(motion, motion.referenceUs - live.oldestUs(), 2 * reach, STEP_PX);
        for (int k = 0; k < size; k++) {
            int i = index[k];
            stepped.advance(live.timeUs[i]);
            x[k] = (float) stepped.x(live.x[i], live.y[i]);
            y[k] = (float) stepped.y(live.x[i], live.y[i]);
        }
    }

    private void sortByTile() {
        Arrays.fill(events, 0);
        for (int k = 0; k < size; k++) {
            int column = Math.max(0, Math.min(columns - 1, ((int) Math.floor(x[k]) >> TILE_BITS) + MARGIN));
            int row = Math.max(0, Math.min(rows - 1, ((int) Math.floor(y[k]) >> TILE_BITS) + MARGIN));
            tile[k] = row * columns + column;
            events[tile[k]]++;
        }
    }

    /**
     * Determines how often the events of each tile meet where they were laid, moved back by a velocity in px/s. Returns
     * the metric of all events.
     */
    double meet(double vx, double vy, long[] byTile) {
        picture.clear();
        for (int k = 0; k < size; k++) {
            placeX[k] = MeetingPicture.place(x[k] - vx * tau[k]);
            placeY[k] = MeetingPicture.place(y[k] - vy * tau[k]);
            picture.add(placeX[k], placeY[k], sign[k]);
        }
        Arrays.fill(byTile, 0);
        long sum = 0;
        for (int k = 0; k < size; k++) {
            long its = picture.met(placeX[k], placeY[k], sign[k]);
            byTile[tile[k]] += its;
            sum += its;
        }
        return metric(sum);
    }

    /** Converts a sum of meetings, as of {@link #meet}, to a metric. */
    static double metric(long met) {
        return Math.scalb((double) met, -MeetingPicture.MET_BITS);
    }

    /** Number of events. */
    int size() {
        return size;
    }

    /** Number of events of a tile. */
    int events(int t) {
        return events[t];
    }

    /** Index of the k-th event among the live events. */
    int index(int k) {
        return index[k];
    }

    /** Place where the k-th event was laid, in px. */
    float x(int k) {
        return x[k];
    }

    float y(int k) {
        return y[k];
    }

    /** Time of the k-th event from the middle of the window, in s. */
    float tauS(int k) {
        return tau[k];
    }

    /** Polarity of the k-th event, 1 or -1. */
    byte sign(int k) {
        return sign[k];
    }

    /** Tile of the k-th event. */
    int tile(int k) {
        return tile[k];
    }
}
