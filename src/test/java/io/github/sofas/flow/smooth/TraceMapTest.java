package io.github.sofas.flow.smooth;

import static org.junit.Assert.assertEquals;

import io.github.sofas.event.SensorSize;
import org.junit.Test;

public class TraceMapTest {
    private static final double EXACT = 1e-12;

    private final TraceMap map = new TraceMap(new SensorSize(20, 10));

    /** The claim of a place in parts 0 to 7, where events of nobody count half, and those of others a quarter. */
    private double claim(double x, double y, boolean isOn) {
        return map.claim(x, y, isOn, TraceMap.parts(0, 8), 0.5, 0.25);
    }

    @Test
    public void eventCountsThreeTimesOnItsPixelAndOnceLessThanAPixelAwayWithItsPolarity() {
        map.add(5, 5, true, 3, TraceMap.OWN);
        assertEquals(3, claim(5, 5, true), EXACT);
        assertEquals(3, claim(5.4, 4.6, true), EXACT);
        assertEquals(1, claim(5.9, 4.1, true), EXACT);
        assertEquals(0, claim(6.1, 5, true), EXACT);
        assertEquals(0, claim(5, 3.9, true), EXACT);
        assertEquals(0, claim(5, 5, false), EXACT);
    }

    @Test
    public void whatIsBesideTheSensorIsFoundAndWhatIsFarFromItIsLeftOut() {
        map.add(-3, 5, true, 0, TraceMap.OWN);
        assertEquals(3, claim(-3, 5, true), EXACT);
        map.add(-30, 5, true, 0, TraceMap.OWN);
        map.add(50, 500, true, 0, TraceMap.OWN);
        assertEquals(0, claim(-30, 5, true), EXACT);
        assertEquals(0, claim(50, 500, true), EXACT);
    }

    @Test
    public void clearedMapIsEmpty() {
        map.add(5, 5, true, 3, TraceMap.OWN);
        map.add(5, 9, false, 3, TraceMap.OWN);
        map.clear();
        assertEquals(0, claim(5, 5, true), EXACT);
        assertEquals(0, claim(5, 9, false), EXACT);
    }

    @Test
    public void eachPartCountsOnceForTheOneThatCountsMost() {
        map.add(5, 5, true, 1, TraceMap.OWN);
        map.add(5, 5, true, 1, TraceMap.OTHERS);
        map.add(6, 5, true, 2, TraceMap.NOBODYS);
        map.add(6, 5, true, 2, TraceMap.OTHERS);
        map.add(5, 6, true, 4, TraceMap.OTHERS);
        map.add(5, 6, true, 9, TraceMap.OWN);
        // part 9 is not wanted; on pixel (5, 5) itself is part 1 only
        assertEquals(1 + 0.5 + 0.25 + 2, claim(5.4, 5.4, true), EXACT);
    }

    @Test
    public void partsAreThoseThatThereAre() {
        assertEquals(0b11100, TraceMap.parts(2, 5));
        assertEquals(0b11, TraceMap.parts(-4, 2));
        assertEquals(1L << TraceMap.PARTS - 1, TraceMap.parts(TraceMap.PARTS - 1, TraceMap.PARTS + 9));
    }

    @Test
    public void noiseScoresByChance() {
        // a quarter of an event of each pixel: 1 / 2 of the parts have one on four pixels, 0.25 / 1.25 on the nearest.
        // Mean 0.5 + 2 * 0.2, square 0.5 + (9 - 1) * 0.2, so 16 parts have 14.4 and a variance of 16 * (2.1 - 0.81)
        assertEquals(14.4, TraceMap.byNoise(0.25, 16, 0), EXACT);
        assertEquals(14.4 + 2 * Math.sqrt(20.64), TraceMap.byNoise(0.25, 16, 2), EXACT);
        assertEquals(0, TraceMap.byNoise(0, 16, 5), EXACT);
    }
}
