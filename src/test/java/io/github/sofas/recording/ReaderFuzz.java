package io.github.sofas.recording;

import static io.github.sofas.FuzzRules.require;

import io.github.sofas.FuzzRules;
import io.github.sofas.event.EventBatch;
import io.github.sofas.event.EventSourceException;
import io.github.sofas.recording.Aedat4Format.Compression;
import java.io.ByteArrayOutputStream;
import java.io.IOException;
import java.io.UncheckedIOException;
import java.nio.ByteBuffer;
import java.nio.ByteOrder;
import java.nio.charset.StandardCharsets;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.List;
import org.apache.commons.compress.compressors.lz4.FramedLZ4CompressorOutputStream.BlockSize;
import org.apache.commons.compress.compressors.lz4.FramedLZ4CompressorOutputStream.Parameters;

/**
 * What every reader must hold to, whatever bytes it is given: events on the sensor in order of time, counted; an end or
 * one exception with a message of one printable line, the same when asked again. Each class inside is a fuzz target.
 */
public final class ReaderFuzz {
    private static final Path FILE = temporaryFolder();
    private static final int BATCH = 64;
    private static final int LONGEST_MESSAGE = 2000;
    private static final long[][] EVENTS = {{1000, 0, 0, 1}, {1002, 15, 11, 0}, {5_000_000_000L, 3, 4, 1}};

    private ReaderFuzz() {
    }

    private static Path temporaryFolder() {
        try {
            Path folder = Files.createTempDirectory("sofas-fuzz");
            folder.toFile().deleteOnExit();
            return folder;
        } catch (IOException e) {
            throw new UncheckedIOException(e);
        }
    }

    /** Reads the bytes as a file of a name. */
    private static void read(String name, byte[] data, RecordingOptions options) {
        Path file = FILE.resolve(name);
        file.toFile().deleteOnExit();
        FuzzRules.write(file, data);
        try (RecordingReader reader = Recordings.open(file, options)) {
            drain(name, reader);
        } catch (EventSourceException e) {
            checkMessage(name, e.getMessage());
        }
    }

    private static void drain(String name, RecordingReader reader) throws EventSourceException {
        EventBatch batch = new EventBatch(BATCH);
        long delivered = 0;
        long lastUs = Long.MIN_VALUE;
        try {
            while (reader.next(batch)) {
                require(batch.size() > 0, "a batch is empty");
                for (int i = 0; i < batch.size(); i++) {
                    require(batch.timeUs[i] >= lastUs, "time falls");
                    lastUs = batch.timeUs[i];
                    require(reader.sensor().contains(batch.x[i], batch.y[i]), "an event lies outside");
                    require(Math.abs(batch.polarity[i]) == 1, "a polarity is neither 1 nor -1");
                }
                delivered += batch.size();
            }
            require(!reader.next(batch), "goes on after its end");
        } catch (EventSourceException e) {
            try {
                reader.next(batch);
                throw new IllegalStateException("goes on after damage");
            } catch (EventSourceException again) {
                require(again == e, "says another thing when asked again");
            }
            throw e;
        } finally {
            require(reader.counts().events() == delivered, "counts what it did not deliver");
            reader.faults().forEach(fault -> checkMessage(name, fault));
        }
    }

    private static void checkMessage(String name, String message) {
        FuzzRules.checkMessage(message, "[" + name + "] ", LONGEST_MESSAGE);
    }

    private static byte[] join(String header, byte[]... parts) {
        ByteArrayOutputStream all = new ByteArrayOutputStream();
        all.writeBytes(header.getBytes(StandardCharsets.ISO_8859_1));
        for (byte[] part : parts) {
            all.writeBytes(part);
        }
        return all.toByteArray();
    }

    private static byte[] words(ByteOrder order, int... words) {
        ByteBuffer bytes = ByteBuffer.allocate(4 * words.length).order(order);
        for (int word : words) {
            bytes.putInt(word);
        }
        return bytes.array();
    }

    /** AEDAT 1.0, with and without a header. */
    public static final class Aedat1 {
        private Aedat1() {
        }

        /** Called by the fuzzer. */
        public static void fuzzerTestOneInput(byte[] data) {
            read("a.dat", data, RecordingOptions.defaults().withChip("DVS128"));
        }

