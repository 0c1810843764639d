package io.github.sofas.flow.search;

import static org.junit.Assert.assertFalse;
import static org.junit.Assert.assertTrue;

import org.junit.Test;

/** When a stream is dense. */
public class EventRateTest {
    private final EventRate rate = new EventRate();

    private void see(int events, long timeUs) {
        for (int i = 0; i < events; i++) {
            rate.goOn(timeUs);
            rate.note(true);
        }
    }

    @Test
    public void isDenseAfterAMsWithManyEvents() {
        see(256, 5_000);
        assertFalse("known when the ms is over", rate.isDense());
        rate.goOn(5_999);
        assertFalse(rate.isDense());
        rate.goOn(6_000);
        assertTrue(rate.isDense());
        see(255, 6_500);
        rate.goOn(7_000);
        assertFalse(rate.isDense());
    }

    @Test
    public void eventsThatAreNotExplainedDoNotCount() {
        see(255, 5_000);
        for (int i = 0; i < 1_000; i++) {
            rate.goOn(5_500);
            rate.note(false);
        }
        rate.goOn(6_000);
        assertFalse(rate.isDense());
    }

    @Test
    public void isNotDenseAfterAPause() {
        see(1_000, 5_000);
        rate.goOn(6_999);
        assertTrue(rate.isDense());
        see(1_000, 7_000);
        rate.goOn(8_999);
        assertFalse("2 ms after the first of them", rate.isDense());
    }

    @Test
    public void resetForgetsTheRate() {
        see(1_000, 5_000);
        rate.goOn(6_000);
        rate.reset();
        assertFalse(rate.isDense());
        rate.goOn(0);
        assertFalse(rate.isDense());
    }
}
