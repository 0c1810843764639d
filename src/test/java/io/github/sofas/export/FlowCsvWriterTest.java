package io.github.sofas.export;

import static org.junit.Assert.assertArrayEquals;
import static org.junit.Assert.assertEquals;
import static org.junit.Assert.assertThrows;
import static org.junit.Assert.assertTrue;

import io.github.sofas.event.EventBatch;
import io.github.sofas.flow.FlowOutput;
import java.io.ByteArrayOutputStream;
import java.io.IOException;
import java.io.OutputStream;
import java.math.BigDecimal;
import java.math.RoundingMode;
import java.nio.charset.StandardCharsets;
import java.util.ArrayList;
import java.util.List;
import java.util.Locale;
import java.util.Random;
import org.junit.Test;

public class FlowCsvWriterTest {
    private static final String HEADER = "t_us,x,y,polarity,vx_px_per_s,vy_px_per_s,segment\n";
    private static final int CAPACITY = 1000;

    private final EventBatch batch = new EventBatch(CAPACITY);
    private final FlowOutput flow = new FlowOutput(CAPACITY);

    private void add(long timeUs, int x, int y, int polarity) {
        flow.segment[batch.size()] = 0;
        batch.add(timeUs, x, y, polarity);
    }

    private void addWithFlow(long timeUs, float vx, float vy, int segment) {
        int i = batch.size();
        flow.vxPxPerS[i] = vx;
        flow.vyPxPerS[i] = vy;
        flow.segment[i] = segment;
        batch.add(timeUs, 3, 4, 1);
    }

    private byte[] bytes() throws IOException {
        ByteArrayOutputStream out = new ByteArrayOutputStream();
        try (FlowCsvWriter writer = new FlowCsvWriter(out)) {
            writer.write(batch, flow);
        }
        return out.toByteArray();
    }

    private String rows() throws IOException {
        String text = new String(bytes(), StandardCharsets.US_ASCII);
        assertTrue(text, text.startsWith(HEADER));
        return text.substring(HEADER.length());
    }

    @Test
    public void writesTheHeaderAloneWhereThereIsNoEvent() throws IOException {
        assertEquals("", rows());
    }

    @Test
    public void leavesVelocityEmptyAndSegmentZeroWithoutFlow() throws IOException {
        add(1_000_000, 12, 5, 1);
        // What the engine left in the arrays of an event without flow does not count.
        flow.vxPxPerS[1] = 9;
        add(1_000_001, 1279, 719, -1);
        assertEquals("1000000,12,5,1,,,0\n1000001,1279,719,-1,,,0\n", rows());
    }

    @Test
    public void writesVelocityAndSegment() throws IOException {
        addWithFlow(7, 58, -72.5f, 1);
        addWithFlow(8, 0, -0f, 2_147_483_647);
        assertEquals("7,3,4,1,58.000,-72.500,1\n8,3,4,1,0.000,0.000,2147483647\n", rows());
    }

    @Test
    public void writesANewVelocityOfTheSameSegment() throws IOException {
        addWithFlow(7, 1, 2, 5);
        addWithFlow(8, 1, 2, 5);
        addWithFlow(9, 1, 3, 5);
        addWithFlow(10, 4, 3, 5);
        // 69 = 5 + 64: what is kept of one must not be taken for the other.
        addWithFlow(11, 4, 3, 69);
        addWithFlow(12, 4, 3, 5);
        assertEquals("7,3,4,1,1.000,2.000,5\n8,3,4,1,1.000,2.000,5\n9,3,4,1,1.000,3.000,5\n10,3,4,1,4.000,3.000,5\n"
            + "11,3,4,1,4.000,3.000,69\n12,3,4,1,4.000,3.000,5\n", rows());
    }

    @Test
    public void writesTimesAroundZeroAndAroundEachMillisecond() throws IOException {
        StringBuilder expected = new StringBuilder();
        for (long timeUs : new long[] {-1_293_810_339L, -1000, -999, -1, 0, 7, 999, 1000, 1001, 1999, 2000, 2000,
            9_999, 10_000, 999_999, 1_000_000, 4_294_967_296_000L}) {
            add(timeUs, 0, 0, 1);
            expected.append(timeUs).append(",0,0,1,,,0\n");
        }
        assertEquals(expected.toString(), rows());
    }

    @Test
    public void writesTheFirstAndLastTimesOfLong() throws IOException {
        add(Long.MIN_VALUE, 0, 0, 1);
        add(Long.MIN_VALUE + 999, 0, 0, 1);
        add(Long.MAX_VALUE, 0, 0, 1);
        assertEquals("-9223372036854775808,0,0,1,,,0\n-9223372036854774809,0,0,1,,,0\n"
            + "9223372036854775807,0,0,1,,,0\n", rows());
    }

    @Test
    public void writesEveryCoordinateOfTheLargestSensor() throws IOException {
        StringBuilder expected = new StringBuilder(HEADER);
        ByteArrayOutputStream out = new ByteArrayOutputStream();
        try (FlowCsvWriter writer = new FlowCsvWriter(out)) {
            for (int x = 0; x < 1280; x++) {
                batch.clear();
                add(0, x, x % 720, -1);
                writer.write(batch, flow);
                expected.append("0,").append(x).append(',').append(x % 720).append(",-1,,,0\n");
            }
        }
        assertEquals(expected.toString(), out.toString(StandardCharsets.US_ASCII));
    }

