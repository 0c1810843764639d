package io.github.sofas.flow;

import io.github.sofas.event.SensorSize;
import java.util.List;
import java.util.function.Consumer;

/** The method of the {@code default} preset: the paper's nouns, made accurate and fast. */
final class RefinedMethod implements Method {
    private final TrackPlaneStack stack;
    private final FlowPlane flowPlane;
    private float vx;
    private float vy;

    RefinedMethod(SensorSize sensor, SofasParameters p, Consumer<Segment> ended) {
        MetricFit fit = new MetricFit(sensor.width(), sensor.height(), p.voteCellPx(), 1 << 15);
        flowPlane = new FlowPlane(sensor.width(), sensor.height(), p, fit);
        stack = new TrackPlaneStack(sensor, p, fit, ended);
    }

    @Override
    public int label(int x, int y, long timeUs, int polarity) {
        stack.advance(timeUs);
        TrackPlane plane = stack.match(x, y, timeUs, polarity);
        int id = 0;
        if (plane != null) {
            id = plane.id;
            vx = plane.vxAt(x, y, timeUs);
            vy = plane.vyAt(x, y, timeUs);
            stack.assign(plane, x, y, timeUs, polarity);
        } else {
            flowPlane.add(x, y, timeUs, polarity);
        }
        if (flowPlane.blockFull(timeUs)) {
            flowPlane.settle(timeUs);
            flowPlane.search(timeUs, stack);
        }
        return id;
    }

    @Override
    public float vxPxPerS() {
        return vx;
    }

    @Override
    public float vyPxPerS() {
        return vy;
    }

    @Override
    public List<Segment> segments() {
        return stack.segments();
    }

    @Override
    public void reset() {
        flowPlane.reset();
        stack.reset();
    }
}
