package io.github.sofas.flow;

import static org.junit.Assert.assertEquals;
import static org.junit.Assert.assertFalse;
import static org.junit.Assert.assertTrue;

import io.github.sofas.event.SensorSize;
import io.github.sofas.flow.PlainPlane.Cell;
import io.github.sofas.flow.PlainPlane.Event;
import io.github.sofas.simulate.Scene;
import java.util.ArrayList;
import java.util.HashMap;
import java.util.List;
import java.util.Map;
import java.util.Random;
import org.junit.Test;

/** The flow plane of the default preset against a plain one, which projects everything anew at each look. */
public class FlowPlaneTest {
    private static final SensorSize TINY = new SensorSize(32, 24);
    private static final SofasParameters P = SofasParameters.defaults();

    /** The events of a flow plane by number, on planes without borders. */
    private static final class PlainFlowPlane {
        private final SofasParameters p;
        private final FlowPlane fast;
        private final List<Event> events = new ArrayList<>();
        private final List<Boolean> taken = new ArrayList<>();
        private int settled;

        PlainFlowPlane(SofasParameters p, FlowPlane fast) {
            this.p = p;
            this.fast = fast;
        }

        void add(Event e) {
            events.add(e);
            taken.add(false);
            fast.add(e.x(), e.y(), e.timeUs(), e.polarity());
        }

        void settle(long nowUs) {
            settled = events.size();
            fast.settle(nowUs);
        }

        private void takeOut(List<Integer> numbers) {
            numbers.forEach(i -> taken.set(i, true));
            fast.takeOut(numbers.stream().mapToInt(Integer::intValue).toArray(), numbers.size());
        }

        /** Numbers of the events whose age is not above the time in which a ring travels its pixels. */
        private List<Integer> held(int ring, long nowUs) {
            double travelUs = p.flowTravelPx() / fast.speed(ring) * 1e6;
            long windowUs = (long) Math.min(p.lifespanUs(), travelUs);
            List<Integer> held = new ArrayList<>();
            for (int i = 0; i < settled; i++) {
                if (!taken.get(i) && events.get(i).timeUs() >= nowUs - windowUs) {
                    held.add(i);
                }
            }
            return held;
        }

        /** Cell of 2 x 2 px, of a position to the next lower 1/256 px. */
        private Cell cell(int k, Event e) {
            long dt = e.timeUs() - events.get(0).timeUs();
            return new Cell(halved(e.x(), fast.vx(k), dt), halved(e.y(), fast.vy(k), dt));
        }

        private static long halved(int px, double pxPerS, long dt) {
            long velocity = Math.round(pxPerS / 1e6 * 0x1p28);
            return Math.floorDiv(256L * px - Math.floorDiv(Math.multiplyExact(velocity, dt), 1L << 20), 512L);
        }

        private void compare(long nowUs) {
            int n = p.flowProjections();
            for (int ring = 0; ring < n; ring++) {
                List<Integer> held = held(ring, nowUs);
                assertEquals("events of ring " + ring, held.size(), fast.count(ring));
                for (int k = ring * n; k < ring * n + n; k++) {
                    Map<Cell, Integer> f = new HashMap<>();
                    Map<Cell, Integer> place = new HashMap<>();
                    for (int i : held) {
                        Cell cell = cell(k, events.get(i));
                        f.merge(cell, events.get(i).polarity(), Integer::sum);
                        place.putIfAbsent(cell, fast.cell(k, i));
                        assertEquals("cell of event " + i, place.get(cell), (Integer) fast.cell(k, i));
                    }
                    long metric = 0;
                    for (Map.Entry<Cell, Integer> entry : f.entrySet()) {
                        metric += (long) entry.getValue() * entry.getValue();
                        assertEquals((int) entry.getValue(), fast.accumulator(k)[place.get(entry.getKey())]);
                    }
                    assertEquals("metric of projection " + k, metric, fast.metric(k));
                }
            }
        }
    }

    @Test
    public void everyMetricIsTheSumOfSquaresAfterEverySettling() {
        List<List<Event>> streams = List.of(
            Streams.edge(2, 25, 24, 1000, 8_000),
            Streams.filmed(Scene.HEXAGON, TINY, 0.2, 30, 1500),
            Streams.chance(1, TINY, 1500, 0, 600),
            Streams.chance(2, TINY, 1500, 4_000_000_000_000_000L, 150),
            Streams.chance(3, TINY, 1500, -5_000_000_000L, 5_000));
        for (List<Event> events : streams) {
            addSettleAndCompare(events, TINY, P.withFlowProjections(5), 1);
            addSettleAndCompare(events, TINY, P.withLifespanUs(30_000), 7);
        }
    }

    @Test
    public void everyMetricIsTheSumOfSquaresWhenTheEventsOutgrowTheArrays() {
        // 20,000 events in 0.2 s, all held by the slow rings
        List<Event> events = Streams.chance(4, new SensorSize(128, 128), 20_000, 0, 10);
        addSettleAndCompare(events, new SensorSize(128, 128), P.withFlowProjections(3), 40);
    }

