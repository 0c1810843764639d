package io.github.sofas.recording;

import static org.junit.Assert.assertEquals;
import static org.junit.Assert.assertFalse;
import static org.junit.Assert.assertNull;
import static org.junit.Assert.assertTrue;

import io.github.sofas.event.EventBatch;
import io.github.sofas.event.GreyFrame;
import java.io.IOException;
import java.nio.ByteBuffer;
import java.nio.charset.StandardCharsets;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.Arrays;
import java.util.List;
import org.junit.Before;
import org.junit.Rule;
import org.junit.Test;
import org.junit.rules.TemporaryFolder;

public class Aedat2ReaderTest {
    private static final String DVS128 = "# AEChip: ch.unizh.ini.jaer.chip.retina.DVS128\r\n";
    private static final String DAVIS = "# AEChip: eu.seebetter.ini.chips.davis.DAVIS240C\r\n";
    private static final String END = "#End Of ASCII Header\r\n";
    private static final String KNOWN = "DVS128, Tmpdiff128, DAVIS240A, DAVIS240B, DAVIS240C, DVS240, Davis346red, "
            + "Davis346blue, Davis346B, Davis346cBSI, Davis346Zynq, Davis128, Davis640";

    @Rule public final TemporaryFolder folder = new TemporaryFolder();

    private String header;

    @Before public void startsWithAHeaderOfDvs128() {
        header = "#!AER-DAT2.0\r\n" + DVS128 + END;
    }

    /** Raw x runs from right to left, raw y from the bottom up; bit 0 set is OFF. */
    @Test public void turnsDvs128AddressesIntoRowsAndColumns() throws Exception {
        ReadResult read = read(dvs(100, 0, 0, 1), dvs(101, 127, 5, -1));
        assertEquals(List.of("100 127 127 1", "101 0 122 -1"), read.events);
        assertNull(read.error);
        assertEquals(List.of(), read.faults);
    }

    @Test public void turnsDavisAddressesIntoRowsAndColumns() throws Exception {
        header = "#!AER-DAT2.0\r\n" + DAVIS + END;
        assertEquals(List.of("7 239 179 1", "8 229 159 -1"), read(davis(7, 0, 0, 1), davis(8, 10, 20, -1)).events);
    }

    @Test public void readsAedat1WithAndWithoutHeader() throws Exception {
        byte[] records = ByteBuffer.allocate(12).putShort((short) 0).putInt(5).putShort((short) 0x0203).putInt(6)
                .array();
        RecordingOptions options = ReadResult.PLAIN.withChip("dvs128");
        List<String> events = List.of("5 127 127 1", "6 126 125 -1");
        assertEquals(events, ReadResult.of(path(), "a.dat", records, options).events);
        assertEquals(events, ReadResult.of(path(), "a.aedat", join("#!AER-DAT1.0\r\n", records), options).events);
    }

    @Test public void countsWhatIsNoChangeEvent() throws Exception {
        header = "#!AER-DAT2.0\r\n" + DAVIS + END;
        byte[][] records = new byte[11][];
        for (int code = 0; code < 7; code++) {
            records[code] = record(0x80000C00 | code << 28, 10);
        }
        records[7] = record(0x80000000, 10);
        records[8] = record(0x80000400, 10);
        records[9] = record(1 << 10, 10);
        records[10] = davis(11, 0, 0, 1);
        ReadResult read = read(records);
        assertEquals(new RecordingCounts(1, 2, 0, 1, 1, 0, 0, 0, 0, 0, 0, 0, 0), read.counts);
        assertEquals(List.of(), read.faults);
        header = "#!AER-DAT2.0\r\n" + DVS128 + END;
        assertEquals(2, read(record(0x8000, 1), record(0x80000000, 1), dvs(2, 0, 0, 1)).counts.triggers());
    }

