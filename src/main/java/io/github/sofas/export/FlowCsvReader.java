package io.github.sofas.export;

import io.github.sofas.event.EventBatch;
import io.github.sofas.event.EventSourceException;
import io.github.sofas.flow.FlowOutput;
import java.io.Closeable;
import java.io.IOException;
import java.nio.file.Path;

/**
 * Reads the file that {@link FlowCsvWriter} wrote: events with their labels. Used where labelled events are needed
 * again after a run.
 */
public final class FlowCsvReader implements Closeable {
    private final EventCsvReader rows;
    private EventSourceException damage;

    private FlowCsvReader(EventCsvReader rows) {
        this.rows = rows;
    }

    /**
     * Opens a file.
     *
     * @param file written by {@link FlowCsvWriter}
     * @return the reader
     * @throws EventSourceException if the file cannot be read, or if its first line lacks a column of
     *     {@link FlowCsvWriter}
     */
    public static FlowCsvReader open(Path file) throws EventSourceException {
        try {
            return new FlowCsvReader(EventCsvReader.open(file, FlowCsvWriter.ID_COLUMN));
        } catch (IOException e) {
            throw new EventSourceException("[" + file + "] cannot be opened: " + e, e);
        }
    }

    /**
     * Clears the batch and fills it, and the labels beside it, with the rows that follow.
     *
     * @param batch receives the events; its previous events are discarded
     * @param flow receives the labels; has at least the batch's capacity
     * @return false at the end
     * @throws EventSourceException if a row is malformed; every row before it was delivered
     */
    public boolean next(EventBatch batch, FlowOutput flow) throws EventSourceException {
        batch.clear();
        try {
            while (damage == null && !batch.isFull() && rows.next()) {
                rows.requireLineEnd();
                int i = batch.size();
                flow.vxPxPerS[i] = rows.vxPxPerS();
                flow.vyPxPerS[i] = rows.vyPxPerS();
                flow.segment[i] = rows.id();
                batch.add(rows.timeUs(), rows.x(), rows.y(), rows.polarity());
            }
        } catch (EventSourceException e) {
            damage = e;
        } catch (IOException e) {
            damage = rows.wrong("cannot be read: " + e);
        }
        if (batch.size() == 0 && damage != null) {
            throw damage;
        }
        return batch.size() > 0;
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
