package io.github.sofas.flow;

import static org.junit.Assert.assertArrayEquals;
import static org.junit.Assert.assertEquals;
import static org.junit.Assert.assertThrows;
import static org.junit.Assert.assertTrue;
import static org.junit.Assert.fail;

import io.github.sofas.event.EventBatch;
import io.github.sofas.event.SensorSize;
import io.github.sofas.flow.PlainPlane.Event;
import io.github.sofas.simulate.Scene;
import java.util.ArrayList;
import java.util.Arrays;
import java.util.HashSet;
import java.util.List;
import java.util.Set;
import org.junit.Test;

/** What a caller may rely on, whichever preset. */
public class SofasTest {
    private static final SensorSize SENSOR = new SensorSize(128, 128);
    private static final List<SofasParameters> PRESETS = List.of(SofasParameters.paper(), SofasParameters.defaults());
    private static final List<Event> FILM = Streams.filmed(Scene.TWO_OPPOSITE, SENSOR, 0.5, 20, 12_000);

    /** All that an engine says of a stream. */
    private record Result(List<Integer> segment, List<Float> vx, List<Float> vy, List<Segment> ended,
                          List<Segment> living) {
    }

    private static Result run(Sofas sofas, List<Segment> ended, List<Event> events, int batchSize) {
        ended.clear();
        List<Integer> segment = new ArrayList<>();
        List<Float> vx = new ArrayList<>();
        List<Float> vy = new ArrayList<>();
        FlowOutput output = new FlowOutput(batchSize);
        for (int i = 0; i < events.size(); i += batchSize) {
            EventBatch batch = Streams.batch(events.subList(i, Math.min(events.size(), i + batchSize)));
            sofas.process(batch, output);
            for (int k = 0; k < batch.size(); k++) {
                segment.add(output.segment[k]);
                vx.add(output.vxPxPerS[k]);
                vy.add(output.vyPxPerS[k]);
            }
        }
        return new Result(segment, vx, vy, List.copyOf(ended), sofas.segments());
    }

    private static Result runAnew(SofasParameters p, List<Event> events, int batchSize) {
        List<Segment> ended = new ArrayList<>();
        return run(new Sofas(SENSOR, p, ended::add), ended, events, batchSize);
    }

    @Test
    public void filmHasEventsWithAndWithoutFlow() {
        for (SofasParameters p : PRESETS) {
            Result result = runAnew(p, FILM, 4096);
            long with = result.segment.stream().filter(id -> id > 0).count();
            assertTrue(p.preset() + " " + with, with > FILM.size() / 4 && with < FILM.size());
        }
    }

    @Test
    public void resultsDoNotDependOnTheCutIntoBatches() {
        for (SofasParameters p : PRESETS) {
            Result whole = runAnew(p, FILM, FILM.size());
            for (int size : new int[] {1, 7, 4096}) {
                assertEquals(p.preset() + " in batches of " + size, whole, runAnew(p, FILM, size));
            }
        }
    }

    @Test
    public void engineAfterResetIsAsIfMadeAnew() {
        List<Event> other = Streams.later(Streams.filmed(Scene.HEXAGON, SENSOR, 0.5, -60, 6_000), 9_000_000_000L);
        for (SofasParameters p : PRESETS) {
            List<Segment> ended = new ArrayList<>();
            Sofas sofas = new Sofas(SENSOR, p, ended::add);
            run(sofas, ended, other, 500);
            sofas.process(Streams.batch(List.of(new Event(200, 0, 0, 1), new Event(0, 0, 0, 1))), new FlowOutput(2));
            sofas.reset();
            assertEquals(List.of(), sofas.segments());
            assertEquals(0, sofas.eventsOutside());
            assertEquals(0, sofas.eventsBackwards());
            assertEquals(p.preset().toString(), runAnew(p, FILM, 100), run(sofas, ended, FILM, 100));
        }
    }

