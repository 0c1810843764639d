package io.github.sofas.jaer;

import io.github.sofas.event.EventBatch;
import io.github.sofas.flow.FlowOutput;
import java.util.Arrays;

/**
 * The events of one picture, with their flow. They come from all packets since the last picture, because a live packet
 * may be much shorter than the time between pictures. If no picture is drawn for long, only the newest events are kept.
 */
final class ShownEvents {
    /** Most events that are kept: more are of no use in one picture, but cost memory. */
    static final int MOST = 1 << 18;

    private short[] x = new short[4096];
    private short[] y = new short[4096];
    private float[] vx = new float[4096];
    private float[] vy = new float[4096];
    private int[] segment = new int[4096];
    private int size;
    private int withFlow;
    private boolean drawn;

    /** Adds the events of a packet; begins a new picture if the events before have been drawn. */
    void add(EventBatch batch, FlowOutput flow) {
        if (drawn) {
            clear();
        }
        int from = Math.max(0, batch.size() - MOST);
        int count = batch.size() - from;
        if (size + count > MOST) {
            dropOldest(size + count - MOST);
        }
        reserve(size + count);
        for (int i = from; i < batch.size(); i++) {
            x[size] = batch.x[i];
            y[size] = batch.y[i];
            vx[size] = flow.vxPxPerS[i];
            vy[size] = flow.vyPxPerS[i];
            segment[size] = flow.segment[i];
            withFlow += flow.segment[i] == 0 ? 0 : 1;
            size++;
        }
    }

    private void dropOldest(int count) {
        for (int i = 0; i < count; i++) {
            withFlow -= segment[i] == 0 ? 0 : 1;
        }
        size -= count;
        for (Object array : new Object[] {x, y, vx, vy, segment}) {
            System.arraycopy(array, count, array, 0, size);
        }
    }

    private void reserve(int wanted) {
        if (wanted > x.length) {
            int room = Math.max(wanted, 2 * x.length);
            x = Arrays.copyOf(x, room);
            y = Arrays.copyOf(y, room);
            vx = Arrays.copyOf(vx, room);
            vy = Arrays.copyOf(vy, room);
            segment = Arrays.copyOf(segment, room);
        }
    }

    /** Notes that the picture is complete: it may be drawn again, but the next packet begins another picture. */
    void setDrawn() {
        drawn = true;
    }

    void clear() {
        size = 0;
        withFlow = 0;
        drawn = false;
    }

    int size() {
        return size;
    }

    int withFlow() {
        return withFlow;
    }

    int x(int i) {
        return x[i];
    }

    int y(int i) {
        return y[i];
    }

    float vxPxPerS(int i) {
        return vx[i];
    }

    float vyPxPerS(int i) {
        return vy[i];
    }

    int segment(int i) {
        return segment[i];
    }
}
