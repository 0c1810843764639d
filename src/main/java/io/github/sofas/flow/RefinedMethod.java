package io.github.sofas.flow;

import io.github.sofas.event.SensorSize;
import io.github.sofas.flow.fit.MetricFit;
import io.github.sofas.flow.motion.MeasuredMotions;
import io.github.sofas.flow.search.BusyPixels;
import io.github.sofas.flow.search.FlowPlane;
import io.github.sofas.flow.search.LoneEvents;
import io.github.sofas.flow.search.StructureSearch;
import io.github.sofas.flow.track.TrackPlaneStack;
import java.util.List;
import java.util.function.Consumer;

/**
 * The method of the {@code default} preset: the paper's nouns, made accurate and fast. An event goes to the track plane
 * that expects it, else to the flow plane; what the search finds there becomes a track plane.
 */
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

    RefinedMethod(SensorSize sensor, SofasParameters p, Consumer<Segment> ended, MeasuredMotions measured) {
        this.sensor = sensor;
        this.p = p;
        lone = new LoneEvents(sensor.width(), sensor.height(), p.search().slowestPxPerS());
        busy = new BusyPixels(sensor.width(), sensor.height(), p.search());
        flowPlane = new FlowPlane(sensor.width(), sensor.height(), p.search());
        stack = new TrackPlaneStack(sensor, p.track(), newFit(TRACKED_ON_BOTH), ended, measured);
        search = newSearch(p);
    }

    private StructureSearch newSearch(SofasParameters p) {
        return new StructureSearch(flowPlane, p.search(), newFit(SEARCHED_ON_BOTH), new StackedStructures(stack),
            stack.votes());
    }

    private MetricFit newFit(int mostOnBoth) {
        return new MetricFit(sensor.width(), sensor.height(), MetricFit.CELL_PX, TrackPlaneStack.MOST_MEASURED,
            mostOnBoth);
    }

    static long mostBytes(SensorSize sensor, SofasParameters p) {
        long fit = MetricFit.bytes(sensor.width(), sensor.height(), MetricFit.CELL_PX,
            TrackPlaneStack.MOST_MEASURED);
        return LoneEvents.bytes(sensor) + BusyPixels.bytes(sensor) + StructureSearch.mostBytes(sensor, p.search())
            + TrackPlaneStack.mostBytes(sensor, p.track()) + 2 * fit;
    }

    @Override
    public void label(int x, int y, long timeUs, int polarity, FlowOutput output, int i) {
        stack.check(timeUs);
        if (!stack.label(x, y, timeUs, polarity, output, i) && !lone.isAlone(x, y, timeUs)
                && !busy.isBusy(x, y, timeUs)) {
            flowPlane.add(x, y, timeUs, polarity);
        }
        if (flowPlane.isToSettle(timeUs)) {
            flowPlane.settle(timeUs);
        }
        search.run(stack.votes());
    }

    @Override
    public void setParameters(SofasParameters next) {
        SofasParameters.Search from = p.search();
        SofasParameters.Search to = next.search();
        if (to.flowProjections() != from.flowProjections() || to.slowestPxPerS() != from.slowestPxPerS()
                || to.fastestPxPerS() != from.fastestPxPerS() || to.lifespanUs() != from.lifespanUs()) {
            lone = new LoneEvents(sensor.width(), sensor.height(), to.slowestPxPerS());
            busy = new BusyPixels(sensor.width(), sensor.height(), to);
            flowPlane = new FlowPlane(sensor.width(), sensor.height(), to);
            search = newSearch(next);
        } else {
            search.setParameters(to);
        }
        stack.setParameters(next.track());
        p = next;
    }

    @Override
    public List<Segment> segments() {
        return stack.segments();
    }

    @Override
    public MetricArray metricArray() {
        return new MetricArray(SofasParameters.Preset.DEFAULT, p.search().flowProjections(),
            flowPlane.metricsPerEvent());
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
