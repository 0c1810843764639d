package io.github.sofas.flow;

import io.github.sofas.event.EventBatch;
import io.github.sofas.event.SensorSize;
import io.github.sofas.flow.motion.Motion;
import io.github.sofas.flow.smooth.SliceClock;
import io.github.sofas.flow.smooth.Smoother;
import java.util.List;
import java.util.Objects;
import java.util.function.Consumer;

/**
 * {@link Sofas} with look-ahead: labels of events that know what came after them. What the engine measures over a
 * window is taken for the window's middle, so that velocities do not lag; the events by which a structure was found are
 * labelled with it; and where several structures may have an event, it goes to the one along whose motion its edge came
 * and went ({@link io.github.sofas.flow.smooth.Smoother}).
 *
 * <pre>{@code
 * SmoothedSofas sofas = new SmoothedSofas(sensor, SofasParameters.defaults(), 200_000);
 * while (source.next(batch)) {
 *     sofas.add(batch);
 *     while (sofas.next(earlier, flow)) { ... } // flow.vxPxPerS[i], ... of event i of the batch earlier
 * }
 * sofas.finish();                               // and next() for the rest
 * }</pre>
 *
 * <p>An event is given back once the look-ahead and a quarter of it have passed in the time of the events, and earlier
 * where there are more than {@value Smoother#MOST_EVENTS} events in a quarter of the look-ahead: memory is bounded, by
 * 64 MB beyond that of the engine where events are taken as soon as they can be. Labels depend on the events only.
 *
 * <p>For one thread at a time, or for two: {@link #label} runs the engine, and what it gives is looked at from both
 * sides by {@link #add(CausalBatch)}, {@link #finish} and {@link #next}, which one other thread may call meanwhile. The
 * labels are the same. Instances share nothing.
 */
public final class SmoothedSofas implements Labelling {
    /** Shortest look-ahead in µs. */
    public static final long MIN_LOOK_AHEAD_US = 4_000;
    /** Longest look-ahead in µs. */
    public static final long MAX_LOOK_AHEAD_US = 10_000_000;

    private static final int PART = 4096;

    // of the first step
    private final Sofas sofas;
    private final SliceClock clock;
    private final EventBatch part = new EventBatch(PART);
    private final FlowOutput causal = new FlowOutput(PART);
    private long newestUs = Long.MIN_VALUE;
    /** What the engine finds goes there. */
    private CausalBatch found;
    // of the second
    private final Smoother smoother;
    private final SmoothedSegments segments;
    /** Hands the first step's results to the second where both are one. */
    private final CausalBatch own = new CausalBatch();

    /**
     * Makes an engine with look-ahead.
     *
     * @param sensor size of the pixel array
     * @param parameters of the {@code default} preset
     * @param lookAheadUs time after an event that its label may depend on, in µs, {@value #MIN_LOOK_AHEAD_US} to
     *     {@value #MAX_LOOK_AHEAD_US}
     * @throws IllegalArgumentException where the preset is another, or the look-ahead is outside its range
     */
    public SmoothedSofas(SensorSize sensor, SofasParameters parameters, long lookAheadUs) {
        this(sensor, parameters, lookAheadUs, segment -> { });
    }

    /**
     * Makes an engine with look-ahead that also reports segments that ended.
     *
     * @param sensor size of the pixel array
     * @param parameters of the {@code default} preset
     * @param lookAheadUs time after an event that its label may depend on, in µs, {@value #MIN_LOOK_AHEAD_US} to
     *     {@value #MAX_LOOK_AHEAD_US}
     * @param ended gets each segment that ended, once all of its events can be taken, from within {@link #next}; it
     *     must not call the engine
     * @throws IllegalArgumentException where the preset is another, or the look-ahead is outside its range
     */
    public SmoothedSofas(SensorSize sensor, SofasParameters parameters, long lookAheadUs, Consumer<Segment> ended) {
        if (parameters.preset() != SofasParameters.Preset.DEFAULT) {
            throw new IllegalArgumentException("preset must be default where there is a look-ahead but was paper");
        }
        if (lookAheadUs < MIN_LOOK_AHEAD_US || lookAheadUs > MAX_LOOK_AHEAD_US) {
            throw new IllegalArgumentException("lookAheadUs must be " + MIN_LOOK_AHEAD_US + " to " + MAX_LOOK_AHEAD_US
                + " but was " + lookAheadUs);
        }
        smoother = new Smoother(sensor, parameters.track(), lookAheadUs);
        segments = new SmoothedSegments(smoother, Objects.requireNonNull(ended, "ended"));
        clock = new SliceClock(lookAheadUs);
        sofas = new Sofas(sensor, parameters, segment -> found.add(() -> segments.end(segment)), this::find);
    }

