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
 * @param name how the figures call it
 * @param file where it is
 * @param options how it is read
 */
public record RecordingUnderTest(String name, Path file, RecordingOptions options) {

    /** Opens it; it ends after so many events. */
    EventSource open(long mostEvents) throws EventSourceException {
        return new Beginning(Recordings.open(file, options), mostEvents);
    }

    /** Name and packing of the format. */
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
