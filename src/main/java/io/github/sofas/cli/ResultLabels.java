package io.github.sofas.cli;

import io.github.sofas.event.EventBatch;
import io.github.sofas.event.EventSourceException;
import io.github.sofas.export.EventCsvReader;
import io.github.sofas.flow.EventLabeller;
import io.github.sofas.flow.FlowOutput;
import java.io.Closeable;
import java.io.IOException;
import java.nio.file.Path;

/**
 * Labels from a file, written by this program or another, in place of a method. The file must have one row per event of
 * the recording, in order. A row of another event ends the labelling with a {@link MismatchException}.
 */
final class ResultLabels implements EventLabeller, Closeable {
    private static final String ID_COLUMN = "segment";

    private final EventCsvReader rows;
    private long events;

    /** The labels are not those of the recording, or cannot be read; the message names the line. */
    static final class MismatchException extends RuntimeException {
        private static final long serialVersionUID = 1L;

        MismatchException(Exception cause) {
            super(cause.getMessage(), cause);
        }
    }

    private ResultLabels(EventCsvReader rows) {
        this.rows = rows;
    }

    /**
     * Opens a file.
     *
     * @throws EventSourceException if it does not have the columns of a flow file
     * @throws IOException if it cannot be read
     */
    static ResultLabels open(Path file) throws EventSourceException, IOException {
        return new ResultLabels(EventCsvReader.open(file, ID_COLUMN));
    }

    @Override
    public void process(EventBatch batch, FlowOutput output) {
        try {
            for (int i = 0; i < batch.size(); i++, events++) {
                if (!rows.next()) {
                    throw rows.wrong(mustBe(batch, i) + "but the file ends");
                }
                if (rows.timeUs() != batch.timeUs[i] || rows.x() != batch.x[i] || rows.y() != batch.y[i]
                        || rows.polarity() != batch.polarity[i]) {
                    throw rows.wrong(mustBe(batch, i) + "but was (" + text(rows.timeUs(), rows.x(), rows.y(),
                        rows.polarity()) + ")");
                }
                output.segment[i] = rows.id();
                output.vxPxPerS[i] = rows.vxPxPerS();
                output.vyPxPerS[i] = rows.vyPxPerS();
            }
        } catch (EventSourceException | IOException e) {
            throw new MismatchException(e);
        }
    }

    private String mustBe(EventBatch batch, int i) {
        return "must be event " + events + " of the recording (" + text(batch.timeUs[i], batch.x[i], batch.y[i],
            batch.polarity[i]) + ") ";
    }

    private static String text(long timeUs, int x, int y, int polarity) {
        return "t_us " + timeUs + ", x " + x + ", y " + y + ", polarity " + polarity;
    }

    /** Not possible: a file is read once. */
    @Override
    public void reset() {
        throw new IllegalStateException("labels of a file are read once");
    }

    @Override
    public void close() {
        try {
            rows.close();
        } catch (IOException e) {
            // Nothing was written, so a failure to close loses nothing.
            return;
        }
    }
}
