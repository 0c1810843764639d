package io.github.sofas.export;

import io.github.sofas.event.EventBatch;
import io.github.sofas.event.EventSourceException;
import io.github.sofas.flow.FlowOutput;
import java.io.Closeable;
import java.io.IOException;
import java.nio.file.Path;

/** Reads the rows that {@link FlowCsvWriter} wrote, events with their labels. */
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
     * @throws EventSourceException where it cannot be read, or begins with another line than {@link FlowCsvWriter}'s
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
     * @param batch is filled; what it held is forgotten
     * @param flow of the batch's capacity at least
     * @return false at the end
     * @throws EventSourceException where a row is malformed; every row before it was delivered
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
