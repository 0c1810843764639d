package io.github.sofas.recording;

import static org.junit.Assert.assertEquals;
import static org.junit.Assert.assertNull;
import static org.junit.Assert.assertTrue;

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

/** Prophesee's RAW: EVT 2.0, 2.1 and 3.0. */
public class EvtReaderTest {
    @Rule public final TemporaryFolder folder = new TemporaryFolder();

    private static final String EVT2 = "% evt 2.0\n% geometry 640x480\n% end\n";
    private static final String EVT21 = "% format EVT21;height=480;width=640\n";
    private static final String EVT3 = "% evt 3.0\n% format EVT3\n% geometry 1280x720\n";

    private static byte[] words16(int... words) {
        ByteBuffer bytes = ByteBuffer.allocate(2 * words.length).order(ByteOrder.LITTLE_ENDIAN);
        for (int word : words) {
            bytes.putShort((short) word);
        }
        return bytes.array();
    }

    private static byte[] words32(int... words) {
        ByteBuffer bytes = ByteBuffer.allocate(4 * words.length).order(ByteOrder.LITTLE_ENDIAN);
        for (int word : words) {
            bytes.putInt(word);
        }
        return bytes.array();
    }

    private static byte[] words64(long... words) {
        ByteBuffer bytes = ByteBuffer.allocate(8 * words.length).order(ByteOrder.LITTLE_ENDIAN);
        for (long word : words) {
            bytes.putLong(word);
        }
        return bytes.array();
    }

    private static byte[] file(String header, byte[] words) {
        ByteArrayOutputStream all = new ByteArrayOutputStream();
        all.writeBytes(header.getBytes(StandardCharsets.US_ASCII));
        all.writeBytes(words);
        return all.toByteArray();
    }

    private ReadResult read(String header, byte[] words) throws IOException {
        return ReadResult.of(folder.getRoot().toPath(), "a.raw", file(header, words), ReadResult.PLAIN);
    }

    /** The first words of a camera's recording: 0x8AAE is time 0xAAE << 12, 0x66E0 its low bits, 0x013B row 315. */
    @Test public void readsEvt3WordsOfACamera() throws Exception {
        ReadResult read = read(EVT3, words16(0x8AAE, 0x66E0, 0x013B, 0x29E4, 0x66E1, 0x00E7, 0x21DA, 0x0135, 0x29C2));
        // 0xAAE6E0 = 11200224; 0x9E4: bit 11 is ON, 0x1E4 = 484
        assertEquals(List.of("11200224 484 315 1", "11200225 474 231 -1", "11200225 450 309 1"), read.events);
        assertEquals(List.of(), read.faults);
        assertNull(read.error);
    }

    /** The first words of a camera's recording: 0x0D9D8D0 << 6 = 913716224, 0x100119BB is ON at 35, 443. */
    @Test public void readsEvt2WordsOfACamera() throws Exception {
        ReadResult read = read(EVT2, words32(0x80D9D8D0, 0x100119BB, 0x100121BB, 0x100251BB));
        assertEquals(List.of("913716224 35 443 1", "913716224 36 443 1", "913716224 74 443 1"), read.events);
        assertEquals(List.of(), read.faults);
    }

    @Test public void readsTheVectorsOfEvt3FromTheBaseToTheRight() throws Exception {
        ReadResult read = read(EVT3, words16(0x8000, 0x6005, 0x0007, 0x3000 | 1 << 11 | 100, 0x4801, 0x4002, 0x5081));
        // 0x801: 100 and 111; then from 112 bit 1; then from 124 bits 0 and 7
        assertEquals(List.of("5 100 7 1", "5 111 7 1", "5 113 7 1", "5 124 7 1", "5 131 7 1"), read.events);
    }

