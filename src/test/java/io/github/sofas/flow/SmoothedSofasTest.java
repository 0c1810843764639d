package io.github.sofas.flow;

import static org.junit.Assert.assertEquals;
import static org.junit.Assert.assertFalse;
import static org.junit.Assert.assertNull;
import static org.junit.Assert.assertThrows;
import static org.junit.Assert.assertTrue;

import io.github.sofas.event.EventBatch;
import io.github.sofas.event.SensorSize;
import io.github.sofas.flow.PlainPlane.Event;
import io.github.sofas.simulate.Scene;
import io.github.sofas.simulate.SimulatedRecording;
import io.github.sofas.simulate.SimulationOptions;
import java.util.ArrayDeque;
import java.util.ArrayList;
import java.util.Deque;
import java.util.HashMap;
import java.util.List;
import java.util.Map;
import java.util.TreeMap;
import org.junit.Test;

public class SmoothedSofasTest {
    private static final SensorSize SENSOR = new SensorSize(128, 128);
    private static final long LOOK_AHEAD_US = 200_000;
    private static final List<Event> FILM = Streams.filmed(Scene.TWO_OPPOSITE, SENSOR, 0.5, 20, 12_000);

    /** An event as it was given back. */
    private record Given(Event event, int segment, float vx, float vy) {
    }

    private static List<Given> run(SmoothedSofas sofas, List<Event> events, int batchSize) {
        List<Given> given = new ArrayList<>();
        EventBatch batch = new EventBatch(batchSize);
        FlowOutput flow = new FlowOutput(batchSize);
        for (int i = 0; i < events.size(); i += batchSize) {
            sofas.add(Streams.batch(events.subList(i, Math.min(events.size(), i + batchSize))));
            take(sofas, batch, flow, given);
        }
        sofas.finish();
        take(sofas, batch, flow, given);
        return given;
    }

    private static void take(SmoothedSofas sofas, EventBatch batch, FlowOutput flow, List<Given> given) {
        while (sofas.next(batch, flow)) {
            for (int i = 0; i < batch.size(); i++) {
                given.add(new Given(new Event(batch.x[i], batch.y[i], batch.timeUs[i], batch.polarity[i]),
                    flow.segment[i], flow.vxPxPerS[i], flow.vyPxPerS[i]));
            }
        }
    }

    private static List<Given> run(List<Event> events, int batchSize) {
        return run(new SmoothedSofas(SENSOR, SofasParameters.defaults(), LOOK_AHEAD_US), events, batchSize);
    }

    private static List<Event> eventsOf(List<Given> given) {
        return given.stream().map(Given::event).toList();
    }

    @Test
    public void givesEveryEventBackOnceAndInOrder() {
        List<Event> events = new ArrayList<>(FILM);
        // outside of the sensor, back in time, and after a pause of an hour
        events.add(5000, new Event(200, 5, FILM.get(5000).timeUs(), 1));
        events.add(6000, new Event(5, 5, FILM.get(5999).timeUs() - 70_000, -1));
        events.addAll(Streams.later(FILM.subList(0, 3000), 3_600_000_000L));
        assertEquals(events, eventsOf(run(events, 4096)));
        assertEquals(List.of(), run(List.of(), 10));
    }

    @Test
    public void labelsDoNotDependOnHowEventsAreCutIntoBatches() {
        List<Given> whole = run(FILM, FILM.size());
        assertTrue(whole.stream().anyMatch(given -> given.segment != 0));
        assertEquals(whole, run(FILM, 4096));
        assertEquals(whole, run(FILM, 37));
        assertEquals(whole, run(FILM, 1));
    }

    @Test
    public void labelsAreTheSameHoweverFarTheFirstStepIsAhead() {
        List<Given> together = run(FILM, 1000);
        for (int ahead : new int[] {1, 5, FILM.size()}) {
            SmoothedSofas sofas = new SmoothedSofas(SENSOR, SofasParameters.defaults(), LOOK_AHEAD_US);
            Deque<CausalBatch> onTheirWay = new ArrayDeque<>();
            List<Given> given = new ArrayList<>();
            EventBatch batch = new EventBatch(1000);
            FlowOutput flow = new FlowOutput(1000);
            for (int i = 0; i < FILM.size(); i += 1000) {
                CausalBatch causal = new CausalBatch();
                sofas.label(Streams.batch(FILM.subList(i, Math.min(FILM.size(), i + 1000))), causal);
                onTheirWay.add(causal);
                if (onTheirWay.size() > ahead) {
                    sofas.add(onTheirWay.remove());
                    take(sofas, batch, flow, given);
                }
            }
            onTheirWay.forEach(sofas::add);
            sofas.finish();
            take(sofas, batch, flow, given);
            assertEquals(together, given);
        }
    }

