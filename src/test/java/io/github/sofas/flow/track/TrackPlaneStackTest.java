package io.github.sofas.flow.track;

import static io.github.sofas.flow.track.TrackedEdges.COLUMNS;
import static io.github.sofas.flow.track.TrackedEdges.ROWS;
import static org.junit.Assert.assertEquals;
import static org.junit.Assert.assertFalse;
import static org.junit.Assert.assertTrue;

import io.github.sofas.flow.PixelConsumer;
import io.github.sofas.flow.Segment;
import io.github.sofas.flow.SofasParameters;
import java.util.ArrayList;
import java.util.List;
import java.util.Random;
import org.junit.Test;

/** A stack of track planes as a whole; which of them gets an event is asked in {@link CandidatesTest}. */
public class TrackPlaneStackTest {
    private final TrackedEdges edges = new TrackedEdges();

    @Test
    public void eventOnAContourGetsTheVelocityOfItsPlane() {
        edges.begin(40, 30, 100, 1);
        edges.nowUs += 10_000;
        assertEquals(1, edges.label(41, 45));
        assertEquals(100, edges.output.vxPxPerS[0], 3);
        assertEquals(0, edges.output.vyPxPerS[0], 5);
        assertEquals(1, edges.stack.segments().get(0).events());
    }

    @Test
    public void planeThatWasFoundLabelsNothingBeforeItIsAdopted() {
        TrackPlane plane = edges.stack.found().create(edges.nowUs, 100, 0);
        for (int i = 0; i < COLUMNS * ROWS; i++) {
            plane.addPast(36 + i / ROWS, 30 + i % ROWS, edges.nowUs - (4 - i / ROWS) * 10_000, 1, true);
        }
        edges.stack.found().begin(plane, edges.nowUs);
        edges.nowUs += 10_000;
        assertEquals(0, edges.label(41, 45));
        assertEquals(List.of(), edges.ids());
        // but takes what it expects
        assertTrue(edges.stack.found().takes(41, 45, edges.nowUs, 1));
        assertFalse(edges.stack.found().takes(80, 45, edges.nowUs, 1));
        edges.stack.adopt();
        assertEquals(List.of(1), edges.ids());
        assertFalse("it is the stack's", edges.stack.found().takes(41, 46, edges.nowUs, 1));
        assertEquals(1, edges.label(41, 46));
    }

    @Test
    public void placeThatIsSeenExpectsItsEventsAtOnce() {
        TrackPlane plane = edges.begin(40, 30, 100, 1);
        edges.nowUs += 10_000;
        assertEquals(0, edges.label(90, 80));
        for (int times = 0; times < 16; times++) {
            edges.stack.see(plane, 89, 80, edges.nowUs - 10_000 * times, 1, edges.nowUs);
            edges.stack.see(plane, 90, 80, edges.nowUs - 10_000 * times, 1, edges.nowUs);
        }
        assertEquals(1, edges.label(90, 80));
    }

    @Test
    public void placeMayBeSeenOfAnyPlaneAtAnyTime() {
        // the newest of more planes than boxes were kept for, none of which has labelled an event
        for (int i = 0; i < 20; i++) {
            edges.stack.see(edges.begin(20 + 5 * i, 30, 100, 1), 60, 50, edges.nowUs, 1, edges.nowUs);
        }
        TrackPlane untracked = edges.stack.found().create(edges.nowUs, 100, 0);
        edges.label(60, 50);
        edges.stack.see(untracked, 60, 50, edges.nowUs, 1, edges.nowUs);
        assertEquals(20, edges.ids().size());
    }

    @Test
    public void resetForgetsWhatWasFound() {
        TrackPlane plane = edges.stack.found().create(edges.nowUs, 100, 0);
        plane.addPast(40, 30, edges.nowUs, 1, true);
        edges.stack.found().begin(plane, edges.nowUs);
        edges.stack.reset();
        edges.stack.adopt();
        assertEquals(List.of(), edges.ids());
        edges.begin(40, 30, 100, 1);
        assertEquals(List.of(1), edges.ids());
    }

    @Test
    public void eventOnNoContourIsLeftAlone() {
        edges.begin(40, 30, 100, 1);
        assertEquals(0, edges.label(60, 45));
        assertEquals(0, edges.stack.segments().get(0).events());
    }

