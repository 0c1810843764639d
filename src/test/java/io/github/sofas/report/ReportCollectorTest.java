package io.github.sofas.report;

import static org.junit.Assert.assertEquals;
import static org.junit.Assert.assertTrue;

import io.github.sofas.event.EventBatch;
import io.github.sofas.event.SensorSize;
import io.github.sofas.flow.FlowOutput;
import java.util.List;
import org.junit.Test;

public class ReportCollectorTest {
    /** 10,000 segments of 2 events, 20 ms each, after one of 50 events, before one that is alive at the end. */
    @Test
    public void ofManySegmentsThoseWithMostEventsAreKept() {
        ReportCollector collector = new ReportCollector(new SensorSize(8, 8));
        EventBatch batch = new EventBatch(50);
        FlowOutput flow = new FlowOutput(50);
        for (int i = 0; i < 50; i++) {
            batch.add(i, 1, 1, 1);
            flow.segment[i] = 1;
        }
        collector.add(batch, flow);
        for (int id = 2; id <= 10_001; id++) {
            batch.clear();
            for (int i = 0; i < 2; i++) {
                batch.add(id * 20_000L + i * 10_000L, 1, 1, 1);
                flow.segment[i] = id;
            }
            collector.add(batch, flow);
        }
        List<SegmentCurve> curves = collector.curves();
        assertTrue("twice those kept of the ended at most: " + curves.size(), curves.size() <= 512);
        assertEquals(1, curves.get(0).id);
        assertEquals(50, curves.get(0).events());
        assertTrue(curves.stream().anyMatch(curve -> curve.id == 10_001));
    }
}
