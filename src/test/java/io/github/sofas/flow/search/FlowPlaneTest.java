package io.github.sofas.flow.search;

import static org.junit.Assert.assertEquals;
import static org.junit.Assert.assertFalse;
import static org.junit.Assert.assertTrue;

import io.github.sofas.event.SensorSize;
import io.github.sofas.flow.PlainPlane.Cell;
import io.github.sofas.flow.PlainPlane.Event;
import io.github.sofas.flow.SofasParameters;
import io.github.sofas.flow.Streams;
import io.github.sofas.simulate.Scene;
import java.math.BigDecimal;
import java.math.RoundingMode;
import java.util.ArrayList;
import java.util.Arrays;
import java.util.HashMap;
import java.util.HashSet;
import java.util.List;
import java.util.Map;
import java.util.Random;
import java.util.Set;
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
        /** Cells of the events by projection and number, which exact numbers take long to work out. */
        private final Map<Long, Cell> cells = new HashMap<>();
        /** Rings that each event was taken out of. */
        private final List<Set<Integer>> taken = new ArrayList<>();
        // by ring: how many events it has taken in, and when
        private final int[] end;
        private final long[] settledUs;

        PlainFlowPlane(SofasParameters p, FlowPlane fast) {
            this.p = p;
            this.fast = fast;
            end = new int[p.search().flowProjections()];
            settledUs = new long[p.search().flowProjections()];
        }

        void add(Event e) {
            if (events.isEmpty()) {
                Arrays.fill(settledUs, e.timeUs());
            }
            events.add(e);
            taken.add(new HashSet<>());
            fast.add(e.x(), e.y(), e.timeUs(), e.polarity());
        }

        void settle(long nowUs) {
            for (int ring = 0; ring < end.length; ring++) {
                // 1,024 events make a block; fewer are taken in after a sixteenth of the window
                if (events.size() - end[ring] >= 1024 || nowUs - settledUs[ring] >= windowUs(ring) / 16.0) {
                    end[ring] = events.size();
                    settledUs[ring] = nowUs;
                }
            }
            fast.settle(nowUs);
        }

        private void takeOut(int ring, List<Integer> numbers) {
            numbers.forEach(i -> taken.get(i).add(ring));
            int[] array = numbers.stream().mapToInt(Integer::intValue).toArray();
            fast.takeOut(ring, array, 0, array.length);
        }

        /** The time in which a ring travels its pixels. */
        private long windowUs(int ring) {
            double speed = fast.projections().speed(ring);
            return (long) Math.min(p.search().lifespanUs(), Projections.TRAVEL_PX / speed * 1e6);
        }

        /** Numbers of the events that were not older than the window when the ring settled last. */
        private List<Integer> held(int ring) {
            List<Integer> held = new ArrayList<>();
            for (int i = 0; i < end[ring]; i++) {
                if (!taken.get(i).contains(ring) && events.get(i).timeUs() >= settledUs[ring] - windowUs(ring)) {
                    held.add(i);
                }
            }
            return held;
        }

        /** Cell of 2 x 2 px, of time in ticks of a power of two µs that travel 1/512 to 1/256 px. */
        private Cell cell(int k, int event) {
            return cells.computeIfAbsent((long) k << 32 | event, key -> cell(k, events.get(event)));
        }

        private Cell cell(int k, Event e) {
            double pxPerUs = fast.projections().speed(k / p.search().flowProjections()) / 1e6;
            int bits = 0;
            while ((2L << bits) * pxPerUs <= 1.0 / 256) {
                bits++;
            }
            long ticks = e.timeUs() - events.get(0).timeUs() >> bits;
            return new Cell(halved(e.x(), fast.projections().vx(k) * (1L << bits), ticks),
                halved(e.y(), fast.projections().vy(k) * (1L << bits), ticks));
        }

        private static long halved(int px, double microPxPerTick, long ticks) {
            BigDecimal travel = new BigDecimal(microPxPerTick / 1e6).multiply(BigDecimal.valueOf(ticks));
            return BigDecimal.valueOf(px).subtract(travel).divide(BigDecimal.valueOf(2))
                .setScale(0, RoundingMode.FLOOR).longValueExact();
        }

        private void compare() {
            int n = p.search().flowProjections();
            for (int ring = 0; ring < n; ring++) {
                List<Integer> held = held(ring);
                assertEquals("events of ring " + ring, held.size(), fast.count(ring));
                for (int k = ring * n; k < ring * n + n; k++) {
                    Map<Cell, Integer> f = new HashMap<>();
                    Map<Cell, Integer> place = new HashMap<>();
                    for (int i : held) {
                        Cell cell = cell(k, i);
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
            addSettleAndCompare(events, TINY, P.with("flowProjections", 5), 1);
            addSettleAndCompare(events, TINY, P.with("lifespanUs", 30_000), 7);
        }
    }

    @Test
    public void everyMetricIsTheSumOfSquaresWhenTheEventsOutgrowTheArrays() {
        // 20,000 events in 0.2 s, all held by the slow rings
        List<Event> events = Streams.chance(4, new SensorSize(128, 128), 20_000, 0, 10);
        addSettleAndCompare(events, new SensorSize(128, 128), P.with("flowProjections", 3), 40);
    }

    private static void addSettleAndCompare(List<Event> events, SensorSize sensor, SofasParameters p, int every) {
        Random random = new Random(5);
        FlowPlane fast = new FlowPlane(sensor.width(), sensor.height(), p.search());
        PlainFlowPlane plain = new PlainFlowPlane(p, fast);
        int settlings = 0;
        List<Integer> structure = new ArrayList<>();
        int nextRing = p.search().flowProjections();
        for (Event e : events) {
            plain.add(e);
            if (fast.mustSettle(e.timeUs())) {
                plain.settle(e.timeUs());
                if (settlings++ % every == 0) {
                    plain.compare();
                }
                if (nextRing < p.search().flowProjections()) {
                    plain.takeOut(nextRing++, structure);
                } else if (random.nextInt(4) == 0) {
                    // a structure is taken out ring by ring, as if a third of the events of one ring were it
                    structure = plain.held(random.nextInt(p.search().flowProjections()));
                    structure.removeIf(i -> random.nextInt(3) > 0);
                    nextRing = 0;
                }
            }
        }
        assertTrue("settlings " + settlings, settlings >= events.size() / 256);
    }

    @Test
    public void blockIsFullAt256EventsOrAfterTwoMilliseconds() {
        FlowPlane plane = new FlowPlane(32, 24, P.search());
        assertFalse(plane.mustSettle(1_000_000));
        for (int i = 0; i < 255; i++) {
            plane.add(1, 1, 0, 1);
        }
        assertFalse(plane.mustSettle(2_000));
        assertTrue(plane.mustSettle(2_001));
        plane.add(1, 1, 0, 1);
        assertTrue(plane.mustSettle(0));
        plane.settle(0);
        assertFalse(plane.mustSettle(1_000_000));
    }

    @Test
    public void speedsAreEvenlySpacedInLogarithmAndDirectionsAllRound() {
        // 5 speeds from 4 to 1024 px/s: a factor of 4 each. Ring 1 is turned by 36 degrees, half of 72.
        SofasParameters p = P.with("flowProjections", 5).with("slowestPxPerS", 4).with("fastestPxPerS", 1024);
        FlowPlane plane = new FlowPlane(32, 24, p.search());
        for (int ring = 0; ring < 5; ring++) {
            assertEquals(4 * Math.pow(4, ring), plane.projections().speed(ring), 1e-9);
        }
        assertEquals(4, plane.projections().vx(0), 0.004);
        assertEquals(0, plane.projections().vy(0), 0.004);
        assertEquals(16 * Math.cos(Math.toRadians(36)), plane.projections().vx(5), 0.004);
        assertEquals(16 * Math.sin(Math.toRadians(36)), plane.projections().vy(5), 0.004);
        assertEquals(1024 * Math.cos(Math.toRadians(72)), plane.projections().vx(21), 0.004);
        assertEquals(1024 * Math.sin(Math.toRadians(72)), plane.projections().vy(21), 0.004);
    }

    @Test
    public void eventLeavesASpeedWhenThatHasTravelledItsPixels() {
        // 6 px: at 6 px/s 1 s, at 24 px/s 0.25 s, at 96 px/s 62,500 us; the lifespan of 0.5 s ends the first sooner
        SofasParameters p = P.with("flowProjections", 3).with("slowestPxPerS", 6).with("fastestPxPerS", 96)
            .with("lifespanUs", 500_000);
        long[] leaves = {500_000, 250_000, 62_500};
        for (int ring = 0; ring < 3; ring++) {
            for (int late = 0; late < 2; late++) {
                FlowPlane plane = new FlowPlane(32, 24, p.search());
                plane.add(10, 10, 0, 1);
                plane.settle(leaves[ring] + late);
                assertEquals("ring " + ring + " late " + late, 1 - late, plane.count(ring));
                assertEquals(1 - late, plane.metric(ring * 3));
            }
        }
    }

    @Test
    public void ringTakesItsEventsInAfterASixteenthOfItsWindowOrWhenTheyAreABlock() {
        // windows of 1 s, 0.25 s and 62.5 ms: a sixteenth is 62,500, 15,625 and 3,906.25 us
        SofasParameters p = P.with("flowProjections", 3).with("slowestPxPerS", 6).with("fastestPxPerS", 96);
        FlowPlane plane = new FlowPlane(32, 24, p.search());
        plane.add(10, 10, 0, 1);
        plane.settle(15_624);
        assertEquals(0, plane.count(0));
        assertEquals(0, plane.count(1));
        assertEquals(1, plane.count(2));
        plane.settle(15_625);
        assertEquals(0, plane.count(0));
        assertEquals(1, plane.count(1));
        for (int i = 1; i < 1024; i++) {
            plane.add(10, 10, 15_625, 1);
        }
        plane.settle(15_625);
        assertEquals(1024, plane.count(0));
    }

    @Test
    public void resetEmptiesEveryProjection() {
        FlowPlane plane = new FlowPlane(32, 24, P.search());
        for (Event e : Streams.edge(3, 10, 20, -100, 5_000)) {
            plane.add(e.x(), e.y(), e.timeUs(), e.polarity());
            if (plane.mustSettle(e.timeUs())) {
                plane.settle(e.timeUs());
            }
        }
        plane.reset();
        int n = P.search().flowProjections();
        for (int k = 0; k < n * n; k++) {
            assertEquals(0, plane.metric(k));
            assertEquals(0, plane.count(k / n));
        }
        // as a new one: seen from the first event's time on, however late
        plane.add(5, 5, 1L << 50, 1);
        plane.settle((1L << 50) + 100_000);
        assertEquals(1, plane.count(0));
        assertEquals(1, plane.metric(0));
        assertEquals(2 << plane.projections().columnBits() | 2, plane.cell(0, 0));
    }
}
