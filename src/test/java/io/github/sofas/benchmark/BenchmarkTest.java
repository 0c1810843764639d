package io.github.sofas.benchmark;

import static org.junit.Assert.assertEquals;
import static org.junit.Assert.assertThrows;
import static org.junit.Assert.assertTrue;

import io.github.sofas.event.EventBatch;
import io.github.sofas.event.EventSourceException;
import io.github.sofas.event.SensorSize;
import io.github.sofas.flow.FlowOutput;
import io.github.sofas.flow.SofasParameters;
import io.github.sofas.recording.RecordingOptions;
import java.io.File;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.Arrays;
import java.util.List;
import java.util.stream.IntStream;
import org.junit.Rule;
import org.junit.Test;
import org.junit.rules.TemporaryFolder;

public class BenchmarkTest {
    private static final BenchmarkOptions BRIEF = new BenchmarkOptions(SofasParameters.defaults(), 5, 1, 0, 3000, 0);

    @Rule
    public final TemporaryFolder folder = new TemporaryFolder();

    private RecordingUnderTest text(String name, List<String> lines) throws Exception {
        Path file = Files.write(folder.getRoot().toPath().resolve(name), lines);
        return new RecordingUnderTest(name, file, RecordingOptions.defaults().withChip("16x16"));
    }

    @Test
    public void sameEventsGiveSameChecksumsAndLeaveNoFile() throws Exception {
        // an edge of eight pixels, one column each 10 ms
        List<String> lines = IntStream.range(0, 128)
            .mapToObj(i -> "0." + String.format("%06d", i / 8 * 10_000 + i % 8) + " " + i / 8 + " " + i % 8 + " 1")
            .toList();
        RecordingFigures first = Benchmark.measure(text("edge.txt", lines), BRIEF, folder.getRoot().toPath());
        RecordingFigures second = Benchmark.measure(text("edge.txt", lines), BRIEF, folder.getRoot().toPath());
        assertEquals("edge.txt", first.recording());
        assertEquals("text", first.format());
        assertEquals(128, first.engine().events());
        assertEquals(first.engine().checksum(), second.engine().checksum());
        assertEquals(first.decode().checksum(), second.decode().checksum());
        assertEquals(first.csv().checksum(), second.run().checksum());
        assertEquals("one packet each 10 ms", 16, first.figures().packets().ofOneMs().packets());
        assertEquals("128 of 1000 events", 1, first.figures().packets().paced().packets());
        File[] left = folder.getRoot().listFiles();
        assertEquals(List.of("edge.txt"), Arrays.stream(left).map(File::getName).toList());
    }

    @Test
    public void usesNoMoreEventsThanAskedFor() throws Exception {
        BenchmarkOptions two = new BenchmarkOptions(SofasParameters.defaults(), 5, 1, 0, 2, 0);
        RecordingFigures figures = Benchmark.measure(text("three.txt", List.of("0 1 1 1", "0.001 2 2 1", "bad")), two,
            folder.getRoot().toPath());
        assertEquals(2, figures.decode().events());
        assertEquals(2, figures.run().events());
    }

    @Test
    public void refusesARecordingWithoutEvents() throws Exception {
        RecordingUnderTest none = text("none.txt", List.of("# nothing"));
        assertEquals("[none.txt] has no events to measure with", assertThrows(EventSourceException.class,
            () -> Benchmark.measure(none, BRIEF, folder.getRoot().toPath())).getMessage());
    }

    @Test
    public void densityIsEventsWithFlowOverTheWayThatTheyGoInTheTimeOfTheRecording() {
        // three events in half a second; of the two with flow one goes 3 and one 5 px/s, so 2 px: one event a px
        EventBatch batch = new EventBatch(3);
        FlowOutput flow = new FlowOutput(3);
        for (int i = 0; i < 3; i++) {
            batch.add(i * 250_000L, i, 0, 1);
        }
        flow.segment[0] = 1;
        flow.vxPxPerS[0] = 3;
        flow.segment[2] = 1;
        flow.vxPxPerS[2] = -3;
        flow.vyPxPerS[2] = 4;
        EventsInMemory events = new EventsInMemory(new SensorSize(3, 1), List.of(batch), 3);
        assertEquals(1, Benchmark.eventsPerPx(events, List.of(flow)), 1e-12);
        assertEquals(0, Benchmark.eventsPerPx(events, List.of(new FlowOutput(3))), 0);
    }

    @Test
    public void builtInScenesHaveEventsInEveryFile() throws Exception {
        List<String> names = BuiltInScenes.names();
        assertEquals(List.of("hexagon (simulated, 240x180)", "hexagon (simulated, 1280x720)",
            "sixteen (simulated, 240x180)", "three-crossing (simulated, 240x180)", "four-bars (simulated, 240x180)",
            "noise of 5 Hz/px (simulated, 346x260)", "textured-pan of 0.35 million/s (simulated, 240x180)",
            "textured-pan of 1 million/s (simulated, 240x180)", "textured-pan of 5 million/s (simulated, 240x180)",
            "textured-pan of 0.35 million/s (simulated, 346x260)", "textured-pan of 1 million/s (simulated, 346x260)",
            "textured-pan of 5 million/s (simulated, 346x260)", "faint textured-pan (simulated, 346x260)",
            "strong textured-pan (simulated, 346x260)", "textured-pan of 10 million/s (simulated, 1280x720)",
            "textured-pan of 50 million/s (simulated, 1280x720)"), names);
        assertTrue(BuiltInScenes.film(names.get(5), folder.getRoot().toPath()).file().toFile().length() > 0);
    }
}