    @Test public void readsTheVectorsOfEvt21FromTheBaseToTheRight() throws Exception {
        long event = (1L << 28 | 9 << 22 | 32 << 11 | 5) << 32 | 0x8000_0003L;
        long next = (0L << 28 | 10 << 22 | 1 << 11 | 6) << 32 | 1;
        ReadResult read = read(EVT21, words64((8L << 28 | 2) << 32, event, next));
        assertEquals(List.of("137 32 5 1", "137 33 5 1", "137 63 5 1", "138 1 6 -1"), read.events);
    }

    @Test public void swapsTheHalvesOfLegacyEvt21() throws Exception {
        long event = 0x8000_0003L << 32 | (1L << 28 | 9 << 22 | 32 << 11 | 5);
        String header = "% format EVT21;endianness=legacy;height=480;width=640\n";
        assertEquals(List.of("137 32 5 1", "137 33 5 1", "137 63 5 1"),
                read(header, words64(8L << 28 | 2, event)).events);
        header = "% evt 2.1\n% endianness legacy\n% geometry 640x480\n";
        assertEquals(3, read(header, words64(8L << 28 | 2, event)).events.size());
    }

    /** 12 high and 12 low bits are 16.8 s, 28 and 6 are 4.8 hours. */
    @Test public void undoesOverflowsOfTime() throws Exception {
        ReadResult read = read(EVT3, words16(0x8FFF, 0x6FFF, 0x0000, 0x2000, 0x8000, 0x6000, 0x2001));
        assertEquals(List.of("16777215 0 0 -1", "16777216 1 0 -1"), read.events);
        assertEquals(1, read.counts.timeWraps());
        read = read(EVT2, words32(0x8FFFFFFF, 63 << 22, 0x80000000, 1 << 11));
        assertEquals(List.of((1L << 34) - 1 + " 0 0 -1", (1L << 34) + " 1 0 -1"), read.events);
        assertEquals(1, read.counts.timeWraps());
    }

    /** The high bits come before the low ones: until those, time is that of the high bits alone. */
    @Test public void newHighBitsBeginWithLowBitsOfZero() throws Exception {
        assertEquals(List.of("5 0 0 -1", "4096 1 0 -1", "4096 2 0 -1"),
                read(EVT3, words16(0x8000, 0x6005, 0x0000, 0x2000, 0x8001, 0x2001, 0x8001, 0x2002)).events);
    }

    @Test public void countsTriggersAndWordsOfOtherKinds() throws Exception {
        ReadResult read = read(EVT3, words16(0x8000, 0xA100, 0x7123, 0xE014, 0xF001, 0x9999, 0x1234, 0x0001, 0x2002));
        assertEquals(List.of("0 2 1 -1"), read.events);
        assertEquals(new RecordingCounts(1, 0, 0, 0, 1, 0, 0, 0, 0, 5, 0, 0, 0), read.counts);
        read = read(EVT2, words32(0x80000000, 0xA0000000, 0xE0000000, 0xF0000000, 0x70000000, 0));
        assertEquals(new RecordingCounts(1, 0, 0, 0, 1, 0, 0, 0, 0, 3, 0, 0, 0), read.counts);
        read = read(EVT21, words64(8L << 60, 0xAL << 60, 0xEL << 60, 1));
        assertEquals(new RecordingCounts(1, 0, 0, 0, 1, 0, 0, 0, 0, 1, 0, 0, 0), read.counts);
    }

    @Test public void passesOverWhatComesBeforeTheFirstTime() throws Exception {
        ReadResult read = read(EVT3, words16(0x0001, 0x2002, 0x8000, 0x2005, 0x4001, 0x0003, 0x2004));
        assertEquals(List.of("0 4 3 -1"), read.events);
        assertEquals(new RecordingCounts(1, 0, 0, 0, 0, 2, 0, 0, 0, 2, 0, 0, 0), read.counts);
        int at = EVT3.length();
        assertEquals(List.of("[a.raw] event 0 at byte " + at + ": malformed, a recording must begin with a word of "
                + "time; the words before it were passed over (the first of 2)", "[a.raw] event 0 at byte " + (at + 6)
                + ": malformed, an event's row and a vector's base must come before it; it was passed over (the first "
                + "of 2)"), read.faults);
    }

