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

    /**
     * The most memory that an engine holds, whatever the events: the sum of its arrays, as large as they may grow, in
     * bytes. For 240 x 180 px it is 78 MB with the default preset and 275 MB with the paper's, with 64 track planes;
     * with one, 42 and 44 MB.
     *
     * <p>With n² projections, P track planes and a sensor of w x h px, {@code default}: 2 n² + 16 bytes for each cell
     * of an accumulator, which has up to w/2 + travel/2 + 3 columns and h/2 + travel/2 + 3 rows, rounded up to powers
     * of two; 33 bytes for each of the 2^20 events that the flow plane holds at most; 8 bytes a pixel; 4 bytes for each
     * cell of the grid that motion is measured on; and for each track plane 4 bytes for each of (w + 48) (h + 48)
     * cells, and 18 for each of its 16,384 live events at most.
     *
     * <p>{@code paper}: 2 bytes for each cell of the n² accumulators, whose sides are those of the sensor and the
     * travel during the lifespan, rounded up to powers of two, at most 4,096; 9 for each cell of the plane that a
     * structure is refined on, at most 4,098²; and for each track plane 32 bytes for each cell of sensor and farthest
     * travel, and 12 for each of the 131,072 events that its arrays have room for.
     */
    public static long mostBytes(SensorSize sensor, SofasParameters parameters) {
        return MemoryBound.bytes(sensor, parameters);
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