    @Test public void deliversWholeImuSamplesToThoseWhoWantThem() throws Exception {
        header = "#!AER-DAT2.0\r\n" + DAVIS + END;
        byte[][] records = new byte[3 * 7 - 1][];
        for (int i = 0; i < records.length; i++) {
            // words 0 to 6 hold -3, -2, ... 3 in the first sample, ten times that in the second; the last is cut off
            int value = (i % 7 - 3) * (i < 7 ? 1 : 10);
            records[i] = record(0x80000C00 | i % 7 << 28 | (value & 0xFFFF) << 12, i < 7 ? 5 : 6);
        }
        Path file = Files.write(path().resolve("a.aedat"), join(header, records));
        List<ImuSample> samples = new ArrayList<>();
        try (RecordingReader reader = Recordings.open(file, ReadResult.PLAIN)) {
            reader.onImuSample(samples::add);
            assertFalse(reader.next(new EventBatch(4)));
        }
        assertEquals(List.of(new ImuSample(5, 1, 2, 3), new ImuSample(6, 10, 20, 30)), samples);
    }

    /** Other than for events, raw x runs from left to right. Brightness is what the exposure took from the reset. */
    @Test public void deliversFramesToThoseWhoWantThem() throws Exception {
        header = "#!AER-DAT2.0\r\n" + DAVIS + END;
        byte[][] records = new byte[2 * 240 * 180 + 2][];
        int n = 0;
        for (int read = 0; read < 2; read++) {
            for (int x = 0; x < 240; x++) {
                for (int y = 0; y < 180; y++) {
                    records[n++] = aps(read * 1000 + x, x, y, read, 1000 - read * 4 * x);
                }
            }
        }
        // the second signal read of a pixel begins the next frame, which is never whole
        records[n++] = aps(5000, 0, 0, 0, 900);
        records[n] = aps(5001, 0, 0, 1, 100);
        Path file = Files.write(path().resolve("a.aedat"), join(header, records));
        List<GreyFrame> frames = new ArrayList<>();
        try (RecordingReader reader = Recordings.open(file, ReadResult.PLAIN)) {
            reader.onFrame(frames::add);
            assertFalse(reader.next(new EventBatch(4)));
            assertEquals(records.length, reader.counts().apsSamples());
        }
        assertEquals(1, frames.size());
        GreyFrame frame = frames.get(0);
        assertEquals("240x180 at 1000", frame.width() + "x" + frame.height() + " at " + frame.timeUs());
        // 1000 - (1000 - 4 x), then from 10 bits to 8
        assertEquals(List.of(0, 7, 224), List.of(frame.level(0, 0), frame.level(7, 100), frame.level(224, 179)));
    }

    @Test public void frameWithoutAllItsSamplesEndsWhereTheNextBegins() throws Exception {
        header = "#!AER-DAT2.0\r\n" + DAVIS + END;
        Path file = Files.write(path().resolve("a.aedat"), join(header, aps(1, 3, 0, 0, 800), aps(2, 3, 0, 1, 400),
                aps(3, 3, 0, 0, 800), aps(4, 3, 0, 1, 600)));
        List<GreyFrame> frames = new ArrayList<>();
        try (RecordingReader reader = Recordings.open(file, ReadResult.PLAIN)) {
            reader.onFrame(frames::add);
            assertFalse(reader.next(new EventBatch(4)));
        }
        assertEquals(1, frames.size());
        assertEquals(2, frames.get(0).timeUs());
        assertEquals(100, frames.get(0).level(3, 179));
        assertEquals(0, frames.get(0).level(4, 179));
    }

    @Test public void reportsAnImuSampleThatMissesAWord() throws Exception {
        header = "#!AER-DAT2.0\r\n" + DAVIS + END;
        byte[][] records = new byte[13][];
        for (int i = 0, code = 0; i < 13; i++, code = i == 2 ? 3 : (code + 1) % 7) {
            records[i] = record(0x80000C00 | code << 28, 10);
        }
        ReadResult read = read(records);
        assertEquals(1, read.counts.imuSamples());
        assertEquals(List.of("[a.aedat] event 0 at byte " + (header.length() + 16)
                + ": malformed, an IMU sample's word must have code 2 but had 3"), read.faults);
    }

