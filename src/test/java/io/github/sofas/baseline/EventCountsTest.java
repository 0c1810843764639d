package io.github.sofas.baseline;

import static org.junit.Assert.assertArrayEquals;
import static org.junit.Assert.assertEquals;

import io.github.sofas.event.SensorSize;
import java.util.Random;
import org.junit.Test;

public class EventCountsTest {
    @Test
    public void agreesWithCountingAllEventsAnew() {
        // About 2,000 events are live at a time, so that the ring grows, and it goes round several times.
        int events = 6_000;
        long[] timeUs = new long[events];
        int[] cell = new int[events];
        EventCounts counts = new EventCounts(new SensorSize(3, 2), 3_000);
        Random random = new Random(7);
        long now = -500;
        for (int i = 0; i < events; i++) {
            now += random.nextInt(4);
            int x = random.nextInt(3);
            int y = random.nextInt(2);
            int polarity = random.nextBoolean() ? 1 : -1;
            counts.add(now, x, y, polarity);
            timeUs[i] = now;
            cell[i] = counts.cell(x, y, polarity);
            if (i % 97 == 0 || i == events - 1) {
                int[] expected = new int[12];
                for (int j = 0; j <= i; j++) {
                    if (now - timeUs[j] <= 3_000) {
                        expected[cell[j]]++;
                    }
                }
                assertArrayEquals(expected, counts.counts());
            }
        }
    }

    @Test
    public void putsOnBehindOffAndRowsOneAfterAnother() {
        EventCounts counts = new EventCounts(new SensorSize(3, 2), 1);
        assertEquals(5, counts.cell(2, 1, -1));
        assertEquals(6, counts.cell(0, 0, 1));
    }
}