    @Test
    public void livingSegmentsEndAsRemovedAtReset() {
        for (SofasParameters p : PRESETS) {
            List<Segment> ended = new ArrayList<>();
            Sofas sofas = new Sofas(SENSOR, p, ended::add);
            List<Segment> living = run(sofas, ended, FILM.subList(0, 9_000), 500).living;
            assertTrue(p.preset() + " lives", living.size() > 0);
            ended.clear();
            sofas.reset();
            Set<Integer> ids = new HashSet<>();
            for (Segment segment : ended) {
                assertEquals(Segment.Fate.REMOVED, segment.fate());
                assertEquals(0, segment.mergedInto());
                ids.add(segment.id());
            }
            Set<Integer> expected = new HashSet<>();
            living.forEach(segment -> expected.add(segment.id()));
            assertEquals(expected, ids);
        }
    }

    @Test
    public void enginesDoNotKnowOfEachOther() throws InterruptedException {
        List<Event> other = Streams.filmed(Scene.HEXAGON, SENSOR, 0.5, -60, 6_000);
        for (SofasParameters p : PRESETS) {
            Result alone = runAnew(p, FILM, 100);
            Result otherAlone = runAnew(p, other, 100);
            Result[] both = new Result[2];
            Thread second = new Thread(() -> both[1] = runAnew(p, other, 100));
            second.start();
            both[0] = runAnew(p, FILM, 100);
            second.join();
            assertEquals(alone, both[0]);
            assertEquals(otherAlone, both[1]);
        }
    }

    @Test
    public void regularEdgeOfAnEventAPixelKeepsItsVelocity() {
        // all rows of a column at one moment, one column after the other: thinner than any cell that it is measured on
        for (int columnUs : new int[] {2_000, 5_000, 10_000, 20_000}) {
            double speed = 1e6 / columnUs;
            Result result = runAnew(SofasParameters.defaults(), Streams.edge(20, 50, 40, 0, columnUs), 100);
            Set<Integer> segments = new HashSet<>();
            for (int i = 25 * 40; i < result.vx.size(); i++) {
                assertEquals("event " + i + " at " + speed + " px/s", speed, result.vx.get(i), 0.05 * speed);
                segments.add(result.segment.get(i));
            }
            assertEquals(Set.of(1), segments);
        }
    }

    @Test
    public void contourLiesWhereTheStructureIsNow() {
        // enters column 20 + i at 10,000 i µs: column 69 with the last event
        List<Event> edge = Streams.edge(20, 50, 40, 0, 10_000);
        Sofas sofas = new Sofas(SENSOR, SofasParameters.defaults());
        Set<Integer> rows = new HashSet<>();
        for (Segment segment : run(sofas, new ArrayList<>(), edge, 100).living) {
            sofas.contour(segment.id(), (x, y) -> {
                assertEquals(69, x, 1);
                assertTrue("row " + y, y >= 0 && y < 41);
                rows.add(y);
            });
        }
        assertTrue("rows " + rows.size(), rows.size() >= 38);
    }

    @Test
    public void contourLiesInTheBoxOfItsSegment() {
        for (SofasParameters p : PRESETS) {
            Sofas sofas = new Sofas(SENSOR, p);
            List<Segment> living = run(sofas, new ArrayList<>(), FILM.subList(0, 9_000), 500).living;
            for (Segment segment : living) {
                List<Integer> columns = new ArrayList<>();
                sofas.contour(segment.id(), (x, y) -> {
                    String where = p.preset() + " (" + x + ", " + y + ") " + segment;
                    // a segment's box is that of its last event, a few pixels of travel ago
                    assertTrue(where, x >= segment.minX() - 3 && x <= segment.maxX() + 3);
                    assertTrue(where, y >= segment.minY() - 3 && y <= segment.maxY() + 3);
                    columns.add(x);
                });
                assertTrue(p.preset() + " " + segment, columns.size() > 20);
            }
        }
    }

    @Test
    public void lookingAtContoursChangesNothing() {
        for (SofasParameters p : PRESETS) {
            List<Segment> ended = new ArrayList<>();
            Sofas looked = new Sofas(SENSOR, p, ended::add);
            FlowOutput output = new FlowOutput(100);
            List<Integer> segment = new ArrayList<>();
            for (int i = 0; i < FILM.size(); i += 100) {
                looked.process(Streams.batch(FILM.subList(i, i + 100)), output);
                for (int k = 0; k < 100; k++) {
                    segment.add(output.segment[k]);
                }
                looked.segments().forEach(each -> looked.contour(each.id(), (x, y) ->
                    assertTrue(SENSOR.contains(x, y))));
            }
            Result unseen = runAnew(p, FILM, 100);
            assertEquals(unseen.segment, segment);
            assertEquals(unseen.living, looked.segments());
        }
    }

