package io.github.sofas.cli;

import static org.junit.Assert.assertEquals;
import static org.junit.Assert.assertThrows;
import static org.junit.Assert.assertTrue;

import io.github.sofas.export.FlowCsvWriter;
import java.io.ByteArrayOutputStream;
import java.io.IOException;
import java.io.OutputStream;
import java.nio.charset.StandardCharsets;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.List;
import java.util.concurrent.CopyOnWriteArrayList;
import java.util.concurrent.CountDownLatch;
import org.junit.Rule;
import org.junit.Test;
import org.junit.rules.TemporaryFolder;

public class LiveWriterTest {
    @Rule
    public final TemporaryFolder folder = new TemporaryFolder();

    private final List<String> warnings = new CopyOnWriteArrayList<>();

    private static final OutputStream FULL = new OutputStream() {
        @Override
        public void write(int b) throws IOException {
            throw new IOException("No space left on device");
        }
    };

    private LiveWriter writer(FlowCsvWriter csv) {
        Path file = folder.getRoot().toPath().resolve("live.flow.csv");
        return new LiveWriter(List.of(LiveSink.rows(file, file, csv)), warnings::add);
    }

    private static void handOn(LiveWriter writer, int events, long firstUs) throws IOException {
        LiveWriter.Labelled batch = writer.empty();
        fill(batch, events, firstUs);
        writer.handOn(batch);
    }

    private static void fill(LiveWriter.Labelled batch, int events, long firstUs) {
        batch.events.clear();
        for (int i = 0; i < events; i++) {
            batch.events.add(firstUs + i, 3, 4, 1);
            batch.flow.segment[i] = 0;
        }
    }

    @Test(timeout = 60_000)
    public void writesAllInOrderThoughTheDiskIsSlow() throws IOException {
        ByteArrayOutputStream bytes = new ByteArrayOutputStream();
        CountDownLatch slow = new CountDownLatch(1);
        OutputStream disk = new OutputStream() {
            @Override
            public void write(int b) {
                bytes.write(b);
            }

            @Override
            public void write(byte[] from, int at, int length) throws IOException {
                try {
                    slow.await();
                } catch (InterruptedException e) {
                    throw new IOException(e);
                }
                bytes.write(from, at, length);
            }
        };
        StringBuilder expected = new StringBuilder(FlowCsvWriter.HEADER).append('\n');
        for (int i = 0; i < 200_000; i++) {
            expected.append(i).append(",3,4,1,,,0\n");
        }
        try (FlowCsvWriter csv = new FlowCsvWriter(disk); LiveWriter writer = writer(csv)) {
            // 100 batches wait, as fewer do than there are, while nothing is written
            for (int i = 0; i < 100; i++) {
                handOn(writer, 1000, 1000 * i);
            }
            slow.countDown();
            for (int i = 100; i < 200; i++) {
                handOn(writer, 1000, 1000 * i);
            }
            writer.finish();
        }
        assertEquals(expected.toString(), bytes.toString(StandardCharsets.US_ASCII));
    }

    @Test(timeout = 60_000)
    public void whoeverLabelsIsToldThatTheDiskIsFull() throws IOException {
        FlowCsvWriter csv = new FlowCsvWriter(FULL);
        IOException told = assertThrows(IOException.class, () -> {
            try (LiveWriter writer = writer(csv)) {
                for (int i = 0; i < 100_000; i++) {
                    handOn(writer, 1000, 1000L * i);
                }
            }
        });
        assertEquals("No space left on device", told.getMessage());
    }

    @Test(timeout = 60_000)
    public void theEndTellsThatTheDiskIsFull() throws IOException {
        FlowCsvWriter csv = new FlowCsvWriter(FULL);
        try (LiveWriter writer = writer(csv)) {
            List<LiveWriter.Labelled> batches = new ArrayList<>();
            for (int i = 0; i < 100; i++) {
                batches.add(writer.empty());
                fill(batches.get(i), 1000, 1000L * i);
            }
            batches.forEach(writer::handOn);
            writer.finish();
            assertEquals(1, warnings.size());
            assertTrue(warnings.get(0), warnings.get(0).startsWith("[" + folder.getRoot() + "/live.flow.csv] cannot be "
                + "written on: No space left on device; what it holds is whole, of less than the first "));
        }
    }
}
