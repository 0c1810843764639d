package io.github.sofas.export;

import static org.junit.Assert.assertArrayEquals;
import static org.junit.Assert.assertEquals;
import static org.junit.Assert.assertFalse;
import static org.junit.Assert.assertThrows;
import static org.junit.Assert.assertTrue;

import io.github.sofas.event.EventBatch;
import io.github.sofas.event.EventSourceException;
import io.github.sofas.flow.FlowOutput;
import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.Arrays;
import org.junit.Rule;
import org.junit.Test;
import org.junit.rules.TemporaryFolder;

public class FlowCsvReaderTest {
    private static final String HEADER = FlowCsvWriter.HEADER + "\n";

    @Rule
    public final TemporaryFolder folder = new TemporaryFolder();

    private Path file(String text) throws IOException {
        return Files.writeString(folder.newFile("a.flow.csv").toPath(), text);
    }

    @Test
    public void readsWhatTheWriterWrote() throws IOException, EventSourceException {
        int n = 20_000; // more than a buffer
        EventBatch batch = new EventBatch(n);
        FlowOutput flow = new FlowOutput(n);
        for (int i = 0; i < n; i++) {
            batch.add(-7_000 + i * 37L, i % 1280, i % 720, i % 3 == 0 ? -1 : 1);
            flow.segment[i] = i % 5;
            flow.vxPxPerS[i] = i % 5 == 0 ? 0 : (i - 10_000) * 0.125f;
            flow.vyPxPerS[i] = i % 5 == 0 ? 0 : i * 0.25f;
        }
        Path file = folder.newFile("b.flow.csv").toPath();
        try (FlowCsvWriter writer = new FlowCsvWriter(Files.newOutputStream(file))) {
            writer.write(batch, flow);
        }
        EventBatch read = new EventBatch(n);
        FlowOutput labels = new FlowOutput(n);
        try (FlowCsvReader reader = FlowCsvReader.open(file)) {
            assertTrue(reader.next(read, labels));
            assertEquals(n, read.size());
            assertArrayEquals(batch.timeUs, read.timeUs);
            assertArrayEquals(batch.x, read.x);
            assertArrayEquals(batch.y, read.y);
            assertArrayEquals(batch.polarity, read.polarity);
            assertArrayEquals(flow.segment, labels.segment);
            assertArrayEquals(flow.vxPxPerS, labels.vxPxPerS, 0);
            assertArrayEquals(flow.vyPxPerS, labels.vyPxPerS, 0);
            assertFalse(reader.next(read, labels));
        }
    }

    @Test
    public void deliversEveryRowBeforeTheDamage() throws IOException, EventSourceException {
        EventBatch batch = new EventBatch(8);
        try (FlowCsvReader reader = FlowCsvReader.open(file(HEADER + "10,1,2,1,,,0\n20,x,2,1,,,0\n"))) {
            assertTrue(reader.next(batch, new FlowOutput(8)));
            assertEquals("[10]", Arrays.toString(Arrays.copyOf(batch.timeUs, batch.size())));
            assertEquals("[a.flow.csv] line 3: x must be a whole number from 0 to 32767 but was \"x\"",
                assertThrows(EventSourceException.class, () -> reader.next(batch, new FlowOutput(8))).getMessage());
        }
    }

    @Test
    public void refusesWhatTheWriterNeverWrites() throws IOException {
        assertEquals("[a.flow.csv] line 2: x must be a whole number from 0 to 32767 but was \"-1\"",
            damage("10,-1,2,1,,,0\n"));
        assertEquals("[a.flow.csv] line 2: y must be a whole number from 0 to 32767 but was \"32768\"",
            damage("10,1,32768,1,,,0\n"));
        assertEquals("[a.flow.csv] line 2: polarity must be 1 or -1 but was \"0\"", damage("10,1,2,0,,,0\n"));
        assertEquals("[a.flow.csv] line 2: segment must be a whole number from 0 to 2147483647 but was \"-3\"",
            damage("10,1,2,1,,,-3\n"));
    }

    private String damage(String row) throws IOException {
        Path file = folder.newFolder().toPath().resolve("a.flow.csv");
        Files.writeString(file, HEADER + row);
        EventSourceException damage = assertThrows(EventSourceException.class, () -> {
            try (FlowCsvReader reader = FlowCsvReader.open(file)) {
                reader.next(new EventBatch(8), new FlowOutput(8));
            }
        });
        return damage.getMessage();
    }

    @Test
    public void lineWithoutItsEndIsDamage() throws IOException, EventSourceException {
        try (FlowCsvReader reader = FlowCsvReader.open(file(HEADER + "10,1,2,1,,,0"))) {
            assertEquals("[a.flow.csv] line 2: must end with a new line but was \"10,1,2,1,,,0\"",
                assertThrows(EventSourceException.class, () -> reader.next(new EventBatch(8), new FlowOutput(8)))
                    .getMessage());
        }
    }

    @Test
    public void fileWithAnotherHeaderIsRefused() throws IOException {
        Path file = file("a,b\n");
        assertEquals("[a.flow.csv] line 1: must be \"t_us,x,y,polarity,vx_px_per_s,vy_px_per_s,segment\" but was "
            + "\"a,b\"", assertThrows(EventSourceException.class, () -> FlowCsvReader.open(file)).getMessage());
    }
}