    @Test
    public void onlyLivingSegmentsHaveContours() {
        for (SofasParameters p : PRESETS) {
            Sofas sofas = new Sofas(SENSOR, p);
            run(sofas, new ArrayList<>(), FILM, 100);
            sofas.contour(0, (x, y) -> fail("no segment has id 0"));
            sofas.contour(1_000_000, (x, y) -> fail("no segment has this id"));
            int living = sofas.segments().get(0).id();
            sofas.reset();
            sofas.contour(living, (x, y) -> fail("no segment lives after a reset"));
        }
    }

    @Test
    public void segmentsAreNumberedFromOneWithoutRepeating() {
        for (SofasParameters p : PRESETS) {
            Result result = runAnew(p, FILM, 100);
            List<Integer> ids = new ArrayList<>();
            result.ended.forEach(segment -> ids.add(segment.id()));
            result.living.forEach(segment -> ids.add(segment.id()));
            ids.sort(null);
            for (int i = 0; i < ids.size(); i++) {
                assertEquals(p.preset().toString(), i + 1, (int) ids.get(i));
            }
            assertTrue(new HashSet<>(ids).containsAll(result.segment.stream().filter(id -> id > 0).toList()));
        }
    }

    @Test
    public void segmentsCountTheEventsThatGotTheirNumber() {
        for (SofasParameters p : PRESETS) {
            Result result = runAnew(p, FILM, 100);
            long counted = 0;
            for (Segment segment : result.living) {
                counted += segment.events();
            }
            for (Segment segment : result.ended) {
                // a merged one's are counted by the one that took it over
                counted += segment.fate() == Segment.Fate.MERGED ? 0 : segment.events();
            }
            assertEquals(p.preset().toString(), result.segment.stream().filter(id -> id > 0).count(), counted);
        }
    }

    @Test
    public void boxesLieOnTheSensor() {
        for (SofasParameters p : PRESETS) {
            Result result = runAnew(p, FILM, 100);
            List<Segment> all = new ArrayList<>(result.ended);
            all.addAll(result.living);
            for (Segment s : all) {
                assertTrue(s.toString(), 0 <= s.minX() && s.minX() <= s.maxX() && s.maxX() < SENSOR.width());
                assertTrue(s.toString(), 0 <= s.minY() && s.minY() <= s.maxY() && s.maxY() < SENSOR.height());
                assertTrue(s.toString(), s.firstTimeUs() <= s.lastTimeUs());
            }
        }
    }

    @Test
    public void velocitiesAndBoxesStayFiniteInAnyStream() {
        // where ON and OFF cancel, where nothing moves, where all is over for seconds
        SensorSize tiny = new SensorSize(32, 24);
        for (SofasParameters p : PRESETS) {
            for (int seed = 0; seed < 40; seed++) {
                List<Event> events = Streams.chance(seed, tiny, 4000, 0, 600);
                List<Segment> all = new ArrayList<>();
                Sofas sofas = new Sofas(tiny, p, all::add);
                FlowOutput output = new FlowOutput(50);
                for (int i = 0; i < events.size(); i += 50) {
                    sofas.process(Streams.batch(events.subList(i, i + 50)), output);
                    for (int k = 0; k < 50; k++) {
                        assertTrue(p.preset() + " " + seed, Float.isFinite(output.vxPxPerS[k] + output.vyPxPerS[k]));
                    }
                    all.addAll(sofas.segments());
                }
                for (Segment s : all) {
                    assertTrue(seed + " " + s, Float.isFinite(s.vxPxPerS() + s.vyPxPerS()));
                    assertTrue(seed + " " + s, 0 <= s.minX() && s.minX() <= s.maxX() && s.maxX() < 32);
                    assertTrue(seed + " " + s, 0 <= s.minY() && s.minY() <= s.maxY() && s.maxY() < 24);
                }
            }
        }
    }

