package io.github.sofas.flow.smooth;

import static org.junit.Assert.assertEquals;

import io.github.sofas.event.SensorSize;
import org.junit.Test;

public class TraceMapTest {
    private static final double EXACT = 1e-12;

    private final TraceMap map = new TraceMap(new SensorSize(20, 10));

    @Test
    public void eventsAreFoundFromLessThanAPixelAwayWithTheirPolarity() {
        map.add(5, 5, true, 3, TraceMap.OWN);
        assertEquals(1L << 3, map.around(5, 5, true));
        assertEquals(1L << 3, map.around(5.9, 4.1, true));
        assertEquals(0, map.around(6.1, 5, true));
        assertEquals(0, map.around(5, 3.9, true));
        assertEquals(0, map.around(5, 5, false));
    }

    @Test
    public void whatIsBesideTheSensorIsFoundAndWhatIsFarFromItIsLeftOut() {
        map.add(-3, 5, true, 0, TraceMap.OWN);
        assertEquals(1, map.around(-3, 5, true));
        map.add(-30, 5, true, 0, TraceMap.OWN);
        map.add(50, 500, true, 0, TraceMap.OWN);
        assertEquals(0, map.around(-30, 5, true));
        assertEquals(0, map.around(50, 500, true));
    }

    @Test
    public void clearedMapIsEmpty() {
        map.add(5, 5, true, 3, TraceMap.OWN);
        map.add(5, 9, false, 3, TraceMap.OWN);
        map.clear();
        assertEquals(0, map.around(5, 5, true));
        assertEquals(0, map.around(5, 9, false));
    }

    @Test
    public void eachPartCountsOnceForTheOneThatCountsMost() {
        map.add(5, 5, true, 1, TraceMap.OWN);
        map.add(5, 5, true, 1, TraceMap.OTHERS);
        map.add(6, 5, true, 2, TraceMap.NOBODYS);
        map.add(6, 5, true, 2, TraceMap.OTHERS);
        map.add(5, 6, true, 4, TraceMap.OTHERS);
        map.add(5, 6, true, 9, TraceMap.OWN);
        long known = map.around(5.5, 5.5, true);
        // part 9 is not wanted
        assertEquals(1 + 0.5 + 0.25, TraceMap.score(known, TraceMap.parts(0, 5), 0.5, 0.25), EXACT);
    }

    @Test
    public void partsAreThoseThatThereAre() {
        assertEquals(0b11100, TraceMap.parts(2, 5));
        assertEquals(0b11, TraceMap.parts(-4, 2));
        assertEquals(1L << TraceMap.PARTS - 1, TraceMap.parts(TraceMap.PARTS - 1, TraceMap.PARTS + 9));
    }
}
