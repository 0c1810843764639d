package io.github.sofas.benchmark;

import static org.junit.Assert.assertEquals;
import static org.junit.Assert.assertThrows;

import io.github.sofas.flow.SofasParameters;
import org.junit.Test;

public class StopwatchTest {
    private static BenchmarkOptions options(int runs, int warmUps) {
        return new BenchmarkOptions(SofasParameters.defaults(), runs, warmUps, 0, 1000, 0);
    }

    @Test
    public void warmsUpThenCountsTheRunsAskedFor() throws Exception {
        int[] runs = new int[1];
        Rates rates = new Stopwatch(options(5, 3)).time("x", 10, () -> runs[0]++, () -> 0x12);
        assertEquals(8, runs[0]);
        assertEquals(5, rates.runs());
        assertEquals(10, rates.events());
        assertEquals("0000000000000012", rates.checksum());
    }

    @Test
    public void refusesRunsThatDiffer() {
        int[] runs = new int[1];
        Stopwatch stopwatch = new Stopwatch(options(5, 1));
        IllegalStateException e = assertThrows(IllegalStateException.class,
            () -> stopwatch.time("the engine", 10, () -> runs[0]++, () -> runs[0] < 3 ? 1 : 2));
        assertEquals("the results of the engine must be the same in every run but their checksums were "
            + "0000000000000001 and 0000000000000002", e.getMessage());
    }

    @Test
    public void optionsHaveBounds() {
        assertEquals("runs must be at least 5 but was 4",
            assertThrows(IllegalArgumentException.class, () -> options(4, 1)).getMessage());
        assertEquals("warmUps must be at least 1 but was 0",
            assertThrows(IllegalArgumentException.class, () -> options(5, 0)).getMessage());
        assertEquals("warmUpMs must be at least 0 but was -1", assertThrows(IllegalArgumentException.class,
            () -> new BenchmarkOptions(SofasParameters.defaults(), 5, 1, -1, 1, 0)).getMessage());
        assertEquals("mostEvents must be at least 1 but was 0", assertThrows(IllegalArgumentException.class,
            () -> new BenchmarkOptions(SofasParameters.defaults(), 5, 1, 0, 0, 0)).getMessage());
        assertEquals("sampledMs must be at least 0 but was -1", assertThrows(IllegalArgumentException.class,
            () -> new BenchmarkOptions(SofasParameters.defaults(), 5, 1, 0, 1, -1)).getMessage());
    }
}
