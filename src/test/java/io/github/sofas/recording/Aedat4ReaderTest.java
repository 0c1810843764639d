package io.github.sofas.recording;

import static io.github.sofas.recording.Aedat4Bytes.EVENTS_ID;
import static io.github.sofas.recording.Aedat4Bytes.FRAMES_ID;
import static io.github.sofas.recording.Aedat4Bytes.IMU_ID;
import static io.github.sofas.recording.Aedat4Bytes.TRIGGERS_ID;
import static org.junit.Assert.assertEquals;
import static org.junit.Assert.assertNotNull;
import static org.junit.Assert.assertNull;
import static org.junit.Assert.assertTrue;

import io.github.sofas.event.GreyFrame;
import io.github.sofas.recording.Aedat4Format.Compression;
import java.io.IOException;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.Arrays;
import java.util.List;
import org.junit.Rule;
import org.junit.Test;
import org.junit.rules.TemporaryFolder;

public class Aedat4ReaderTest {
    private static final long[] FIRST = {1_589_163_147_368_868L, 0, 0, 1};
    private static final long[] SECOND = {1_589_163_147_368_869L, 15, 11, 0};
    private static final long[] THIRD = {1_589_163_147_368_870L, 3, 4, 1};
    private static final List<String> ALL = List.of("1589163147368868 0 0 1", "1589163147368869 15 11 -1",
            "1589163147368870 3 4 1");

    @Rule public final TemporaryFolder folder = new TemporaryFolder();

    private final Aedat4Bytes bytes = new Aedat4Bytes();

    /** The sensor has 16 x 12 pixels. */
    @Test public void deliversFramesToThoseWhoWantThem() throws Exception {
        bytes.compression = Compression.LZ4;
        bytes.packet(FRAMES_ID, bytes.pack(Aedat4Bytes.framePayload(70, 0, 2, 1, 15, 11, (byte) 200, (byte) 9)))
                .events(new long[] {80, 1, 2, 1})
                .packet(FRAMES_ID, bytes.pack(Aedat4Bytes.framePayload(90, 16, 1, 1, 3, 4, (byte) 255, (byte) 0,
                    (byte) 255)));
        List<GreyFrame> frames = new ArrayList<>();
        ReadResult read = ReadResult.of(path(), "a.aedat4", bytes.build(), ReadResult.PLAIN, frames::add);
        assertEquals(List.of("80 1 2 1"), read.events);
        assertEquals(List.of(), read.faults);
        assertEquals(2, frames.size());
        assertEquals("16x12 at 70", frames.get(0).width() + "x" + frames.get(0).height() + " at "
                + frames.get(0).timeUs());
        assertEquals(200, frames.get(0).level(15, 11));
        assertEquals(0, frames.get(0).level(14, 11));
        // (29 x 255 + 77 x 255) / 256
        assertEquals(105, frames.get(1).level(3, 4));
    }

    @Test public void spoiledFramesLoseNoEvent() throws Exception {
        bytes.packet(FRAMES_ID, Aedat4Bytes.framePayload(70, 5, 1, 1, 0, 0, (byte) 1))
                .packet(FRAMES_ID, Aedat4Bytes.framePayload(70, 0, 16, 12, 0, 0, (byte) 1))
                .packet(FRAMES_ID, new byte[9])
                .events(new long[] {80, 1, 2, 1});
        List<GreyFrame> frames = new ArrayList<>();
        ReadResult read = ReadResult.of(path(), "a.aedat4", bytes.build(), ReadResult.PLAIN, frames::add);
        assertEquals(List.of("80 1 2 1"), read.events);
        assertEquals(List.of("[a.aedat4] event 0 at byte " + bytes.firstPacketAt() + ": unsupported, a frame's format "
                + "must be one of 0, 16, 24 but was 5 (the first of 3)"), read.faults);
        assertEquals(List.of(), frames);
        assertEquals(3, read.counts.frames());
    }

    @Test public void readsEveryCompression() throws Exception {
        for (Compression compression : Compression.values()) {
            Aedat4Bytes packed = new Aedat4Bytes();
            packed.compression = compression;
            ReadResult read = read(packed.events(FIRST, SECOND).events(THIRD).build());
            assertEquals(compression.label, ALL, read.events);
            assertNull(read.error);
            assertEquals(List.of(), read.faults);
        }
    }

    @Test public void countsOtherStreamsAndNeedsNoneOfThem() throws Exception {
        ReadResult read = read(bytes.packet(IMU_ID, Aedat4Bytes.tablePayload("IMUS", 5)).events(FIRST)
                .packet(FRAMES_ID, new byte[9]).packet(TRIGGERS_ID, Aedat4Bytes.tablePayload("TRIG", 2)).build());
        assertEquals(new RecordingCounts(1, 0, 1, 5, 2, 0, 0, 0, 0, 0, 0, 0, 0), read.counts);
        assertEquals(List.of(), read.faults);
        bytes.streams = Aedat4Bytes.stream(EVENTS_ID, "EVTS", Aedat4Bytes.size("16", "12"));
        read = read(bytes.build());
        assertEquals(3, read.counts.otherRecords());
        assertEquals(List.of("[a.aedat4] event 0 at byte " + bytes.firstPacketAt()
                + ": malformed, a packet's stream must be "
                + "declared in the header but was 2 (the first of 3)"), read.faults);
    }

