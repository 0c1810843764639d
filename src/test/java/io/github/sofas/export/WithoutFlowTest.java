package io.github.sofas.export;

import static org.junit.Assert.assertEquals;
import static org.junit.Assert.assertTrue;

import io.github.sofas.event.EventBatch;
import io.github.sofas.event.SensorSize;
import io.github.sofas.flow.FlowOutput;
import java.util.Random;
import org.junit.Test;

public class WithoutFlowTest {
    private final WithoutFlow withoutFlow = new WithoutFlow(new SensorSize(100, 100));
    private final EventBatch batch = new EventBatch(1);
    private final FlowOutput flow = new FlowOutput(1);

    private void add(long timeUs, int x, int y, int polarity, int segment) {
        batch.clear();
        batch.add(timeUs, x, y, polarity);
        flow.segment[0] = segment;
        withoutFlow.add(batch, flow);
    }

    private void assertReason(String start) {
        assertTrue(withoutFlow.likelyReason(), withoutFlow.likelyReason().startsWith(start));
    }

    @Test
    public void saysNothingWhereHalfOfTheEventsHaveFlow() {
        add(0, 1, 1, 1, 0);
        add(1, 1, 1, 1, 7);
        assertEquals("", withoutFlow.likelyReason());
    }

    @Test
    public void saysNothingOfNoEvents() {
        assertEquals("", withoutFlow.likelyReason());
    }

    @Test
    public void loneEventsAreNoise() {
        // Two pixels and 20 ms apart: nobody has company.
        for (int i = 0; i < 40; i++) {
            add(1_000_000_000L + i * 20_000L, 2 * i, 50, 1, 0);
        }
        assertEquals("100 % of these have no neighbouring event in the 10 ms before: noise, or too sparse",
            withoutFlow.likelyReason());
    }

    @Test
    public void aFewPixelsThatFireAllTheTimeAreHot() {
        // 10 of 10,000 pixels are a thousandth.
        for (int i = 0; i < 4000; i++) {
            add(i * 250L, 10 * (i % 10), 50, 1, 0);
        }
        assertReason("100 % of these come from 10 pixels: hot pixels");
    }

    @Test
    public void aLampComesAgainInEqualTimes() {
        // 100 Hz over 20 x 20 px, two events up and two down each time.
        for (int half = 0; half < 40; half++) {
            for (int twice = 0; twice < 2; twice++) {
                for (int pixel = 0; pixel < 400; pixel++) {
                    add(half * 5000L + twice * 1500L + pixel, 30 + pixel % 20, 30 + pixel / 20,
                        half % 2 == 0 ? 1 : -1, 0);
                }
            }
        }
        // Two equal times are first known at the second fall: 37 of 40 halves.
        assertReason("93 % of these repeat at their pixel at equal intervals: flickering light");
    }

    @Test
    public void aShortRecordingMayBeTooShort() {
        Random random = new Random(4);
        for (int i = 0; i < 8000; i++) {
            add(i, random.nextInt(100), random.nextInt(100), random.nextBoolean() ? 1 : -1, 0);
        }
        assertEquals("a recording of 8 ms is too short to find a motion", withoutFlow.likelyReason());
    }

    @Test
    public void otherwiseTheMotionIsTooShortOrTooIrregular() {
        Random random = new Random(4);
        for (int i = 0; i < 80_000; i++) {
            add(i * 10L, random.nextInt(100), random.nextInt(100), random.nextBoolean() ? 1 : -1, 0);
        }
        assertReason("the motion is too short or too irregular");
    }
}
