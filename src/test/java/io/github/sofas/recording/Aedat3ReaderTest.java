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

public class Aedat3ReaderTest {
    @Rule public final TemporaryFolder folder = new TemporaryFolder();

    private String header = "#!AER-DAT3.1\r\n#Format: RAW\r\n#Source 1: DVS128\r\n#!END-HEADER\r\n";
    private int eventBytes = 8;
    private int timePlace = 4;
    private int overflow;
    private int source = 1;
    private int announced = -1;

    /** 3.1: bit 0 valid, bit 1 polarity, y from bit 2, x from bit 17. */
    @Test public void readsPolarityEvents() throws Exception {
        ReadResult read = read(packet(1, word(5, 6, 1), 10, word(127, 0, 0), 11));
        assertEquals(List.of("10 5 6 1", "11 127 0 -1"), read.events);
        assertEquals(List.of(), read.faults);
        assertNull(read.error);
    }

    @Test public void reads30WithItsOwnBits() throws Exception {
        header = header.replace("3.1", "3.0");
        assertEquals(List.of("10 5 6 1"), read(packet(1, 5 << 18 | 6 << 4 | 3, 10)).events);
    }

    /** One overflow is worth 2^31 us. */
    @Test public void addsTheOverflowsOfTime() throws Exception {
        overflow = 3;
        assertEquals(List.of((3L << 31) + 10 + " 5 6 1"), read(packet(1, word(5, 6, 1), 10)).events);
    }

    @Test public void countsOtherPacketsAndInvalidEvents() throws Exception {
        ReadResult read = read(packet(0, 0, 0), packet(2, 0, 0, 0, 0), packet(3, 0, 0), packet(9, 0, 0),
                packet(1, word(5, 6, 1) - 1, 10, word(128, 0, 1), 10, word(1, 1, 1), 11));
        assertEquals(List.of("11 1 1 1"), read.events);
        assertEquals(new RecordingCounts(1, 0, 2, 1, 1, 1, 1, 0, 0, 1, 0, 0, 0), read.counts);
        assertEquals(List.of("[a.aedat] event 1 at byte " + (header.length() + 4 * 36 + 8 + 28 + 8)
                + ": x must be smaller than width 128 but was 128"), read.faults);
    }

    @Test public void passesOverEventsOfAnotherSource() throws Exception {
        source = 2;
        ReadResult read = read(packet(1, word(5, 6, 1), 10));
        assertEquals(List.of(), read.events);
        assertEquals(1, read.counts.otherRecords());
        assertEquals(List.of("[a.aedat] event 0 at byte " + header.length() + ": unsupported, a packet of events must "
                + "come from source 1 but came from 2; it was passed over"), read.faults);
    }

    @Test public void deliversEveryEventBeforeATruncationAtAnyByte() throws Exception {
        byte[] file = join(packet(1, word(1, 1, 1), 1, word(2, 2, 1), 2), packet(2, 0, 0), packet(1, word(3, 3, 1), 3));
        List<String> all = readFile(file).events;
        assertEquals(3, all.size());
        for (int length = 0; length < file.length; length++) {
            ReadResult read = readFile(Arrays.copyOf(file, length));
            int data = length - header.length();
            int whole = data < 36 ? 0 : data < 44 ? 1 : 2;
            assertEquals(all.subList(0, whole), read.events);
            boolean atPacket = data == 0 || data == 44 || data == 80;
            assertTrue("cut at " + length + ": " + read.error,
                    atPacket ? read.error == null : read.error.contains("truncated"));
        }
    }

    @Test public void refusesPacketsThatContradictThemselves() throws Exception {
        announced = -2;
        assertError("malformed, a packet's number of events must not be negative but was -2");
        announced = -1;
        eventBytes = 7;
        assertError("malformed, an event must have at least 8 bytes but had 7");
        eventBytes = Integer.MAX_VALUE;
        assertError("malformed, an event must have at most " + RecordingFile.BUFFER_BYTES
            + " bytes but had 2147483647");
        eventBytes = 8;
        timePlace = 5;
        assertError("malformed, an event's time must lie between byte 4 and 4 of it but lay at 5");
        timePlace = 4;
        overflow = -1;
        assertError("malformed, a packet's overflow of time must not be negative but was -1");
    }

    @Test public void allocatesNothingForANumberThatLies() throws Exception {
        announced = Integer.MAX_VALUE;
        ReadResult read = read(packet(1, word(5, 6, 1), 10));
        assertEquals(List.of("10 5 6 1"), read.events);
        assertEquals("[a.aedat] event 1 at byte " + (header.length() + 36) + ": truncated, a packet must hold "
                + "2147483646 more events of 8 bytes but had 0 bytes", read.error);
    }

    @Test public void refusesOtherFormatsAndVersions() throws Exception {
        String good = header;
        header = good.replace("RAW", "SerializedTS");
        assertEquals("[a.aedat] header at byte 0: unsupported, the format must be RAW but was SerializedTS",
                read(packet(1, 0, 0)).error);
        header = good.replace("3.1", "3.7");
        assertEquals("[a.aedat] header at byte 9: unsupported, the AEDAT version must be one of 1.0, 2.0, 3.0, 3.1, "
                + "4.0 but was \"3.7\"", read(packet(1, 0, 0)).error);
        header = good.replace("#!END-HEADER\r\n", "");
        assertEquals("[a.aedat] header at byte " + header.length()
                + ": malformed, it must end with the line #!END-HEADER",
                read(packet(1, 0, 0)).error);
    }

    private void assertError(String rule) throws IOException {
        assertEquals("[a.aedat] event 0 at byte " + header.length() + ": " + rule,
                read(packet(1, word(5, 6, 1), 10)).error);
    }

    private static int word(int x, int y, int on) {
        return x << 17 | y << 2 | on << 1 | 1;
    }

    private byte[] packet(int type, int... words) {
        ByteBuffer packet = ByteBuffer.allocate(28 + 4 * words.length).order(ByteOrder.LITTLE_ENDIAN);
        int number = announced == -1 ? words.length / 2 : announced;
        packet.putShort((short) type).putShort((short) source).putInt(eventBytes).putInt(timePlace).putInt(overflow);
        packet.putInt(number).putInt(number).putInt(number);
        for (int word : words) {
            packet.putInt(word);
        }
        return packet.array();
    }

    private ReadResult read(byte[]... packets) throws IOException {
        return readFile(join(packets));
    }

    private ReadResult readFile(byte[] file) throws IOException {
        return ReadResult.of(folder.getRoot().toPath(), "a.aedat", file, ReadResult.PLAIN);
    }

    private byte[] join(byte[]... packets) {
        ByteArrayOutputStream all = new ByteArrayOutputStream();
        all.writeBytes(header.getBytes(StandardCharsets.US_ASCII));
        for (byte[] packet : packets) {
            all.writeBytes(packet);
        }
        return all.toByteArray();
    }
}
