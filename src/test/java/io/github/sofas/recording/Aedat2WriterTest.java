package io.github.sofas.recording;

import static org.junit.Assert.assertArrayEquals;
import static org.junit.Assert.assertEquals;
import static org.junit.Assert.assertFalse;
import static org.junit.Assert.assertThrows;
import static org.junit.Assert.assertTrue;

import io.github.sofas.event.EventBatch;
import java.io.File;
import java.nio.charset.StandardCharsets;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.Arrays;
import org.junit.Rule;
import org.junit.Test;
import org.junit.rules.TemporaryFolder;

public class Aedat2WriterTest {
    @Rule public final TemporaryFolder folder = new TemporaryFolder();

    @Test public void givesBackTheCornersOfEveryChip() throws Exception {
        for (Chip chip : Chip.known()) {
            int right = chip.sensor().width() - 1;
            int bottom = chip.sensor().height() - 1;
            EventBatch written = new EventBatch(8);
            written.add(10, 0, 0, 1);
            written.add(11, right, 0, -1);
            written.add(12, 0, bottom, 1);
            written.add(13, right, bottom, -1);
            assertSame(chip.name(), written, roundTrip(chip, written));
        }
    }

    /** The 32-bit times overflow at 2^31 and at 3 * 2^31 = 6,442,450,944. Steps stay below 2^31. */
    @Test public void givesBackTimesBeyond32Bits() throws Exception {
        EventBatch written = new EventBatch(8);
        for (long timeUs : new long[] {1L << 30, (1L << 31) - 1, 1L << 31, 1L << 32, 6_000_000_000L, 7_000_000_000L}) {
            written.add(timeUs, 3, 4, 1);
        }
        assertSame("times", written, roundTrip(Chip.named("DVS128").get(), written));
    }

    /** jAER: x = 239 - raw x, row = 179 - raw y, so (1, 2) is raw (238, 177): 177 << 22 | 238 << 12 | 1 << 11. */
    @Test public void writesHeaderAndAddressesAsJaerDoes() throws Exception {
        Path path = folder.newFile().toPath();
        EventBatch batch = new EventBatch(1);
        batch.add(0x01020304, 1, 2, 1);
        try (Aedat2Writer writer = new Aedat2Writer(path, Chip.named("DAVIS240C").get())) {
            writer.write(batch);
        }
        byte[] bytes = Files.readAllBytes(path);
        String header = "#!AER-DAT2.0\r\n# This is a raw AE data file - do not edit\r\n"
                + "# Data format is int32 address, int32 timestamp (8 bytes total), repeated for each event\r\n"
                + "# Timestamps tick is 1 us\r\n# AEChip: eu.seebetter.ini.chips.davis.DAVIS240C\r\n"
                + "#End Of ASCII Header\r\n";
        assertEquals(header, new String(bytes, 0, bytes.length - 8, StandardCharsets.US_ASCII));
        int address = 177 << 22 | 238 << 12 | 1 << 11;
        assertArrayEquals(new byte[] {(byte) (address >>> 24), (byte) (address >>> 16), (byte) (address >>> 8),
                (byte) address, 1, 2, 3, 4}, Arrays.copyOfRange(bytes, bytes.length - 8, bytes.length));
    }

    @Test public void refusesAnEventOutsideTheSensor() throws Exception {
        EventBatch batch = new EventBatch(2);
        batch.add(1, 0, 0, 1);
        batch.add(2, 128, 0, 1);
        assertEquals("event 1: x must be smaller than width 128 but was 128",
                assertThrows(IllegalArgumentException.class,
                () -> roundTrip(Chip.named("DVS128").get(), batch)).getMessage());
    }

    @Test public void refusesTimeThatFalls() throws Exception {
        EventBatch batch = new EventBatch(2);
        batch.add(7, 0, 0, 1);
        batch.add(6, 0, 0, 1);
        assertEquals("event 1: time must not fall below 7 us but was 6 us",
                assertThrows(IllegalArgumentException.class,
                () -> roundTrip(Chip.named("DVS128").get(), batch)).getMessage());
    }

    private EventBatch roundTrip(Chip chip, EventBatch written) throws Exception {
        File file = folder.newFile();
        try (Aedat2Writer writer = new Aedat2Writer(file.toPath(), chip)) {
            writer.write(written);
        }
        EventBatch read = new EventBatch(written.size() + 1);
        try (RecordingReader reader = Recordings.open(file.toPath(), RecordingOptions.defaults())) {
            assertEquals(chip.name(), reader.chip().get());
            assertEquals(chip.sensor(), reader.sensor());
            assertTrue(reader.next(read));
            assertFalse(reader.next(new EventBatch(1)));
            assertEquals(written.size(), reader.counts().events());
        }
        return read;
    }

    private static void assertSame(String what, EventBatch expected, EventBatch actual) {
        int n = expected.size();
        assertEquals(what, n, actual.size());
        assertArrayEquals(what, Arrays.copyOf(expected.timeUs, n), Arrays.copyOf(actual.timeUs, n));
        assertArrayEquals(what, Arrays.copyOf(expected.x, n), Arrays.copyOf(actual.x, n));
        assertArrayEquals(what, Arrays.copyOf(expected.y, n), Arrays.copyOf(actual.y, n));
        assertArrayEquals(what, Arrays.copyOf(expected.polarity, n), Arrays.copyOf(actual.polarity, n));
    }
}
