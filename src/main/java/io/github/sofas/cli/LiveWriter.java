package io.github.sofas.cli;

import io.github.sofas.event.EventBatch;
import io.github.sofas.flow.FlowOutput;
import io.github.sofas.live.ThreadEnd;
import java.io.IOException;
import java.io.InterruptedIOException;
import java.util.HashSet;
import java.util.List;
import java.util.Set;
import java.util.concurrent.ArrayBlockingQueue;
import java.util.concurrent.BlockingQueue;
import java.util.concurrent.TimeUnit;
import java.util.function.Consumer;

/**
 * Writes labelled events on a thread of its own, so that labelling does not wait for the formatting of rows or for a
 * slow disk. The queue is bounded. If writing falls behind for longer, labelling waits for it. The source then drops
 * and counts the events that come in.
 */
final class LiveWriter implements AutoCloseable {
    /** Batches in the queue: a quarter of a second at 1 million events/s, in 7 MB. */
    private static final int BATCHES = 128;
    /** Events per batch: more than a transfer brings at 1 million events/s. */
    private static final int BATCH = 2048;
    /** Time after which labelled events are on the disk. */
    private static final long FLUSH_NS = 1_000_000_000;
    private static final Labelled END = new Labelled();

    private final List<LiveSink> sinks;
    private final Consumer<String> warn;
    private final Set<LiveSink> failed = new HashSet<>();
    private final BlockingQueue<Labelled> empty = new ArrayBlockingQueue<>(BATCHES);
    private final BlockingQueue<Labelled> filled = new ArrayBlockingQueue<>(BATCHES + 1);
    private final Thread thread = new Thread(this::write, "results");
    private volatile boolean nothingIsWritten;
    private long outputNs;

    /** Events and their labels. */
    static final class Labelled {
        final EventBatch events = new EventBatch(BATCH);
        final FlowOutput flow = new FlowOutput(BATCH);
    }

    /**
     * Starts writing.
     *
     * @param sinks receive the events; not closed here
     * @param warn receives a message as soon as a sink fails
     */
    LiveWriter(List<LiveSink> sinks, Consumer<String> warn) {
        this.sinks = sinks;
        this.warn = warn;
        for (int i = 0; i < BATCHES; i++) {
            empty.add(new Labelled());
        }
        // while the queue has room, the labelling thread has priority
        thread.setPriority(Thread.MIN_PRIORITY);
        thread.start();
    }

    /**
     * Returns a batch to be filled; waits for one while all are queued.
     *
     * @throws IOException if no sink can be written any more
     */
    Labelled empty() throws IOException {
        try {
            Labelled batch = empty.take();
            throwIfNothingIsWritten();
            return batch;
        } catch (InterruptedException e) {
            Thread.currentThread().interrupt();
            throw new InterruptedIOException("interrupted while waiting for what is written");
        }
    }

    /** Queues a batch that {@link #empty} returned. */
    void handOn(Labelled batch) {
        filled.add(batch);
    }

    private void throwIfNothingIsWritten() throws IOException {
        if (nothingIsWritten) {
            throw sinks.get(0).failure();
        }
    }

    private void write() {
        try {
            long flushedNs = System.nanoTime();
            while (true) {
                Labelled batch = filled.poll(FLUSH_NS, TimeUnit.NANOSECONDS);
                if (batch == END) {
                    return;
                }
                long startNs = System.nanoTime();
                if (batch != null) {
                    for (LiveSink sink : sinks) {
                        sink.write(batch.events, batch.flow);
                    }
                    empty.add(batch);
                }
                if (startNs - flushedNs >= FLUSH_NS) {
                    flushedNs = startNs;
                    sinks.forEach(LiveSink::flush);
                }
                outputNs += System.nanoTime() - startNs;
                for (LiveSink sink : sinks) {
                    if (sink.failure() != null && failed.add(sink)) {
                        warn.accept(sink.fault());
                    }
                }
                nothingIsWritten = failed.size() == sinks.size();
            }
        } catch (InterruptedException e) {
            throw new IllegalStateException("nobody interrupts this thread", e);
        }
    }

    /** Writes the queued batches as far as possible, and returns the time spent on writing, in ns. */
    long finish() {
        close();
        return outputNs;
    }

    /** Ends the thread once the queued batches are written; does not report failures to write. */
    @Override
    public void close() {
        if (thread.isAlive()) {
            filled.add(END);
        }
        ThreadEnd.await(thread);
    }
}
