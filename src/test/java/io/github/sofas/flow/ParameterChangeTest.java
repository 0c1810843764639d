package io.github.sofas.flow;

import static org.junit.Assert.assertEquals;
import static org.junit.Assert.assertNotEquals;
import static org.junit.Assert.assertNull;
import static org.junit.Assert.assertSame;
import static org.junit.Assert.assertThrows;
import static org.junit.Assert.assertTrue;

import io.github.sofas.event.EventBatch;
import io.github.sofas.event.SensorSize;
import io.github.sofas.flow.PlainPlane.Event;
import io.github.sofas.simulate.Scene;
import java.util.ArrayList;
import java.util.Arrays;
import java.util.List;
import java.util.Random;
import java.util.concurrent.atomic.AtomicReference;
import org.junit.Test;

/** Parameters that change while structures are tracked. */
public class ParameterChangeTest {
    private static final SensorSize SENSOR = new SensorSize(128, 128);
    private static final List<Event> FILM = Streams.filmed(Scene.TWO_OPPOSITE, SENSOR, 0.5, 20, 12_000);
    private static final int BATCH = 500;

    private final List<Segment> ended = new ArrayList<>();
    private final FlowOutput output = new FlowOutput(BATCH);

    private Sofas tracking(SofasParameters p) {
        Sofas sofas = new Sofas(SENSOR, p, ended::add);
        show(sofas, 0, FILM.size() / 2);
        assertTrue(p.preset() + " tracks", !sofas.segments().isEmpty());
        ended.clear();
        return sofas;
    }

    private void show(Sofas sofas, int from, int to) {
        for (int i = from; i < to; i += BATCH) {
            sofas.process(Streams.batch(FILM.subList(i, Math.min(to, i + BATCH))), output);
        }
    }

    private static List<Integer> ids(Sofas sofas) {
        return sofas.segments().stream().map(Segment::id).sorted().toList();
    }

    @Test
    public void sameValuesChangeNothing() {
        for (SofasParameters p : List.of(SofasParameters.paper(), SofasParameters.defaults())) {
            Sofas sofas = new Sofas(SENSOR, p);
            Sofas other = new Sofas(SENSOR, p);
            FlowOutput expected = new FlowOutput(BATCH);
            for (int i = 0; i + BATCH <= FILM.size(); i += BATCH) {
                EventBatch batch = Streams.batch(FILM.subList(i, i + BATCH));
                // a copy that is equal but not the same
                other.setParameters(p.with("minEvents", p.search().minEvents()));
                sofas.process(batch, expected);
                other.process(batch, output);
                assertEquals(Arrays.toString(expected.segment), Arrays.toString(output.segment));
                assertEquals(Arrays.toString(expected.vxPxPerS), Arrays.toString(output.vxPxPerS));
            }
        }
    }

    @Test
    public void segmentsAreTrackedOnUnderTheirIds() {
        SofasParameters p = SofasParameters.defaults();
        for (SofasParameters next : List.of(p.with("minShare", 0.25), p.with("maxLifetimePx", 12),
                p.with("flowProjections", 9), p.with("fastestPxPerS", 900), p.with("lifespanUs", 1_000_000),
                p.with("maxTrackPlanes", 32))) {
            Sofas sofas = tracking(p);
            List<Integer> before = ids(sofas);
            sofas.setParameters(next);
            show(sofas, FILM.size() / 2, FILM.size() / 2 + BATCH);
            assertTrue(before + " in " + ids(sofas) + ", ended " + ended, ids(sofas).containsAll(before));
            assertSame(next, sofas.parameters());
        }
    }

    @Test
    public void segmentsOfThePaperPresetAreTrackedOnUnderTheirIds() {
        SofasParameters p = SofasParameters.paper();
        for (SofasParameters next : List.of(p.with("minShare", 0.15), p.with("lifetimePx", 3.5),
                p.with("flowProjections", 7), p.with("lifespanUs", 150_000), p.with("constantEvents", 200))) {
            Sofas sofas = tracking(p);
            List<Integer> before = ids(sofas);
            sofas.setParameters(next);
            show(sofas, FILM.size() / 2, FILM.size() / 2 + 1);
            assertEquals(List.of(), ended);
            assertEquals(before, ids(sofas));
        }
    }

    @Test
    public void changeTakesEffectWithTheNextBatch() {
        Sofas sofas = tracking(SofasParameters.defaults());
        assertTrue("segments " + ids(sofas), ids(sofas).size() > 1);
        sofas.setParameters(SofasParameters.defaults().with("maxTrackPlanes", 1));
        assertEquals(List.of(), ended);
        sofas.process(Streams.batch(List.of()), output);
        assertEquals(1, sofas.segments().size());
        assertEquals(Segment.Fate.REMOVED, ended.get(0).fate());
    }

