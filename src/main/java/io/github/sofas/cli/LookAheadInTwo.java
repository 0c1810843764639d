package io.github.sofas.cli;

import io.github.sofas.event.EventBatch;
import io.github.sofas.flow.CausalBatch;
import io.github.sofas.flow.FlowOutput;
import io.github.sofas.flow.Labelling;
import io.github.sofas.flow.Segment;
import io.github.sofas.flow.SmoothedSofas;
import java.util.ArrayDeque;
import java.util.List;
import java.util.Queue;
import java.util.concurrent.ExecutionException;
import java.util.concurrent.ExecutorService;
import java.util.concurrent.Executors;
import java.util.concurrent.Future;

/**
 * Labels with look-ahead in two threads. One thread runs the engine on the newest batches. Meanwhile, the caller's
 * thread looks at the engine's results for earlier batches from both sides: at what came before and after an event.
 * Which thread is faster affects neither the labels nor the batch with which each is given back.
 */
final class LookAheadInTwo implements Labelling, AutoCloseable {
    /** Batches by which the engine may be ahead: looking from both sides takes long at the end of a time slice. */
    private static final int AHEAD = 4;

    private final SmoothedSofas sofas;
    private final ExecutorService engine = Executors.newSingleThreadExecutor();
    private final Queue<Step> underWay = new ArrayDeque<>();
    private final Queue<Step> free = new ArrayDeque<>();

    /** A batch that the engine is labelling or has labelled. */
    private static final class Step {
        private EventBatch events = new EventBatch(1);
        private final CausalBatch causal = new CausalBatch();
        private Future<?> labelled;

        void fill(EventBatch batch) {
            if (events.capacity() < batch.size()) {
                events = new EventBatch(batch.size());
            }
            events.clear();
            events.addAll(batch, 0, batch.size());
        }
    }

    /**
     * Creates a labelling in two threads.
     *
     * @param sofas engine for the events' sensor; nobody else uses it until this object is closed
     */
    LookAheadInTwo(SmoothedSofas sofas) {
        this.sofas = sofas;
    }

    @Override
    public void add(EventBatch batch) {
        Step step = free.isEmpty() ? new Step() : free.remove();
        step.fill(batch);
        step.labelled = engine.submit(() -> sofas.label(step.events, step.causal));
        underWay.add(step);
        lookBack(AHEAD);
    }

    /** Looks at the engine's results until at most {@code ahead} batches are under way. */
    private void lookBack(int ahead) {
        while (underWay.size() > ahead) {
            Step step = underWay.remove();
            await(step.labelled);
            sofas.add(step.causal);
            free.add(step);
        }
    }

    private static void await(Future<?> labelled) {
        try {
            labelled.get();
        } catch (ExecutionException e) {
            if (e.getCause() instanceof Error) {
                throw (Error) e.getCause();
            }
            throw new IllegalStateException(e.getCause());
        } catch (InterruptedException e) {
            Thread.currentThread().interrupt();
            throw new IllegalStateException("interrupted while a batch was labelled", e);
        }
    }

    @Override
    public void finish() {
        lookBack(0);
        sofas.finish();
    }

    @Override
    public boolean next(EventBatch batch, FlowOutput flow) {
        return sofas.next(batch, flow);
    }

    @Override
    public List<Segment> segments() {
        lookBack(0);
        return sofas.segments();
    }

    @Override
    public void close() {
        engine.shutdownNow();
    }
}