    @Test public void readsAFileWithoutDataTable() throws Exception {
        bytes.dataTable = false;
        ReadResult read = read(bytes.events(FIRST, SECOND, THIRD).build());
        assertEquals(ALL, read.events);
        assertNull(read.error);
    }

    @Test public void reportsADataTableThatContradictsThePackets() throws Exception {
        bytes.tableEvents = 9;
        byte[] file = bytes.events(FIRST).build();
        ReadResult read = read(file);
        assertNull(read.error);
        assertEquals(List.of("[a.aedat4] event 1 at byte " + (bytes.firstPacketAt() + 8
                + Aedat4Bytes.eventPayload("EVTS", 1, FIRST).length)
                        + ": data table: malformed, it must count the 1 events "
                + "of the packets but counted 9"), read.faults);
    }

    @Test public void dropsAndReportsEventsOutsideTheSensor() throws Exception {
        ReadResult read = read(bytes.events(FIRST, new long[] {SECOND[0], 16, 0, 1}, new long[] {SECOND[0], 0, -1, 1})
                .build());
        assertEquals(ALL.subList(0, 1), read.events);
        assertEquals(2, read.counts.outsideSensor());
        assertEquals(List.of("[a.aedat4] event 1 at byte " + bytes.firstPacketAt()
                + ": x must be smaller than width 16 but was 16 (the first of 2)"), read.faults);
    }

    @Test public void deliversStepsBackWithTheGreatestTime() throws Exception {
        ReadResult read = read(bytes.events(SECOND, FIRST).build());
        assertEquals(List.of("1589163147368869 15 11 -1", "1589163147368869 0 0 1"), read.events);
        assertEquals(1, read.counts.stepsBack());
    }

    /** No compression: an event's 16 bytes are at hand or not. Others unpack as much as their blocks allow. */
    @Test public void deliversEveryEventBeforeATruncationAtAnyByte() throws Exception {
        for (Compression compression : List.of(Compression.NONE, Compression.LZ4, Compression.ZSTD)) {
            Aedat4Bytes packed = new Aedat4Bytes();
            packed.compression = compression;
            byte[] file = packed.events(FIRST, SECOND).events(THIRD).build();
            int firstEnd = packed.firstPacketAt() + 8
                    + packed.pack(Aedat4Bytes.eventPayload("EVTS", 2, FIRST, SECOND)).length;
            int secondEnd = firstEnd + 8 + packed.pack(Aedat4Bytes.eventPayload("EVTS", 1, THIRD)).length;
            for (int length = 0; length < file.length; length++) {
                ReadResult read = read(Arrays.copyOf(file, length));
                String what = compression + " cut at " + length + ": " + read.error + " " + read.events;
                int whole = length >= secondEnd ? 3 : length >= firstEnd ? 2 : 0;
                assertEquals(what, ALL.subList(0, read.events.size()), read.events);
                assertTrue(what, read.events.size() >= whole);
                if (compression == Compression.NONE && length > firstEnd - 16 && length < firstEnd) {
                    assertEquals(what, 1, read.events.size());
                }
                // From the data table on nothing is lost that was recorded.
                String said = length >= secondEnd ? String.join("", read.faults) : read.error;
                assertNotNull(what, said);
                assertTrue(what, said.contains("truncated") || length >= secondEnd && said.contains("data table"));
            }
        }
    }

    @Test public void namesTheLostPartOfAPacket() throws Exception {
        bytes.dataTable = false;
        bytes.events(FIRST);
        byte[] file = bytes.build();
        int size = file.length - bytes.firstPacketAt() - 8;
        assertEquals("[a.aedat4] event 0 at byte " + bytes.firstPacketAt() + ": truncated, a packet must have " + size
                + " bytes but had " + (size - 1), read(Arrays.copyOf(file, file.length - 1)).error);
    }

    @Test public void deliversEveryEventBeforeADamagedPacket() throws Exception {
        for (Compression compression : List.of(Compression.LZ4, Compression.ZSTD)) {
            Aedat4Bytes packed = new Aedat4Bytes();
            packed.compression = compression;
            ReadResult read = read(packed.events(FIRST, SECOND).packet(EVENTS_ID, new byte[40]).build());
            assertEquals(ALL.subList(0, 2), read.events);
            assertTrue(read.error, read.error.contains("event 2 at byte ") && read.error.contains(": malformed, "));
        }
    }