    @Test
    public void scaleOfThePaperEndsItsSegmentsAndUsesNoIdTwice() {
        Sofas sofas = tracking(SofasParameters.paper());
        List<Integer> before = ids(sofas);
        sofas.setParameters(SofasParameters.paper().with("velocityScalePxPerS", 120));
        show(sofas, FILM.size() / 2, FILM.size());
        assertTrue(ended.stream().map(Segment::id).toList().containsAll(before));
        assertTrue("found anew", !sofas.segments().isEmpty());
        assertTrue(ids(sofas).stream().noneMatch(before::contains));
    }

    @Test
    public void otherPresetBeginsAnew() {
        for (SofasParameters p : List.of(SofasParameters.paper(), SofasParameters.defaults())) {
            SofasParameters other = p.preset() == SofasParameters.Preset.PAPER ? SofasParameters.defaults()
                : SofasParameters.paper();
            Sofas sofas = tracking(p);
            int living = sofas.segments().size();
            sofas.setParameters(other);
            Sofas fresh = new Sofas(SENSOR, other);
            FlowOutput expected = new FlowOutput(BATCH);
            for (int i = 0; i + BATCH <= FILM.size(); i += BATCH) {
                EventBatch batch = Streams.batch(FILM.subList(i, i + BATCH));
                sofas.process(batch, output);
                fresh.process(batch, expected);
                assertEquals(Arrays.toString(expected.segment), Arrays.toString(output.segment));
            }
            assertTrue(ended.size() >= living);
            ended.clear();
        }
    }

    @Test
    public void refusesNone() {
        Sofas sofas = new Sofas(SENSOR, SofasParameters.defaults());
        assertEquals("parameters",
            assertThrows(NullPointerException.class, () -> sofas.setParameters(null)).getMessage());
    }

    @Test
    public void anotherThreadMayChangeThemAtAnyTime() throws InterruptedException {
        Sofas sofas = new Sofas(SENSOR, SofasParameters.defaults(), ended::add);
        AtomicReference<Throwable> thrown = new AtomicReference<>();
        Thread labeller = new Thread(() -> {
            for (int i = 0; i < 4; i++) {
                show(sofas, 0, FILM.size());
                sofas.reset();
            }
        });
        labeller.setUncaughtExceptionHandler((thread, e) -> thrown.set(e));
        labeller.start();
        Random random = new Random(4);
        while (labeller.isAlive()) {
            SofasParameters p = random.nextInt(20) == 0 ? SofasParameters.paper() : SofasParameters.defaults();
            sofas.setParameters(p.with("flowProjections", 5 + random.nextInt(9))
                .with("lifetimePx", 1 + random.nextInt(5)).with("memoryPx", 100 * random.nextDouble())
                .with("maxTrackPlanes", 1 + random.nextInt(64)).with("lifespanUs", 100_000 + random.nextInt(900_000)));
            Thread.sleep(1);
        }
        assertNull(thrown.get());
    }

    @Test
    public void metricArrayIsGreatestAtTheVelocityThatWaitingEventsHave() {
        // an edge that moves a column in 10 ms, 100 px/s to the right, which is 45 degrees of the paper's scale
        Sofas sofas = new Sofas(SENSOR, SofasParameters.paper().with("constantEvents", 100_000));
        sofas.process(Streams.batch(Streams.edge(20, 12, 40, 0, 10_000)), new FlowOutput(480));
        MetricArray array = sofas.metricArray();
        assertEquals(SofasParameters.Preset.PAPER, array.preset());
        assertEquals(9, array.n());
        // 9 angles over 180 degrees: -80, -60, ... 80; 40 is column 6, 60 is 7; along the edge nothing is known
        int best = 0;
        for (int column = 0; column < 9; column++) {
            best = array.perEvent(4, column) > array.perEvent(4, best) ? column : best;
        }
        assertEquals(6, best);
        assertNotEquals(0, array.perEvent(4, 0), 0);
    }

    @Test
    public void metricArrayOfAnEmptyPlaneIsZero() {
        for (SofasParameters p : List.of(SofasParameters.paper(), SofasParameters.defaults())) {
            MetricArray array = new Sofas(SENSOR, p).metricArray();
            assertEquals(p.preset(), array.preset());
            assertEquals(p.search().flowProjections(), array.n());
            assertEquals(0, array.perEvent(array.n() - 1, array.n() - 1), 0);
        }
    }
}