    @Test
    public void roundsHalfAwayFromZero() throws IOException {
        // 1/16 = 0.0625 and 3/16 = 0.1875 are exact as float, half way between two thousandths.
        addWithFlow(1, 0.0625f, -0.0625f, 1);
        addWithFlow(2, 0.1875f, -0.1875f, 1);
        // 0.0005f is 0.0005000000237..., 0.0015f is 0.00150000001...
        addWithFlow(3, 0.0005f, -0.0015f, 1);
        // Next below 0.0005f: 0.00049999996...
        addWithFlow(4, Math.nextDown(0.0005f), -Math.nextDown(0.0005f), 1);
        addWithFlow(5, 999.9996f, -Float.MIN_VALUE, 1);
        assertEquals("1,3,4,1,0.063,-0.063,1\n2,3,4,1,0.188,-0.188,1\n3,3,4,1,0.001,-0.002,1\n"
            + "4,3,4,1,0.000,0.000,1\n5,3,4,1,1000.000,0.000,1\n", rows());
    }

    @Test
    public void roundsAsBigDecimalDoes() throws IOException {
        Random random = new Random(1);
        for (int run = 0; run < 100; run++) {
            batch.clear();
            StringBuilder expected = new StringBuilder();
            while (!batch.isFull()) {
                float vx = velocity(random);
                float vy = velocity(random);
                int segment = 1 + random.nextInt(200);
                addWithFlow(batch.size(), vx, vy, segment);
                expected.append(batch.size() - 1).append(",3,4,1,").append(rounded(vx)).append(',')
                    .append(rounded(vy)).append(',').append(segment).append('\n');
            }
            assertEquals(expected.toString(), rows());
        }
    }

    /** Of any magnitude below 1e12, or a multiple of 1/16, of which many lie half way. */
    private static float velocity(Random random) {
        if (random.nextBoolean()) {
            return (random.nextInt(200_001) - 100_000) / 16f;
        }
        float any;
        do {
            any = Float.intBitsToFloat(random.nextInt());
        } while (!(Math.abs(any) < 1e12f));
        return any;
    }

    private static String rounded(float velocity) {
        String text = new BigDecimal(velocity).setScale(3, RoundingMode.HALF_UP).toPlainString();
        return text.equals("-0.000") ? "0.000" : text;
    }

    @Test
    public void refusesVelocitiesThatAreNoneOrTooLarge() {
        assertRefused(Float.NaN, "velocity must be smaller than 1e12 px/s but was NaN");
        assertRefused(Float.NEGATIVE_INFINITY, "velocity must be smaller than 1e12 px/s but was -Infinity");
        // 1e12f is 999999995904; the next float is the first above the limit.
        assertRefused(Math.nextUp(1e12f), "velocity must be smaller than 1e12 px/s but was 1.00000006E12");
    }

    private void assertRefused(float vx, String message) {
        batch.clear();
        addWithFlow(0, vx, 0, 1);
        assertEquals(message, assertThrows(IllegalArgumentException.class, this::bytes).getMessage());
    }

    @Test
    public void writesTheLargestVelocity() throws IOException {
        addWithFlow(0, 1e12f, -1e12f, 1);
        assertEquals("0,3,4,1,999999995904.000,-999999995904.000,1\n", rows());
    }

    @Test
    public void writesTheSameBytesInEveryLocale() throws IOException {
        addWithFlow(1_234_567, -1234.5f, 0.25f, 1000);
        add(1_234_568, 1000, 0, -1);
        Locale before = Locale.getDefault();
        try {
            for (String tag : List.of("en-US", "de-DE", "ar-EG-u-nu-arab", "hi-IN-u-nu-deva", "tr-TR")) {
                Locale.setDefault(Locale.forLanguageTag(tag));
                assertEquals(tag, "1234567,3,4,1,-1234.500,0.250,1000\n1234568,1000,0,-1,,,0\n", rows());
            }
        } finally {
            Locale.setDefault(before);
        }
    }

    @Test
    public void writesTheSameBytesHoweverEventsAreBatched() throws IOException {
        List<Integer> segments = new ArrayList<>();
        for (int i = 0; i < CAPACITY; i++) {
            segments.add(i % 3);
        }
        // 20,000 rows: more than the writer's buffer holds.
        byte[] whole = repeated(segments, CAPACITY);
        assertTrue(whole.length > 1 << 18);
        assertArrayEquals(whole, repeated(segments, 1));
        assertArrayEquals(whole, repeated(segments, 7));
    }

    private static byte[] repeated(List<Integer> segments, int batchSize) throws IOException {
        ByteArrayOutputStream out = new ByteArrayOutputStream();
        EventBatch some = new EventBatch(batchSize);
        FlowOutput its = new FlowOutput(batchSize);
        try (FlowCsvWriter writer = new FlowCsvWriter(out)) {
            for (int i = 0; i < 20 * segments.size(); i++) {
                int segment = segments.get(i % segments.size());
                its.segment[some.size()] = segment;
                its.vxPxPerS[some.size()] = i / 4f;
                some.add(i * 10L, i % 640, i % 480, i % 2 * 2 - 1);
                if (some.isFull()) {
                    writer.write(some, its);
                    some.clear();
                }
            }
            writer.write(some, its);
        }
        return out.toByteArray();
    }

    @Test
    public void closesTheStreamEvenWhereItCannotBeWritten() throws IOException {
        boolean[] closed = new boolean[1];
        OutputStream full = new OutputStream() {
            @Override
            public void write(int value) throws IOException {
                throw new IOException("No space left on device");
            }

            @Override
            public void close() {
                closed[0] = true;
            }
        };
        FlowCsvWriter writer = new FlowCsvWriter(full);
        assertEquals("No space left on device", assertThrows(IOException.class, writer::close).getMessage());
        assertTrue(closed[0]);
    }
}
