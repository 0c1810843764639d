package io.github.sofas.jaer;

import static org.junit.Assert.assertEquals;

import io.github.sofas.event.EventBatch;
import io.github.sofas.flow.FlowOutput;
import org.junit.Test;

public class ShownEventsTest {
    private final ShownEvents shown = new ShownEvents();

    /** Events at x from..to - 1, those of even x with flow. */
    private void add(int from, int to) {
        EventBatch batch = new EventBatch(to - from);
        FlowOutput flow = new FlowOutput(to - from);
        for (int i = from; i < to; i++) {
            batch.add(i, i % 1000, 0, 1);
            flow.segment[i - from] = i % 2 == 0 ? 5 : 0;
            flow.vxPxPerS[i - from] = i;
        }
        shown.add(batch, flow);
    }

    @Test
    public void allPacketsSinceTheLastPictureAreShown() {
        add(0, 3);
        add(3, 5);
        assertEquals(5, shown.size());
        assertEquals(3, shown.withFlow());
        assertEquals(4, shown.x(4));
        assertEquals(5, shown.segment(4));
    }

    @Test
    public void pictureThatIsDrawnAgainIsTheSame() {
        add(0, 3);
        shown.setDrawn();
        shown.setDrawn();
        assertEquals(3, shown.size());
    }

    @Test
    public void packetAfterAPictureBeginsAnother() {
        add(0, 3);
        shown.setDrawn();
        add(3, 5);
        assertEquals(2, shown.size());
        assertEquals(1, shown.withFlow());
        assertEquals(3, shown.x(0));
    }

    @Test
    public void newestAreKeptWhereNoneIsDrawn() {
        add(0, ShownEvents.MOST);
        add(0, 10);
        assertEquals(ShownEvents.MOST, shown.size());
        assertEquals(ShownEvents.MOST / 2, shown.withFlow());
        assertEquals(10, shown.vxPxPerS(0), 0);
        add(0, ShownEvents.MOST + 4);
        assertEquals(4, shown.vxPxPerS(0), 0);
    }
}
