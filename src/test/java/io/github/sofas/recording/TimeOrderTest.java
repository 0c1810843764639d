package io.github.sofas.recording;

import static org.junit.Assert.assertEquals;
import static org.junit.Assert.assertNull;
import static org.junit.Assert.assertTrue;

import io.github.sofas.event.EventBatch;
import io.github.sofas.event.EventSourceException;
import java.io.IOException;
import java.nio.ByteBuffer;
import java.nio.charset.StandardCharsets;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.Collections;
import java.util.List;
import java.util.Random;
import java.util.function.LongUnaryOperator;
import org.junit.Rule;
import org.junit.Test;
import org.junit.rules.TemporaryFolder;

/** A damaged time costs the event that has it, and no other; a clock that was set back costs none. */
public class TimeOrderTest {
    private static final int EVENTS = 26_101;
    private static final int SPOILED = 5000;

    @Rule
    public final TemporaryFolder folder = new TemporaryFolder();

    /** Times delivered, and what was said. */
    private static final class Times {
        final List<Long> times = new ArrayList<>();
        RecordingCounts counts;
        List<String> faults;
        String error;
    }

    private Times read(byte[] bytes, String name, String chip, int batchSize, boolean strict) throws IOException {
        Path file = Files.write(folder.getRoot().toPath().resolve(name), bytes);
        Times read = new Times();
        EventBatch batch = new EventBatch(batchSize);
        try (RecordingReader reader = Recordings.open(file, ReadResult.PLAIN.withChip(chip).withStrict(strict))) {
            try {
                while (reader.next(batch)) {
                    for (int i = 0; i < batch.size(); i++) {
                        read.times.add(batch.timeUs[i]);
                    }
                }
            } catch (EventSourceException e) {
                read.error = e.getMessage();
            }
            read.counts = reader.counts();
            read.faults = reader.faults();
        } catch (EventSourceException e) {
            throw new IOException(e);
        }
        return read;
    }

    private Times read(byte[] bytes) throws IOException {
        return read(bytes, "a.aedat", null, 4096, false);
    }

    private static byte[] hexagon() throws IOException {
        return Files.readAllBytes(Path.of("recordings/hexagon.aedat"));
    }

    /** Where the time of an event of hexagon.aedat lies. */
    private static int timeAt(byte[] bytes, int event) {
        return bytes.length - 8 * (EVENTS - event) + 4;
    }

    private static byte[] spoiled(byte[] bytes, int event, LongUnaryOperator how) {
        byte[] copy = bytes.clone();
        ByteBuffer buffer = ByteBuffer.wrap(copy);
        int at = timeAt(bytes, event);
        buffer.putInt(at, (int) how.applyAsLong(buffer.getInt(at)));
        return copy;
    }

    private static List<Long> without(List<Long> times, int from, int count) {
        List<Long> rest = new ArrayList<>(times);
        rest.subList(from, from + count).clear();
        return rest;
    }

    @Test
    public void eventWhoseTimeIsDamagedIsDroppedAndAllOthersKeepTheirs() throws Exception {
        byte[] whole = hexagon();
        List<Long> times = read(whole).times;
        assertEquals(EVENTS, times.size());
        for (int event : new int[] {0, 1, SPOILED, 4095, 4096, EVENTS - 2, EVENTS - 1}) {
            for (int bit : new int[] {21, 25, 29, 31}) {
                String what = "bit " + bit + " of event " + event;
                Times read = read(spoiled(whole, event, time -> time ^ 1L << bit));
                // of the last event nothing tells that it does not come after a pause, unless that is very long
                boolean isPause = event == EVENTS - 1 && bit < 26;
                if (!isPause) {
                    assertTrue(what, without(times, event, 1).equals(read.times));
                    assertEquals(what, 1, read.counts.damagedTimes());
                    assertEquals(what + ": " + read.faults, 1, read.faults.size());
                } else {
                    assertEquals(what, EVENTS, read.times.size());
                }
                assertNull(what, read.error);
            }
        }
    }

