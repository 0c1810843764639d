package io.github.sofas.cli;

import io.github.sofas.event.EventBatch;
import io.github.sofas.flow.CausalBatch;
import io.github.sofas.flow.FlowOutput;
import java.io.IOException;
import java.util.Queue;
import java.util.concurrent.ArrayBlockingQueue;
import java.util.concurrent.BlockingQueue;
import java.util.concurrent.ConcurrentLinkedQueue;
import java.util.concurrent.ExecutorService;
import java.util.concurrent.Executors;
import java.util.concurrent.TimeUnit;
import java.util.concurrent.atomic.AtomicBoolean;
import java.util.function.Consumer;

/**
 * Reads, labels and writes the batches of a recording: all in the caller's thread, or with a helper that writes, and
 * does what labelling has for one, or with another one that reads. Where labels look ahead, that is a part of writing.
 * Each step gets all batches in order and one at a time, so that its results are the same however many threads there
 * are.
 */
final class BatchPipeline {
    /** Labelling, helping, reading. */
    static final int MOST_THREADS = 3;
    /** Events labelled at once: few enough to stay in a core's cache from reader to writer. */
    private static final int BATCH = 4096;
    /** Batches on their way: enough that a step that is slow for once holds up nobody. */
    private static final int SLOTS = 8;

    /** A batch on its way from reader to writer. */
    static final class Slot {
        final EventBatch events = new EventBatch(BATCH);
        final FlowOutput flow = new FlowOutput(BATCH);
        /** Where labels look ahead, what they are made from: the writer makes them, of other events than were read. */
        final CausalBatch causal = new CausalBatch();
        /** How much of the file was read when it was filled. */
        long bytesRead;
    }

    /** What is done with a batch. */
    interface Steps {
        /** Fills a batch; false at the end, or at damage. */
        boolean read(Slot slot);

        /** Says who does what labelling has for a helper; not called where there is none. */
        void helpedBy(Consumer<Runnable> helper);

        /** Labels it, in the caller's thread. */
        void label(Slot slot);

        /**
         * Writes it.
         *
         * @throws IOException where it cannot be written; no further batch is read then
         */
        void write(Slot slot) throws IOException;

        /**
         * Writes what is held back when all batches are written.
         *
         * @param slot any
         * @throws IOException where it cannot be written
         */
        void finish(Slot slot) throws IOException;
    }

    private static final Slot END = new Slot();

    private final Steps steps;
    // a place more than there are batches, for the end
    private final BlockingQueue<Slot> free = new ArrayBlockingQueue<>(SLOTS + 1);
    private final BlockingQueue<Slot> filled = new ArrayBlockingQueue<>(SLOTS + 1);
    private final Queue<Slot> labelled = new ConcurrentLinkedQueue<>();
    /** Whether a helper writes, or is asked to. */
    private final AtomicBoolean writing = new AtomicBoolean();
    /** The first fault of reader or writer; all stop then. */
    private volatile Throwable failure;

    private BatchPipeline(Steps steps) {
        this.steps = steps;
    }

    /**
     * Takes all batches through the steps.
     *
     * @param threads 1 to {@value #MOST_THREADS}, the caller's included
     * @throws IOException of the writer
     */
    static void run(Steps steps, int threads) throws IOException, InterruptedException {
        if (threads == 1) {
            Slot slot = new Slot();
            while (steps.read(slot)) {
                steps.label(slot);
                steps.write(slot);
            }
            steps.finish(slot);
        } else {
            new BatchPipeline(steps).runTogether(threads);
        }
    }

    private void runTogether(int threads) throws IOException, InterruptedException {
        for (int i = 0; i < SLOTS; i++) {
            free.add(new Slot());
        }
        ExecutorService helpers = Executors.newFixedThreadPool(threads - 1);
        try {
            if (threads == MOST_THREADS) {
                helpers.submit(this::readAll);
            }
            steps.helpedBy(helpers::execute);
            for (Slot slot = next(threads); slot != END && failure == null; slot = next(threads)) {
                steps.label(slot);
                labelled.add(slot);
                if (writing.compareAndSet(false, true)) {
                    helpers.execute(this::writeWaiting);
                }
            }
            helpers.shutdown();
            awaitEnd(helpers);
            if (failure == null) {
                steps.finish(new Slot());
            }
        } finally {
            // where labelling failed the others still wait; they are not to touch what the caller closes next
            helpers.shutdownNow();
            awaitEnd(helpers);
        }
        if (failure instanceof IOException) {
            throw (IOException) failure;
        } else if (failure instanceof Error) {
            throw (Error) failure;
        } else if (failure != null) {
            throw (RuntimeException) failure;
        }
    }

    private static void awaitEnd(ExecutorService helpers) throws InterruptedException {
        helpers.awaitTermination(Long.MAX_VALUE, TimeUnit.NANOSECONDS);
    }

    private Slot next(int threads) throws InterruptedException {
        if (threads == MOST_THREADS) {
            return filled.take();
        }
        Slot slot = free.take();
        return steps.read(slot) ? slot : END;
    }

    private Void readAll() throws InterruptedException {
        try {
            Slot slot = free.take();
            while (failure == null && steps.read(slot)) {
                filled.put(slot);
                slot = free.take();
            }
        } catch (RuntimeException | Error e) {
            failure = e;
        } finally {
            filled.put(END);
        }
        return null;
    }

    /** Writes what is labelled; after a failure only hands batches back, so that nobody waits for one. */
    private void writeWaiting() {
        do {
            for (Slot slot = labelled.poll(); slot != null; slot = labelled.poll()) {
                try {
                    if (failure == null) {
                        steps.write(slot);
                    }
                } catch (IOException | RuntimeException | Error e) {
                    failure = e;
                }
                free.add(slot);
            }
            writing.set(false);
            // unless another one was labelled just before that, and nobody else was asked
        } while (!labelled.isEmpty() && writing.compareAndSet(false, true));
    }
}
