package io.github.sofas.flow;

import io.github.sofas.event.SensorSize;
import java.util.List;
import java.util.function.Consumer;

/** The method of the {@code default} preset: the paper's nouns, made accurate and fast. */
final class RefinedMethod implements Method {
    /** Most events that vote on two grids, at twice the cost: of a track plane, less than a thinned sample has. */
    private static final int TRACKED_ON_BOTH = 1900;
    /** The same of a piece of the flow plane, whose velocity is to be right to a few percent only. */
    private static final int SEARCHED_ON_BOTH = 300;

    private final SensorSize sensor;
    private final TrackPlaneStack stack;
    private SofasParameters p;
    private LoneEvents lone;
    private BusyPixels busy;
    private FlowPlane flowPlane;
    private StructureSearch search;
    private float vxPxPerS;
    private float vyPxPerS;

    RefinedMethod(SensorSize sensor, SofasParameters p, Consumer<Segment> ended) {
        this.sensor = sensor;
        this.p = p;
        lone = new LoneEvents(sensor.width(), sensor.height(), p.slowestPxPerS());
        busy = new BusyPixels(sensor.width(), sensor.height(), p);
        flowPlane = new FlowPlane(sensor.width(), sensor.height(), p);
        search = new StructureSearch(flowPlane, p, newFit(p, SEARCHED_ON_BOTH));
        stack = new TrackPlaneStack(sensor, p, newFit(p, TRACKED_ON_BOTH), ended);
    }

    private MetricFit newFit(SofasParameters p, int mostOnBoth) {
        return new MetricFit(sensor.width(), sensor.height(), p.voteCellPx(), LiveEvents.CAPACITY, mostOnBoth);
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
        }
        search.run(stack);
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
        if (looksElsewhere) {
            lone = new LoneEvents(sensor.width(), sensor.height(), next.slowestPxPerS());
            busy = new BusyPixels(sensor.width(), sensor.height(), next);
            flowPlane = new FlowPlane(sensor.width(), sensor.height(), next);
        }
        boolean measuresElsewise = next.voteCellPx() != p.voteCellPx();
        if (looksElsewhere || measuresElsewise) {
            search = new StructureSearch(flowPlane, next, newFit(next, SEARCHED_ON_BOTH));
        } else {
            search.setParameters(next);
        }
        stack.setParameters(next);
        if (measuresElsewise) {
            stack.setFit(newFit(next, TRACKED_ON_BOTH));
        }
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
