package io.github.sofas.flow;

import static org.junit.Assert.assertArrayEquals;
import static org.junit.Assert.assertEquals;
import static org.junit.Assert.assertNull;
import static org.junit.Assert.assertTrue;

import io.github.sofas.event.EventBatch;
import io.github.sofas.event.SensorSize;
import io.github.sofas.flow.PlainPlane.Event;
import io.github.sofas.simulate.Scene;
import io.github.sofas.simulate.SimulatedRecording;
import io.github.sofas.simulate.SimulationOptions;
import java.util.ArrayList;
import java.util.Arrays;
import java.util.List;
import java.util.Random;
import java.util.concurrent.Callable;
import java.util.concurrent.ExecutorService;
import java.util.concurrent.Executors;
import java.util.concurrent.Future;
import java.util.concurrent.atomic.AtomicLong;
import java.util.concurrent.atomic.AtomicReference;
import java.util.function.Consumer;
import org.junit.Test;

/** Several threads at one engine, and engines side by side. */
public class ConcurrencyTest {
    private static final SensorSize SENSOR = new SensorSize(128, 128);
    private static final List<Event> FILM = Streams.filmed(Scene.TWO_OPPOSITE, SENSOR, 0.5, 20, 12_000);
    private static final int BATCH = 250;
    private static final int FILMS = 4;

    /** What an engine said of the whole film. */
    private static final class Labels {
        final int[] segment;
        final float[] vxPxPerS;
        final float[] vyPxPerS;
        List<Segment> segments;

        Labels(int events) {
            segment = new int[events];
            vxPxPerS = new float[events];
            vyPxPerS = new float[events];
        }

        void assertSame(Labels other) {
            assertArrayEquals(segment, other.segment);
            assertArrayEquals(vxPxPerS, other.vxPxPerS, 0);
            assertArrayEquals(vyPxPerS, other.vyPxPerS, 0);
            assertEquals(segments, other.segments);
        }
    }

    private static Labels label(Sofas sofas) {
        return label(sofas, FILM);
    }

    private static Labels label(Sofas sofas, List<Event> film) {
        int n = film.size();
        Labels labels = new Labels(n);
        FlowOutput output = new FlowOutput(BATCH);
        for (int i = 0; i < n; i += BATCH) {
            EventBatch batch = Streams.batch(film.subList(i, Math.min(n, i + BATCH)));
            sofas.process(batch, output);
            System.arraycopy(output.segment, 0, labels.segment, i, batch.size());
            System.arraycopy(output.vxPxPerS, 0, labels.vxPxPerS, i, batch.size());
            System.arraycopy(output.vyPxPerS, 0, labels.vyPxPerS, i, batch.size());
        }
        labels.segments = sofas.segments();
        return labels;
    }

    /** Whatever another thread may ask of an engine, one at random. */
    private static void disturb(Sofas sofas, Random random, SofasParameters base) {
        switch (random.nextInt(5)) {
            case 0:
                SofasParameters p = random.nextInt(8) > 0 ? base : base.preset() == SofasParameters.Preset.PAPER
                    ? SofasParameters.defaults() : SofasParameters.paper();
                sofas.setParameters(p.with("flowProjections", 5 + random.nextInt(5))
                    .with("lifetimePx", 1 + random.nextInt(5)).with("maxTrackPlanes", 1 + random.nextInt(64))
                    .with("lifespanUs", 100_000 + random.nextInt(900_000)));
                break;
            case 1:
                if (random.nextInt(4) == 0) {
                    sofas.reset();
                }
                break;
            case 2:
                MetricArray array = sofas.metricArray();
                for (int i = 0; i < array.n() * array.n(); i++) {
                    float perEvent = array.perEvent(i / array.n(), i % array.n());
                    assertTrue("metric " + perEvent, perEvent >= 0 && Float.isFinite(perEvent));
                }
                break;
            case 3:
                sofas.contour(1 + random.nextInt(3), (x, y) -> assertTrue(x + " " + y, SENSOR.contains(x, y)));
                break;
            default:
                sofas.segments().forEach(segment -> HostileEventsTest.check("asked meanwhile", segment, SENSOR));
                // each film begins before the end of the one before
                assertTrue(sofas.eventsOutside() == 0 && sofas.eventsBackwards() <= FILMS * FILM.size());
                break;
        }
    }

