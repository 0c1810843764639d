package io.github.sofas.benchmark;

import static org.junit.Assert.assertEquals;
import static org.junit.Assert.assertNotEquals;

import io.github.sofas.event.EventBatch;
import io.github.sofas.flow.FlowOutput;
import org.junit.Test;

public class ChecksumTest {
    private static FlowOutput twoEvents() {
        FlowOutput flow = new FlowOutput(2);
        flow.segment[0] = 1;
        flow.vxPxPerS[0] = 58;
        flow.vyPxPerS[0] = -1.5f;
        return flow;
    }

    private static long of(FlowOutput flow) {
        Checksum checksum = new Checksum();
        checksum.add(flow, flow.capacity());
        return checksum.value();
    }

    private static EventBatch events(int from, int to) {
        EventBatch batch = new EventBatch(8);
        for (int i = from; i < to; i++) {
            batch.add(1000L * i, i, 2 * i, i % 2 == 0 ? 1 : -1);
        }
        return batch;
    }

    @Test
    public void equalResultsHaveEqualChecksums() {
        assertEquals(of(twoEvents()), of(twoEvents()));
    }

    @Test
    public void everyFieldCounts() {
        long plain = of(twoEvents());
        FlowOutput otherSegment = twoEvents();
        otherSegment.segment[1] = 2;
        FlowOutput otherVx = twoEvents();
        otherVx.vxPxPerS[0] = Math.nextUp(58f);
        FlowOutput otherVy = twoEvents();
        otherVy.vyPxPerS[0] = 1.5f;
        assertNotEquals(plain, of(otherSegment));
        assertNotEquals(plain, of(otherVx));
        assertNotEquals(plain, of(otherVy));
    }

    @Test
    public void orderCounts() {
        FlowOutput swapped = new FlowOutput(2);
        swapped.segment[1] = 1;
        swapped.vxPxPerS[1] = 58;
        swapped.vyPxPerS[1] = -1.5f;
        assertNotEquals(of(twoEvents()), of(swapped));
    }

    @Test
    public void batchesDoNotCount() {
        Checksum inOne = new Checksum();
        inOne.add(events(0, 5));
        Checksum inTwo = new Checksum();
        inTwo.add(events(0, 2));
        inTwo.add(events(2, 5));
        assertEquals(inOne.value(), inTwo.value());
    }

    @Test
    public void theStartIsThatOfTheHashAsPublished() {
        // FNV-1a's offset basis for 64 bits
        assertEquals(0xcbf29ce484222325L, new Checksum().value());
    }
}