    @Test public void countsAndReportsEventsOutsideTheSensor() throws Exception {
        ReadResult read = read("% evt 2.0\n% geometry 64x48\n", words32(0x80000000, 64 << 11, 48, 63 << 11 | 47));
        assertEquals(List.of("0 63 47 -1"), read.events);
        assertEquals(2, read.counts.outsideSensor());
        assertEquals(List.of("[a.raw] event 0 at byte 31: x must be smaller than width 64 but was 64 (the first of 2)"),
                read.faults);
        read = read("% evt 3.0\n% geometry 64x48\n", words16(0x8000, 0x0000, 0x303E, 0x400F, 0x0030, 0x2000));
        assertEquals(List.of("0 62 0 -1", "0 63 0 -1"), read.events);
        assertEquals(3, read.counts.outsideSensor());
    }

    @Test public void givesAStepBackTheTimeBefore() throws Exception {
        ReadResult read = read(EVT3, words16(0x8001, 0x6009, 0x0000, 0x2000, 0x6005, 0x2001, 0x3000, 0x4003));
        assertEquals(List.of("4105 0 0 -1", "4105 1 0 -1", "4105 0 0 -1", "4105 1 0 -1"), read.events);
        assertEquals(3, read.counts.stepsBack());
        assertEquals(List.of("[a.raw] event 1 at byte " + (EVT3.length() + 10) + ": time must not fall below 4105 us "
                + "but was 4101 us (the first of 3)"), read.faults);
    }

    @Test public void headerEndsWithOrWithoutALineThatSaysSo() throws Exception {
        byte[] words = words16(0x8000, 0x0001, 0x2002);
        for (String end : List.of("", "% end\n", "%  end\r\n")) {
            assertEquals(List.of("0 2 1 -1"), read(EVT3 + end, words).events);
        }
        // data that begins as a line of the header does: 0x2025 is an event, before any time
        assertEquals(1, read(EVT3, words16(0x2025, 0x8000, 0x0001, 0x2002)).counts.otherRecords());
        // and after the line that ends it, even what reads as text
        byte[] likeText = file("% abc\n", words);
        assertEquals(List.of("0 2 1 -1"), read(EVT3 + "% end\n", likeText).events);
    }

    @Test public void asksForTheSizeAndTheEncodingWhereTheHeaderDoesNotSayThem() throws Exception {
        String error = read("% evt 2.0\n", words32(0x80000000, 0)).error;
        assertTrue(error, error.startsWith("[a.raw] the recording names no chip: --chip must name one of ")
                && error.endsWith(" or a size such as 240x180; all its events lie within 34x34"));
        byte[] file = file("% evt 2.0\n", words32(0x80000000, 639 << 11));
        assertEquals(List.of("0 639 0 -1"),
                ReadResult.of(folder.getRoot().toPath(), "a.raw", file, ReadResult.PLAIN.withChip("640x480")).events);
        assertEquals("[a.raw] header at byte 0: unsupported, the encoding must be one of EVT2, EVT21, EVT3 but the "
                + "header does not say it", read("% geometry 640x480\n", new byte[4]).error);
        assertEquals("[a.raw] header at byte 0: unsupported, the encoding must be one of EVT2, EVT21, EVT3 but was "
                + "HISTO3D", read("% format HISTO3D;height=320;width=320\n", new byte[4]).error);
        assertEquals("[a.raw] header at byte 0: unsupported, the sensor must measure 1x1 to 1280x720 but was 0x480",
                read("% evt 2.0\n% geometry 0x480\n", new byte[4]).error);
    }

    @Test public void namesWordsThatTheEndCutsOff() throws Exception {
        byte[] words = words32(0x80000000, 0, 0x00400000);
        ReadResult read = read(EVT2, Arrays.copyOf(words, 10));
        assertEquals(List.of("0 0 0 -1"), read.events);
        assertEquals("[a.raw] event 1 at byte " + (EVT2.length() + 8)
                + ": truncated, a word must have 4 bytes but had 2", read.error);
    }
}