    /**
     * An edge of which five columns were seen, each in another sixteenth, so that its support is 10; and nine dots on
     * the tile of 8 px at (80, 32), so far apart that none supports another, that were seen twice: 4, less than 0.6 of
     * the mean.
     */
    private List<int[]> beginWithDots() {
        List<int[]> dots = new ArrayList<>();
        for (int k = 0; k < 9; k++) {
            dots.add(new int[] {80 + 3 * (k % 3), 32 + 3 * (k / 3)});
        }
        TrackPlane plane = edges.stack.found().create(edges.nowUs, 100, 0);
        for (int c = COLUMNS - 1; c >= 0; c--) {
            for (int y = 0; y < ROWS; y++) {
                plane.addPast(40 - c, 30 + y, edges.nowUs - c * 10_000, 1, true);
            }
            for (int[] dot : dots) {
                if (c == 1 || c == 2) {
                    plane.addPast(dot[0] - c, dot[1], edges.nowUs - c * 10_000, 1, true);
                }
            }
        }
        edges.stack.found().begin(plane, edges.nowUs);
        edges.stack.adopt();
        return dots;
    }

    @Test
    public void whereManyEventsHaveLittleSupportSomethingElseMayBe() {
        // of the dots the fifth is still one of few
        List<Boolean> explained = new ArrayList<>();
        for (int[] dot : beginWithDots()) {
            explained.add(edges.stack.label(dot[0], dot[1], edges.nowUs, 1, edges.output, 0));
            assertEquals("labelled all the same", 1, edges.output.segment[0]);
        }
        assertEquals(List.of(true, true, true, true, true, false, false, false, false), explained);
    }

    @Test
    public void whereManyEventsLieOnNoContourSomethingElseMayBe() {
        // rows 32 to 39 of an ON edge are one tile: OFF events there are remembered, and have no support
        edges.begin(40, 30, 100, 1);
        List<Boolean> explained = new ArrayList<>();
        for (int y = 32; y < 40; y++) {
            explained.add(edges.stack.label(40, y, edges.nowUs, -1, edges.output, 0));
            assertEquals("labelled all the same", 1, edges.output.segment[0]);
        }
        assertEquals(List.of(true, true, true, true, true, false, false, false), explained);
    }

    @Test
    public void whatTurnsBackIsNothingElseWhereItsContourWas() {
        // at 1,000 px/s² its velocity changes by 80 px/s within a trace of 8 px, more than half of it
        edges.begin(40, 30, 100, 1).motion().ax = -1_000;
        for (int y = 32; y < 40; y++) {
            assertTrue(edges.stack.label(40, y, edges.nowUs, -1, edges.output, 0));
        }
    }

    @Test
    public void resetForgetsWhereEventsHadLittleSupport() {
        for (int[] dot : beginWithDots()) {
            edges.stack.label(dot[0], dot[1], edges.nowUs, 1, edges.output, 0);
        }
        edges.stack.reset();
        int[] dot = beginWithDots().get(0);
        assertTrue(edges.stack.label(dot[0], dot[1], edges.nowUs, 1, edges.output, 0));
    }

    @Test
    public void planeThatGetsNoEventsIsRemoved() {
        edges.begin(40, 30, 100, 1);
        edges.pause();
        assertEquals(List.of(), edges.ids());
        assertEquals(1, edges.ended.size());
        assertEquals(Segment.Fate.REMOVED, edges.ended.get(0).fate());
    }

    @Test
    public void planesAreLookedAfterEachFiveMilliseconds() {
        edges.stack.check(edges.nowUs);
        edges.begin(40, 30, 100, 1);
        edges.begin(40, 62, 100, 1);
        edges.stack.check(edges.nowUs + 4_999);
        assertEquals(List.of(1, 2), edges.ids());
        edges.stack.check(edges.nowUs + 5_000);
        assertEquals(List.of(1), edges.ids());
    }

    @Test
    public void stackIsFullWithAsManyPlanesAsAreAllowed() {
        edges.stack.setParameters(SofasParameters.defaults().with("maxTrackPlanes", 2).track());
        edges.begin(20, 10, 100, 1);
        assertFalse(edges.stack.found().isFull());
        edges.begin(60, 10, -100, 1);
        assertTrue(edges.stack.found().isFull());
        edges.stack.setParameters(SofasParameters.defaults().with("maxTrackPlanes", 1).track());
        assertEquals(List.of(1), edges.ids());
        assertEquals(2, edges.ended.get(0).id());
        assertTrue(edges.stack.found().isFull());
    }

    @Test
    public void contourIsThatOfTheOneThatIsAskedFor() {
        edges.begin(40, 10, 100, 1);
        edges.begin(80, 50, -100, 1);
        List<Integer> columns = new ArrayList<>();
        edges.stack.contour(2, edges.nowUs, (x, y) -> columns.add(x));
        assertFalse(columns.isEmpty());
        columns.forEach(x -> assertEquals(80, x, 1));
        edges.stack.contour(3, edges.nowUs, (x, y) -> assertEquals("none has this id", 0, x));
    }

