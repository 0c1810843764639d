package io.github.sofas.flow;

import io.github.sofas.event.EventBatch;
import io.github.sofas.event.SensorSize;
import io.github.sofas.flow.motion.MeasuredMotions;
import java.util.List;
import java.util.Objects;
import java.util.function.Consumer;

/**
 * Labels every event of a sensor with its flow and its segment (paper, section Algorithm). An event goes to the track
 * plane that expects it. An event that no track plane expects goes to the flow plane, which finds new structures and
 * makes track planes of them.
 *
 * <pre>{@code
 * Sofas sofas = new Sofas(new SensorSize(240, 180), SofasParameters.defaults());
 * EventBatch batch = new EventBatch(4096);
 * FlowOutput flow = new FlowOutput(batch.capacity());
 * batch.add(timeUs, x, y, polarity); // and more, in order of time
 * sofas.process(batch, flow);        // flow.vxPxPerS[i], flow.vyPxPerS[i], flow.segment[i]
 * }</pre>
 *
 * <p>Results do not depend on how the events are cut into batches, nor on whether another thread helps
 * ({@link #helpedBy}).
 *
 * <p>Any thread may call any method at any time. A call takes effect between two batches, and waits until the current
 * batch is labelled; {@link #setParameters} and {@link #parameters} do not wait. Engines share nothing. Batches and
 * outputs belong to the caller, and no two threads may use the same one at once.
 */
public final class Sofas implements EventLabeller {
    /**
     * Objects, headers of arrays, arrays per projection and per block: everything that does not grow with the events.
     */
    private static final long FIXED_BYTES = 1 << 20;

    private final SensorSize sensor;
    private final Consumer<Segment> ended;
    private final MeasuredMotions measured;
    private Consumer<Runnable> helper;
    /** Parameters that the next batch is to be labelled with; any thread may write them. */
    private volatile SofasParameters parameters;
    private SofasParameters inUse;
    private Method method;
    private long newestUs = Long.MIN_VALUE;
    private long outside;
    private long backwards;

    /**
     * Makes an engine for a sensor.
     *
     * @param sensor size of the pixel array
     * @param parameters parameters to label events with
     */
    public Sofas(SensorSize sensor, SofasParameters parameters) {
        this(sensor, parameters, segment -> { });
    }

    /**
     * Makes an engine that also reports segments when they end.
     *
     * @param sensor size of the pixel array
     * @param parameters parameters to label events with
     * @param ended gets each segment whose track plane was merged into another or removed; called from within
     *     {@link #process} or {@link #reset}, and must not call the engine
     */
    public Sofas(SensorSize sensor, SofasParameters parameters, Consumer<Segment> ended) {
        this(sensor, parameters, ended, (segment, motion) -> { });
    }

    /** Makes an engine that also reports each motion that it measures, with the default preset only. */
    Sofas(SensorSize sensor, SofasParameters parameters, Consumer<Segment> ended, MeasuredMotions measured) {
        this.sensor = sensor;
        this.parameters = parameters;
        this.ended = Objects.requireNonNull(ended, "ended");
        this.measured = measured;
        inUse = parameters;
        method = make(parameters);
    }

    private Method make(SofasParameters p) {
        return p.preset() == SofasParameters.Preset.PAPER ? new PaperMethod(sensor, p, ended)
            : new RefinedMethod(sensor, p, ended, measured);
    }

