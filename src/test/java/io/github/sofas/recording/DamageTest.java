package io.github.sofas.recording;

import static org.junit.Assert.assertEquals;
import static org.junit.Assert.assertNull;
import static org.junit.Assert.assertTrue;

import com.github.luben.zstd.Zstd;
import com.sun.management.ThreadMXBean;
import io.github.sofas.Skipped;
import io.github.sofas.event.EventBatch;
import io.github.sofas.event.EventSourceException;
import io.github.sofas.recording.Aedat4Format.Compression;
import java.io.IOException;
import java.lang.management.ManagementFactory;
import java.nio.charset.StandardCharsets;
import java.nio.file.FileSystemException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.nio.file.StandardOpenOption;
import java.util.Arrays;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;
import org.apache.commons.compress.compressors.lz4.FramedLZ4CompressorOutputStream.BlockSize;
import org.apache.commons.compress.compressors.lz4.FramedLZ4CompressorOutputStream.Parameters;
import org.junit.Rule;
import org.junit.Test;
import org.junit.rules.TemporaryFolder;

/** Damage of every kind, whatever the format: what was whole before it is delivered, and it costs bounded memory. */
public class DamageTest {
    private static final RecordingOptions DVS128 = RecordingOptions.defaults().withChip("DVS128")
        .withForceChip(true);
    private static final RecordingOptions DAVIS = RecordingOptions.defaults().withChip("240x180");
    private static final long BUFFERS = 1 << 20;

    @Rule
    public final TemporaryFolder folder = new TemporaryFolder();

    private Path root() {
        return folder.getRoot().toPath();
    }

    private ReadResult read(String name, byte[] bytes, RecordingOptions options) throws IOException {
        return ReadResult.of(root(), name, bytes, options);
    }

    /** Recordings with their names, valid and small. */
    private static Map<String, List<byte[]>> recordings() throws IOException {
        Map<String, List<byte[]>> all = new LinkedHashMap<>();
        all.put("a.dat", ReaderFuzz.Aedat1.seeds());
        all.put("dvs128.aedat", ReaderFuzz.Aedat2Dvs128.seeds());
        all.put("davis.aedat", ReaderFuzz.Aedat2Davis.seeds());
        all.put("3.aedat", ReaderFuzz.Aedat3.seeds());
        all.put("4.aedat4", ReaderFuzz.Aedat4.seeds());
        all.put("a.raw", ReaderFuzz.Evt.seeds());
        all.put("b.dat", ReaderFuzz.Dat.seeds());
        all.put("a.es", ReaderFuzz.EventStream.seeds());
        all.put("a.bin", ReaderFuzz.NMnist.seeds());
        // what is cut from the others may make their header or unit another
        all.put("a.txt", ReaderFuzz.Text.seeds().subList(0, 2));
        return all;
    }

    @Test
    public void deliversWhatIsWholeBeforeACutAtAnyByteAndNamesTheCut() throws Exception {
        for (Map.Entry<String, List<byte[]>> entry : recordings().entrySet()) {
            String name = entry.getKey();
            RecordingOptions options = name.endsWith(".txt") || name.startsWith("3") ? DAVIS : DVS128;
            for (byte[] whole : entry.getValue()) {
                List<String> all = read(name, whole, options).events;
                int before = 0;
                int unnamed = 0;
                for (int length = 0; length <= whole.length; length++) {
                    ReadResult cut = read(name, Arrays.copyOf(whole, length), options);
                    String what = name + " cut at " + length + " of " + whole.length + ": " + cut.events + cut.error;
                    int n = cut.events.size();
                    // text that ends inside a number is a line too
                    boolean insideNumber = name.endsWith(".txt") && n > 0;
                    int sure = insideNumber ? n - 1 : n;
                    assertEquals(what, all.subList(0, sure), cut.events.subList(0, sure));
                    assertTrue(what, n >= before);
                    before = insideNumber ? n - 1 : n;
                    boolean named = cut.error != null && cut.error.matches(
                        "\\[\\Q" + name + "\\E\\] (header|line|event) .*\\b(truncated|malformed), .*");
                    assertTrue(what, named || cut.error == null);
                    unnamed += named ? 0 : 1;
                }
                // where a record, a packet or a line ends, nothing is missing
                int mostUnnamed = name.endsWith(".txt") ? 18
                    : whole.length / (name.startsWith("3") ? 28 : name.endsWith(".raw") ? 2 : 5);
                assertTrue(name + ": " + unnamed, unnamed <= mostUnnamed);
                assertEquals(name, all.size(), read(name, whole, options).events.size());
            }
        }
    }

