package io.github.sofas.live;

import static io.github.sofas.FuzzRules.require;

import io.github.sofas.event.EventBatch;
import io.github.sofas.event.SensorSize;
import io.github.sofas.recording.Chip;
import io.github.sofas.recording.JaerAddress;
import java.io.ByteArrayOutputStream;
import java.nio.ByteBuffer;
import java.util.Arrays;
import java.util.List;
import java.util.Map;

/**
 * What comes from a camera or the network, whatever it is: events on the sensor in order of time, and nothing that is
 * not counted. Inputs are transfers, each after a byte that tells its length. Each class inside is a fuzz target.
 */
public final class LiveFuzz {
    private LiveFuzz() {
    }

    /** Turns a transfer into events. */
    private interface Decoder {
        void decode(byte[] data, int length, EventBatch batch);
    }

    /** Gives the transfers of an input to a decoder; how many events and whole records of a size there were. */
    private static long[] run(byte[] input, SensorSize sensor, int recordBytes, Decoder decoder) {
        byte[] data = new byte[255];
        EventBatch batch = new EventBatch(data.length / recordBytes);
        long lastUs = Long.MIN_VALUE;
        long[] eventsAndRecords = new long[2];
        for (int at = 0; at < input.length;) {
            int length = Math.min(input[at++] & 0xFF, input.length - at);
            System.arraycopy(input, at, data, 0, length);
            at += length;
            batch.clear();
            decoder.decode(data, length, batch);
            for (int i = 0; i < batch.size(); i++) {
                require(batch.timeUs[i] >= lastUs, "time falls");
                lastUs = batch.timeUs[i];
                require(sensor.contains(batch.x[i], batch.y[i]), "an event lies outside");
                require(Math.abs(batch.polarity[i]) == 1, "a polarity is neither 1 nor -1");
            }
            eventsAndRecords[0] += batch.size();
            eventsAndRecords[1] += length / recordBytes;
        }
        return eventsAndRecords;
    }

    private static byte[] transfers(byte[]... all) {
        ByteArrayOutputStream input = new ByteArrayOutputStream();
        for (byte[] each : all) {
            for (int at = 0; at < each.length; at += 254) {
                byte[] part = Arrays.copyOfRange(each, at, Math.min(each.length, at + 254));
                input.write(part.length);
                input.writeBytes(part);
            }
        }
        return input.toByteArray();
    }

    /** Words of a DAVIS; an empty transfer stands for one that was lost. */
    public static final class Davis {
        private Davis() {
        }

        /** Called by the fuzzer. */
        public static void fuzzerTestOneInput(byte[] input) {
            SensorSize sensor = new SensorSize(240, 180);
            DavisDecoder decoder = new DavisDecoder(sensor, input.length % 2 == 1);
            run(input, sensor, Short.BYTES, (data, length, batch) -> {
                if (length == 0) {
                    decoder.lose();
                }
                decoder.decode(data, length, batch);
            });
            for (Map<String, Long> counts : List.of(decoder.counts(), decoder.dropped())) {
                require(counts.values().stream().allMatch(count -> count >= 0), "a count is negative: " + counts);
            }
        }

        /** Valid inputs to start from. */
        public static List<byte[]> seeds() {
            return List.of(transfers(new DavisStream(1, 60, 300).bytes()),
                transfers(new DavisStream(2, 20, 20_000).bytes(), new DavisStream(3, 20, 20_000).bytes()));
        }
    }

    /** Events of a DVS128; an empty transfer stands for one that was lost. */
    public static final class Dvs128 {
        private static final Chip CHIP = Chip.named("DVS128").orElseThrow();

        private Dvs128() {
        }

        /** Called by the fuzzer. */
        public static void fuzzerTestOneInput(byte[] input) {
            Dvs128Decoder decoder = new Dvs128Decoder(new JaerAddress(CHIP));
            long[] seen = run(input, CHIP.sensor(), 4, (data, length, batch) -> {
                if (length == 0) {
                    decoder.lose();
                }
                decoder.decode(data, length, batch);
            });
            Map<String, Long> counts = decoder.counts();
            long others = counts.get("triggers") + counts.get("time_resets");
            // a wrap is also counted where it was in a lost transfer
            require(seen[0] + others <= seen[1] && seen[1] <= seen[0] + others + counts.get("time_wraps"),
                "records are lost: " + Arrays.toString(seen) + counts);
        }

        /** Valid inputs to start from. */
        public static List<byte[]> seeds() {
            byte[] events = {0, 0, 10, 0, 0x7F, 0x7F, (byte) 0xFF, 0x3F, 0, 0, 0, (byte) 0x80, 2, 3, 5, 0,
                0, 0, 0, 0x40, 1, 1, 1, 0, 0, (byte) 0x80, 9, 0, 7};
            return List.of(transfers(events, events), transfers(events, new byte[0], events));
        }
    }

    /** Datagrams of jAER. */
    public static final class Datagrams {
        private static final Chip CHIP = Chip.named("DAVIS240C").orElseThrow();

        private Datagrams() {
        }

        /** Called by the fuzzer. */
        public static void fuzzerTestOneInput(byte[] input) {
            JaerDatagramDecoder decoder = new JaerDatagramDecoder(new JaerAddress(CHIP));
            run(input, CHIP.sensor(), JaerDatagramDecoder.EVENT_BYTES, (data, length, batch) ->
                decoder.decode(ByteBuffer.wrap(data), length, batch));
            require(decoder.outside() >= 0 && decoder.counts().values().stream().allMatch(count -> count >= 0),
                "a count is negative: " + decoder.counts());
            require(decoder.faults().size() <= 2, "faults are more than two lines");
        }

        /** Valid inputs to start from. */
        public static List<byte[]> seeds() {
            int event = 100 << 12 | 90 << 22 | 1 << 11;
            return List.of(transfers(datagram(1, event, 5, event, 6), datagram(2, event, Integer.MAX_VALUE),
                datagram(5, event, Integer.MIN_VALUE), datagram(4, event, 1), datagram(0, event | 1 << 10, 7)));
        }

        private static byte[] datagram(int... words) {
            ByteBuffer bytes = ByteBuffer.allocate(4 * words.length);
            for (int word : words) {
                bytes.putInt(word);
            }
            return bytes.array();
        }
    }
}
