package io.github.sofas.flow.paper;

import static org.junit.Assert.assertEquals;
import static org.junit.Assert.assertTrue;

import io.github.sofas.event.EventBatch;
import io.github.sofas.event.SensorSize;
import io.github.sofas.flow.FlowOutput;
import io.github.sofas.flow.PlainPlane.Event;
import io.github.sofas.flow.Segment;
import io.github.sofas.flow.Sofas;
import io.github.sofas.flow.SofasParameters;
import io.github.sofas.flow.Streams;
import io.github.sofas.simulate.Scene;
import java.util.ArrayList;
import java.util.List;
import org.junit.Test;

/** The fast planes of the paper preset against the plain ones: equal after every event. */
public class AgreesWithPlainTest {
    private static final SensorSize TINY = new SensorSize(32, 24);
    private static final SensorSize SMALL = new SensorSize(128, 128);
    /** Few enough events for the plain planes, whose time grows with the square of the window. */
    private static final SofasParameters PRESET = SofasParameters.paper().with("constantEvents", 40)
        .with("minEvents", 12).with("lifespanUs", 100_000);
    private static final Numbers SHORT = Numbers.of(PRESET);

    private static List<List<Event>> streams() {
        List<List<Event>> all = new ArrayList<>();
        all.add(Streams.edge(2, 25, 24, 1000, 8_000));
        all.add(Streams.edge(29, 25, 24, 1000, -3_000));
        all.add(Streams.filmed(Scene.HEXAGON, TINY, 0.2, 30, 1500));
        all.add(Streams.later(Streams.filmed(Scene.SMALL_CIRCLE, TINY, 0.8, 200, 1000), -7_000_000_000_000L));
        all.add(Streams.chance(1, TINY, 1200, 0, 600));
        all.add(Streams.chance(2, TINY, 1200, 4_000_000_000_000_000L, 150));
        all.add(Streams.chance(3, TINY, 1200, -5_000_000_000L, 2_000));
        return all;
    }

    @Test
    public void everyMetricIsTheSumOfSquaresAfterEveryEvent() {
        Numbers p = Changed.of(SHORT, "flowProjections", 5);
        for (List<Event> events : streams()) {
            FlowPlane fast = new FlowPlane(TINY.width(), TINY.height(), p);
            PlainFlowPlane plain = new PlainFlowPlane(p);
            for (int e = 0; e < events.size(); e++) {
                addAndCompare(fast, plain, events.get(e), p, "event " + e);
            }
        }
    }

    @Test
    public void everyMetricIsTheSumOfSquaresOnALargerSensorWithAllProjections() {
        List<Event> events = Streams.filmed(Scene.LARGE_CIRCLE, SMALL, 0.3, -70, 1200);
        FlowPlane fast = new FlowPlane(SMALL.width(), SMALL.height(), SHORT);
        PlainFlowPlane plain = new PlainFlowPlane(SHORT);
        int found = 0;
        for (int e = 0; e < events.size(); e++) {
            found += addAndCompare(fast, plain, events.get(e), SHORT, "event " + e) ? 1 : 0;
        }
        assertTrue("found " + found, found >= 2);
    }

    private static boolean addAndCompare(FlowPlane fast, PlainFlowPlane plain, Event e, Numbers p,
                                         String at) {
        boolean found = plain.add(e);
        assertEquals(at, found, fast.add(e.x(), e.y(), e.timeUs(), e.polarity()));
        assertEquals(at, plain.events.size(), fast.size());
        for (int j = 0; j < p.flowProjections(); j++) {
            for (int i = 0; i < p.flowProjections(); i++) {
                assertEquals(at + " metric " + i + " " + j, plain.metric(i, j), fast.metric(i, j));
            }
        }
        if (found) {
            assertEquals(at, plain.angleX, fast.structure().angleX(), 0);
            assertEquals(at, plain.angleY, fast.structure().angleY(), 0);
            assertEquals(at, plain.members, members(fast.structure()));
            fast.release();
            plain.release();
        }
        return found;
    }

    @Test
    public void eventsThatWaitForOthersFindTheSameStructures() {
        // nobody asks for a metric between two structures, so that events wait for as long as they may
        int found = 0;
        for (Numbers p : List.of(SHORT, Changed.of(SHORT, "flowProjections", 4),
                Changed.of(SHORT, "flowProjections", 7, "constantEvents", 3))) {
            for (List<Event> events : streams()) {
                FlowPlane fast = new FlowPlane(TINY.width(), TINY.height(), p);
                PlainFlowPlane plain = new PlainFlowPlane(p);
                for (Event e : events) {
                    boolean expected = plain.add(e);
                    assertEquals(expected, fast.add(e.x(), e.y(), e.timeUs(), e.polarity()));
                    if (expected) {
                        found++;
                        assertEquals(plain.angleX, fast.structure().angleX(), 0);
                        assertEquals(plain.angleY, fast.structure().angleY(), 0);
                        assertEquals(plain.members, members(fast.structure()));
                        fast.release();
                        plain.release();
                    }
                }
            }
        }
        assertTrue("found " + found, found >= 30);
    }

    private static List<Event> members(Refinement structure) {
        List<Event> members = new ArrayList<>();
        for (int i = 0; i < structure.loaded(); i++) {
            if (structure.contains(i)) {
                members.add(new Event(structure.x(i), structure.y(i), structure.timeUs(i), structure.polarity(i)));
            }
        }
        return members;
    }

