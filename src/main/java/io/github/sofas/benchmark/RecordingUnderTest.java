package io.github.sofas.benchmark;

import io.github.sofas.event.EventBatch;
import io.github.sofas.event.EventSource;
import io.github.sofas.event.EventSourceException;
import io.github.sofas.event.SensorSize;
import io.github.sofas.recording.RecordingOptions;
import io.github.sofas.recording.RecordingReader;
import io.github.sofas.recording.Recordings;
import java.nio.file.Path;

/**
 * A recording to be measured.
 *
 * @param name name of the recording in the figures
 * @param file path of the recording
 * @param options options for reading the recording
 */
public record RecordingUnderTest(String name, Path file, RecordingOptions options) {

    /** Opens the recording, which ends after at most the given number of events. */
    EventSource open(long mostEvents) throws EventSourceException {
        return new Beginning(Recordings.open(file, options), mostEvents);
    }

    /** Returns the name of the format, and the compression in parentheses if there is one. */
    String format() throws EventSourceException {
        try (RecordingReader reader = Recordings.open(file, options)) {
            return reader.formatName() + reader.compression().map(how -> " (" + how + ")").orElse("");
        }
    }

    private static final class Beginning implements EventSource {
        private final RecordingReader reader;
        private long left;

        Beginning(RecordingReader reader, long left) {
            this.reader = reader;
            this.left = left;
        }

        @Override
        public SensorSize sensor() {
            return reader.sensor();
        }

        @Override
        public boolean next(EventBatch batch) throws EventSourceException {
            batch.clear();
            if (left == 0 || !reader.next(batch)) {
                return false;
            }
            batch.setSize((int) Math.min(left, batch.size()));
            left -= batch.size();
            return true;
        }

        @Override
        public void close() {
            reader.close();
        }
    }
}