    @Test
    public void eventsAreGivenBackOnceTheLookAheadAndAQuarterHavePassed() {
        SmoothedSofas sofas = new SmoothedSofas(SENSOR, SofasParameters.defaults(), LOOK_AHEAD_US);
        List<Given> given = new ArrayList<>();
        EventBatch batch = new EventBatch(100);
        FlowOutput flow = new FlowOutput(100);
        long mostUs = 0;
        for (Event event : FILM) {
            sofas.add(Streams.batch(List.of(event)));
            take(sofas, batch, flow, given);
            long waitingUs = given.size() < FILM.size() ? event.timeUs() - FILM.get(given.size()).timeUs() : 0;
            mostUs = Math.max(mostUs, waitingUs);
        }
        assertTrue(mostUs + " us", mostUs >= LOOK_AHEAD_US && mostUs <= LOOK_AHEAD_US + LOOK_AHEAD_US / 4);
    }

    @Test
    public void fewerThanTheMostEventsAreHeldHoweverDenseTheyAre() {
        // one a µs: the look-ahead would be 200,000 and its quarter 50,000 events for each ten times as dense
        SmoothedSofas sofas = new SmoothedSofas(SENSOR, SofasParameters.defaults(), 10_000_000);
        List<Event> events = new ArrayList<>();
        for (int i = 0; i < 600_000; i++) {
            events.add(new Event(i % 128, i / 128 % 128, i, i / 3 % 2 == 0 ? 1 : -1));
        }
        List<Given> given = new ArrayList<>();
        EventBatch batch = new EventBatch(4096);
        FlowOutput flow = new FlowOutput(4096);
        int most = 0;
        for (int i = 0; i < events.size(); i += 4096) {
            sofas.add(Streams.batch(events.subList(i, Math.min(events.size(), i + 4096))));
            take(sofas, batch, flow, given);
            most = Math.max(most, Math.min(events.size(), i + 4096) - given.size());
        }
        // four slices of 2^16 behind the one that is being filled
        assertTrue(most + " events", most <= 5 << 16);
        sofas.finish();
        take(sofas, batch, flow, given);
        assertEquals(events.size(), given.size());
    }

    /** Object events with a label, and mean relative error of these, of a film. */
    private record Figures(double share, double error) {
    }

    private static Figures figures(SimulatedRecording film, Labelling labelling) {
        EventBatch all = new EventBatch(film.size());
        for (int i = 0; i < film.size(); i++) {
            all.add(film.timeUs[i], film.x[i], film.y[i], film.polarity[i]);
        }
        labelling.add(all);
        labelling.finish();
        EventBatch batch = new EventBatch(4096);
        FlowOutput flow = new FlowOutput(4096);
        int event = 0;
        double objects = 0;
        double labelled = 0;
        double error = 0;
        while (labelling.next(batch, flow)) {
            for (int i = 0; i < batch.size(); i++, event++) {
                if (film.object[event] != 0) {
                    objects++;
                    if (flow.segment[i] != 0) {
                        labelled++;
                        error += Math.hypot(flow.vxPxPerS[i] - film.vxPxPerS[event],
                            flow.vyPxPerS[i] - film.vyPxPerS[event])
                            / Math.max(1, Math.hypot(film.vxPxPerS[event], film.vyPxPerS[event]));
                    }
                }
            }
        }
        return new Figures(labelled / objects, error / labelled);
    }

    @Test
    public void eventsOfBeforeAStructureWasFoundGetItsFlow() {
        SimulatedRecording film = SimulatedRecording.of(Scene.HEXAGON, SimulationOptions.defaults());
        Figures causal = figures(film, Labelling.atOnce(new Sofas(film.sensor(), SofasParameters.defaults())));
        Figures ahead = figures(film, new SmoothedSofas(film.sensor(), SofasParameters.defaults(), LOOK_AHEAD_US));
        assertTrue(causal.share + " at once", causal.share < ahead.share - 0.01);
        assertTrue(ahead.share + " with look-ahead", ahead.share > 0.995);
        assertTrue(ahead.error + " with look-ahead", ahead.error < 0.01);
    }