        /** Valid inputs to start from. */
        public static List<byte[]> seeds() {
            byte[] events = ByteBuffer.allocate(18).putShort((short) 0).putInt(5).putShort((short) 0x0203).putInt(6)
                .putShort((short) 0x7FFF).putInt(-6).array();
            return List.of(events, join("#!AER-DAT1.0\r\n# made by hand\r\n", events));
        }
    }

    /** AEDAT 2.0 of a DVS128. */
    public static final class Aedat2Dvs128 {
        private Aedat2Dvs128() {
        }

        /** Called by the fuzzer. */
        public static void fuzzerTestOneInput(byte[] data) {
            read("a.aedat", data, RecordingOptions.defaults().withChip("DVS128").withStrict(data.length % 2 == 1));
        }

        /** Valid inputs to start from. */
        public static List<byte[]> seeds() {
            byte[] events = words(ByteOrder.BIG_ENDIAN, 0x0102, 10, 0x7F7F, 20, 0x8000, 21, 0x0001, Integer.MAX_VALUE,
                0x0003, Integer.MIN_VALUE);
            return List.of(join("#!AER-DAT2.0\r\n# AEChip: ch.unizh.ini.jaer.chip.retina.DVS128\r\n", events),
                join("#!AER-DAT2.0\r\n#End Of ASCII Header\r\n", events));
        }
    }

    /** AEDAT 2.0 of a DAVIS. */
    public static final class Aedat2Davis {
        private Aedat2Davis() {
        }

        /** Called by the fuzzer. */
        public static void fuzzerTestOneInput(byte[] data) {
            read("a.aedat", data, RecordingOptions.defaults().withChip("DAVIS240C"));
        }

        /** Valid inputs to start from. */
        public static List<byte[]> seeds() {
            int[] all = new int[2 * 13];
            for (int code = 0; code < 7; code++) {
                all[2 * code] = 0x80000C00 | code << 28;
                all[2 * code + 1] = 10;
            }
            int[] others = {0x80000000, 10, 0x80000400, 11, 1 << 10, 12, 239 << 12 | 179 << 22 | 1 << 11, 13,
                300 << 12, 14, 5 << 12, -1};
            System.arraycopy(others, 0, all, 14, others.length);
            return List.of(join("#!AER-DAT2.0\r\n# AEChip: eu.seebetter.ini.chips.davis.DAVIS240C\r\n"
                + "#End Of ASCII Header\r\n", words(ByteOrder.BIG_ENDIAN, all)));
        }
    }

    /** AEDAT 3.0 and 3.1. */
    public static final class Aedat3 {
        private Aedat3() {
        }

        /** Called by the fuzzer. */
        public static void fuzzerTestOneInput(byte[] data) {
            read("a.aedat", data, RecordingOptions.defaults().withChip("240x180"));
        }

        /** Valid inputs to start from. */
        public static List<byte[]> seeds() {
            List<byte[]> seeds = new ArrayList<>();
            for (String version : List.of("3.0", "3.1")) {
                seeds.add(join("#!AER-DAT" + version + "\r\n#Format: RAW\r\n#Source 1: DVS128\r\n#!END-HEADER\r\n",
                    packet(1, 5 << 17 | 6 << 2 | 3, 10, 127 << 17 | 1, 11), packet(0, 0, 12), packet(2, 1, 2, 3, 4),
                    packet(3, 0, 0), packet(1, 1 << 17 | 1, 9)));
            }
            return seeds;
        }

        private static byte[] packet(int type, int... body) {
            int[] all = new int[7 + body.length];
            all[0] = type | 1 << 16;
            all[1] = 8;
            all[2] = 4;
            all[4] = all[5] = all[6] = body.length / 2;
            System.arraycopy(body, 0, all, 7, body.length);
            return words(ByteOrder.LITTLE_ENDIAN, all);
        }
    }

    /** AEDAT 4.0. */
    public static final class Aedat4 {
        private Aedat4() {
        }

        /** Called by the fuzzer. */
        public static void fuzzerTestOneInput(byte[] data) {
            read("a.aedat4", data, RecordingOptions.defaults());
        }

