package io.github.sofas.cli;

import static org.junit.Assert.assertEquals;

import io.github.sofas.event.EventBatch;
import io.github.sofas.event.EventSourceException;
import io.github.sofas.flow.EventLabeller;
import io.github.sofas.flow.FlowOutput;
import io.github.sofas.flow.Segment;
import io.github.sofas.live.Cameras;
import io.github.sofas.live.FakeTransport;
import io.github.sofas.live.LiveSource;
import java.io.PrintWriter;
import java.io.StringWriter;
import java.util.ArrayList;
import java.util.List;
import org.junit.Test;

public class LiveStatusTest {
    private final StringWriter shown = new StringWriter();
    private final List<Segment> segments = new ArrayList<>();
    private long nowNs = 5_000_000_000L;

    private final EventLabeller labeller = new EventLabeller() {
        @Override
        public void process(EventBatch batch, FlowOutput output) {
            throw new AssertionError("only asked for its segments");
        }

        @Override
        public List<Segment> segments() {
            return segments;
        }

        @Override
        public void reset() {
            throw new AssertionError("only asked for its segments");
        }
    };

    private void segment(int id, long events, float vx, float vy) {
        segments.add(new Segment(id, 0, 1, events, vx, vy, 0, 0, 0, 0, 1, 1, Segment.Fate.ALIVE, 0));
    }

    private LiveStatus status(int columns) throws EventSourceException {
        LiveSource source = new Cameras(FakeTransport.davis240c()).open(null);
        return new LiveStatus(source, new PrintWriter(shown), columns, () -> nowNs);
    }

    /** Two seconds: segments are those of the first batch after the line before. */
    private void run(LiveStatus status) {
        status.started();
        nowNs += 1_000_000_000L;
        status.show();
        status.labelled(1_500_000, 300_000, 700_000, labeller::segments);
        nowNs += 2_000_000_000L;
        status.show();
    }

    private List<String> lines() {
        return shown.toString().lines().toList();
    }

    @Test
    public void showsTheLargestSegmentsWithTheirVelocities() throws Exception {
        segment(1, 10, 3, 4);
        segment(2, 50, 250.4f, -37.6f);
        segment(3, 40, 0, 0);
        segment(4, 30, -1, 1);
        segment(5, 20, 9, 9);
        run(status(Integer.MAX_VALUE));
        assertEquals(List.of("    1 s:       0 events/s,   0.0 % flow, queue   0/256, 0 dropped, 0 segments",
            "    3 s:  750000 events/s,  20.0 % flow, queue   0/256, 0 dropped, 5 segments: #2 (250, -38) #3 (0, 0) "
            + "#4 (-1, 1) #5 (9, 9) ... px/s"), lines());
    }

    @Test
    public void takesASecondLineForSegmentsOnANarrowTerminal() throws Exception {
        segment(1, 10, 300, 44);
        segment(2, 50, 250.4f, -37.6f);
        run(status(80));
        assertEquals(List.of("    1 s:       0 events/s,   0.0 % flow, queue   0/256, 0 dropped, 0 segments",
            "    3 s:  750000 events/s,  20.0 % flow, queue   0/256, 0 dropped, 2 segments",
            "         #2 (250, -38) #1 (300, 44) px/s"), lines());
    }

    @Test
    public void showsNothingBeforeTheStart() throws Exception {
        status(80).show();
        assertEquals(List.of(), lines());
    }

    @Test
    public void tellsHowLongEventsTookToTheirLabels() throws Exception {
        LiveStatus status = status(80);
        status.started();
        // 990 of 1 ms, 9 of 4 ms, one of 20 ms
        for (int i = 0; i < 1000; i++) {
            status.labelled(1, 1, i < 990 ? 1_000_000 : i < 999 ? 4_000_000 : 20_000_000, labeller::segments);
        }
        assertEquals("from arrival to label: p50 1.0 ms, p99 1.0 ms, p99.9 4.0 ms, longest 20.0 ms", status.latency());
    }
}
