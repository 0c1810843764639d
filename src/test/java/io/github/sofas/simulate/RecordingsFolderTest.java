package io.github.sofas.simulate;

import static org.junit.Assert.assertArrayEquals;
import static org.junit.Assert.assertEquals;
import static org.junit.Assert.assertTrue;

import io.github.sofas.event.EventBatch;
import io.github.sofas.recording.RecordingOptions;
import io.github.sofas.recording.RecordingReader;
import io.github.sofas.recording.Recordings;
import java.io.ByteArrayOutputStream;
import java.nio.file.Files;
import java.nio.file.Path;
import java.nio.file.Paths;
import java.util.LinkedHashMap;
import java.util.Map;
import org.junit.Test;

/** The files of recordings/ are what the commands in its README make. */
public class RecordingsFolderTest {
    private static final Path FOLDER = Paths.get("recordings");
    private static final long LARGEST_BYTES = 1_000_000;

    private static Map<Scene, Long> durationsUs() {
        Map<Scene, Long> durations = new LinkedHashMap<>();
        durations.put(Scene.HEXAGON, 1_100_000L);
        durations.put(Scene.SMALL_CIRCLE, 3_000_000L);
        durations.put(Scene.TWO_OPPOSITE, 600_000L);
        durations.put(Scene.SHORT_BAR, 750_000L);
        return durations;
    }

    private static SimulatedRecording film(Scene scene, long durationUs) {
        return SimulatedRecording.of(scene, SimulationOptions.defaults().withDurationUs(durationUs));
    }

    @Test
    public void truthIsMadeAgainByteForByte() throws Exception {
        for (Map.Entry<Scene, Long> made : durationsUs().entrySet()) {
            ByteArrayOutputStream truth = new ByteArrayOutputStream();
            try (TruthCsv csv = new TruthCsv(truth)) {
                csv.write(film(made.getKey(), made.getValue()));
            }
            Path file = FOLDER.resolve(made.getKey().sceneName() + ".truth.csv");
            assertArrayEquals(file.toString(), Files.readAllBytes(file), truth.toByteArray());
            assertTrue(file.toString(), truth.size() < LARGEST_BYTES);
        }
    }

    @Test
    public void recordingHoldsTheEventsOfItsTruth() throws Exception {
        for (Map.Entry<Scene, Long> made : durationsUs().entrySet()) {
            SimulatedRecording film = film(made.getKey(), made.getValue());
            Path file = FOLDER.resolve(made.getKey().sceneName() + ".aedat");
            EventBatch batch = new EventBatch(1000);
            int n = 0;
            try (RecordingReader reader = Recordings.open(file, RecordingOptions.defaults())) {
                assertEquals(film.sensor(), reader.sensor());
                for (; reader.next(batch); n += batch.size()) {
                    for (int i = 0; i < batch.size(); i++) {
                        assertEquals(film.timeUs[n + i], batch.timeUs[i]);
                        assertEquals(film.x[n + i], batch.x[i]);
                        assertEquals(film.y[n + i], batch.y[i]);
                        assertEquals(film.polarity[n + i], batch.polarity[i]);
                    }
                }
            }
            assertEquals(film.size(), n);
        }
    }
}
