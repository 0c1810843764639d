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
 * Reads, labels and writes the batches of a recording in one to three threads. With one thread, the caller does all of
 * it. With two, a helper writes and does the work that labelling can delegate. With three, another helper reads.
 * Look-ahead is a part of writing. Each step gets all batches in order and one at a time, so that its results do not
 * depend on the number of threads.
 */
final class BatchPipeline {
    /** One thread labels, one helps and writes, one reads. */
    static final int MOST_THREADS = 3;
    /** Events per batch: few enough to stay in a core's cache from reader to writer. */
    private static final int BATCH = 4096;
    /** Batches in the pipeline: enough that an occasional slow step does not hold up the others. */
    private static final int SLOTS = 8;

    /** A batch on its way from reader to writer. */
    static final class Slot {
        final EventBatch events = new EventBatch(BATCH);
        final FlowOutput flow = new FlowOutput(BATCH);
        /** With look-ahead, causal labels. The writer makes the final ones, for other events than were read. */
        final CausalBatch causal = new CausalBatch();
        /** Bytes of the file that were read when the slot was filled. */
        long bytesRead;
    }

    /** The steps that each batch goes through. */
    interface Steps {
        /** Fills a batch; false at the end of the recording or at damage. */
        boolean read(Slot slot);

        /** Sets the helper for work that labelling can delegate; not called if there is no helper. */
        void helpedBy(Consumer<Runnable> helper);

        /** Labels a batch, in the caller's thread. */
        void label(Slot slot);

        /**
         * Writes a batch.
         *
         * @throws IOException if it cannot be written; no further batch is read then
         */
        void write(Slot slot) throws IOException;

        /**
         * Writes the events that were held back, after all batches are written.
         *
         * @param slot any slot; its content does not matter
         * @throws IOException if they cannot be written
         */
        void finish(Slot slot) throws IOException;
    }

    private static final Slot END = new Slot();

    private final Steps steps;
    // one place more than there are batches, for the end
    private final BlockingQueue<Slot> free = new ArrayBlockingQueue<>(SLOTS + 1);
    private final BlockingQueue<Slot> filled = new ArrayBlockingQueue<>(SLOTS + 1);
    private final Queue<Slot> labelled = new ConcurrentLinkedQueue<>();
    /** Whether a helper is writing, or has been asked to. */
    private final AtomicBoolean writing = new AtomicBoolean();
    /** A fault of reader or writer, at which all threads stop; of two at the same time, either. */
    private volatile Throwable failure;

    private BatchPipeline(Steps steps) {
        this.steps = steps;
    }

    /**
     * Runs all batches through the steps.
     *
     * @param threads 1 to {@value #MOST_THREADS}, including the caller's
     * @throws IOException if the writer fails
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
            // if labelling failed, the helpers still wait; they must not touch what the caller closes next
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

    /** Writes the labelled batches. After a failure, only hands them back, so that no thread waits for a free one. */
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
            // a batch may have been labelled just before that, without another helper being asked
        } while (!labelled.isEmpty() && writing.compareAndSet(false, true));
    }
}
