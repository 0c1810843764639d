package io.github.sofas.flow;

import io.github.sofas.event.SensorSize;
import io.github.sofas.flow.paper.FlowPlane;
import io.github.sofas.flow.paper.Numbers;
import io.github.sofas.flow.paper.TrackPlane;
import io.github.sofas.flow.paper.TrackPlaneStack;
import java.util.List;
import java.util.function.Consumer;

/**
 * The method as published: nearest cells, signed votes, and a stack of track planes that are asked in turn. An event
 * that no track plane takes goes to the flow plane, which makes new track planes.
 */
final class PaperMethod implements Method {
    private final SensorSize sensor;
    private final TrackPlaneStack stack;
    private Numbers p;
    private FlowPlane flowPlane;

    PaperMethod(SensorSize sensor, SofasParameters parameters, Consumer<Segment> ended) {
        this.sensor = sensor;
        p = Numbers.of(parameters);
        stack = new TrackPlaneStack(sensor, p, ended);
        flowPlane = new FlowPlane(sensor.width(), sensor.height(), p);
    }

    static long mostBytes(SensorSize sensor, SofasParameters parameters) {
        Numbers p = Numbers.of(parameters);
        return FlowPlane.mostBytes(sensor, p) + TrackPlaneStack.mostBytes(sensor, p);
    }

    @Override
    public void label(int x, int y, long timeUs, int polarity, FlowOutput output, int i) {
        TrackPlane plane = stack.offer(x, y, timeUs);
        if (plane != null) {
            output.set(i, plane.id(), plane.vxPxPerS(), plane.vyPxPerS());
            return;
        }
        output.set(i, 0, 0, 0);
        if (flowPlane.add(x, y, timeUs, polarity)) {
            stack.add(flowPlane.structure());
            flowPlane.release();
        }
    }

    @Override
    public void setParameters(SofasParameters parameters) {
        Numbers next = Numbers.of(parameters);
        stack.setParameters(next);
        if (next.velocityScalePxPerS() == p.velocityScalePxPerS() && next.flowProjections() == p.flowProjections()
                && next.lifespanUs() == p.lifespanUs()) {
            flowPlane.setParameters(next);
        } else {
            flowPlane = new FlowPlane(sensor.width(), sensor.height(), next);
        }
        p = next;
    }

    @Override
    public List<Segment> segments() {
        return stack.segments();
    }

    @Override
    public MetricArray metricArray() {
        return new MetricArray(SofasParameters.Preset.PAPER, p.flowProjections(), flowPlane.metricsPerEvent());
    }

    @Override
    public void contour(int id, long nowUs, PixelConsumer pixels) {
        stack.contour(id, nowUs, pixels);
    }

    @Override
    public void reset() {
        stack.reset();
        flowPlane.reset();
    }
}
