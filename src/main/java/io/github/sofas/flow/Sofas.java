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
 * <p>Results do not depend on how the events are cut into batches. One thread at a time.
 */
public final class Sofas implements EventLabeller {
    private final SensorSize sensor;
    private final SofasParameters parameters;
    private final Method method;
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
        Objects.requireNonNull(ended, "ended");
        method = parameters.preset() == SofasParameters.Preset.PAPER
            ? new PaperMethod(sensor, parameters, ended) : new RefinedMethod(sensor, parameters, ended);
    }

    /** The sensor that the engine was made for. */
    public SensorSize sensor() {
        return sensor;
    }

    /** The parameters that the engine was made with. */
    public SofasParameters parameters() {
        return parameters;
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