    @Test
    public void idsBeginAnewAfterReset() {
        edges.begin(40, 30, 100, 1);
        edges.stack.reset();
        assertEquals(List.of(), edges.ids());
        assertEquals(Segment.Fate.REMOVED, edges.ended.get(0).fate());
        assertEquals(0, edges.label(40, 45));
        edges.begin(40, 30, 100, 1);
        assertEquals(List.of(1), edges.ids());
    }

    /** Textures of 150 and of 50 dots, one above the other, that a plane holds after 100 ms and that go on for 60. */
    private final class TwoTextures {
        private final double[] x0 = new Random(3).doubles(200, 0, 20).toArray();
        private final double[] y0 = new Random(4).doubles(200, 0, 20).toArray();
        private final long beganUs = edges.nowUs;
        private final double faster;

        TwoTextures(double faster) {
            this.faster = faster;
            TrackPlane plane = edges.stack.found().create(beganUs, 100, 0);
            for (long t = -100_000; t <= 0; t += 100) {
                long us = beganUs + t;
                at(t, (x, y) -> plane.addPast(x, y, us, 1, true));
            }
            edges.stack.found().begin(plane, beganUs);
            edges.stack.adopt();
        }

        /** Those pixels that dots come to in 100 us; the second texture goes by so much more than 100 px/s. */
        private void at(long t, PixelConsumer pixels) {
            for (int dot = 0; dot < x0.length; dot++) {
                boolean isSecond = dot % 4 == 0;
                double vx = (isSecond ? 100 + faster : 100) * 1e-6;
                int x = (int) Math.floor(60 + x0[dot] + vx * t);
                if (x != (int) Math.floor(60 + x0[dot] + vx * (t - 100))) {
                    pixels.accept(x, (int) (y0[dot] + (isSecond ? 60 : 10)));
                }
            }
        }

        /** Returns the share of the events of the last 10 ms that the upper texture has in 1, the lower one in 2. */
        double goOn() {
            int[] events = new int[1];
            int[] right = new int[1];
            for (long t = 100; t <= 60_000; t += 100) {
                boolean isCounted = t > 50_000;
                edges.nowUs = beganUs + t;
                at(t, (x, y) -> {
                    boolean isRight = edges.label(x, y) == (y < 50 ? 1 : 2);
                    events[0] += isCounted ? 1 : 0;
                    right[0] += isCounted && isRight ? 1 : 0;
                });
                edges.stack.check(edges.nowUs);
            }
            return (double) right[0] / events[0];
        }
    }

    @Test
    public void bodyThatMovesOtherwiseThanThePlaneThatHasItBecomesOneOfItsOwn() {
        double right = new TwoTextures(50).goOn();
        assertEquals(List.of(1, 2), edges.ids());
        assertEquals(100, edges.stack.segments().get(0).vxPxPerS(), 3);
        assertEquals(150, edges.stack.segments().get(1).vxPxPerS(), 3);
        assertTrue(edges.stack.segments().get(1).minY() > 50);
        assertTrue("in their own: " + right, right > 0.98);
        assertEquals(List.of(), edges.ended);
    }

    @Test
    public void bodiesThatMoveAlikeStayOnePlane() {
        new TwoTextures(0).goOn();
        assertEquals(List.of(1), edges.ids());
    }

    @Test
    public void planeThatWasFoundIsLetGoWhereAPartTookTheLastRoom() {
        edges.stack.setParameters(SofasParameters.defaults().with("maxTrackPlanes", 2).track());
        TwoTextures textures = new TwoTextures(50);
        TrackPlane late = edges.stack.found().create(edges.nowUs, 100, 0);
        edges.stack.found().begin(late, edges.nowUs);
        textures.goOn();
        assertEquals(List.of(1, 2), edges.ids());
        edges.stack.adopt();
        assertEquals(List.of(1, 2), edges.ids());
        assertFalse(edges.stack.tracks(late));
        assertTrue("no more are to be found", edges.stack.found().isFull());
    }

    @Test
    public void partsAreMadeOfPlanesThatAreNotUsed() {
        edges.stack.setParameters(SofasParameters.defaults().with("maxTrackPlanes", 2).track());
        for (int times = 0; times < 5; times++) {
            new TwoTextures(50).goOn();
            assertEquals(List.of(1, 2), edges.ids());
            edges.stack.reset();
        }
        int usedBefore = 0;
        while (edges.stack.found().create(edges.nowUs, 100, 0).served() > 1) {
            usedBefore++;
        }
        assertEquals(2, usedBefore);
    }
}
