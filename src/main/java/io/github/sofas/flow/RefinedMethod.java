package io.github.sofas.flow;

import io.github.sofas.event.SensorSize;
import java.util.List;
import java.util.function.Consumer;

/** The method of the {@code default} preset: the paper's nouns, made accurate and fast. */
final class RefinedMethod implements Method {
    private final SensorSize sensor;
    private final TrackPlaneStack stack;
    private SofasParameters p;
    private MetricFit fit;
    private LoneEvents lone;
    private BusyPixels busy;
    private FlowPlane flowPlane;
    private StructureSearch search;
    private float vxPxPerS;
    private float vyPxPerS;

    RefinedMethod(SensorSize sensor, SofasParameters p, Consumer<Segment> ended) {
        this.sensor = sensor;
        this.p = p;
        fit = new MetricFit(sensor.width(), sensor.height(), p.voteCellPx(), LiveEvents.CAPACITY);
        lone = new LoneEvents(sensor.width(), sensor.height(), p.slowestPxPerS());
        busy = new BusyPixels(sensor.width(), sensor.height(), p);
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
        } else if (!lone.isAlone(x, y, timeUs) && !busy.isBusy(x, y, timeUs)) {
            flowPlane.add(x, y, timeUs, polarity);
        }
        if (flowPlane.isToSettle(timeUs)) {
            flowPlane.settle(timeUs);
            if (!stack.isFull()) {
                search.run(stack, timeUs);
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
    public void setParameters(SofasParameters next) {
        boolean looksElsewhere = next.flowProjections() != p.flowProjections()
            || next.slowestPxPerS() != p.slowestPxPerS() || next.fastestPxPerS() != p.fastestPxPerS()
            || next.flowTravelPx() != p.flowTravelPx() || next.lifespanUs() != p.lifespanUs();
        if (next.voteCellPx() != p.voteCellPx()) {
            fit = new MetricFit(sensor.width(), sensor.height(), next.voteCellPx(), LiveEvents.CAPACITY);
        }
        if (looksElsewhere) {
            lone = new LoneEvents(sensor.width(), sensor.height(), next.slowestPxPerS());
            busy = new BusyPixels(sensor.width(), sensor.height(), next);
            flowPlane = new FlowPlane(sensor.width(), sensor.height(), next);
            search = new StructureSearch(flowPlane, next, fit);
        }
        search.setParameters(next, fit);
        stack.setParameters(next, fit);
        p = next;
    }

    @Override
    public List<Segment> segments() {
        return stack.segments();
    }

    @Override
    public MetricArray metricArray() {
        return flowPlane.metricArray();
    }

    @Override
    public void contour(int id, long nowUs, PixelConsumer pixels) {
        stack.contour(id, nowUs, pixels);
    }

    @Override
    public void reset() {
        lone.reset();
        busy.reset();
        flowPlane.reset();
        search.reset();
        stack.reset();
    }
}