        /** Valid inputs to start from. */
        public static List<byte[]> seeds() throws IOException {
            List<byte[]> seeds = new ArrayList<>();
            for (Compression compression : List.of(Compression.NONE, Compression.LZ4, Compression.ZSTD)) {
                Aedat4Bytes bytes = new Aedat4Bytes();
                bytes.compression = compression;
                bytes.events(EVENTS).packet(Aedat4Bytes.IMU_ID, bytes.pack(Aedat4Bytes.tablePayload("IMUS", 2)))
                    .packet(Aedat4Bytes.FRAMES_ID, new byte[9]).events(EVENTS[2]);
                seeds.add(bytes.build());
            }
            return seeds;
        }
    }

    /** Text. */
    public static final class Text {
        private Text() {
        }

        /** Called by the fuzzer. */
        public static void fuzzerTestOneInput(byte[] data) {
            RecordingOptions options = RecordingOptions.defaults().withChip("240x180")
                .withStrict(data.length % 2 == 1);
            if (data.length % 3 > 0) {
                read("a.csv", data, options);
            } else {
                read("a.txt", data, options.withTimeUnit(TextTimeUnit.values()[data.length % 4])
                    .withColumns(List.of("x", "y", "t", "_", "p")));
            }
        }

        /** Valid inputs to start from. */
        public static List<byte[]> seeds() {
            return List.of(join("# t x y p\n0.003811000 96 133 0\n0.003820001 127 171 1\r\n\n1,1,2,-1\n2.0\t3\t4\t0"),
                join("-1.5 0 0 1\n-.0000014 0 0 1\n1e-9 0 0 1\n1468940293.9551094 239 179 1\n"),
                join("\u00EF\u00BB\u00BFt [us],x,y,p,more\r\n7,1,2,True,\r\n8,1.0,2,-1,x\r\n"),
                join("1;2;3;1\n2;3;4;0\n".repeat(8)));
        }
    }

    /** Prophesee's RAW, versions 2.0, 2.1 and 3.0. */
    public static final class Evt {
        private Evt() {
        }

        /** Called by the fuzzer. */
        public static void fuzzerTestOneInput(byte[] data) {
            read("a.raw", data, RecordingOptions.defaults().withChip("640x480").withStrict(data.length % 2 == 1));
        }

        /** Valid inputs to start from. */
        public static List<byte[]> seeds() {
            return List.of(
                join("% evt 2.0\n% geometry 640x480\n% end\n", words(ByteOrder.LITTLE_ENDIAN, 0x80D9D8D0, 0x100119BB,
                    0x100121BB, 0xA0000000, 0xE0000000, 0xF0000000, 0x8FFFFFFF, 0x00000001)),
                join("% format EVT21;height=480;width=640\n", words(ByteOrder.LITTLE_ENDIAN, 0, 0x80000001, 0x80000003,
                    0x12410005, -1, 0x02410006, 0, 0xA0000000, 0, 0xE0000000)),
                join("% evt 3.0\n% system_ID 49\n", words(ByteOrder.LITTLE_ENDIAN, 0x66E08AAE, 0x29E4013B, 0x309966E1,
                    0x4002 << 16 | 0x4801, 0x7123 << 16 | 0x5081, 0xE014A100, 0x8000F001, 0x20018FFF)));
        }
    }

    /** HDF5, whose container is a library's. */
    public static final class Hdf5 {
        private Hdf5() {
        }

        /** Called by the fuzzer. */
        public static void fuzzerTestOneInput(byte[] data) {
            read("a.h5", data, RecordingOptions.defaults().withChip("346x260").withStrict(data.length % 2 == 1));
        }

        /** Valid inputs to start from. */
        public static List<byte[]> seeds() {
            return List.of(Hdf5Bytes.dsec(true));
        }
    }

    /** Prophesee's DAT, versions 1 and 2. */
    public static final class Dat {
        private Dat() {
        }

        /** Called by the fuzzer. */
        public static void fuzzerTestOneInput(byte[] data) {
            read("a.dat", data, RecordingOptions.defaults().withChip("304x240").withStrict(data.length % 2 == 1));
        }