    /**
     * {@return the upper bound of the memory that is held, in bytes, whatever the events and the look-ahead} It is that
     * of the engine and, where events are taken as soon as they can be, at most 64 MB more on a sensor of 346 x 260 px:
     * 37 bytes for each of 2^20 events, and 28 for each pixel, 12 more for each of 655,360 events and what is measured
     * of them.
     *
     * @param sensor size of the pixel array
     * @param parameters of the {@code default} preset
     */
    public static long mostBytes(SensorSize sensor, SofasParameters parameters) {
        return Sofas.mostBytes(sensor, parameters) + Smoother.mostBytes(sensor);
    }

    /**
     * Has a part of the engine's work done beside the thread that labels, as {@link Sofas#helpedBy} does.
     *
     * @param helper runs what it is given, in another thread; null for none
     */
    public void helpedBy(Consumer<Runnable> helper) {
        sofas.helpedBy(helper);
    }

    @Override
    public void add(EventBatch batch) {
        for (int from = 0; from < batch.size(); from += PART) {
            label(batch, from, Math.min(batch.size(), from + PART), own);
            add(own);
        }
    }

    /**
     * The first of two steps that {@link #add(EventBatch)} does at once: labels events as a camera would.
     *
     * @param batch events that are not earlier than those before; one outside the sensor gets no flow
     * @param to gets what the second step needs; up to a few thousand of the newest events are handed over later
     */
    public void label(EventBatch batch, CausalBatch to) {
        label(batch, 0, batch.size(), to);
    }

    private void label(EventBatch batch, int from, int until, CausalBatch to) {
        to.clear();
        for (int i = from; i < until; i++) {
            newestUs = Math.max(newestUs, batch.timeUs[i]);
            if (clock.begins(newestUs)) {
                labelPart(to);
                long us = newestUs;
                to.add(() -> smoother.endSlices(us));
            } else if (part.isFull()) {
                labelPart(to);
            }
            part.add(batch.timeUs[i], batch.x[i], batch.y[i], batch.polarity[i]);
        }
    }

    private void labelPart(CausalBatch to) {
        found = to;
        sofas.process(part, causal);
        to.add(part, causal);
        part.clear();
    }

    private void find(int segment, Motion motion) {
        Motion measured = new Motion();
        measured.copyFrom(motion);
        found.add(() -> {
            segments.begin(segment);
            smoother.add(segment, measured);
        });
    }

    /**
     * The second of two steps: looks at labelled events from both sides.
     *
     * @param labelled what {@link #label} gave, batch after batch
     */
    public void add(CausalBatch labelled) {
        labelled.replay(smoother::add);
    }

    /**
     * {@inheritDoc} Where there are two threads, the first step is over by then, and all that it gave was added.
     */
    @Override
    public void finish() {
        own.clear();
        labelPart(own);
        add(own);
        smoother.finish();
    }

    @Override
    public boolean next(EventBatch batch, FlowOutput flow) {
        boolean given = smoother.take(batch, flow);
        segments.give(batch, flow);
        return given;
    }

    /**
     * Segments that are tracked at the newest event, with the events that were given back of them. Where there are two
     * threads, the first step is over by then.
     */
    @Override
    public List<Segment> segments() {
        return segments.living(sofas.segments());
    }

    /** {@return how many events lay outside the sensor} */
    public long eventsOutside() {
        return sofas.eventsOutside();
    }

    /** {@return how many events were earlier than one before them} */
    public long eventsBackwards() {
        return sofas.eventsBackwards();
    }
}
