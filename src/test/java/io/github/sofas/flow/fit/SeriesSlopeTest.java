package io.github.sofas.flow.fit;

import static org.junit.Assert.assertEquals;

import org.junit.Test;

/** Slope of a series of measurements, over windows of 0.2 s. */
public class SeriesSlopeTest {
    private static final double HALF_S = 0.1;
    private static final double PER_PX = 100;
    private static final double TINY = 1e-12;

    private final SeriesSlope slope = new SeriesSlope();

    private void measured(double value, long timeMs) {
        slope.measured(value, timeMs * 1000, 0, PER_PX, HALF_S);
    }

    @Test
    public void slopeIsAMeanOverAboutHalfAWindow() {
        measured(1, 0);
        // 50 of 200 ms: a quarter of a window is too little
        measured(1.1, 50);
        assertEquals(0, slope.perS(), 0);
        // half a window: half of 0.2 in 50 ms, that is of 4 a second
        measured(1.3, 100);
        assertEquals(2, slope.perS(), TINY);
        // another quarter: 2 + (4 - 2) / 2
        measured(1.5, 150);
        assertEquals(3, slope.perS(), TINY);
        // a whole window at once: the slope is that since the last one
        measured(1.1, 350);
        assertEquals(-2, slope.perS(), TINY);
    }

    @Test
    public void noiseIsWhatTheSlopesBetweenNeighboursScatterBy() {
        measured(1, 0);
        for (int window = 1; window <= 40; window++) {
            measured(1 + 0.1 * window, 20 * window);
        }
        assertEquals("a line has none, once it is known", 0, slope.noisePerS(), 0.1);
        // 0.05 more and less, each 20 ms: slopes of 5 a second more and less than 5, and five of them in half a window
        for (int window = 41; window <= 120; window++) {
            measured(1 + 0.1 * window + (window % 2 == 0 ? 0.05 : -0.05), 20 * window);
        }
        assertEquals(5.0 / 5, slope.noisePerS(), 0.2);
        assertEquals(5, slope.perS(), 1);
        slope.restart();
        assertEquals(0, slope.noisePerS(), 0);
    }

    @Test
    public void valueThatIsFarFromSettledHasNoSlope() {
        measured(1, 0);
        measured(1.4, 200);
        assertEquals(2, slope.perS(), TINY);
        slope.measured(9, 400_000, 0.31 * PER_PX, PER_PX, HALF_S);
        assertEquals(0, slope.perS(), 0);
        // and the news begin anew
        measured(9.1, 450);
        assertEquals(0, slope.perS(), 0);
        measured(9.2, 500);
        assertEquals(1, slope.perS(), TINY);
    }

    @Test
    public void whatWasNotMeasuredIsNoSlope() {
        measured(1, 0);
        measured(1.4, 200);
        slope.skip();
        measured(7, 400);
        assertEquals(2, slope.perS(), TINY);
        // a window from there: 1 in 0.2 s
        measured(8, 600);
        assertEquals(5, slope.perS(), TINY);
    }

    @Test
    public void valueOfAnotherStructureBeginsAnew() {
        measured(1, 0);
        measured(1.4, 200);
        slope.skip();
        // farther than a tenth of what shifts the end of the window by a px
        measured(11.5, 400);
        assertEquals(0, slope.perS(), 0);
        // a quarter of a window is too little again
        measured(11.6, 450);
        assertEquals(0, slope.perS(), 0);
        measured(11.7, 500);
        assertEquals(1, slope.perS(), TINY);
    }

    @Test
    public void middleThatWentBackTellsNothing() {
        measured(1, 0);
        measured(1.4, 200);
        measured(5, 190);
        measured(6, 190);
        assertEquals(2, slope.perS(), TINY);
    }

    @Test
    public void heldSlopeKeepsAShare() {
        measured(1, 0);
        measured(1.4, 200);
        slope.hold(0.8);
        assertEquals(1.6, slope.perS(), TINY);
        slope.restart();
        assertEquals(0, slope.perS(), 0);
    }
}
