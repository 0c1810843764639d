package io.github.sofas.recording;

import static org.junit.Assert.assertEquals;
import static org.junit.Assert.assertNull;

import java.io.ByteArrayOutputStream;
import java.io.IOException;
import java.nio.ByteBuffer;
import java.nio.ByteOrder;
import java.nio.charset.StandardCharsets;
import java.util.Arrays;
import java.util.List;
import org.junit.Rule;
import org.junit.Test;
import org.junit.rules.TemporaryFolder;

public class DatReaderTest {
    @Rule public final TemporaryFolder folder = new TemporaryFolder();

    private static final String HEADER = "% Height 480\n% Version 2\n% Width 640\n";

    private byte[] file(String header, int type, int bytes, int... words) {
        ByteArrayOutputStream all = new ByteArrayOutputStream();
        all.writeBytes(header.getBytes(StandardCharsets.US_ASCII));
        all.write(type);
        all.write(bytes);
        ByteBuffer records = ByteBuffer.allocate(4 * words.length).order(ByteOrder.LITTLE_ENDIAN);
        for (int word : words) {
            records.putInt(word);
        }
        all.writeBytes(records.array());
        return all.toByteArray();
    }

    private ReadResult read(byte[] file) throws IOException {
        return ReadResult.of(folder.getRoot().toPath(), "a.dat", file, ReadResult.PLAIN);
    }

    /** Version 2: x in bits 0 to 13, y in 14 to 27, polarity in 28. */
    @Test public void readsVersion2() throws Exception {
        for (int type : new int[] {0, 12}) {
            ReadResult read = read(file(HEADER, type, 8, 5, 1 << 28 | 479 << 14 | 639, 6, 1));
            assertEquals(List.of("5 639 479 1", "6 1 0 -1"), read.events);
            assertEquals(List.of(), read.faults);
            assertNull(read.error);
        }
    }

    /** Version 1: x in bits 0 to 8, y in 9 to 16, polarity in 17. */
    @Test public void readsVersion1WithItsOwnBits() throws Exception {
        byte[] file = file("% Data file containing CD events.\n% Version 1\n", 0, 8, 5, 1 << 17 | 239 << 9 | 303);
        assertEquals(List.of("5 303 239 1"), ReadResult.of(folder.getRoot().toPath(), "a.dat", file,
                ReadResult.PLAIN.withChip("304x240")).events);
    }

    /** 32 bits of time are 71.6 minutes. */
    @Test public void undoesOverflowsOfTime() throws Exception {
        ReadResult read = read(file(HEADER, 12, 8, -1, 0, 3, 0, 2, 0));
        assertEquals(List.of("4294967295 0 0 -1", "4294967299 0 0 -1", "4294967299 0 0 -1"), read.events);
        assertEquals(1, read.counts.timeWraps());
        assertEquals(1, read.counts.stepsBack());
    }

    @Test public void countsAndReportsEventsOutsideTheSensor() throws Exception {
        ReadResult read = read(file(HEADER, 12, 8, 1, 640, 2, 480 << 14, 3, 0));
        assertEquals(List.of("3 0 0 -1"), read.events);
        assertEquals(List.of("[a.dat] event 0 at byte " + (HEADER.length() + 2)
                + ": x must be smaller than width 640 but was 640 (the first of 2)"), read.faults);
    }

    @Test public void refusesRecordsThatAreNoChangeEvents() throws Exception {
        assertEquals("[a.dat] header at byte " + HEADER.length() + ": unsupported, events must be of type 0 or 12 and "
                + "of 8 bytes but were of type 14 and 16 bytes", read(file(HEADER, 14, 16)).error);
        assertEquals("[a.dat] header at byte " + HEADER.length() + ": truncated, the type and size of events must have "
                + "2 bytes but had 0", read(HEADER.getBytes(StandardCharsets.US_ASCII)).error);
    }

    @Test public void namesARecordThatTheEndCutsOff() throws Exception {
        byte[] file = file(HEADER, 12, 8, 1, 0, 2, 0);
        ReadResult read = read(Arrays.copyOf(file, file.length - 3));
        assertEquals(List.of("1 0 0 -1"), read.events);
        assertEquals("[a.dat] event 1 at byte " + (HEADER.length() + 10)
                + ": truncated, a record must have 8 bytes but had 5", read.error);
    }
}
