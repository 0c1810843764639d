package io.github.sofas.recording;

import static org.junit.Assert.assertEquals;
import static org.junit.Assert.assertNull;

import java.io.ByteArrayOutputStream;
import java.io.IOException;
import java.nio.charset.StandardCharsets;
import java.util.Arrays;
import java.util.List;
import org.junit.Rule;
import org.junit.Test;
import org.junit.rules.TemporaryFolder;

public class EventStreamReaderTest {
    @Rule public final TemporaryFolder folder = new TemporaryFolder();

    private int version = 2;
    private int type = 1;

    private byte[] file(int... bytes) {
        ByteArrayOutputStream all = new ByteArrayOutputStream();
        all.writeBytes("Event Stream".getBytes(StandardCharsets.US_ASCII));
        for (int each : new int[] {version, 0, 0, type, 0x40, 1, 240, 0}) {
            all.write(each);
        }
        for (int each : bytes) {
            all.write(each);
        }
        return all.toByteArray();
    }

    private ReadResult read(byte[] file) throws IOException {
        return ReadResult.of(folder.getRoot().toPath(), "a.es", file, ReadResult.PLAIN);
    }

    /** A byte holds the time since the event before, and polarity; row 239 of 240 from below is the top one. */
    @Test public void readsTimeStepsAndRowsFromBelow() throws Exception {
        ReadResult read = read(file(1, 0, 0, 239, 0, 3 << 1, 0x3F, 1, 0, 0));
        assertEquals(List.of("0 0 0 1", "3 319 239 -1"), read.events);
        assertEquals(List.of(), read.faults);
        assertNull(read.error);
    }

    /** A byte of 0xFF is 127 us more, 0xFE a reset. */
    @Test public void addsLongSteps() throws Exception {
        ReadResult read = read(file(0xFF, 0xFE, 0xFF, 126 << 1, 5, 0, 0, 0, 0xFF));
        assertEquals(List.of("380 5 239 -1"), read.events);
        assertEquals(1, read.counts.otherRecords());
        assertNull(read.error);
    }

    @Test public void countsAndReportsEventsOutsideTheSensor() throws Exception {
        ReadResult read = read(file(0, 0x40, 1, 0, 0, 2, 0, 0, 240, 0, 2, 0, 0, 0, 0));
        assertEquals(List.of("2 0 239 -1"), read.events);
        assertEquals(List.of("[a.es] event 0 at byte 20: x must be smaller than width 320 but was 320 (the first of "
                + "2)"), read.faults);
    }

    @Test public void refusesOtherVersionsAndEvents() throws Exception {
        type = 2;
        assertEquals("[a.es] header at byte 15: unsupported, the events must be of type 1 (DVS) but were of type 2 "
                + "(ATIS)", read(file()).error);
        version = 1;
        assertEquals("[a.es] header at byte 12: unsupported, the version must be 2 but was 1", read(file()).error);
        assertEquals("[a.es] header at byte 0: truncated, the header must have 20 bytes but had 19",
                read(Arrays.copyOf(file(), 19)).error);
    }

    @Test public void namesAnEventThatTheEndCutsOff() throws Exception {
        ReadResult read = read(file(1, 0, 0, 0, 0, 1, 0, 0));
        assertEquals(List.of("0 0 239 1"), read.events);
        assertEquals("[a.es] event 1 at byte 25: truncated, an event must have 5 bytes but had 3", read.error);
    }
}