    @Test
    public void outputThatIsTooSmallIsRefusedBeforeAnyEvent() {
        for (SofasParameters p : PRESETS) {
            Sofas sofas = new Sofas(SENSOR, p);
            EventBatch batch = Streams.batch(List.of(new Event(500, 0, 0, 1), new Event(1, 1, 0, 1),
                new Event(1, 1, 0, 1)));
            assertEquals("output must hold 3 events but holds 2", assertThrows(IllegalArgumentException.class,
                () -> sofas.process(batch, new FlowOutput(2))).getMessage());
            assertEquals(0, sofas.eventsOutside());
            sofas.process(batch, new FlowOutput(3));
            assertEquals(1, sofas.eventsOutside());
        }
    }

    @Test
    public void emptyBatchIsNothing() {
        for (SofasParameters p : PRESETS) {
            new Sofas(SENSOR, p).process(new EventBatch(1), new FlowOutput(1));
        }
    }

    @Test
    public void eventOutsideTheSensorIsCountedAndHasNoFlow() {
        for (SofasParameters p : PRESETS) {
            // the film with events outside between, at times far ahead: they change nothing
            List<Event> with = new ArrayList<>();
            int[][] outside = {{-1, 5}, {128, 5}, {5, -1}, {5, 128}};
            for (int i = 0; i < FILM.size(); i++) {
                with.add(FILM.get(i));
                if (i % 1000 < 4) {
                    with.add(new Event(outside[i % 1000][0], outside[i % 1000][1], 900_000_000, 1));
                }
            }
            List<Segment> ended = new ArrayList<>();
            Sofas sofas = new Sofas(SENSOR, p, ended::add);
            Result result = run(sofas, ended, with, 100);
            assertEquals(with.size() - FILM.size(), sofas.eventsOutside());
            assertEquals(0, sofas.eventsBackwards());
            Result plain = runAnew(p, FILM, 100);
            int i = 0;
            for (int k = 0; k < with.size(); k++) {
                Event e = with.get(k);
                if (SENSOR.contains(e.x(), e.y())) {
                    assertEquals(plain.segment.get(i), result.segment.get(k));
                    i++;
                } else {
                    assertEquals(0, (int) result.segment.get(k));
                    assertEquals(0f, result.vx.get(k), 0);
                    assertEquals(0f, result.vy.get(k), 0);
                }
            }
            assertEquals(plain.living, result.living);
        }
    }

    @Test
    public void timeThatStepsBackIsTakenAsTheNewestAndCounted() {
        for (SofasParameters p : PRESETS) {
            List<Event> stepping = new ArrayList<>();
            List<Event> clamped = new ArrayList<>();
            int steps = 0;
            for (int i = 0; i < FILM.size(); i++) {
                Event e = FILM.get(i);
                long newest = e.timeUs();
                boolean back = i % 100 == 50 && newest > 0;
                steps += back ? 1 : 0;
                stepping.add(new Event(e.x(), e.y(), back ? newest - 1_000_000 : newest, e.polarity()));
                clamped.add(new Event(e.x(), e.y(), back ? FILM.get(i - 1).timeUs() : newest, e.polarity()));
            }
            List<Segment> ended = new ArrayList<>();
            Sofas sofas = new Sofas(SENSOR, p, ended::add);
            Result result = run(sofas, ended, stepping, 100);
            assertEquals(steps, sofas.eventsBackwards());
            assertEquals(runAnew(p, clamped, 100), result);
        }
    }

    @Test
    public void anyPolarityAboveZeroIsOnAndAnyOtherOff() {
        for (SofasParameters p : PRESETS) {
            List<Event> odd = new ArrayList<>();
            for (Event e : FILM) {
                odd.add(new Event(e.x(), e.y(), e.timeUs(), e.polarity() > 0 ? 7 : 0));
            }
            assertEquals(runAnew(p, FILM, 100), runAnew(p, odd, 100));
        }
    }

    @Test
    public void timesMayBeginAnywhere() {
        for (SofasParameters p : PRESETS) {
            Result first = runAnew(p, FILM, 100);
            for (long start : new long[] {-3_000_000_000_000L, 4_000_000_000_000_000L}) {
                Result later = runAnew(p, Streams.later(FILM, start), 100);
                assertEquals(first.segment, later.segment);
                assertEquals(first.vx, later.vx);
                assertEquals(first.vy, later.vy);
            }
        }
    }

