package io.github.sofas.baseline;

import static org.junit.Assert.assertEquals;

import io.github.sofas.event.EventBatch;
import io.github.sofas.event.SensorSize;
import io.github.sofas.flow.FlowOutput;
import java.util.ArrayList;
import java.util.Comparator;
import java.util.List;
import org.junit.Test;

public class LocalPlanesTest {
    private static final SensorSize SENSOR = new SensorSize(11, 11);
    private static final int MIDDLE = 5;
    private static final long NOW_US = 1_000_000;

    private final List<long[]> events = new ArrayList<>();
    private final FlowOutput output = new FlowOutput(500);

    private void fire(long timeUs, int x, int y, int polarity) {
        events.add(new long[] {timeUs, x, y, polarity});
    }

    /** An event at each pixel of the window that the edge passed before it reached the middle, now. */
    private void edge(long usPerColumn, long usPerRow) {
        for (int dy = -3; dy <= 3; dy++) {
            for (int dx = -3; dx <= 3; dx++) {
                long timeUs = NOW_US + usPerColumn * dx + usPerRow * dy;
                if (timeUs < NOW_US || dx == 0 && dy == 0) {
                    fire(timeUs, MIDDLE + dx, MIDDLE + dy, 1);
                }
            }
        }
    }

    private int process() {
        events.sort(Comparator.comparingLong((long[] e) -> e[0]));
        EventBatch batch = new EventBatch(500);
        for (long[] e : events) {
            batch.add(e[0], (int) e[1], (int) e[2], (int) e[3]);
        }
        new LocalPlanes(SENSOR).process(batch, output);
        return batch.size() - 1;
    }

    private void assertLast(double vx, double vy) {
        int last = process();
        assertEquals(vx, output.vxPxPerS[last], 1e-3);
        assertEquals(vy, output.vyPxPerS[last], 1e-3);
        assertEquals(vx == 0 && vy == 0 ? 0 : 1, output.segment[last]);
    }

    @Test
    public void givesAnEdgeItsVelocityExactly() {
        // v = (40, 30): g = v / |v|² = (0.016, 0.012) s/px.
        edge(16_000, 12_000);
        assertLast(40, 30);
    }

    @Test
    public void givesAnEdgeThatMovesStraightLeftNoVerticalPart() {
        edge(-20_000, 0);
        assertLast(-50, 0);
    }

    @Test
    public void dropsAPointThatIsOffThePlane() {
        edge(16_000, 12_000);
        events.removeIf(e -> e[1] == 4 && e[2] == 4);
        // The plane has 972,000 there.
        fire(996_000, 4, 4, 1);
        assertLast(40, 30);
    }

    @Test
    public void givesNoFlowToAnEventSoonAfterAnotherOfItsPixel() {
        edge(16_000, 12_000);
        fire(NOW_US - 49_999, MIDDLE, MIDDLE, 1);
        assertLast(0, 0);
    }

    @Test
    public void givesFlowWhereTheOtherIsOlderOrOfTheOtherPolarity() {
        edge(16_000, 12_000);
        fire(NOW_US - 50_000, MIDDLE, MIDDLE, 1);
        fire(NOW_US - 10, MIDDLE, MIDDLE, -1);
        assertLast(40, 30);
    }

    @Test
    public void givesNoFlowToFewerThanFourPoints() {
        fire(980_000, 4, 5, 1);
        fire(980_000, 4, 4, 1);
        fire(NOW_US, MIDDLE, MIDDLE, 1);
        assertLast(0, 0);
    }

    @Test
    public void givesNoFlowToAnEdgeFasterThanTheLeastSlope() {
        // 400 px/s is 0.0025 s/px, below 0.003.
        edge(2_500, 0);
        assertLast(0, 0);
    }

    @Test
    public void ignoresTimesOfTheMaximumAge() {
        edge(16_000, 12_000);
        // 50 ms old at (8, 8), where the edge has not been yet.
        fire(950_000, 8, 8, 1);
        assertLast(40, 30);
    }

    @Test
    public void anEchoDoesNotMoveTheSurface() {
        edge(16_000, 12_000);
        // The plane has 972,000 at (4, 4).
        fire(990_000, 4, 4, 1);
        assertLast(40, 30);
    }

    @Test
    public void givesNoFlowToEventsOutsideTheSensor() {
        EventBatch outside = new EventBatch(2);
        outside.add(0, -1, 5, 1);
        outside.add(1, 5, 11, -1);
        output.segment[1] = 7;
        new LocalPlanes(SENSOR).process(outside, output);
        assertEquals(0, output.segment[0]);
        assertEquals(0, output.segment[1]);
    }
}
