package io.github.sofas.evaluate;

import io.github.sofas.event.EventBatch;
import io.github.sofas.flow.FlowOutput;
import java.util.Arrays;

/**
 * The events of one window with their flow, in order of arrival. They can be drawn as they are, moved along their own
 * flow, or all moved along one velocity. Moving refers to the middle of the time between the first and last event.
 */
final class MovedEvents {
    private long[] timeUs = new long[1024];
    private short[] x = new short[1024];
    private short[] y = new short[1024];
    private float[] vxPxPerS = new float[1024];
    private float[] vyPxPerS = new float[1024];
    private int size;
    private int withFlow;

    void clear() {
        size = 0;
        withFlow = 0;
    }

    /** Adds event i of a batch. */
    void add(EventBatch batch, FlowOutput flow, int i) {
        if (size == timeUs.length) {
            timeUs = Arrays.copyOf(timeUs, 2 * size);
            x = Arrays.copyOf(x, 2 * size);
            y = Arrays.copyOf(y, 2 * size);
            vxPxPerS = Arrays.copyOf(vxPxPerS, 2 * size);
            vyPxPerS = Arrays.copyOf(vyPxPerS, 2 * size);
        }
        timeUs[size] = batch.timeUs[i];
        x[size] = batch.x[i];
        y[size] = batch.y[i];
        boolean moves = flow.segment[i] != 0;
        vxPxPerS[size] = moves ? flow.vxPxPerS[i] : 0;
        vyPxPerS[size] = moves ? flow.vyPxPerS[i] : 0;
        withFlow += moves ? 1 : 0;
        size++;
    }

    int size() {
        return size;
    }

    int withFlow() {
        return withFlow;
    }

    long firstUs() {
        return timeUs[0];
    }

    long lastUs() {
        return timeUs[size - 1];
    }

    int x(int i) {
        return x[i];
    }

    int y(int i) {
        return y[i];
    }

    /** Time of event i relative to the middle between the first and the last event, in s. */
    double fromMiddleS(int i) {
        return (timeUs[i] - firstUs() - (lastUs() - firstUs()) / 2.0) * 1e-6;
    }

    /** Draws the events where they occurred. */
    void drawAsTheyAre(EventPicture picture) {
        drawMovedBy(picture, 0, 0);
    }

    /** Draws each event where its own flow puts it at the window's middle; events without flow stay in place. */
    void drawMoved(EventPicture picture) {
        picture.clear();
        for (int i = 0; i < size; i++) {
            double dtS = fromMiddleS(i);
            picture.add(x[i] - vxPxPerS[i] * dtS, y[i] - vyPxPerS[i] * dtS);
        }
    }

    /** Draws all events where one common velocity puts them at the window's middle. */
    void drawMovedBy(EventPicture picture, double allVxPxPerS, double allVyPxPerS) {
        picture.clear();
        for (int i = 0; i < size; i++) {
            double dtS = fromMiddleS(i);
            picture.add(x[i] - allVxPxPerS * dtS, y[i] - allVyPxPerS * dtS);
        }
    }
}
