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
 * {@link Sofas} with look-ahead: the label of an event also depends on the events that follow it. A motion that the
 * engine measures over a window is taken for the window's middle, so that velocities do not lag. The events by which a
 * structure was found are labelled with that structure. An event that several structures may have goes to the one along
 * whose motion its edge came and went ({@link io.github.sofas.flow.smooth.Smoother}).
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
 * <p>An event is given back once 1.25 times the look-ahead has passed in the time of the events, or earlier where a
 * quarter of the look-ahead holds more than {@value Smoother#MOST_EVENTS} events. Memory is therefore bounded: at most
 * 64 MB beyond that of the engine, if events are taken as soon as they can be. Labels depend on the events only.
 *
 * <p>For one thread at a time, or for two. {@link #label} runs the engine. One other thread may meanwhile call
 * {@link #add(CausalBatch)}, {@link #finish} and {@link #next}, which look at the results from both sides. The labels
 * are the same either way. Instances share nothing.
 */
public final class SmoothedSofas implements Labelling {
    /** Shortest look-ahead in µs. */
    public static final long MIN_LOOK_AHEAD_US = 4_000;
    /** Longest look-ahead in µs. */
    public static final long MAX_LOOK_AHEAD_US = 10_000_000;

    private static final int PART = 4096;

    // the first step: labelling as a camera would
    private final Sofas sofas;
    private final SliceClock clock;
    private final EventBatch part = new EventBatch(PART);
    private final FlowOutput causal = new FlowOutput(PART);
    private long newestUs = Long.MIN_VALUE;
    /** Takes what the engine finds. */
    private CausalBatch found;
    // the second step: looking from both sides
    private final Smoother smoother;
    private final SmoothedSegments segments;
    /** Hands results from the first step to the second where one call does both. */
    private final CausalBatch own = new CausalBatch();

    /**
     * Makes an engine with look-ahead.
     *
     * @param sensor size of the pixel array
     * @param parameters of the {@code default} preset
     * @param lookAheadUs time after an event that its label may depend on, in µs, {@value #MIN_LOOK_AHEAD_US} to
     *     {@value #MAX_LOOK_AHEAD_US}
     * @throws IllegalArgumentException if the preset is another one, or the look-ahead is outside its range
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
     * @param ended gets each segment that ended, once all of its events can be taken; called from within
     *     {@link #next}, and must not call the engine
     * @throws IllegalArgumentException if the preset is another one, or the look-ahead is outside its range
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
     * {@return the upper bound of the memory that is held, in bytes, whatever the events and the look-ahead} It is the
     * memory of the engine and, if events are taken as soon as they can be, that of the look-ahead: at most 64 MB more
     * on a sensor of 346 x 260 px, most of it for a million events.
     *
     * @param sensor size of the pixel array
     * @param parameters of the {@code default} preset
     */
    public static long mostBytes(SensorSize sensor, SofasParameters parameters) {
        return Sofas.mostBytes(sensor, parameters) + Smoother.mostBytes(sensor);
    }

    /**
     * Has a helper do a part of the engine's work beside the labelling thread, as {@link Sofas#helpedBy} does.
     *
     * @param helper runs the tasks that it is given, in another thread; null for none
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
     * Labels events as a camera would: the first of the two steps that {@link #add(EventBatch)} does at once.
     *
     * @param batch events that are not earlier than those before; an event outside the sensor gets no flow
     * @param to gets the input of the second step; up to a few thousand of the newest events are handed over later
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
     * Looks at labelled events from both sides: the second of the two steps.
     *
     * @param labelled results of {@link #label}, batch after batch
     */
    public void add(CausalBatch labelled) {
        labelled.replay(smoother::add);
    }

    /** {@inheritDoc} With two threads, call it once the first step is over and all of its results were added. */
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
     * Segments that are tracked at the newest event, each with the events of it that were given back. With two threads,
     * call it once the first step is over.
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