    /** What reading allocates, of which the reader's own buffers are the most. */
    private long allocatedBy(String name, byte[] bytes, RecordingOptions options) throws IOException {
        if (!(ManagementFactory.getThreadMXBean() instanceof ThreadMXBean threads)) {
            throw Skipped.because("this Java does not count what a thread allocates");
        }
        read(name, bytes, options);
        long id = Thread.currentThread().getId();
        long before = threads.getThreadAllocatedBytes(id);
        read(name, bytes, options);
        return threads.getThreadAllocatedBytes(id) - before;
    }

    @Test
    public void sizeThatLiesCostsNoMemory() throws Exception {
        for (int size : new int[] {Integer.MAX_VALUE, -1, 1 << 27, 1 << 30}) {
            Aedat4Bytes bytes = new Aedat4Bytes();
            bytes.dataTable = false;
            byte[] file = bytes.packet(Aedat4Bytes.EVENTS_ID, size, new byte[100]).build();
            long allocated = allocatedBy("a.aedat4", file, RecordingOptions.defaults());
            assertTrue("size " + size + ": " + allocated, allocated < BUFFERS);
            String error = read("a.aedat4", file, RecordingOptions.defaults()).error;
            assertEquals("[a.aedat4] event 0 at byte " + bytes.firstPacketAt() + ": truncated, a packet must have "
                + Integer.toUnsignedString(size) + " bytes but had 100", error);
        }
        byte[] header = new Aedat4Bytes().build();
        for (int i = 0; i < 4; i++) {
            byte[] spoiled = header.clone();
            spoiled[14 + i] = (byte) 0x7F;
            assertTrue(allocatedBy("a.aedat4", spoiled, RecordingOptions.defaults()) < 2 * BUFFERS);
        }
    }

    @Test
    public void bombUnpacksToTheLimitAndNoFurther() throws Exception {
        byte[] zeros = new byte[64 << 20];
        int most = 1 << 20;
        Map<Compression, byte[]> bombs = Map.of(Compression.ZSTD, Zstd.compress(zeros), Compression.LZ4,
            Aedat4Bytes.lz4(zeros, new Parameters(BlockSize.K64, false, false, true)));
        for (Map.Entry<Compression, byte[]> bomb : bombs.entrySet()) {
            try (PacketUnpacker unpacker = new PacketUnpacker(bomb.getKey(), most)) {
                unpacker.unpack(bomb.getValue(), bomb.getValue().length);
                assertEquals("unsupported, a packet must unpack to at most 1048576 bytes", unpacker.fault());
                assertTrue(unpacker.output().length + " bytes", unpacker.output().length <= most + 64);
            }
        }
    }

    @Test
    public void controlCharactersOfAFileReachNoTerminal() throws Exception {
        // 0x9B begins a command to a terminal, as ESC [ does
        byte[] header = "#!AER-DAT2.0\r\n# AEChip: \u009B2Jchip\u007F\r\n".getBytes(StandardCharsets.ISO_8859_1);
        String error = read("a.aedat", header, RecordingOptions.defaults()).error;
        assertTrue(error, error.startsWith("[a.aedat] the recording's chip ?2Jchip? is not known: --chip must name "));
        byte[] version = "#!AER-DAT\u009B\u009B\u009B\r\n".getBytes(StandardCharsets.ISO_8859_1);
        error = read("a.aedat", version, RecordingOptions.defaults()).error;
        assertTrue(error, error.chars().noneMatch(Character::isISOControl));
        error = read("\u001B[2J.aedat4", new byte[0], RecordingOptions.defaults()).error;
        assertEquals("[?[2J.aedat4] header at byte 0: truncated, a recording must not be empty", error);
    }

    @Test
    public void longTextOfAFileIsCutInMessages() throws Exception {
        String error = read("a.txt", ("1e" + "9".repeat(8) + " 0 0 1\n" ).getBytes(StandardCharsets.US_ASCII), DAVIS)
            .error;
        assertEquals("[a.txt] line 1: malformed, time must be smaller than 1000000000000 s but was 1e99999999", error);
        error = read("a.txt", ("9".repeat(4000) + "e0 0 0 1\n").getBytes(StandardCharsets.US_ASCII), DAVIS).error;
        assertEquals("[a.txt] line 1: malformed, time must be smaller than 1000000000000 s but was "
            + "9".repeat(200) + "...", error);
    }

