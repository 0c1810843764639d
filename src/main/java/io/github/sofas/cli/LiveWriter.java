package io.github.sofas.cli;

import io.github.sofas.event.EventBatch;
import io.github.sofas.export.FlowCsvWriter;
import io.github.sofas.flow.FlowOutput;
import io.github.sofas.live.ThreadEnd;
import io.github.sofas.recording.Aedat2Writer;
import java.io.IOException;
import java.io.InterruptedIOException;
import java.util.concurrent.ArrayBlockingQueue;
import java.util.concurrent.BlockingQueue;

/**
 * Writes labelled events on a thread of its own, so that events do not wait for their labels while rows are made and a
 * disk takes its time. What waits is bounded: where writing falls behind for longer, labelling waits for it, and what
 * comes in then is dropped and counted where it comes in.
 */
final class LiveWriter implements AutoCloseable {
    /** A fifth of a second at 1 million events/s, in 7 MB. */
    private static final int BATCHES = 128;
    /** More than a transfer brings at 1 million events/s. */
    private static final int BATCH = 2048;
    private static final Labelled END = new Labelled();

    private final FlowCsvWriter csv;
    private final Aedat2Writer recorder;
    private final BlockingQueue<Labelled> empty = new ArrayBlockingQueue<>(BATCHES);
    private final BlockingQueue<Labelled> filled = new ArrayBlockingQueue<>(BATCHES + 1);
    private final Thread thread = new Thread(this::write, "results");
    private volatile IOException failure;
    private long outputNs;

    /** Events and their labels. */
    static final class Labelled {
        final EventBatch events = new EventBatch(BATCH);
        final FlowOutput flow = new FlowOutput(BATCH);
    }

    /**
     * Starts writing.
     *
     * @param csv takes the rows; not closed here
     * @param recorder takes the events; null for none; not closed here
     */
    LiveWriter(FlowCsvWriter csv, Aedat2Writer recorder) {
        this.csv = csv;
        this.recorder = recorder;
        for (int i = 0; i < BATCHES; i++) {
            empty.add(new Labelled());
        }
        // as long as there is room, the thread that labels goes first
        thread.setPriority(Thread.MIN_PRIORITY);
        thread.start();
    }

    /**
     * A batch to be filled; waits for one while all wait to be written.
     *
     * @throws IOException where something before could not be written
     */
    Labelled empty() throws IOException {
        try {
            Labelled batch = empty.take();
            if (failure != null) {
                throw failure;
            }
            return batch;
        } catch (InterruptedException e) {
            Thread.currentThread().interrupt();
            throw new InterruptedIOException("interrupted while waiting for what is written");
        }
    }

    /** Hands over a batch that {@link #empty} gave. */
    void handOn(Labelled batch) {
        filled.add(batch);
    }

    private void write() {
        try {
            for (Labelled batch = filled.take(); batch != END; batch = filled.take()) {
                // after a failure batches are only given back: the thread that labels must not wait for ever
                if (failure == null) {
                    long startNs = System.nanoTime();
                    write(batch);
                    outputNs += System.nanoTime() - startNs;
                }
                empty.add(batch);
            }
        } catch (InterruptedException e) {
            throw new IllegalStateException("nobody interrupts this thread", e);
        }
    }

    private void write(Labelled batch) {
        try {
            csv.write(batch.events, batch.flow);
            if (recorder != null) {
                recorder.write(batch.events);
            }
        } catch (IOException e) {
            failure = e;
        } catch (RuntimeException e) {
            failure = new IOException("unexpected error: " + e, e);
        }
    }

    /**
     * Writes what was handed over, and returns the time spent on writing, in nanoseconds.
     *
     * @throws IOException where something could not be written
     */
    long finish() throws IOException {
        close();
        if (failure != null) {
            throw failure;
        }
        return outputNs;
    }

    /** Ends the thread after all that was handed over; tells nothing of what could not be written. */
    @Override
    public void close() {
        if (thread.isAlive()) {
            filled.add(END);
        }
        ThreadEnd.await(thread);
    }
}
