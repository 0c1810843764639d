package io.github.sofas.benchmark;

import static org.junit.Assert.assertEquals;

import java.util.stream.LongStream;
import org.junit.Test;

public class LatencyTest {
    @Test
    public void aPercentileIsTheSmallestTimeThatTheShareDoesNotExceed() {
        // of 1 to 2000: rank 0.5 x 2000, 0.99 x 2000, 0.999 x 2000, 2000
        long[] nanos = LongStream.rangeClosed(1, 2000).map(i -> 2001 - i).toArray();
        assertEquals(new Latency(2000, 1000, 1980, 1998, 2000), Latency.of(nanos));
    }

    @Test
    public void aRankBetweenTwoPacketsIsTheLaterOne() {
        // of three: ranks 1.5, 2.97 and 2.997 are the second, third and third
        assertEquals(new Latency(3, 20, 30, 30, 30), Latency.of(new long[] {30, 10, 20}));
    }

    @Test
    public void onePacketIsEveryPercentile() {
        assertEquals(new Latency(1, 7, 7, 7, 7), Latency.of(new long[] {7}));
    }

    @Test
    public void noPacketHasNoLatency() {
        assertEquals(new Latency(0, 0, 0, 0, 0), Latency.of(new long[0]));
    }
}
