package io.github.sofas.flow;

import io.github.sofas.event.EventBatch;
import io.github.sofas.event.SensorSize;
import java.util.ArrayList;
import java.util.List;
import java.util.function.Consumer;

/**
 * Labels every event of a sensor with flow and segment (paper, section Algorithm): an event goes to the track plane
 * that expects it, else to the flow plane, which makes new track planes.
 *
 * <p>One thread at a time. Results do not depend on how the events are cut into batches.
 */
public final class Sofas {
    private final SensorSize sensor;
    private final SofasParameters p;
    private final TrackPlaneStack stack;
    private final FlowPlane flow;
    private final MetricFit fit;
    private long now = Long.MIN_VALUE;

    /** Makes an engine for a sensor. */
    public Sofas(SensorSize sensor, SofasParameters parameters) {
        this(sensor, parameters, s -> { });
    }

    /** Makes an engine that reports each segment when it ends. */
    public Sofas(SensorSize sensor, SofasParameters parameters, Consumer<Segment> ended) {
        this.sensor = sensor;
        p = parameters;
        fit = new MetricFit(sensor.width(), sensor.height(), parameters.sampleEvents());
        flow = new FlowPlane(sensor.width(), sensor.height(), parameters, fit);
        stack = new TrackPlaneStack(sensor, parameters, fit, ended);
    }

    /** Labels the events of a batch; entry i of the output belongs to event i. */
    public void process(EventBatch batch, FlowOutput out) {
        int n = batch.size();
        for (int i = 0; i < n; i++) {
            long t = Math.max(now, batch.timeUs[i]);
            now = t;
            int x = batch.x[i];
            int y = batch.y[i];
            int s = batch.polarity[i];
            out.segment[i] = 0;
            out.vxPxPerS[i] = 0;
            out.vyPxPerS[i] = 0;
            if (!sensor.contains(x, y)) {
                continue;
            }
            stack.advance(t);
            TrackPlane plane = stack.match(x, y, t, s);
            if (plane != null) {
                out.segment[i] = plane.id;
                double dt = (t - plane.t0) * 1e-6;
                out.vxPxPerS[i] = (float) (plane.vx + plane.ax * dt);
                out.vyPxPerS[i] = (float) (plane.vy + plane.ay * dt);
                stack.assign(plane, x, y, t, s);
            } else {
                flow.add(x, y, t, s);
            }
            if (flow.blockFull(t)) {
                flow.settle(t);
                flow.search(t, stack);
            }
        }
    }

    /** The living segments. */
    public List<Segment> segments() {
        return new ArrayList<>(stack.segments());
    }

    /** Forgets every event and segment. */
    public void reset() {
        flow.reset();
        stack.reset();
        now = Long.MIN_VALUE;
    }
}