    private static void addSettleAndCompare(List<Event> events, SensorSize sensor, SofasParameters p, int every) {
        Random random = new Random(5);
        FlowPlane fast = new FlowPlane(sensor.width(), sensor.height(), p);
        PlainFlowPlane plain = new PlainFlowPlane(p, fast);
        int settlings = 0;
        for (Event e : events) {
            plain.add(e);
            if (fast.isBlockFull(e.timeUs())) {
                plain.settle(e.timeUs());
                if (settlings++ % every == 0) {
                    plain.compare(e.timeUs());
                }
                if (random.nextInt(4) == 0) {
                    // a structure is taken out, as if a third of the events of one ring were it
                    List<Integer> structure = plain.held(random.nextInt(p.flowProjections()), e.timeUs());
                    structure.removeIf(i -> random.nextInt(3) > 0);
                    plain.takeOut(structure);
                    if (settlings % every == 0) {
                        plain.compare(e.timeUs());
                    }
                }
            }
        }
        assertTrue("settlings " + settlings, settlings >= events.size() / 256);
    }

    @Test
    public void blockIsFullAt256EventsOrAfterTwoMilliseconds() {
        FlowPlane plane = new FlowPlane(32, 24, P);
        assertFalse(plane.isBlockFull(1_000_000));
        for (int i = 0; i < 255; i++) {
            plane.add(1, 1, 0, 1);
        }
        assertFalse(plane.isBlockFull(2_000));
        assertTrue(plane.isBlockFull(2_001));
        plane.add(1, 1, 0, 1);
        assertTrue(plane.isBlockFull(0));
        plane.settle(0);
        assertFalse(plane.isBlockFull(1_000_000));
    }

    @Test
    public void speedsAreEvenlySpacedInLogarithmAndDirectionsAllRound() {
        // 5 speeds from 4 to 1024 px/s: a factor of 4 each. Ring 1 is turned by 36 degrees, half of 72.
        SofasParameters p = P.withFlowProjections(5).withSlowestPxPerS(4).withFastestPxPerS(1024);
        FlowPlane plane = new FlowPlane(32, 24, p);
        for (int ring = 0; ring < 5; ring++) {
            assertEquals(4 * Math.pow(4, ring), plane.speed(ring), 1e-9);
        }
        assertEquals(4, plane.vx(0), 0.004);
        assertEquals(0, plane.vy(0), 0.004);
        assertEquals(16 * Math.cos(Math.toRadians(36)), plane.vx(5), 0.004);
        assertEquals(16 * Math.sin(Math.toRadians(36)), plane.vy(5), 0.004);
        assertEquals(1024 * Math.cos(Math.toRadians(72)), plane.vx(21), 0.004);
        assertEquals(1024 * Math.sin(Math.toRadians(72)), plane.vy(21), 0.004);
    }

    @Test
    public void eventLeavesASpeedWhenThatHasTravelledItsPixels() {
        // 4 px: at 4 px/s 1 s, at 16 px/s 0.25 s, at 64 px/s 62,500 us; the lifespan of 0.5 s ends the first sooner
        SofasParameters p = P.withFlowProjections(3).withSlowestPxPerS(4).withFastestPxPerS(64).withFlowTravelPx(4)
            .withLifespanUs(500_000);
        FlowPlane plane = new FlowPlane(32, 24, p);
        plane.add(10, 10, 0, 1);
        long[] leaves = {500_000, 250_000, 62_500};
        for (long now : new long[] {62_500, 62_501, 250_000, 250_001, 500_000, 500_001}) {
            plane.settle(now);
            for (int ring = 0; ring < 3; ring++) {
                assertEquals("ring " + ring + " at " + now, now > leaves[ring] ? 0 : 1, plane.count(ring));
                assertEquals(now > leaves[ring] ? 0 : 1, plane.metric(ring * 3));
            }
        }
    }

    @Test
    public void resetEmptiesEveryProjection() {
        FlowPlane plane = new FlowPlane(32, 24, P);
        for (Event e : Streams.edge(3, 10, 20, -100, 5_000)) {
            plane.add(e.x(), e.y(), e.timeUs(), e.polarity());
            if (plane.isBlockFull(e.timeUs())) {
                plane.settle(e.timeUs());
            }
        }
        plane.reset();
        int n = P.flowProjections();
        for (int k = 0; k < n * n; k++) {
            assertEquals(0, plane.metric(k));
            assertEquals(0, plane.count(k / n));
        }
        // as a new one: seen from the first event's time on, however late
        plane.add(5, 5, 1L << 50, 1);
        plane.settle(1L << 50);
        assertEquals(1, plane.metric(0));
        assertEquals(2 << plane.rowBits() | 2, plane.cell(0, 0));
    }
}