    @Test
    public void velocitiesOfWhatSwingsDoNotLag() {
        SimulatedRecording film = SimulatedRecording.of(Scene.SWINGING_BALL, SimulationOptions.defaults());
        Figures causal = figures(film, Labelling.atOnce(new Sofas(film.sensor(), SofasParameters.defaults())));
        Figures ahead = figures(film, new SmoothedSofas(film.sensor(), SofasParameters.defaults(), LOOK_AHEAD_US));
        assertTrue(causal.error + " at once, " + ahead.error + " ahead",
            ahead.error < 0.08 && ahead.error < 0.8 * causal.error);
    }

    @Test
    public void whatComesNearGrowsWithoutLag() {
        SimulatedRecording film = SimulatedRecording.of(Scene.COMING_NEAR, SimulationOptions.defaults());
        Figures causal = figures(film, Labelling.atOnce(new Sofas(film.sensor(), SofasParameters.defaults())));
        Figures ahead = figures(film, new SmoothedSofas(film.sensor(), SofasParameters.defaults(), LOOK_AHEAD_US));
        assertTrue(causal.error + " at once, " + ahead.error + " ahead",
            ahead.error < 0.08 && ahead.error < 0.8 * causal.error);
    }

    private static List<Event> events(SimulatedRecording film) {
        List<Event> events = new ArrayList<>();
        for (int i = 0; i < film.size(); i++) {
            events.add(new Event(film.x[i], film.y[i], film.timeUs[i], film.polarity[i]));
        }
        return events;
    }

    @Test
    public void whatTurnsRoundIsKnownAgain() {
        // the engine finds the ball anew after the first turn
        SimulatedRecording film = SimulatedRecording.of(Scene.SWINGING_BALL, SimulationOptions.defaults());
        Map<Integer, Integer> counts = new HashMap<>();
        SmoothedSofas sofas = new SmoothedSofas(film.sensor(), SofasParameters.defaults(), LOOK_AHEAD_US);
        for (Given given : run(sofas, events(film), 4096)) {
            counts.merge(given.segment, 1, Integer::sum);
        }
        counts.remove(0);
        int most = counts.values().stream().mapToInt(count -> count).max().orElseThrow();
        assertTrue(counts.toString(), most > 0.99 * counts.values().stream().mapToInt(count -> count).sum());
    }

    @Test
    public void eachLabelHasOneSegmentThatCountsItsEvents() {
        SimulatedRecording film = SimulatedRecording.of(Scene.THREE_WANDERING, SimulationOptions.defaults());
        List<Segment> segments = new ArrayList<>();
        SmoothedSofas sofas = new SmoothedSofas(film.sensor(), SofasParameters.defaults(), LOOK_AHEAD_US,
            segments::add);
        Map<Integer, Long> counts = new TreeMap<>();
        Map<Integer, Long> firstUs = new TreeMap<>();
        for (Given given : run(sofas, events(film), 1000)) {
            counts.merge(given.segment, 1L, Long::sum);
            firstUs.putIfAbsent(given.segment, given.event.timeUs());
        }
        counts.remove(0);
        assertFalse("none has ended", segments.isEmpty());
        segments.addAll(sofas.segments());
        Map<Integer, Segment> byId = new TreeMap<>();
        segments.forEach(segment -> assertNull("twice: " + segment, byId.put(segment.id(), segment)));
        counts.forEach((id, count) -> {
            long withMerged = count + byId.values().stream()
                .filter(segment -> segment.mergedInto() == id).mapToLong(Segment::events).sum();
            assertEquals(withMerged, byId.get(id).events());
            assertTrue(byId.get(id).toString(), byId.get(id).firstTimeUs() <= firstUs.get(id));
        });
    }

    @Test
    public void presetMustBeDefaultAndLookAheadInItsRange() {
        assertEquals("preset must be default where there is a look-ahead but was paper",
            assertThrows(IllegalArgumentException.class,
                () -> new SmoothedSofas(SENSOR, SofasParameters.paper(), LOOK_AHEAD_US)).getMessage());
        assertEquals("lookAheadUs must be 4000 to 10000000 but was 3999", assertThrows(IllegalArgumentException.class,
            () -> new SmoothedSofas(SENSOR, SofasParameters.defaults(), 3999)).getMessage());
        assertEquals("lookAheadUs must be 4000 to 10000000 but was 10000001",
            assertThrows(IllegalArgumentException.class,
                () -> new SmoothedSofas(SENSOR, SofasParameters.defaults(), 10_000_001)).getMessage());
    }
}