    @Test
    public void noOtherEventMovesByMoreThanTenMillisecondsWhateverBitIsDamaged() throws Exception {
        byte[] whole = hexagon();
        List<Long> times = read(whole).times;
        for (int bit = 0; bit < 32; bit++) {
            int flipped = bit;
            Times read = read(spoiled(whole, SPOILED, time -> time ^ 1L << flipped));
            int dropped = (int) read.counts.damagedTimes();
            assertEquals("bit " + bit, EVENTS - dropped, read.times.size());
            for (int i = 0; i < EVENTS; i++) {
                if (i != SPOILED) {
                    long moved = read.times.get(i > SPOILED ? i - dropped : i) - times.get(i);
                    assertTrue("bit " + bit + " moves event " + i + " by " + moved, moved >= 0 && moved <= 10_000);
                }
            }
        }
    }

    @Test
    public void messageNamesEventAndByteTheRuleAndTheValue() throws Exception {
        byte[] whole = hexagon();
        List<Long> times = read(whole).times;
        Times read = read(spoiled(whole, SPOILED, time -> time ^ 1 << 29));
        assertEquals(List.of("[a.aedat] event 5000 at byte " + (timeAt(whole, SPOILED) - 4) + ": malformed, time must "
            + "go on from " + times.get(SPOILED - 1) + " us but was " + (times.get(SPOILED) ^ 1 << 29)
            + " us, from which the next events do not go on; the event was dropped"), read.faults);
        Times strict = read(spoiled(whole, SPOILED, time -> time ^ 1 << 29), "a.aedat", null, 4096, true);
        assertEquals(times.subList(0, SPOILED), strict.times);
        assertEquals("[a.aedat] event 5000 at byte " + (timeAt(whole, SPOILED) - 4) + ": malformed, time must go on "
            + "from " + times.get(SPOILED - 1) + " us but was " + (times.get(SPOILED) ^ 1 << 29) + " us", strict.error);
    }

    @Test
    public void blockOfDamageCostsItsEventsAndNoOthers() throws Exception {
        byte[] whole = hexagon();
        List<Long> times = read(whole).times;
        Random random = new Random(5);
        LongUnaryOperator[] damages = {time -> random.nextInt(), time -> -1, time -> time ^ 1 << 30,
            time -> time + 5_000_000};
        for (LongUnaryOperator damage : damages) {
            byte[] bytes = whole;
            for (int i = 0; i < 64; i++) {
                bytes = spoiled(bytes, SPOILED + i, damage);
            }
            Times read = read(bytes);
            assertTrue(without(times, SPOILED, 64).equals(read.times));
            assertEquals(64, read.counts.damagedTimes());
        }
    }

    @Test
    public void batchSizeChangesNothing() throws Exception {
        byte[] bytes = hexagon();
        for (int event = 10; event < EVENTS; event += 777) {
            bytes = spoiled(bytes, event, time -> time ^ 1 << 27);
        }
        Times read = read(bytes);
        assertEquals(34, read.counts.damagedTimes());
        for (int batch : new int[] {1, 7, 100, 30_000}) {
            Times other = read(bytes, "a.aedat", null, batch, false);
            assertTrue("batches of " + batch, read.times.equals(other.times));
            assertEquals(read.faults, other.faults);
        }
    }

    @Test
    public void pausesAreKept() throws Exception {
        byte[] bytes = hexagon();
        List<Long> times = read(bytes).times;
        // a minute longer from event 5,000 on, and an hour from event 9,000 on
        for (int i = SPOILED; i < EVENTS; i++) {
            long pauseUs = i < 9000 ? 60_000_000 : 60_000_000 + 3_600_000_000L;
            bytes = spoiled(bytes, i, time -> time + pauseUs);
        }
        Times read = read(bytes);
        assertEquals(List.of(), read.faults);
        assertEquals(times.get(SPOILED) + 60_000_000, (long) read.times.get(SPOILED));
        assertEquals(times.get(9000) + 3_660_000_000L, (long) read.times.get(9000));
        assertEquals(EVENTS, read.times.size());
    }

