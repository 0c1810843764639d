package io.github.sofas.render;

import io.github.sofas.event.EventBatch;
import io.github.sofas.event.SensorSize;
import io.github.sofas.flow.FlowOutput;

/** The last event of every pixel with its label, and which of them are still exposed. */
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
    /** Pixels in the order of their events; only a pixel's last place, which is remembered beside, counts. */
    private final int[] order;
    private final int[] place;
    private int ordered;

    /** Makes it without events; one of the exposures of {@link PictureOptions} is 0. */
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

    /** Takes events of a batch, from one place to before another; those outside the sensor are passed over. */
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
     * @param pixels takes them, row by row times the sensor's width, the newest first; as many as the sensor has fit
     * @return how many there are
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

    /** Its velocity to the right, px/s. */
    float vx(int pixel) {
        return vx[pixel];
    }

    /** The same, downwards. */
    float vy(int pixel) {
        return vy[pixel];
    }

    /** Its segment, 0 for none. */
    int segment(int pixel) {
        return segment[pixel];
    }
}
