package io.github.sofas.flow.smooth;

import static org.junit.Assert.assertEquals;

import io.github.sofas.event.SensorSize;
import java.util.ArrayList;
import java.util.Arrays;
import java.util.List;
import org.junit.Test;

/** Events each 10 ms from 0 s on, of segments 1 and 2 in turn, in slices of 50 ms. */
public class SegmentCursorTest {
    private static final SensorSize SENSOR = new SensorSize(32, 32);

    private final EventWindow window = new EventWindow();
    private final List<Slice> slices = new ArrayList<>();
    private final SegmentCursor cursor = new SegmentCursor(window);

    private void film() {
        long from = 0;
        for (int k = 0; k < 20; k++) {
            window.give(window.add(10_000L * k, 0, 1, 1, 1), 1 + k % 2, 1 + k % 2);
            if (k % 5 == 4) {
                slices.add(new Slice(window, SENSOR, from, 10_000L * (k - 4), 10_000L * (k + 1), 0));
                from = window.end();
            }
        }
    }

    private List<Long> timesMs(int segment, long fromMs, long untilMs) {
        List<Long> times = new ArrayList<>();
        cursor.begin(slices, segment, 1_000 * fromMs, 1_000 * untilMs);
        for (int k = cursor.next(); k != SegmentCursor.NONE; k = cursor.next()) {
            times.add(window.timeUs[k] / 1_000);
        }
        assertEquals("once there is none there is none", SegmentCursor.NONE, cursor.next());
        return times;
    }

    @Test
    public void eventsAreThoseOfTheSegmentFromATimeToBeforeAnother() {
        film();
        assertEquals(Arrays.asList(20L, 40L, 60L, 80L), timesMs(1, 20, 100));
        assertEquals(Arrays.asList(30L, 50L, 70L, 90L), timesMs(2, 20, 100));
        assertEquals(Arrays.asList(170L, 190L), timesMs(2, 160, 900));
    }

    @Test
    public void whereTheSegmentHasNoneThereIsNone() {
        film();
        assertEquals(new ArrayList<>(), timesMs(3, 0, 200));
        assertEquals(new ArrayList<>(), timesMs(1, 61, 80));
        assertEquals(new ArrayList<>(), timesMs(1, 300, 400));
    }

    @Test
    public void labelsAreThoseOfNowOnceTheSliceIsTold() {
        film();
        timesMs(1, 0, 200);
        window.give(window.at(3), 1, 1);
        slices.get(0).relabel();
        assertEquals(Arrays.asList(0L, 20L, 30L, 40L), timesMs(1, 0, 50));
    }
}
