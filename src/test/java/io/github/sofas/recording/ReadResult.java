package io.github.sofas.recording;

import io.github.sofas.event.EventBatch;
import io.github.sofas.event.EventSourceException;
import io.github.sofas.event.GreyFrame;
import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.List;
import java.util.function.Consumer;

/** What reading some bytes gave: the events as "t x y p", then what there was to say. */
final class ReadResult {
    static final RecordingOptions PLAIN = RecordingOptions.defaults();

    final List<String> events = new ArrayList<>();
    RecordingCounts counts;
    List<String> faults = List.of();
    List<String> notes = List.of();
    /** Message of the exception that ended the reading; null where it ended well. */
    String error;

    /** Writes the bytes to a file of the given name, reads it with batches of three events and deletes it. */
    static ReadResult of(Path folder, String name, byte[] bytes, RecordingOptions options) throws IOException {
        return of(folder, name, bytes, options, null);
    }

    /** The same, with the frames delivered to a receiver; null for none. */
    static ReadResult of(Path folder, String name, byte[] bytes, RecordingOptions options,
                         Consumer<GreyFrame> frames) throws IOException {
        Path file = Files.write(folder.resolve(name), bytes);
        ReadResult result = new ReadResult();
        EventBatch batch = new EventBatch(3);
        try (RecordingReader reader = Recordings.open(file, options)) {
            reader.onFrame(frames);
            try {
                while (reader.next(batch)) {
                    for (int i = 0; i < batch.size(); i++) {
                        result.events.add(batch.timeUs[i] + " " + batch.x[i] + " " + batch.y[i] + " "
                                + batch.polarity[i]);
                    }
                }
            } finally {
                result.counts = reader.counts();
                result.faults = reader.faults();
                result.notes = reader.notes();
            }
        } catch (EventSourceException e) {
            result.error = e.getMessage();
        }
        Files.delete(file);
        return result;
    }
}
