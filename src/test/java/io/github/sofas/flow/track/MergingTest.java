package io.github.sofas.flow.track;

import static io.github.sofas.flow.track.TrackedEdges.ROWS;
import static org.junit.Assert.assertEquals;
import static org.junit.Assert.assertFalse;
import static org.junit.Assert.assertTrue;

import io.github.sofas.flow.Segment;
import io.github.sofas.flow.fit.MotionLoss;
import java.util.List;
import java.util.function.IntUnaryOperator;
import org.junit.Test;

/** Which planes are taken for one. */
public class MergingTest {
    private final TrackedEdges edges = new TrackedEdges();

    @Test
    public void planesThatMoveAlikeSideBySideAreOneUnderTheOlderId() {
        edges.begin(40, 10, 100, 1);
        edges.begin(40, 42, 100, 1);
        edges.stack.check(edges.nowUs);
        assertEquals(List.of(1), edges.ids());
        Segment merged = edges.ended.get(0);
        assertEquals(2, merged.id());
        assertEquals(Segment.Fate.MERGED, merged.fate());
        assertEquals(1, merged.mergedInto());
        // it has the contours of both
        edges.nowUs += 10_000;
        assertEquals(1, edges.label(41, 15));
        assertEquals(1, edges.label(41, 65));
    }

    @Test
    public void mergedPlaneRemembersWhereEitherWasSeen() {
        edges.begin(20, 10, 100, 1);
        edges.begin(20, 42, 100, 1);
        edges.stack.check(edges.nowUs);
        assertEquals(1, edges.goOn(20, 10, 7));
        // hidden for 200 ms, in which the contour fades: the lower half was last seen before they merged
        edges.pause();
        assertEquals(1, edges.label(47, 57));
    }

    @Test
    public void olderPlaneTakesOverWhereverItStandsInTheStack() {
        // the first ends, and the last takes its place before the second, with the first look at them
        edges.begin(110, 60, 100, 1);
        edges.begin(20, 5, 100, 1);
        edges.begin(20, 37, 100, 1);
        edges.goOnWithTwo(20, 5, 20, 37, 10);
        assertEquals(List.of(2), edges.ids());
        assertEquals(List.of(1, 3), edges.ended.stream().map(Segment::id).toList());
        assertEquals(2, edges.ended.get(1).mergedInto());
    }

    @Test
    public void planesThatMoveAlikeForAMomentOnlyStayTwo() {
        TrackPlane steady = edges.begin(60, 10, 100, 1);
        TrackPlane changing = edges.begin(60, 42, 100, 1);
        Merging merging = new Merging();
        assertTrue(merging.areOne(steady, changing, edges.fit, edges.nowUs));
        // as fast now, but 62.5 px/s in the middle of its 50 ms
        changing.motion().ax = 1500;
        assertFalse(merging.areOne(steady, changing, edges.fit, edges.nowUs));
        steady.motion().ax = 1500;
        assertTrue("both change alike", merging.areOne(steady, changing, edges.fit, edges.nowUs));
    }

    @Test
    public void planesThatMoveApartStayTwo() {
        edges.begin(60, 10, 100, 1);
        edges.begin(60, 42, -100, 1);
        edges.stack.check(edges.nowUs);
        assertEquals(List.of(1, 2), edges.ids());
    }

    @Test
    public void planesThatMoveAlikeApartFromEachOtherAreOneAfterEightPixels() {
        edges.begin(40, 30, 100, 1);
        edges.begin(60, 30, 100, 1);
        edges.goOnWithTwo(40, 30, 60, 30, 6);
        assertEquals(List.of(1, 2), edges.ids());
        edges.goOnWithTwo(46, 30, 66, 30, 4);
        assertEquals(List.of(1), edges.ids());
    }

    @Test
    public void planesApartWhoseSpeedsDifferByATwelfthStayTwo() {
        edges.begin(40, 30, 100, 1);
        edges.begin(60, 30, 108, 1);
        long beganUs = edges.nowUs;
        int first = 1;
        int second = 1;
        while (first <= 12) {
            boolean firstIsNext = first * 108 <= second * 100;
            edges.nowUs = beganUs + (firstIsNext ? first * 10_000 : second * 1_000_000 / 108);
            int column = firstIsNext ? 40 + first++ : 60 + second++;
            for (int y = 0; y < ROWS; y++) {
                edges.label(column, 30 + y);
            }
            edges.stack.check(edges.nowUs);
        }
        assertEquals(List.of(1, 2), edges.ids());
    }

    @Test
    public void planesThatMoveAlikeFarFromEachOtherStayTwo() {
        // boxes 29 px long may lie 0.8 of that apart, and no more
        edges.begin(40, 30, 100, 1);
        edges.begin(68, 30, 100, 1);
        edges.goOnWithTwo(40, 30, 68, 30, 10);
        assertEquals(List.of(1, 2), edges.ids());
    }

    /** Travel in px, each 0.5 px of which it is asked, after which planes are one; 0 where not in 100 px. */
    private double oneAfterPx(Merging merging, TrackPlane a, TrackPlane b) {
        for (int k = 1; k <= 200; k++) {
            if (merging.areOne(a, b, edges.fit, edges.nowUs + 5_000 * k)) {
                return 0.5 * k;
            }
        }
        return 0;
    }