    @Test
    public void noCallOfAnotherThreadTearsAnEngine() throws Exception {
        for (SofasParameters base : List.of(SofasParameters.defaults(), SofasParameters.paper())) {
            AtomicLong eventsOfEnded = new AtomicLong();
            // the events of a merged one count among those of the other
            Sofas sofas = new Sofas(SENSOR, base, segment ->
                eventsOfEnded.addAndGet(segment.fate() == Segment.Fate.REMOVED ? segment.events() : 0));
            ExecutorService helper = Executors.newSingleThreadExecutor();
            sofas.helpedBy(helper::execute);
            AtomicReference<Throwable> thrown = new AtomicReference<>();
            long[] labelled = new long[1];
            Thread labeller = new Thread(() -> {
                for (int film = 0; film < FILMS; film++) {
                    labelled[0] += Arrays.stream(label(sofas).segment).filter(id -> id > 0).count();
                }
            });
            labeller.setUncaughtExceptionHandler((thread, e) -> thrown.set(e));
            labeller.start();
            Random random = new Random(5);
            while (labeller.isAlive()) {
                disturb(sofas, random, base);
            }
            assertNull(thrown.get());
            sofas.reset();
            // each labelled event was counted by one segment, however it ended
            assertEquals(labelled[0], eventsOfEnded.get());
            sofas.setParameters(base);
            label(new Sofas(SENSOR, base)).assertSame(label(sofas));
            helper.shutdownNow();
        }
    }

    /** A wall that gives a million events a second, so that there is work worth a helper's while. */
    private static List<Event> wall() {
        SimulatedRecording wall = SimulatedRecording.of(Scene.TEXTURED_PAN, SimulationOptions.defaults()
            .withSensor(SENSOR).withSpeedPxPerS(400).withDurationUs(40_000));
        List<Event> events = new ArrayList<>();
        for (int i = 0; i < wall.size(); i++) {
            events.add(new Event(wall.x[i], wall.y[i], wall.timeUs[i], wall.polarity[i]));
        }
        return events;
    }

    @Test
    public void helperMakesNoDifference() throws Exception {
        List<Event> film = wall();
        Labels alone = label(new Sofas(SENSOR, SofasParameters.defaults()), film);
        assertTrue("found", alone.segments.size() > 0);
        ExecutorService one = Executors.newSingleThreadExecutor();
        ExecutorService several = Executors.newFixedThreadPool(3);
        Random random = new Random(2);
        int[] asked = new int[1];
        try {
            for (Consumer<Runnable> helper : List.<Consumer<Runnable>>of(
                    one::execute,
                    several::execute,
                    // never, at once, or sometimes
                    work -> asked[0]++,
                    Runnable::run,
                    work -> {
                        if (random.nextBoolean()) {
                            one.execute(work);
                        }
                    })) {
                Sofas helped = new Sofas(SENSOR, SofasParameters.defaults());
                helped.helpedBy(helper);
                alone.assertSame(label(helped, film));
                helped.reset();
                alone.assertSame(label(helped, film));
            }
        } finally {
            one.shutdownNow();
            several.shutdownNow();
        }
        assertTrue("asked for help " + asked[0] + " times", asked[0] > 20);
    }

    @Test
    public void enginesSideBySideShareNothing() throws Exception {
        for (SofasParameters p : List.of(SofasParameters.defaults(), SofasParameters.paper())) {
            Labels alone = label(new Sofas(SENSOR, p));
            ExecutorService pool = Executors.newFixedThreadPool(4);
            try {
                List<Callable<Labels>> tasks = new ArrayList<>();
                for (int i = 0; i < 8; i++) {
                    tasks.add(() -> label(new Sofas(SENSOR, p)));
                }
                for (Future<Labels> other : pool.invokeAll(tasks)) {
                    alone.assertSame(other.get());
                }
            } finally {
                pool.shutdownNow();
            }
        }
    }
}