    @Test
    public void linksAreFollowedAndOnesThatLeadNowhereAreNamed() throws Exception {
        Path file = Files.write(root().resolve("real.dat"), ReaderFuzz.Aedat1.seeds().get(0));
        Path link = link("link.dat", file);
        assertEquals(List.of(), open(link));
        Path dangling = link("dangling.dat", root().resolve("gone.dat"));
        assertEquals(List.of("[" + dangling + "] cannot be opened: no such file"), open(dangling));
        Path loop = link("loop.dat", root().resolve("loop.dat"));
        String message = open(loop).get(0);
        // the system's own words follow
        assertTrue(message, message.matches("\\[\\Q" + loop + "\\E\\] cannot be opened: [A-Z][a-z ]+"));
        assertEquals(List.of("[" + root() + "] cannot be opened: is a directory"), open(root()));
    }

    private Path link(String name, Path to) throws IOException {
        try {
            return Files.createSymbolicLink(root().resolve(name), to);
        } catch (UnsupportedOperationException | FileSystemException e) {
            throw Skipped.because("this system makes no links: " + e.getMessage());
        }
    }

    private static List<String> open(Path file) {
        try (RecordingReader reader = Recordings.open(file, DVS128)) {
            return reader.faults();
        } catch (EventSourceException e) {
            return List.of(e.getMessage());
        }
    }

    @Test
    public void fileWithoutPermissionIsNamedSo() throws Exception {
        Path file = Files.write(root().resolve("a.dat"), new byte[6]);
        if (!file.toFile().setReadable(false) || Files.isReadable(file)) {
            throw Skipped.because("this user may read every file");
        }
        assertEquals(List.of("[" + file + "] cannot be opened: no permission to read it"), open(file));
    }

    @Test
    public void fileThatGrowsIsReadAsFarAsItReachesThenAndItIsSaid() throws Exception {
        // larger than the buffer, so that the end is not read when more is written
        Path file = Files.write(root().resolve("a.dat"), new byte[6 * 100_000]);
        EventBatch batch = new EventBatch(1000);
        long events = 0;
        try (RecordingReader reader = Recordings.open(file, DVS128)) {
            assertTrue(reader.next(batch));
            Files.write(file, new byte[6 * 3], StandardOpenOption.APPEND);
            do {
                events += batch.size();
            } while (reader.next(batch));
            assertEquals(100_003, events);
            assertEquals(List.of("[a.dat] event 100003 at byte 600018: the file must not grow while it is read but had "
                + "600000 bytes at first and has 600018 now"), reader.faults());
        }
    }

    @Test
    public void fileThatShrinksEndsWhereItEnds() throws Exception {
        // larger than the buffer, so that the rest is gone when it is asked for
        Path file = Files.write(root().resolve("a.dat"), new byte[6 * 100_000]);
        EventBatch batch = new EventBatch(1000);
        long events = 0;
        try (RecordingReader reader = Recordings.open(file, DVS128)) {
            assertTrue(reader.next(batch));
            Files.write(file, new byte[0], StandardOpenOption.TRUNCATE_EXISTING);
            events = batch.size();
            while (reader.next(batch)) {
                events += batch.size();
            }
        } catch (EventSourceException e) {
            assertTrue(e.getMessage(), e.getMessage().contains("truncated, a record must have 6 bytes but had "));
        }
        assertTrue("events " + events, events > 0 && events < 100_000);
    }

    @Test
    public void xmlOfAHeaderOpensNoFile() throws Exception {
        Path secret = Files.writeString(root().resolve("secret"), "EVTS");
        for (String xml : List.of(
            "<!DOCTYPE dv [<!ENTITY e SYSTEM \"" + secret.toUri() + "\">]><dv>&e;</dv>",
            "<!DOCTYPE dv SYSTEM \"" + secret.toUri() + "\"><dv/>",
            "<!DOCTYPE dv [<!ENTITY a \"aaaaaaaaaa\"><!ENTITY b \"&a;&a;&a;&a;\">]><dv>&b;</dv>")) {
            Aedat4Bytes bytes = new Aedat4Bytes();
            bytes.xml = xml;
            String error = read("a.aedat4", bytes.build(), RecordingOptions.defaults()).error;
            assertTrue(error, error.startsWith("[a.aedat4] header at byte 14: malformed, the streams must be declared "
                + "in XML without a document type but were not: DOCTYPE is disallowed"));
        }
        Aedat4Bytes bytes = new Aedat4Bytes();
        bytes.xml = "<dv xmlns:xi=\"http://www.w3.org/2001/XInclude\"><xi:include href=\"" + secret.toUri()
            + "\" parse=\"text\"/></dv>";
        String error = read("a.aedat4", bytes.build(), RecordingOptions.defaults()).error;
        assertEquals("[a.aedat4] header at byte 14: unsupported, a recording must declare a stream of events (EVTS) "
            + "but had 0 others", error);
        assertNull(read("b.aedat4", new Aedat4Bytes().build(), RecordingOptions.defaults()).error);
    }
}
