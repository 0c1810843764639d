package io.github.sofas.render;

import io.github.sofas.event.EventBatch;
import io.github.sofas.event.SensorSize;
import io.github.sofas.flow.FlowOutput;

/**
 * The last event of every pixel with its label. Determines which of these events are still exposed: those of a time
 * span, or a number of the newest events. The memory does not grow with the recording.
 */
final class LastEvents {
    private final SensorSize sensor;
    private final long exposureUs;
    private final long exposureEvents;
    private final long[] seenUs;
    private final long[] number;
    private final byte[] polarity;
    private final float[] vx;
    private final float[] vy;
    private final int[] segment;
    private long events;
    /**
     * Pixels in the order of their events. A pixel may occur more than once; only its last occurrence counts, whose
     * index {@link #place} holds.
     */
    private final int[] order;
    private final int[] place;
    private int ordered;

    /** Starts without events. One of the two exposures, as in {@link PictureOptions}, is 0. */
    LastEvents(SensorSize sensor, long exposureUs, long exposureEvents) {
        this.sensor = sensor;
        this.exposureUs = exposureUs;
        this.exposureEvents = exposureEvents;
        int n = sensor.width() * sensor.height();
        seenUs = new long[n];
        number = new long[n];
        polarity = new byte[n];
        vx = new float[n];
        vy = new float[n];
        segment = new int[n];
        order = new int[2 * n];
        place = new int[n];
    }

    /** Takes the events of a batch from one index to before another. Events outside the sensor are skipped. */
    void add(EventBatch batch, FlowOutput flow, int from, int to) {
        int columns = sensor.width();
        for (int i = from; i < to; i++) {
            int x = batch.x[i];
            int y = batch.y[i];
            if (sensor.contains(x, y)) {
                int at = y * columns + x;
                seenUs[at] = batch.timeUs[i];
                number[at] = events++;
                polarity[at] = batch.polarity[i];
                vx[at] = flow.vxPxPerS[i];
                vy[at] = flow.vyPxPerS[i];
                segment[at] = flow.segment[i];
                if (ordered == order.length) {
                    forgetEarlierPlaces();
                }
                place[at] = ordered;
                order[ordered++] = at;
            }
        }
    }

    private void forgetEarlierPlaces() {
        int kept = 0;
        for (int i = 0; i < ordered; i++) {
            int at = order[i];
            if (place[at] == i) {
                place[at] = kept;
                order[kept++] = at;
            }
        }
        ordered = kept;
    }

    /**
     * Finds the pixels whose last event is exposed at a time.
     *
     * @param pixels receives their indices, row times the sensor's width plus column, those with the newest events
     *     first; must have room for all pixels of the sensor
     * @return number of exposed pixels
     */
    int exposed(long timeUs, int[] pixels) {
        int count = 0;
        for (int i = ordered - 1; i >= 0 && isExposed(order[i], timeUs); i--) {
            if (place[order[i]] == i) {
                pixels[count++] = order[i];
            }
        }
        return count;
    }

    private boolean isExposed(int pixel, long timeUs) {
        return exposureUs > 0 ? timeUs - seenUs[pixel] < exposureUs : events - number[pixel] <= exposureEvents;
    }

    /** Polarity of a pixel's last event. */
    int polarity(int pixel) {
        return polarity[pixel];
    }

    /** Velocity to the right of a pixel's last event, px/s. */
    float vx(int pixel) {
        return vx[pixel];
    }

    /** Velocity downwards of a pixel's last event, px/s. */
    float vy(int pixel) {
        return vy[pixel];
    }

    /** Segment of a pixel's last event, 0 for none. */
    int segment(int pixel) {
        return segment[pixel];
    }
}