    /** A block of 0xFF, as of a flash memory, is IMU words of a code that none has. */
    @Test public void wordsOfNoImuSampleAreMalformed() throws Exception {
        header = "#!AER-DAT2.0\r\n" + DAVIS + END;
        ReadResult read = read(davis(1, 0, 0, 1), record(-1, -1), record(-1, -1), record(-1, -1), davis(2, 0, 0, 1));
        assertEquals(3, read.counts.malformed());
        assertEquals(1, read.counts.doubtfulShare(), 0.5);
    }

    @Test public void reportsAnImuSampleThatTheEndCutsOffAndEndsWell() throws Exception {
        header = "#!AER-DAT2.0\r\n" + DAVIS + END;
        ReadResult read = read(davis(1, 0, 0, 1), record(0x80000C00, 2), record(0x90000C00, 2));
        assertNull(read.error);
        assertEquals(0, read.counts.imuSamples());
        assertEquals(List.of("[a.aedat] event 1 at byte " + (header.length() + 24)
                + ": truncated, an IMU sample must have 7 words but had 2"), read.faults);
    }

    @Test public void dropsAndReportsEventsOutsideTheSensor() throws Exception {
        header = "#!AER-DAT2.0\r\n" + DAVIS + END;
        ReadResult read = read(davis(1, 0, 0, 1), davis(2, 301, 0, 1), davis(3, 0, 180, 1), davis(4, 0, 0, 1));
        assertEquals(List.of("1 239 179 1", "4 239 179 1"), read.events);
        assertEquals(2, read.counts.outsideSensor());
        assertEquals(List.of("[a.aedat] event 1 at byte " + (header.length() + 8)
                + ": x must be smaller than width 240 but was 301 (the first of 2)"), read.faults);
    }

    @Test public void undoesOverflowsOfTime() throws Exception {
        ReadResult read = read(dvs(Integer.MAX_VALUE, 0, 0, 1), dvs(Integer.MIN_VALUE, 0, 0, 1), dvs(-1, 0, 0, 1),
                dvs(1_000_000_000, 0, 0, 1), dvs(Integer.MIN_VALUE, 0, 0, 1));
        // 2^31 - 1, 2^31, 2^32 - 1, 2^32 + 10^9, 2^32 + 2^31
        assertEquals(List.of("2147483647 127 127 1", "2147483648 127 127 1", "4294967295 127 127 1",
                "5294967296 127 127 1", "6442450944 127 127 1"), read.events);
        assertEquals(2, read.counts.timeWraps());
        assertEquals(List.of(), read.faults);
    }

    @Test public void recognisesAnEventThatAnOverflowOvertook() throws Exception {
        ReadResult read = read(dvs(Integer.MAX_VALUE, 0, 0, 1), dvs(Integer.MIN_VALUE, 0, 0, 1),
                dvs(Integer.MAX_VALUE - 1, 0, 0, 1), dvs(Integer.MIN_VALUE + 2, 0, 0, 1));
        assertEquals(List.of("2147483647 127 127 1", "2147483648 127 127 1", "2147483648 127 127 1",
                "2147483650 127 127 1"), read.events);
        assertEquals(1, read.counts.timeWraps());
        assertEquals(1, read.counts.stepsBack());
    }

    @Test public void leavesNegativeTimesAsTheyAre() throws Exception {
        ReadResult read = read(dvs(-2_000_000_000, 0, 0, 1), dvs(-5, 0, 0, 1), dvs(0, 0, 0, 1), dvs(5, 0, 0, 1));
        assertEquals(List.of("-2000000000 127 127 1", "-5 127 127 1", "0 127 127 1", "5 127 127 1"), read.events);
        assertEquals(0, read.counts.timeWraps());
    }