    /**
     * {@return the upper bound of the memory that an engine holds, in bytes, whatever the events} It is the sum of its
     * arrays, as large as they may grow. For 240 x 180 px it is 126 MB with the default preset and 275 MB with the
     * paper's, with 64 track planes; with one, 67 and 44 MB.
     *
     * <p>With n² projections, P track planes and a sensor of w x h px, {@code default}: 2 n² + 16 bytes for each cell
     * of an accumulator, which has up to w/2 + travel/2 + 3 columns and h/2 + travel/2 + 3 rows, rounded up to powers
     * of two; 45 bytes for each of the 2^20 events that the flow plane holds at most, and 23 for each of the newest 2
     * to 4 events per pixel, at most 2^20; 45 bytes per pixel; three times 8 bytes for each cell of a grid that motion
     * is measured on, and for 8,192 more, and 72 for each of 16,384 events; 16 for each cell of 4 x 4 px of the sensor
     * and of 32 px around it; 4 for each of (w + 24) (h + 24) pixels, 33 for each cell of 8 x 8 px of the sensor and of
     * 16 px around it, and 39 for each of 16,384 events; and for each track plane, and one more, 4 bytes for each of
     * (w + 48) (h + 48) cells and 5 for each of (w/2 + 7) (h/2 + 7), rounded up to powers of two, 18 for each of its
     * 32,768 live events at most, and 42,000 for the places that it was at, what it looked like there, and its pace.
     *
     * <p>{@code paper}: 2 bytes for each cell of the n² accumulators, whose sides are those of the sensor and the
     * travel during the lifespan, rounded up to powers of two, at most 4,096; 9 for each cell of the plane that a
     * structure is refined on, at most 4,098²; and for each track plane 32 bytes for each cell of sensor and farthest
     * travel, and 24 for each of the 65,536 events that its arrays have room for.
     *
     * @param sensor size of the pixel array
     * @param parameters what events are labelled with
     */
    public static long mostBytes(SensorSize sensor, SofasParameters parameters) {
        return FIXED_BYTES + (parameters.preset() == SofasParameters.Preset.PAPER
            ? PaperMethod.mostBytes(sensor, parameters) : RefinedMethod.mostBytes(sensor, parameters));
    }

    /** {@return the sensor that the engine was made for} */
    public SensorSize sensor() {
        return sensor;
    }

    /** {@return the parameters that the next batch is labelled with} */
    public SofasParameters parameters() {
        return parameters;
    }

    /**
     * Uses other parameters from the next batch on; any thread may call this at any time.
     *
     * <p>Segments continue under their ids wherever the change allows it. Where the change affects what the flow plane
     * looks for, the flow plane forgets the events that it holds. Where fewer track planes are allowed, the excess
     * ends. With the paper preset, all segments end if the velocity scale changes, or the size of the accumulators.
     * Another preset begins anew, as {@link #reset} does.
     *
     * @param parameters parameters to label events with
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
            method.helpedBy(helper);
        }
        inUse = wanted;
    }

    /**
     * Labels the events of a batch.
     *
     * <p>An event outside the sensor gets no flow, and {@link #eventsOutside()} counts it. An event whose time steps
     * back is labelled at the newest time so far, and {@link #eventsBackwards()} counts it.
     *
     * @param batch polarity above 0 is ON, any other is OFF
     * @throws IllegalArgumentException if the batch holds more events than the output
     */
    @Override
    public synchronized void process(EventBatch batch, FlowOutput output) {
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
            if (sensor.contains(x, y)) {
                long timeUs = batch.timeUs[i];
                if (timeUs < newestUs) {
                    timeUs = newestUs;
                    backwards++;
                }
                newestUs = timeUs;
                method.label(x, y, timeUs, batch.polarity[i] > 0 ? 1 : -1, output, i);
            } else {
                outside++;
                output.set(i, 0, 0, 0);
            }
        }
    }

    /**
     * {@inheritDoc}
     *
     * <p>With the default preset, the helper searches the flow plane while the next events are labelled. The paper
     * preset makes no use of a helper.
     */
    @Override
    public synchronized void helpedBy(Consumer<Runnable> newHelper) {
        helper = newHelper;
        method.helpedBy(helper);
    }

    /** Segments that are tracked at the newest event. */
    @Override
    public synchronized List<Segment> segments() {
        return method.segments();
    }

    /** {@return the present metrics of the flow plane, for display} */
    public synchronized MetricArray metricArray() {
        return method.metricArray();
    }

    /**
     * Reports the contour of a segment at the newest event: the pixels on which its track plane expects its events.
     * This only reads: results do not depend on it, and it allocates nothing.
     *
     * @param id of one of {@link #segments}; any other id has no pixels
     * @param pixels gets each of its pixels on the sensor, in no particular order and some more than once; must not
     *     call the engine
     */
    public synchronized void contour(int id, PixelConsumer pixels) {
        method.contour(id, newestUs, pixels);
    }

    /** {@return how many events lay outside the sensor since the start or the last reset} */
    public synchronized long eventsOutside() {
        return outside;
    }

    /** {@return how many events were earlier than one before them, since the start or the last reset} */
    public synchronized long eventsBackwards() {
        return backwards;
    }

    /** Forgets all events and segments, as if the engine were new; the living segments end as removed. */
    @Override
    public synchronized void reset() {
        method.reset();
        newestUs = Long.MIN_VALUE;
        outside = 0;
        backwards = 0;
    }
}