    @Test
    public void planesFarFromEachOtherAreOneOnceTheyHaveGoneAsFarTogether() {
        TrackPlane a = edges.begin(40, 30, 100, 1);
        TrackPlane b = edges.begin(80, 30, 100, 1);
        // counted once they have travelled 8 px
        assertEquals(8 + 40, oneAfterPx(new Merging(), a, b), 1.5);
    }

    @Test
    public void planesWhoseMotionChangesAlikeAreOneSooner() {
        TrackPlane a = edges.begin(40, 30, 100, 1);
        TrackPlane b = edges.begin(80, 30, 100, 1);
        a.motion().ay = 500;
        b.motion().ay = 500;
        // each px of travel counts as another one, which 500 px/s2 gain in 0.2 s at 100 px/s
        assertEquals(8 + 40 / 2, oneAfterPx(new Merging(), a, b), 1.5);
    }

    @Test
    public void planesFarFromEachOtherGoTogetherByTheMiddleOfTheirWindows() {
        TrackPlane a = edges.begin(40, 30, 100, 1);
        TrackPlane b = edges.begin(80, 30, 100, 1);
        Merging merging = new Merging();
        boolean areOne = false;
        for (int k = 0; k < 200 && !areOne; k++) {
            edges.nowUs += 5_000;
            // always as fast 25 ms ago, in the middle of its 50 ms, and taken to be 40 px/s faster now
            b.motion().referenceUs = edges.nowUs;
            b.motion().vx = 140;
            b.motion().ax = 1_600;
            areOne = merging.areOne(a, b, edges.fit, edges.nowUs);
        }
        assertTrue(areOne);
        assertEquals(Merging.Bond.TOGETHER, merging.bond());
    }

    @Test
    public void planesFarFromEachOtherAreOneLaterWhereOneMovesOtherwiseForAWhile() {
        TrackPlane a = edges.begin(40, 30, 100, 1);
        TrackPlane b = edges.begin(80, 30, 100, 1);
        Merging merging = new Merging();
        for (int px = 1; px <= 16; px++) {
            // the first 8 do not count, and of the others as many are otherwise as are alike
            b.motion().vx = px % 2 == 0 ? 150 : 100;
            edges.nowUs += 10_000;
            assertFalse(merging.areOne(a, b, edges.fit, edges.nowUs));
        }
        b.motion().vx = 100;
        assertEquals(40, oneAfterPx(merging, a, b), 2);
    }

    /** Edges 30 px long whose boxes are 46 px apart go on for some columns; the ids that are left. */
    private List<Integer> idsAfter(IntUnaryOperator polarityOfRow, IntUnaryOperator otherPolarityOfRow, int columns) {
        edges.begin(30, 30, 100, 1, TrackedEdges.COLUMNS, polarityOfRow);
        edges.begin(80, 30, 100, 1, TrackedEdges.COLUMNS, otherPolarityOfRow);
        edges.goOnWithTwo(30, 30, polarityOfRow, 80, 30, otherPolarityOfRow, columns);
        return edges.ids();
    }

    @Test
    public void leadingAndTrailingEdgeOfABodyAreOneAfterSixPixels() {
        assertEquals(List.of(1, 2), idsAfter(y -> 1, y -> -1, 5));
        edges.goOnWithTwo(35, 30, y -> 1, 85, 30, y -> -1, 2);
        assertEquals(List.of(1), edges.ids());
    }

    @Test
    public void edgesOfOnePolarityAsFarFromEachOtherStayTwo() {
        assertEquals(List.of(1, 2), idsAfter(y -> -1, y -> -1, 12));
    }

    @Test
    public void bodiesWithEdgesOfEitherPolarityAsFarFromEachOtherStayTwo() {
        // a third of the one fires OFF, of the other ON
        assertEquals(List.of(1, 2), idsAfter(y -> y % 3 == 0 ? -1 : 1, y -> y % 3 == 0 ? 1 : -1, 12));
    }

    /** A square of dots of a polarity that turns about its right or left side, at 4 rad/s. */
    private TrackPlane turningSquare(double left, int polarity) {
        MovingDots dots = new MovingDots();
        dots.move(90, MovingDots.MIDDLE_X + left, 0, 4);
        edges.nowUs = MovingDots.END_US;
        TrackPlane plane = edges.stack.found().create(edges.nowUs, MovingDots.VX, 4 * (left + MovingDots.SIDE / 2));
        dots.addTo(plane, polarity);
        edges.stack.found().begin(plane, edges.nowUs);
        edges.stack.adopt();
        return plane;
    }

    @Test
    public void partsOfWhatTurnsAreOneUnlessTheyLoseMostOfTheirMetricByOneVelocity() {
        TrackPlane left = turningSquare(-MovingDots.SIDE, 1);
        TrackPlane right = turningSquare(0, -1);
        MotionLoss loss = right.measurement().loss();
        double metric = loss.metric;
        loss.metric = metric / 20;
        assertEquals("px until they are one", 0, oneAfterPx(new Merging(), left, right), 0);
        loss.metric = metric;
        assertTrue("they are one", oneAfterPx(new Merging(), left, right) > 0);
    }
}