        /** Valid inputs to start from. */
        public static List<byte[]> seeds() {
            byte[] events = words(ByteOrder.LITTLE_ENDIAN, -12, 1 << 28 | 9 << 14 | 3, -10, 1, -1, 0, 2, 0);
            return List.of(join("% Height 480\n% Version 2\n% Width 640\n", new byte[] {12, 8}, events),
                join("% Data file containing CD events.\n% Version 1\n", new byte[] {0, 8}, events));
        }
    }

    /** Event Stream. */
    public static final class EventStream {
        private EventStream() {
        }

        /** Called by the fuzzer. */
        public static void fuzzerTestOneInput(byte[] data) {
            read("a.es", data, RecordingOptions.defaults());
        }

        /** Valid inputs to start from. */
        public static List<byte[]> seeds() {
            return List.of(join("Event Stream\2\0\0\1\u0040\1\u00F0\0", new byte[] {1, 0, 0, 9, 0, -1, -2, 6, 0x3F, 1,
                0, 0, 1, 0, 5, 0, 0, -1}));
        }
    }

    /** N-MNIST. */
    public static final class NMnist {
        private NMnist() {
        }

        /** Called by the fuzzer. */
        public static void fuzzerTestOneInput(byte[] data) {
            read("a.bin", data, RecordingOptions.defaults().withChip("34x34").withStrict(data.length % 2 == 1));
        }

        /** Valid inputs to start from. */
        public static List<byte[]> seeds() {
            return List.of(new byte[] {7, 15, -128, 2, -114, 19, 18, 0, 0x12, 0x0B, 0, -16, 0, 0, 0, 33, 33, 1, 0, 0});
        }
    }

    /** The extension and the first bytes, which decide the format. */
    public static final class Detection {
        private Detection() {
        }

        /** Called by the fuzzer. */
        public static void fuzzerTestOneInput(byte[] data) {
            String[] names = {"a", "a.dat", "a.aedat", "a.aedat4", "a.txt", "a.raw", "a.bin"};
            String[] chips = {null, "DVS128", "DAVIS240C", "16x12"};
            int choice = data.length == 0 ? 0 : (data[data.length - 1] & 0xFF) % (names.length * chips.length);
            read(names[choice % names.length], data,
                RecordingOptions.defaults().withChip(chips[choice / names.length]));
        }

        /** Valid inputs to start from. */
        public static List<byte[]> seeds() throws IOException {
            List<byte[]> seeds = new ArrayList<>(Aedat1.seeds());
            seeds.addAll(Aedat2Dvs128.seeds());
            seeds.addAll(Aedat3.seeds());
            seeds.addAll(Text.seeds());
            seeds.add(Aedat4.seeds().get(0));
            seeds.add(Evt.seeds().get(2));
            seeds.add(Dat.seeds().get(0));
            seeds.addAll(EventStream.seeds());
            seeds.add(join("#ROSBAG V2.0\n"));
            return seeds;
        }
    }

    /** LZ4 frames, whose checksums hide the blocks from a fuzzer of whole files. */
    public static final class Lz4 {
        private static final int MOST_BYTES = 1 << 22;

        private Lz4() {
        }

        /** Called by the fuzzer. */
        public static void fuzzerTestOneInput(byte[] data) {
            byte[] frame = data.clone();
            if (frame.length >= 7 && (frame[4] & 0x08) == 0) {
                frame[6] = (byte) (XxHash32.of(frame, 4, 6) >>> 8);
            }
            Lz4FrameDecoder decoder = new Lz4FrameDecoder();
            decoder.decode(frame, 0, frame.length, MOST_BYTES);
            require(decoder.length() <= MOST_BYTES, "unpacks more than it may");
            require(decoder.length() <= decoder.output().length, "announces more than it unpacked");
            if (decoder.fault() != null) {
                checkMessage("a", "[a] " + decoder.fault());
            }
        }

        /** Valid inputs to start from. */
        public static List<byte[]> seeds() throws IOException {
            byte[] text = "event 1 at 2, event 3 at 4, event 5 at 6, aaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaa"
                .getBytes(StandardCharsets.US_ASCII);
            List<byte[]> seeds = new ArrayList<>();
            for (int flags = 0; flags < 4; flags++) {
                seeds.add(Aedat4Bytes.lz4(text, new Parameters(BlockSize.K64, (flags & 1) != 0, false,
                    (flags & 2) != 0)));
            }
            return seeds;
        }
    }
}