    @Test public void deliversStepsBackWithTheGreatestTimeAndCountsThem() throws Exception {
        ReadResult read = read(dvs(50, 0, 0, 1), dvs(40, 0, 0, 1), dvs(45, 0, 0, 1), dvs(51, 0, 0, 1));
        assertEquals(List.of("50 127 127 1", "50 127 127 1", "50 127 127 1", "51 127 127 1"), read.events);
        assertEquals(2, read.counts.stepsBack());
        assertEquals(List.of("[a.aedat] event 1 at byte " + (header.length() + 8)
                + ": time must not fall below 50 us but was 40 us (the first of 2)"), read.faults);
    }

    @Test public void endsAtAStepBackIfStrict() throws Exception {
        byte[] bytes = join(header, dvs(50, 0, 0, 1), dvs(40, 0, 0, 1), dvs(51, 0, 0, 1));
        ReadResult read = ReadResult.of(path(), "a.aedat", bytes, ReadResult.PLAIN.withStrict(true));
        assertEquals(List.of("50 127 127 1"), read.events);
        assertEquals("[a.aedat] event 1 at byte " + (header.length() + 8)
                + ": malformed, time must not fall below 50 us but was 40 us", read.error);
    }

    /** 0x23 is '#': raw y 140 of a DAVIS346 starts a record so. */
    @Test public void takesAFirstByteOfDataForDataEvenIfItStartsAHeaderLine() throws Exception {
        byte[] first = record(0x23 << 24, 1);
        String davis346 = "# AEChip: eu.seebetter.ini.chips.davis.Davis346red\r\n";
        for (String end : new String[] {END, "#end of ascii header\r\n", ""}) {
            header = "#!AER-DAT2.0\r\n" + davis346 + end;
            ReadResult read = read(first, first, record('\n', 2));
            assertEquals(end, List.of("1 345 119 -1", "1 345 119 -1", "2 345 259 -1"), read.events);
        }
    }

    /** A note with an escape, a bell, a letter of a foreign character set. */
    @Test public void headerLinesWithControlCharactersAreNoEvents() throws Exception {
        String[] notes = {"# made \u001B[1mby hand\u0007 on a quiet evening\r\n", "# \u0001\r\n",
            "#\u0000\u0000\u0000\r\n"};
        for (String note : notes) {
            header = "#!AER-DAT2.0\r\n" + DVS128 + note + "# and one more line\r\n" + END;
            ReadResult read = read(dvs(100, 0, 0, 1), dvs(101, 127, 5, -1));
            assertEquals(List.of("100 127 127 1", "101 0 122 -1"), read.events);
            assertEquals(List.of(), read.faults);
        }
        // old files have no last line of their own: a line of text is one all the same
        header = "#!AER-DAT2.0\r\n" + DVS128 + notes[0];
        assertEquals(List.of("100 127 127 1"), read(dvs(100, 0, 0, 1)).events);
    }

    @Test public void deliversEveryEventBeforeATruncationAtAnyByte() throws Exception {
        byte[] whole = join(header, dvs(1, 1, 1, 1), dvs(2, 2, 2, 1), dvs(3, 3, 3, 1), dvs(4, 4, 4, -1));
        List<String> all = readFile(whole).events;
        for (int length = 0; length < whole.length; length++) {
            ReadResult read = readFile(Arrays.copyOf(whole, length));
            int records = (length - header.length()) / 8;
            int left = (length - header.length()) % 8;
            if (length < header.length()) {
                assertEquals(List.of(), read.events);
                assertTrue("at " + length + ": " + read.error, read.error == null || read.error.contains("truncated")
                        || read.error.contains("the recording names no chip"));
            } else {
                assertEquals(all.subList(0, records), read.events);
                assertEquals(left == 0 ? null : "[a.aedat] event " + records + " at byte " + (length - left)
                        + ": truncated, a record must have 8 bytes but had " + left, read.error);
            }
        }
    }

