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
 * Writes labelled events on a thread of its own, so that events do not wait for their labels while rows are made and a
 * disk takes its time. What waits is bounded: where writing falls behind for longer, labelling waits for it, and what
 * comes in then is dropped and counted where it comes in.
 */
final class LiveWriter implements AutoCloseable {
    /** A fifth of a second at 1 million events/s, in 7 MB. */
    private static final int BATCHES = 128;
    /** More than a transfer brings at 1 million events/s. */
    private static final int BATCH = 2048;
    /** What was caught is on the disk after so long. */
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
     * @param sinks take the events; not closed here
     * @param warn is told at once which of them cannot be written on
     */
    LiveWriter(List<LiveSink> sinks, Consumer<String> warn) {
        this.sinks = sinks;
        this.warn = warn;
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
     * @throws IOException where nothing more can be written anywhere
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

    /** Hands over a batch that {@link #empty} gave. */
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

    /** Writes what was handed over, as far as it can be, and returns the time spent on writing, in nanoseconds. */
    long finish() {
        close();
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
