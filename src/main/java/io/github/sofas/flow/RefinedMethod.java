package io.github.sofas.flow;

import io.github.sofas.event.SensorSize;
import java.util.List;
import java.util.function.Consumer;

/** The method of the {@code default} preset: the paper's nouns, made accurate and fast. */
final class RefinedMethod implements Method {
    private final LoneEvents lone;
    private final FlowPlane flowPlane;
    private final StructureSearch search;
    private final TrackPlaneStack stack;
    private float vxPxPerS;
    private float vyPxPerS;

    RefinedMethod(SensorSize sensor, SofasParameters p, Consumer<Segment> ended) {
        MetricFit fit = new MetricFit(sensor.width(), sensor.height(), p.voteCellPx(), LiveEvents.CAPACITY);
        lone = new LoneEvents(sensor.width(), sensor.height(), p.slowestPxPerS());
        flowPlane = new FlowPlane(sensor.width(), sensor.height(), p);
        search = new StructureSearch(flowPlane, p, fit);
        stack = new TrackPlaneStack(sensor, p, fit, ended);
    }

    @Override
    public int label(int x, int y, long timeUs, int polarity) {
        stack.check(timeUs);
        TrackPlane plane = stack.match(x, y, timeUs, polarity);
        int id = 0;
        if (plane != null) {
            id = plane.id();
            vxPxPerS = plane.motion().vxAt(y, timeUs);
            vyPxPerS = plane.motion().vyAt(x, timeUs);
            stack.take(plane, x, y, timeUs, polarity);
        } else if (!lone.isAlone(x, y, timeUs)) {
            flowPlane.add(x, y, timeUs, polarity);
        }
        if (flowPlane.isToSettle(timeUs)) {
            flowPlane.settle(timeUs);
            if (!stack.isFull()) {
                search.run(stack);
            }
        }
        return id;
    }

    @Override
    public float vxPxPerS() {
        return vxPxPerS;
    }

    @Override
    public float vyPxPerS() {
        return vyPxPerS;
    }

    @Override
    public List<Segment> segments() {
        return stack.segments();
    }

    @Override
    public void reset() {
        lone.reset();
        flowPlane.reset();
        search.reset();
        stack.reset();
    }
}