    @Test public void neverGuessesTheChip() throws Exception {
        header = "#!AER-DAT2.0\r\n";
        assertEquals("[a.aedat] the recording names no chip: --chip must name one of " + KNOWN,
                read(dvs(1, 0, 0, 1)).error);
        header = "#!AER-DAT2.0\r\n# AEChip: my.own.Chip\r\n";
        assertEquals("[a.aedat] the recording's chip my.own.Chip is not known: --chip must name one of " + KNOWN,
                read(dvs(1, 0, 0, 1)).error);
    }

    @Test public void refusesASizeInPlaceOfAChip() throws Exception {
        header = "#!AER-DAT2.0\r\n";
        assertEquals("[a.aedat] --chip must name one of " + KNOWN + ", because a size does not say how "
                + "addresses are packed, but was 240x180", readWithChip("240x180").error);
    }

    @Test public void prefersTheHeadersChipAndSaysSo() throws Exception {
        ReadResult read = readWithChip("DAVIS240C");
        assertEquals(List.of("1 127 127 1"), read.events);
        assertEquals(List.of("[a.aedat] the header names DVS128, so --chip DAVIS240C was not used; --force-chip uses "
                + "it"), read.notes);
        assertEquals(List.of(), readWithChip("dvs128").notes);
        header = "#!AER-DAT2.0\r\n# AEChip: my.own.Chip\r\n" + END;
        read = readWithChip("DVS128");
        assertEquals(List.of("1 127 127 1"), read.events);
        assertEquals(List.of("[a.aedat] the header's chip my.own.Chip is not known, so --chip DVS128 was used"),
                read.notes);
        assertEquals("what was chosen is no fault", List.of(), read.faults);
    }

    @Test public void reportsAddressesThatNoDvs128Has() throws Exception {
        ReadResult read = read(dvs(1, 0, 0, 1), record(0x12340000, 2));
        assertEquals(List.of("1 127 127 1", "2 127 127 1"), read.events);
        assertEquals(List.of("[a.aedat] event 1 at byte " + (header.length() + 8)
                + ": malformed, a DVS128 address must "
                + "have 16 bits but was 0x12340000; its low 16 bits were used"), read.faults);
    }

    private ReadResult readWithChip(String chip) throws IOException {
        return ReadResult.of(path(), "a.aedat", join(header, dvs(1, 0, 0, 1)), ReadResult.PLAIN.withChip(chip));
    }

    private ReadResult read(byte[]... records) throws IOException {
        return readFile(join(header, records));
    }

    private ReadResult readFile(byte[] bytes) throws IOException {
        return ReadResult.of(path(), "a.aedat", bytes, ReadResult.PLAIN);
    }

    private Path path() {
        return folder.getRoot().toPath();
    }

    private static byte[] dvs(int time, int rawX, int rawY, int polarity) {
        return record(rawX << 1 | rawY << 8 | (polarity > 0 ? 0 : 1), time);
    }

    private static byte[] davis(int time, int rawX, int rawY, int polarity) {
        return record(rawX << 12 | rawY << 22 | (polarity > 0 ? 1 << 11 : 0), time);
    }

    private static byte[] aps(int time, int rawX, int rawY, int read, int sample) {
        return record(1 << 31 | rawX << 12 | rawY << 22 | read << 10 | sample, time);
    }

    private static byte[] record(int address, int time) {
        return ByteBuffer.allocate(8).putInt(address).putInt(time).array();
    }

    private static byte[] join(String header, byte[]... parts) {
        ByteBuffer all = ByteBuffer.allocate(1_000_000).put(header.getBytes(StandardCharsets.US_ASCII));
        for (byte[] part : parts) {
            all.put(part);
        }
        return Arrays.copyOf(all.array(), all.position());
    }
}
