package io.github.sofas.flow;

import io.github.sofas.event.EventBatch;
import io.github.sofas.event.SensorSize;
import java.util.List;
import java.util.Objects;
import java.util.function.Consumer;

/**
 * Labels every event of a sensor with flow and segment (paper, section Algorithm): an event goes to the track plane
 * that expects it, else to the flow plane, which makes new track planes.
 *
 * <pre>{@code
 * Sofas sofas = new Sofas(new SensorSize(240, 180), SofasParameters.defaults());
 * EventBatch batch = new EventBatch(4096);
 * FlowOutput flow = new FlowOutput(batch.capacity());
 * batch.add(timeUs, x, y, polarity); // and more, in order of time
 * sofas.process(batch, flow);        // flow.vxPxPerS[i], flow.vyPxPerS[i], flow.segment[i]
 * }</pre>
 *
 * <p>Results do not depend on how the events are cut into batches. One thread at a time, but for
 * {@link #setParameters}.
 */
public final class Sofas implements EventLabeller {
    private final SensorSize sensor;
    private final Consumer<Segment> ended;
    /** What the next batch is to be labelled with; any thread may write it. */
    private volatile SofasParameters parameters;
    private SofasParameters inUse;
    private Method method;
    private long newestUs = Long.MIN_VALUE;
    private long outside;
    private long backwards;

    /** Makes an engine for a sensor. */
    public Sofas(SensorSize sensor, SofasParameters parameters) {
        this(sensor, parameters, segment -> { });
    }

    /**
     * Makes an engine that also reports segments when they end.
     *
     * @param ended gets each segment whose track plane was merged into another or removed, from within
     *     {@link #process} or {@link #reset}; it must not call the engine
     */
    public Sofas(SensorSize sensor, SofasParameters parameters, Consumer<Segment> ended) {
        this.sensor = sensor;
        this.parameters = parameters;
        this.ended = Objects.requireNonNull(ended, "ended");
        inUse = parameters;
        method = make(parameters);
    }

    private Method make(SofasParameters p) {
        return p.preset() == SofasParameters.Preset.PAPER ? new PaperMethod(sensor, p, ended)
            : new RefinedMethod(sensor, p, ended);
    }

    /** The sensor that the engine was made for. */
    public SensorSize sensor() {
        return sensor;
    }

    /** The parameters that the next batch is labelled with. */
    public SofasParameters parameters() {
        return parameters;
    }

    /**
     * Labels from the next batch on with other parameters; any thread may ask for it at any time.
     *
     * <p>Segments are tracked on under their ids wherever the change allows it. Where it changes what the flow plane
     * looks for, the events that wait there are forgotten; where fewer track planes are allowed, the excess ends; of
     * the paper preset, all segments end where the velocity scale changes or the size of its accumulators. Another
     * preset begins anew, as {@link #reset} does.
     */
    public void setParameters(SofasParameters parameters) {
        this.parameters = Objects.requireNonNull(parameters, "parameters");
    }

    private void take(SofasParameters wanted) {
        if (wanted.preset() == inUse.preset()) {
            method.setParameters(wanted);
        } else {
            reset();
            method = make(wanted);
        }
        inUse = wanted;
    }

    /**
     * Labels the events of a batch.
     *
     * <p>An event outside the sensor gets no flow and is counted by {@link #eventsOutside()}. Time that steps back is
     * taken as the newest time so far, and counted by {@link #eventsBackwards()}.
     *
     * @param batch polarity above 0 is ON, any other OFF
     * @throws IllegalArgumentException where the batch holds more events than the output
     */
    @Override
    public void process(EventBatch batch, FlowOutput output) {
        int n = batch.size();
        if (n > output.capacity()) {
            throw new IllegalArgumentException("output must hold " + n + " events but holds " + output.capacity());
        }
        SofasParameters wanted = parameters;
        if (wanted != inUse) {
            take(wanted);
        }
        for (int i = 0; i < n; i++) {
            int x = batch.x[i];
            int y = batch.y[i];
            int segment = 0;
            if (sensor.contains(x, y)) {
                long timeUs = batch.timeUs[i];
                if (timeUs < newestUs) {
                    timeUs = newestUs;
                    backwards++;
                }
                newestUs = timeUs;
                segment = method.label(x, y, timeUs, batch.polarity[i] > 0 ? 1 : -1);
            } else {
                outside++;
            }
            output.segment[i] = segment;
            output.vxPxPerS[i] = segment == 0 ? 0 : method.vxPxPerS();
            output.vyPxPerS[i] = segment == 0 ? 0 : method.vyPxPerS();
        }
    }

    /** Segments that are tracked at the newest event. */
    @Override
    public List<Segment> segments() {
        return method.segments();
    }

    /** The metrics of the flow plane as they are now, to be shown; from the thread that labels. */
    public MetricArray metricArray() {
        return method.metricArray();
    }

    /** How many events lay outside the sensor since the start or the last reset. */
    public long eventsOutside() {
        return outside;
    }

    /** How many events were earlier than one before them, since the start or the last reset. */
    public long eventsBackwards() {
        return backwards;
    }

    /** Forgets all events and segments, as if made anew; the living segments end as removed. */
    @Override
    public void reset() {
        method.reset();
        newestUs = Long.MIN_VALUE;
        outside = 0;
        backwards = 0;
    }
}
