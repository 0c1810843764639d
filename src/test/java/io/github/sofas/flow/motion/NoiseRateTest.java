package io.github.sofas.flow.motion;

import static org.junit.Assert.assertEquals;
import static org.junit.Assert.assertTrue;

import io.github.sofas.event.SensorSize;
import org.junit.Test;

/** The rate of noise on 8 x 6 px, of which each has two polarities. */
public class NoiseRateTest {
    private static final int EVERY_US = 96_000;
    /** One event every 96 ms on 96 pixels and polarities. */
    private static final double ONE = 1.0 / EVERY_US / 96;

    private final NoiseRate noise = new NoiseRate(new SensorSize(8, 6));
    private long nowUs = 5_000_000;

    /** Lets events come one beside the other, some at a time. */
    private void come(int times, int atOnce) {
        for (int i = 0; i < times; i++) {
            for (int k = 0; k < atOnce; k++) {
                noise.note(k, i % 6, nowUs);
            }
            nowUs += EVERY_US;
            noise.goOn(nowUs);
        }
    }

    @Test
    public void rateIsOfAPixelAndPolarity() {
        noise.goOn(nowUs);
        come(60, 1);
        // and as many more as others within 10 ms on eight pixels around must hide: 16 times 10,000 µs of its rate
        assertEquals(ONE / (1 - 160_000 * ONE), noise.perUs(), 1e-4 * ONE);
    }

    @Test
    public void eventsSideBySideAreAStructureOfWhichTheFirstOnlyIsAlone() {
        noise.goOn(nowUs);
        come(60, 3);
        assertEquals(ONE / (1 - 160_000 * ONE), noise.perUs(), 1e-4 * ONE);
    }

    @Test
    public void rateFollowsInTenthsOfASecond() {
        noise.goOn(nowUs);
        come(1, 1);
        // 96 ms count 96 / (96 + 300)
        assertEquals(ONE * 96 / 396, noise.perUs(), 0.02 * ONE);
        come(60, 0);
        assertTrue(noise.perUs() < 1e-4 * ONE);
    }

    @Test
    public void nothingIsKnownBeforeTimeHasGoneOn() {
        noise.note(0, 0, nowUs);
        noise.goOn(nowUs);
        assertEquals(0, noise.perUs(), 0);
    }

    @Test
    public void resetForgetsAll() {
        noise.goOn(nowUs);
        come(10, 1);
        noise.reset();
        assertEquals(0, noise.perUs(), 0);
        noise.goOn(nowUs);
        come(60, 1);
        assertEquals(ONE / (1 - 160_000 * ONE), noise.perUs(), 1e-4 * ONE);
    }
}