    @Test
    public void noMoreTrackPlanesThanAllowedAreAlive() {
        List<Event> film = Streams.filmed(Scene.SIXTEEN, new SensorSize(240, 180), 1, 0, 12_000);
        for (SofasParameters preset : PRESETS) {
            Sofas sofas = new Sofas(new SensorSize(240, 180), preset.with("maxTrackPlanes", 3));
            FlowOutput output = new FlowOutput(200);
            int most = 0;
            for (int i = 0; i + 200 <= film.size(); i += 200) {
                sofas.process(Streams.batch(film.subList(i, i + 200)), output);
                most = Math.max(most, sofas.segments().size());
            }
            assertEquals(preset.preset().toString(), 3, most);
        }
    }

    @Test
    public void sixtyFourTrackPlanesAreServedAndNoMore() {
        // 96 squares of 6 x 6 px in twelve columns and eight rows, 60 px/s to the right, to the left, down and up
        SensorSize sensor = new SensorSize(480, 320);
        int[][] direction = {{1, 0}, {-1, 0}, {0, 1}, {0, -1}};
        List<Event> events = new ArrayList<>();
        for (int step = 0; step < 24; step++) {
            for (int square = 0; square < 96; square++) {
                int column = square % 12;
                int row = square / 12;
                int[] d = direction[(column + 2 * row + row / 2) % 4];
                int x = 40 * column + 17 + d[0] * (step - 12);
                int y = 40 * row + 17 + d[1] * (step - 12);
                for (int k = 0; k < 6; k++) {
                    // the side ahead turns dark, the side behind light again
                    long t = step * 16_667L + square * 170 + k;
                    events.add(new Event(d[0] == 0 ? x + k : d[0] > 0 ? x + 6 : x - 1,
                        d[1] == 0 ? y + k : d[1] > 0 ? y + 6 : y - 1, t, -1));
                    events.add(new Event(d[0] == 0 ? x + k : d[0] > 0 ? x : x + 5,
                        d[1] == 0 ? y + k : d[1] > 0 ? y : y + 5, t, 1));
                }
            }
        }
        Sofas sofas = new Sofas(sensor, SofasParameters.defaults());
        FlowOutput output = new FlowOutput(96);
        int most = 0;
        for (int i = 0; i + 96 <= events.size(); i += 96) {
            sofas.process(Streams.batch(events.subList(i, i + 96)), output);
            most = Math.max(most, sofas.segments().size());
        }
        assertEquals(64, most);
    }

    @Test
    public void smallestAndLargestSensorAreServed() {
        for (SofasParameters p : PRESETS) {
            for (SensorSize sensor : List.of(new SensorSize(1, 1), new SensorSize(1280, 720), new SensorSize(1, 720),
                new SensorSize(1280, 1))) {
                // fewer projections, so that the test's memory is modest
                Sofas sofas = new Sofas(sensor, p.with("flowProjections", 5));
                List<Event> corners = new ArrayList<>();
                for (int i = 0; i < 4000; i++) {
                    corners.add(new Event((i & 1) * (sensor.width() - 1), (i >> 1 & 1) * (sensor.height() - 1),
                        i * 100L, 1));
                }
                FlowOutput output = new FlowOutput(corners.size());
                sofas.process(Streams.batch(corners), output);
                assertEquals(0, sofas.eventsOutside());
            }
        }
    }

    @Test
    public void outputOfAnEventWithoutFlowIsOverwrittenWithZeros() {
        for (SofasParameters p : PRESETS) {
            FlowOutput output = new FlowOutput(2);
            Arrays.fill(output.segment, 9);
            Arrays.fill(output.vxPxPerS, 9);
            Arrays.fill(output.vyPxPerS, 9);
            new Sofas(SENSOR, p).process(Streams.batch(List.of(new Event(1, 1, 0, 1))), output);
            assertArrayEquals(new int[] {0, 9}, output.segment);
            assertArrayEquals(new float[] {0, 9}, output.vxPxPerS, 0);
            assertArrayEquals(new float[] {0, 9}, output.vyPxPerS, 0);
        }
    }
}