    @Test
    public void clockThatIsSetBackGoesOnFromTheGreatestTime() throws Exception {
        byte[] bytes = hexagon();
        List<Long> times = read(bytes).times;
        for (int i = 0; i < EVENTS; i++) {
            long before = i < SPOILED ? 900_000_000 : 0;
            bytes = spoiled(bytes, i, time -> time + before);
        }
        Times read = read(bytes);
        assertEquals(EVENTS, read.times.size());
        assertEquals(1, read.counts.timeRestarts());
        long greatest = times.get(SPOILED - 1) + 900_000_000;
        for (int i = SPOILED; i < EVENTS; i += 100) {
            assertEquals(greatest + times.get(i) - times.get(SPOILED), (long) read.times.get(i));
        }
        assertEquals(List.of("[a.aedat] event 5000 at byte " + (timeAt(bytes, SPOILED) - 4) + ": time must not fall "
            + "below " + greatest + " us but was " + times.get(SPOILED) + " us, from where it goes on; "
            + (greatest - times.get(SPOILED)) + " us were added from there on"), read.faults);
    }

    @Test
    public void shuffledTextIsAnErrorWithTheCount() throws Exception {
        List<String> lines = new ArrayList<>();
        for (int i = 0; i < 20_000; i++) {
            lines.add(i * 0.0001 + " " + i % 100 + " " + i % 90 + " " + i % 2);
        }
        Collections.shuffle(lines, new Random(3));
        String text = String.join("\n", lines) + "\n";
        Times read = read(text.getBytes(StandardCharsets.US_ASCII), "a.txt", "240x180", 4096, false);
        long outOfOrder = read.counts.stepsBack() + read.counts.damagedTimes();
        assertTrue(outOfOrder + " of 20000", outOfOrder > 19_000);
        assertEquals("[a.txt] malformed, events must be in order of time but " + outOfOrder + " of 20000 were not",
            read.error);
    }

    /** The same 1,000 events as text and as AEDAT 3 and 4, the time of one damaged in each. */
    @Test
    public void everyFormatDropsWhatIsDamaged() throws Exception {
        long[][] rows = new long[1000][];
        StringBuilder text = new StringBuilder();
        for (int i = 0; i < rows.length; i++) {
            long timeUs = i == 500 ? 7_000_000_000_000L : 1000L * i;
            rows[i] = new long[] {timeUs, i % 16, i % 12, i % 2};
            text.append(timeUs / 1_000_000).append('.').append(String.format("%06d", timeUs % 1_000_000)).append(' ')
                .append(i % 16).append(' ').append(i % 12).append(' ').append(i % 2).append('\n');
        }
        Times fromText = read(text.toString().getBytes(StandardCharsets.US_ASCII), "a.txt", "16x12", 64, false);
        Times fromAedat4 = read(new Aedat4Bytes().events(rows).build(), "a.aedat4", null, 64, false);
        for (Times read : List.of(fromText, fromAedat4)) {
            assertEquals(999, read.times.size());
            assertEquals(999_000L, (long) read.times.get(998));
            assertEquals(1, read.counts.damagedTimes());
        }
        // the data table counts what the packets hold
        assertEquals(1, fromAedat4.faults.size());
    }

    @Test
    public void timesThatNoClockHasAreDamage() throws Exception {
        long[][] rows = new long[100][];
        for (int i = 0; i < rows.length; i++) {
            long timeUs = i == 0 || i == 40 ? Long.MIN_VALUE : i == 50 || i == 99 ? Long.MAX_VALUE : 1000L * i;
            rows[i] = new long[] {timeUs, 1, 2, 1};
        }
        Times read = read(new Aedat4Bytes().events(rows).build(), "a.aedat4", null, 64, false);
        assertEquals(4, read.counts.damagedTimes());
        assertEquals(96, read.times.size());
        assertEquals(98_000L, (long) read.times.get(95));
    }
}
