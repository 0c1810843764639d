package io.github.sofas.benchmark;

import static org.junit.Assert.assertEquals;

import org.junit.Test;

public class RatesTest {
    private static final double EXACT = 1e-9;

    private static Rates of(long events, long... nanos) {
        return Rates.of(events, nanos, nanos, 0);
    }

    @Test
    public void theMiddleRunOfAnOddNumberIsTheMedian() {
        // 1,000 events in 1, 2, 4, 5 and 10 us are 1000, 500, 250, 200 and 100 million a second
        Rates rates = Rates.of(1000, new long[] {4_000, 1_000, 10_000, 2_000, 5_000},
            new long[] {3_000, 1_000, 9_000, 2_000, 4_000}, 0xabcL);
        assertEquals(5, rates.runs());
        assertEquals(1000, rates.events());
        assertEquals(100e6, rates.minPerS(), EXACT);
        assertEquals(250e6, rates.medianPerS(), EXACT);
        assertEquals(1000e6, rates.maxPerS(), EXACT);
        assertEquals(3, rates.cpuNsPerEvent(), EXACT);
        assertEquals("0000000000000abc", rates.checksum());
    }

    @Test
    public void theMedianOfAnEvenNumberOfRunsIsBetweenTheMiddleTwo() {
        // 1000, 500, 250 and 200 million a second
        assertEquals(375e6, of(1000, 1_000, 2_000, 4_000, 5_000).medianPerS(), EXACT);
    }

    @Test
    public void aRunTooShortForTheClockTakesItsSmallestStep() {
        assertEquals(3e9, of(3, 0).medianPerS(), EXACT);
    }

    @Test
    public void theTimeOfAnEventIsThatOfTheMiddleRun() {
        assertEquals(4, of(1000, 4_000, 1_000, 10_000).medianNsPerEvent(), EXACT);
    }
}
