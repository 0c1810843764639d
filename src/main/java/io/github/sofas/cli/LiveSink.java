package io.github.sofas.cli;

import io.github.sofas.event.EventBatch;
import io.github.sofas.export.FlowCsvWriter;
import io.github.sofas.flow.FlowOutput;
import io.github.sofas.recording.Aedat2Writer;
import java.io.Closeable;
import java.io.IOException;
import java.io.RandomAccessFile;
import java.nio.file.Files;
import java.nio.file.Path;

/**
 * One of the files that a live run writes as events come in. After the first failure, nothing more is written to the
 * file, and it is cut back to whole rows or records. The other files continue.
 */
final class LiveSink {
    private static final int LONGEST_ROW = 256;

    private final Path file;
    private final Path temporary;
    private final Writing writing;
    private final Closeable closing;
    private final Flushing flushing;
    private final Whole whole;
    private volatile IOException failure;
    private long events;

    /** Writes a batch. */
    @FunctionalInterface
    private interface Writing {
        void write(EventBatch batch, FlowOutput flow) throws IOException;
    }

    /** Writes buffered data to the file. */
    @FunctionalInterface
    private interface Flushing {
        void flush() throws IOException;
    }

    /** Determines how many bytes of a file are whole rows or records. */
    @FunctionalInterface
    private interface Whole {
        long bytes(Path file) throws IOException;
    }

    private LiveSink(Path file, Path temporary, Writing writing, Flushing flushing, Closeable closing, Whole whole) {
        this.file = file;
        this.temporary = temporary;
        this.writing = writing;
        this.flushing = flushing;
        this.closing = closing;
        this.whole = whole;
    }

    /**
     * Creates a sink for rows with events and labels.
     *
     * @param file final place of the rows
     * @param temporary their place meanwhile
     */
    static LiveSink rows(Path file, Path temporary, FlowCsvWriter csv) {
        return new LiveSink(file, temporary, csv::write, csv::flush, csv::close, LiveSink::wholeLines);
    }

    /** Creates a sink for records of the events, likewise. */
    static LiveSink records(Path file, Path temporary, Aedat2Writer aedat) {
        return new LiveSink(file, temporary, (batch, flow) -> aedat.write(batch), aedat::flush, aedat,
            path -> aedat.wholeBytes(Files.size(path)));
    }

    private static long wholeLines(Path file) throws IOException {
        try (RandomAccessFile bytes = new RandomAccessFile(file.toFile(), "r")) {
            long length = bytes.length();
            long from = Math.max(0, length - LONGEST_ROW);
            byte[] end = new byte[(int) (length - from)];
            bytes.seek(from);
            bytes.readFully(end);
            for (int i = end.length; i > 0; i--) {
                if (end[i - 1] == '\n') {
                    return from + i;
                }
            }
            return from;
        }
    }

    /** Writes a batch, unless writing failed before. */
    void write(EventBatch batch, FlowOutput flow) {
        if (failure != null) {
            return;
        }
        try {
            writing.write(batch, flow);
            events += batch.size();
        } catch (IOException e) {
            failure = e;
        } catch (RuntimeException e) {
            failure = new IOException("unexpected error: " + e, e);
        }
    }

    /** Writes buffered data to the file, where they remain if the program is killed. */
    void flush() {
        try {
            if (failure == null) {
                flushing.flush();
            }
        } catch (IOException e) {
            failure = e;
        }
    }

    /** Closes the file. If not all could be written, cuts it back to whole rows or records. */
    void close() {
        try {
            closing.close();
        } catch (IOException e) {
            failure = failure == null ? e : failure;
        }
        if (failure != null) {
            try (RandomAccessFile bytes = new RandomAccessFile(temporary.toFile(), "rw")) {
                bytes.setLength(whole.bytes(temporary));
            } catch (IOException e) {
                failure.addSuppressed(e);
            }
        }
    }

    /** Why not all was written; null if all was. */
    IOException failure() {
        return failure;
    }

    /** The failure of the file, in words for the user. */
    String fault() {
        return "[" + file + "] cannot be written on: " + FileFailure.text(failure)
            + "; what it holds is whole, of less than the first " + events + " events";
    }
}
