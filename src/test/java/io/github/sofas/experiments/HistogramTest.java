package io.github.sofas.experiments;

import static org.junit.Assert.assertArrayEquals;
import static org.junit.Assert.assertEquals;

import org.junit.Test;

public class HistogramTest {
    @Test
    public void countsInBinsWhoseUpperBoundIsExclusive() {
        // bins [-3, -1), [-1, 1), [1, 3)
        Histogram.Gatherer gatherer = new Histogram.Gatherer(3, 3);
        for (double value : new double[] {-3.1, -3, -1, 0, 0.9, 1, 3, 7}) {
            gatherer.add(value);
        }
        Histogram histogram = gatherer.histogram();
        assertArrayEquals(new long[] {1, 3, 1}, histogram.counts());
        assertEquals(1, histogram.below());
        assertEquals(2, histogram.above());
        assertEquals(8, histogram.total());
        assertEquals(37.5, histogram.percent(1), 0);
        assertEquals(-1, histogram.from(1), 0);
        assertEquals(0, histogram.middle(1), 0);
    }

    @Test
    public void isEmptyWithoutNumbers() {
        assertEquals(0, new Histogram.Gatherer(1, 2).histogram().percent(0), 0);
    }
}
