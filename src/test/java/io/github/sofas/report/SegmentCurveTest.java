package io.github.sofas.report;

import static org.junit.Assert.assertEquals;

import org.junit.Test;

public class SegmentCurveTest {
    @Test
    public void speedIsTheMeanOfABin() {
        SegmentCurve curve = new SegmentCurve(1, 10, 3);
        curve.add(3, 10, 30, 40);
        curve.add(3, 10, 60, 80);
        curve.add(5, 10, 0, -10);
        assertEquals(3, curve.used());
        assertEquals("mean (45, 60)", 75, curve.speed(0), 1e-9);
        assertEquals(Double.NaN, curve.speed(1), 0);
        assertEquals("up, where y runs down", -90, curve.directionDeg(2), 1e-9);
    }

    @Test
    public void widerBinsHoldTheSumsOfTheNarrower() {
        SegmentCurve curve = new SegmentCurve(1, 10, 3);
        // bins 3, 4, 5, 6 become 1, 2, 2, 3
        for (int place = 3; place <= 6; place++) {
            curve.add(place, 10, place, 0);
        }
        curve.widenTo(20);
        assertEquals(1, curve.first());
        assertEquals(3, curve.used());
        assertEquals(3, curve.speed(0), 1e-9);
        assertEquals(4.5, curve.speed(1), 1e-9);
        assertEquals(6, curve.speed(2), 1e-9);
    }

    @Test
    public void binsDoubleWhenTheyDoNotSuffice() {
        TimeBins bins = new TimeBins();
        bins.add(bins.place(0), true);
        bins.add(bins.place(15_000), false);
        // 512 bins of 10 ms end at 5.12 s
        assertEquals(256, bins.place(5_120_000));
        assertEquals(0.02, bins.widthS(), 0);
        assertEquals("two events in 20 ms", 100, bins.rate(0), 1e-9);
        assertEquals(50, bins.share(0), 1e-9);
    }
}
