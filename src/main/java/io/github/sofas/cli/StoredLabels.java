package io.github.sofas.cli;

import io.github.sofas.event.EventBatch;
import io.github.sofas.event.EventSource;
import io.github.sofas.event.EventSourceException;
import io.github.sofas.export.FlowCsvReader;
import io.github.sofas.flow.FlowOutput;
import java.io.Closeable;
import java.nio.file.Path;

/**
 * Labels that {@code run} wrote, read together with the recording. Each label must belong to the recording's next
 * event.
 */
final class StoredLabels implements Closeable {
    private final String name;
    private final String recordingName;
    private final FlowCsvReader labels;
    private final EventSource recording;
    /** Events of the recording; the first {@link #met} of them have met their labels. */
    private final EventBatch events;
    private int met;
    private long eventsBefore;

    private StoredLabels(String name, FlowCsvReader labels, String recordingName, EventSource recording, int batch) {
        this.name = name;
        this.labels = labels;
        this.recordingName = recordingName;
        this.recording = recording;
        events = new EventBatch(batch);
    }

    /**
     * Opens labels.
     *
     * @param file as {@code run} wrote it
     * @param source of the recording's events; the caller closes it
     * @param batch number of events that are read at once
     * @throws EventSourceException if the file cannot be read or holds no labels
     */
    static StoredLabels open(Path file, Path recording, EventSource source, int batch) throws EventSourceException {
        return new StoredLabels(file.getFileName().toString(), FlowCsvReader.open(file),
            recording.getFileName().toString(), source, batch);
    }

    /**
     * Clears the batch, and fills it and the labels with the events that follow.
     *
     * @return false if labels and recording are at their end
     * @throws EventSourceException if the labels are not those of the recording's events, or if either is damaged
     */
    boolean next(EventBatch batch, FlowOutput flow) throws EventSourceException {
        boolean hasLabels = labels.next(batch, flow);
        for (int i = 0; i < batch.size(); i++) {
            if (!hasEvent()) {
                throw differs("must end with the " + number() + " events of " + recordingName + " but goes on with "
                    + event(batch, i));
            }
            if (batch.timeUs[i] != events.timeUs[met] || batch.x[i] != events.x[met] || batch.y[i] != events.y[met]
                    || batch.polarity[i] != events.polarity[met]) {
                throw differs("must be event " + number() + " of " + recordingName + ", " + event(events, met)
                    + ", but was " + event(batch, i));
            }
            met++;
        }
        if (!hasLabels && hasEvent()) {
            throw differs("must be event " + number() + " of " + recordingName + ", " + event(events, met)
                + ", but the file ends");
        }
        return hasLabels;
    }

    private boolean hasEvent() throws EventSourceException {
        if (met < events.size()) {
            return true;
        }
        eventsBefore += met;
        met = 0;
        events.clear();
        return recording.next(events);
    }

    /** Number of the event that meets its label next, counted from 0. */
    private long number() {
        return eventsBefore + met;
    }

    private static String event(EventBatch batch, int i) {
        return batch.timeUs[i] + "," + batch.x[i] + "," + batch.y[i] + "," + batch.polarity[i];
    }

    private EventSourceException differs(String how) {
        // the first line is the header
        return new EventSourceException("[" + name + "] line " + (number() + 2) + ": " + how);
    }

    @Override
    public void close() {
        labels.close();
    }
}
