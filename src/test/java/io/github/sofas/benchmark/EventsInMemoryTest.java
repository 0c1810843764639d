package io.github.sofas.benchmark;

import static org.junit.Assert.assertArrayEquals;
import static org.junit.Assert.assertEquals;

import io.github.sofas.event.EventBatch;
import io.github.sofas.event.SensorSize;
import java.util.Arrays;
import java.util.List;
import java.util.stream.IntStream;
import org.junit.Test;

public class EventsInMemoryTest {
    private static final SensorSize SENSOR = new SensorSize(8, 8);

    /** Event i has x = i % 8; in batches of three. */
    private static EventsInMemory at(long... timesUs) {
        EventBatch[] batches = new EventBatch[(timesUs.length + 2) / 3];
        for (int i = 0; i < timesUs.length; i++) {
            if (i % 3 == 0) {
                batches[i / 3] = new EventBatch(3);
            }
            batches[i / 3].add(timesUs[i], i % 8, 1, -1);
        }
        return new EventsInMemory(SENSOR, List.of(batches), timesUs.length);
    }

    private static long[][] times(EventsInMemory events) {
        return events.batches().stream().map(batch -> Arrays.copyOf(batch.timeUs, batch.size())).toArray(long[][]::new);
    }

    @Test
    public void aPacketHoldsTheEventsOfOnePeriod() {
        EventsInMemory packets = at(-1, 0, 400, 999, 1000, 3001, 3999).packetsOfTime(1000);
        assertArrayEquals(new long[][] {{-1}, {0, 400, 999}, {1000}, {3001, 3999}}, times(packets));
        assertEquals(7, packets.size());
        assertEquals(3, packets.largestBatch());
    }

    @Test
    public void aPacketHoldsTheGivenNumberOfEventsAndTheLastTheRest() {
        EventsInMemory packets = at(1, 2, 3, 4, 5).packetsOfEvents(2);
        assertArrayEquals(new long[][] {{1, 2}, {3, 4}, {5}}, times(packets));
    }

    @Test
    public void aPacketMayHoldMoreThanABatch() {
        long[] timesUs = IntStream.range(0, 3000).mapToLong(i -> 5).toArray();
        EventsInMemory packets = at(timesUs).packetsOfTime(1000);
        assertArrayEquals(new long[][] {timesUs}, times(packets));
        EventBatch packet = packets.batches().get(0);
        assertEquals("x of event 2047", 7, packet.x[2047]);
        assertEquals(1, packet.y[2999]);
        assertEquals(-1, packet.polarity[2999]);
    }

    @Test
    public void noEventsMakeNoPacket() {
        EventsInMemory none = new EventsInMemory(SENSOR, List.of(), 0);
        assertEquals(List.of(), none.packetsOfTime(1000).batches());
        assertEquals(1, none.largestBatch());
    }
}