    @Test public void refusesAPacketThatAnnouncesMoreThanItHolds() throws Exception {
        bytes.packet(EVENTS_ID, Aedat4Bytes.eventPayload("EVTS", 1_000_000, FIRST, SECOND));
        ReadResult read = read(bytes.build());
        assertEquals(ALL.subList(0, 2), read.events);
        assertEquals("[a.aedat4] event 2 at byte " + bytes.firstPacketAt()
                + ": malformed, a packet must have room for its "
                + "1000000 elements but had for 2", read.error);
    }

    @Test public void refusesAPacketOfAnotherKindThanItsStream() throws Exception {
        bytes.packet(EVENTS_ID, Aedat4Bytes.eventPayload("IMUS", 1, FIRST));
        assertEquals("[a.aedat4] event 0 at byte " + bytes.firstPacketAt()
                + ": malformed, a packet of stream 7 must have the "
                + "identifier EVTS but had another", read(bytes.build()).error);
    }

    @Test public void reportsADamagedPacketOfAnotherStreamAndReadsOn() throws Exception {
        bytes.packet(IMU_ID, new byte[20]);
        ReadResult read = read(bytes.events(FIRST).build());
        assertEquals(ALL.subList(0, 1), read.events);
        assertNull(read.error);
        assertEquals(List.of("[a.aedat4] event 0 at byte " + bytes.firstPacketAt()
                + ": malformed, a packet of stream 2 must "
                + "have the identifier IMUS but had another"), read.faults);
    }

    @Test public void refusesAPacketThatRunsIntoTheDataTable() throws Exception {
        bytes.packet(FRAMES_ID, 1000, new byte[10]);
        assertEquals("[a.aedat4] event 0 at byte " + bytes.firstPacketAt()
                + ": malformed, a packet must have 1000 bytes but "
                + "had 10", read(bytes.build()).error);
    }

    @Test public void refusesWhatTheHeaderMayNotSay() throws Exception {
        bytes.compressionCode = 5;
        assertHeaderError("unsupported, the compression must be between 0 and 4 but was 5");
        bytes.compressionCode = 0;
        bytes.streams = Aedat4Bytes.stream(IMU_ID, "IMUS", "");
        assertHeaderError("unsupported, a recording must declare a stream of events (EVTS) but had 1 others");
        bytes.streams = Aedat4Bytes.stream(EVENTS_ID, "EVTS", Aedat4Bytes.size("4000", "12"));
        assertHeaderError("unsupported, the sensor must measure 1x1 to 1280x720 but was 4000x12");
        bytes.xml = "<dv>";
        assertTrue(read(bytes.build()).error.startsWith("[a.aedat4] header at byte 14: malformed, the streams "
                + "must be declared "
                + "in XML without a document type but were not: "));
        bytes.xml = "<!DOCTYPE dv [<!ENTITY e SYSTEM \"file:///etc/hostname\">]><dv>&e;</dv>";
        assertTrue(read(bytes.build()).error.contains("DOCTYPE is disallowed"));
    }

    @Test public void refusesDeclarationsThatNestWithoutEnd() throws Exception {
        bytes.xml = "<node>".repeat(100_000) + "</node>".repeat(100_000);
        String error = read(bytes.build()).error;
        assertTrue(error, error.startsWith("[a.aedat4] header at byte 14: malformed, the streams must be declared "));
    }

    @Test public void asksForTheSizeWhereTheHeaderHasNone() throws Exception {
        bytes.streams = Aedat4Bytes.stream(EVENTS_ID, "EVTS", "");
        byte[] file = bytes.events(FIRST).build();
        assertTrue(read(file).error.startsWith("[a.aedat4] the recording names no chip: --chip must name one of "));
        assertEquals(ALL.subList(0, 1),
                ReadResult.of(path(), "a.aedat4", file, ReadResult.PLAIN.withChip("16x12")).events);
    }

    @Test public void survivesAnySpoiledByte() throws Exception {
        byte[] file = bytes.events(FIRST, SECOND).packet(IMU_ID, Aedat4Bytes.tablePayload("IMUS", 1)).build();
        List<Integer> silent = new ArrayList<>();
        for (int i = 0; i < file.length; i++) {
            for (int value : new int[] {0, 0x7F, 0x80, 0xFF}) {
                byte[] spoiled = file.clone();
                spoiled[i] = (byte) value;
                ReadResult read = read(spoiled);
                if (read.error == null && read.events.isEmpty() && read.faults.isEmpty()) {
                    silent.add(i);
                }
            }
        }
        assertEquals("events vanished without a word", List.of(), silent);
    }

    private void assertHeaderError(String rule) throws IOException {
        String error = read(bytes.build()).error;
        assertEquals("[a.aedat4] header at byte 14: " + rule, error);
    }

    private ReadResult read(byte[] file) throws IOException {
        return ReadResult.of(path(), "a.aedat4", file, ReadResult.PLAIN);
    }

    private Path path() {
        return folder.getRoot().toPath();
    }
}