    @Test
    public void greatestProjectionIsTheSameAfterEveryEvent() {
        // A projection is read out at every event, and no structure is ever large enough to be taken out.
        Numbers p = Changed.of(SHORT, "flowProjections", 7, "constantEvents", 1, "cycles", 1, "minEvents", 100_000);
        for (List<Event> events : streams()) {
            FlowPlane fast = new FlowPlane(TINY.width(), TINY.height(), p);
            PlainFlowPlane plain = new PlainFlowPlane(p);
            for (Event e : events.subList(0, 400)) {
                plain.add(e);
                fast.add(e.x(), e.y(), e.timeUs(), e.polarity());
                assertEquals(Angles.at(plain.best % 7, 7, 180), fast.structure().angleX(), 0);
                assertEquals(Angles.at(plain.best / 7, 7, 180), fast.structure().angleY(), 0);
            }
        }
    }

    @Test
    public void trackPlaneDecidesTheSameForEveryEvent() {
        Numbers p = Changed.of(SHORT, "flowProjections", 5);
        int tracked = 0;
        for (List<Event> events : streams()) {
            tracked += trackAndCompare(events, TINY, p);
            tracked += trackAndCompare(events, TINY, Changed.of(p, "hitShare", 0.6, "contourThreshold", 1));
        }
        assertTrue("belonging events " + tracked, tracked > 1500);
    }

    /** Tracks the first structure of a stream through the rest of it. */
    private static int trackAndCompare(List<Event> events, SensorSize sensor, Numbers p) {
        FlowPlane flowPlane = new FlowPlane(sensor.width(), sensor.height(), p);
        TrackPlane fast = new TrackPlane(sensor.width(), sensor.height(), p);
        PlainTrackPlane plain = null;
        int belonging = 0;
        for (int i = 0; i < events.size(); i++) {
            Event e = events.get(i);
            if (plain == null) {
                if (flowPlane.add(e.x(), e.y(), e.timeUs(), e.polarity())) {
                    Refinement found = flowPlane.structure();
                    fast.start(1, found);
                    plain = new PlainTrackPlane(p, 1, members(found), found.angleX(), found.angleY());
                    compare("start", plain, fast);
                }
            } else {
                boolean belongs = plain.offer(e);
                assertEquals("event " + i, belongs, fast.offer(e.x(), e.y(), e.timeUs()));
                belonging += belongs ? 1 : 0;
                compare("event " + i, plain, fast);
                if (i % 50 == 0) {
                    assertEquals("event " + i, plain.isStarved(e.timeUs()), fast.isStarved(e.timeUs()));
                }
            }
        }
        assertTrue("a structure was found", plain != null);
        return belonging;
    }

    private static void compare(String at, PlainTrackPlane plain, TrackPlane fast) {
        assertEquals(at, plain.live.size(), fast.live());
        assertEquals(at, (float) plain.vxPxPerS, fast.vxPxPerS, 0);
        assertEquals(at, (float) plain.vyPxPerS, fast.vyPxPerS, 0);
        assertEquals(at, plain.events, fast.events);
        assertEquals(at, List.of(plain.minX, plain.minY, plain.maxX, plain.maxY),
            List.of(fast.minX, fast.minY, fast.maxX, fast.maxY));
        for (int k = 0; k < 9; k++) {
            assertEquals(at + " cells of projection " + k, plain.cells(k % 3, k / 3), fast.cells(k % 3, k / 3));
        }
    }

    @Test
    public void everyEventGetsTheSameSegmentAndVelocity() {
        SofasParameters p = PRESET.with("flowProjections", 5);
        int labelled = 0;
        for (List<Event> events : streams()) {
            labelled += labelAndCompare(events, TINY, p);
            labelled += labelAndCompare(events, TINY, p.with("maxTrackPlanes", 2).with("minShare", 0.6));
        }
        assertTrue("labelled " + labelled, labelled > 4000);
    }

    @Test
    public void everyEventGetsTheSameSegmentAndVelocityInThePresetItself() {
        SofasParameters p = SofasParameters.paper().with("constantEvents", 100);
        List<Event> film = Streams.filmed(Scene.TWO_OPPOSITE, SMALL, 0.35, 20, 2500);
        int labelled = labelAndCompare(film, SMALL, p);
        assertTrue("labelled " + labelled, labelled > 1000);
    }

    private static int labelAndCompare(List<Event> events, SensorSize sensor, SofasParameters p) {
        List<Segment> ended = new ArrayList<>();
        Sofas fast = new Sofas(sensor, p, ended::add);
        PlainMethod plain = new PlainMethod(Numbers.of(p));
        EventBatch one = new EventBatch(1);
        FlowOutput output = new FlowOutput(1);
        int labelled = 0;
        for (int i = 0; i < events.size(); i++) {
            Event e = events.get(i);
            one.clear();
            one.add(e.timeUs(), e.x(), e.y(), e.polarity());
            fast.process(one, output);
            assertEquals("event " + i, plain.label(e),
                new PlainMethod.Labelled(output.segment[0], output.vxPxPerS[0], output.vyPxPerS[0]));
            assertEquals("event " + i, plain.ended, ended);
            assertEquals("event " + i, plain.segments(), fast.segments());
            labelled += output.segment[0] > 0 ? 1 : 0;
        }
        return labelled;
    }
}
