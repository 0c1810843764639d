package io.github.sofas.evaluate;

import static org.junit.Assert.assertEquals;

import org.junit.Test;

public class DistributionTest {
    private static Distribution of(double... values) {
        Distribution.Gatherer gatherer = new Distribution.Gatherer();
        for (double value : values) {
            gatherer.add(value);
        }
        return gatherer.distribution();
    }

    @Test
    public void takesQuartilesAtThePositionsPTimesNPlusOne() {
        // n = 5: positions 1.5, 3 and 4.5 of 1, 2, 3, 4, 10.
        Distribution distribution = of(10, 1, 3, 2, 4);
        assertEquals(1.5, distribution.lowerQuartile(), 1e-12);
        assertEquals(3, distribution.median(), 1e-12);
        assertEquals(7, distribution.upperQuartile(), 1e-12);
        assertEquals(4, distribution.mean(), 1e-12);
        // (9 + 4 + 1 + 0 + 36) / 4 = 12.5
        assertEquals(Math.sqrt(12.5), distribution.sd(), 1e-12);
    }

    @Test
    public void clampsQuartilesOfTwoToTheEnds() {
        Distribution distribution = of(1, 2);
        assertEquals(1, distribution.lowerQuartile(), 0);
        assertEquals(1.5, distribution.median(), 0);
        assertEquals(2, distribution.upperQuartile(), 0);
    }

    @Test
    public void givesZerosWithoutNumbersAndNoSpreadForOne() {
        assertEquals(new Distribution(0, 0, 0, 0, 0, 0), of());
        assertEquals(new Distribution(1, 3, 0, 3, 3, 3), of(3));
    }
}
