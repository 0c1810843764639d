package io.github.sofas.flow.track;

import static org.junit.Assert.assertEquals;
import static org.junit.Assert.assertFalse;
import static org.junit.Assert.assertTrue;

import io.github.sofas.event.SensorSize;
import io.github.sofas.flow.FlowOutput;
import io.github.sofas.flow.Segment;
import io.github.sofas.flow.SofasParameters;
import io.github.sofas.flow.fit.MetricFit;
import java.util.ArrayList;
import java.util.List;
import org.junit.Test;

/**
 * Who gets an event, and which planes are one: upright edges of 30 rows that enter a column at a time. At 100 px/s the
 * lifetime of 5 px is 50 ms.
 */
public class TrackPlaneStackTest {
    private static final SensorSize SENSOR = new SensorSize(128, 96);
    private static final SofasParameters.Track P = SofasParameters.defaults().track();
    private static final int ROWS = 30;
    private static final int COLUMNS = 5;

    private final MetricFit fit = newFit();
    private final List<Segment> ended = new ArrayList<>();
    private final TrackPlaneStack stack = new TrackPlaneStack(SENSOR, P, fit, newFit(), ended::add,
        (segment, motion) -> { });
    private final FlowOutput output = new FlowOutput(1);
    private long nowUs = 1_000_000;

    private static MetricFit newFit() {
        return new MetricFit(128, 96, MetricFit.CELL_PX, TrackPlaneStack.MOST_MEASURED, 1900);
    }

    /** An edge that has come to a column by now, each pixel of which fired some times as the edge entered it. */
    private void begin(int column, int row, double vx, int times) {
        begin(column, row, vx, times, COLUMNS);
    }

    private void begin(int column, int row, double vx, int times, int columns) {
        TrackPlane plane = stack.found().create(nowUs, vx, 0);
        for (int c = columns - 1; c >= 0; c--) {
            long timeUs = nowUs - (long) (c * 1e6 / Math.abs(vx));
            for (int i = 0; i < times * ROWS; i++) {
                plane.addPast(column - c * (int) Math.signum(vx), row + i % ROWS, timeUs, 1);
            }
        }
        stack.found().begin(plane, nowUs);
        stack.adopt();
    }

    /** The segment that an ON event of now is given. */
    private int label(int x, int y) {
        output.segment[0] = -1;
        if (stack.label(x, y, nowUs, 1, output, 0)) {
            assertTrue(output.segment[0] > 0);
        }
        return output.segment[0];
    }

    /** An edge goes on for some columns, each of which it enters after 10 ms. */
    private int goOn(int column, int row, int columns) {
        int segment = 0;
        for (int c = 1; c <= columns; c++) {
            nowUs += 10_000;
            for (int y = 0; y < ROWS; y++) {
                segment = label(column + c, row + y);
            }
            stack.check(nowUs);
        }
        return segment;
    }

    /** Two edges go on for some columns, each of which they enter after 10 ms; then the planes are looked after. */
    private void goOnWithTwo(int column, int row, int otherColumn, int otherRow, int columns) {
        for (int c = 1; c <= columns; c++) {
            nowUs += 10_000;
            for (int y = 0; y < ROWS; y++) {
                label(column + c, row + y);
                label(otherColumn + c, otherRow + y);
            }
        }
        stack.check(nowUs);
    }

    private List<Integer> ids() {
        return stack.segments().stream().map(Segment::id).toList();
    }

    @Test
    public void eventOnAContourGetsTheVelocityOfItsPlane() {
        begin(40, 30, 100, 1);
        nowUs += 10_000;
        assertEquals(1, label(41, 45));
        assertEquals(100, output.vxPxPerS[0], 3);
        assertEquals(0, output.vyPxPerS[0], 5);
        assertEquals(1, stack.segments().get(0).events());
    }

    @Test
    public void planeThatWasFoundLabelsNothingBeforeItIsAdopted() {
        TrackPlane plane = stack.found().create(nowUs, 100, 0);
        for (int i = 0; i < COLUMNS * ROWS; i++) {
            plane.addPast(36 + i / ROWS, 30 + i % ROWS, nowUs - (4 - i / ROWS) * 10_000, 1);
        }
        stack.found().begin(plane, nowUs);
        nowUs += 10_000;
        assertEquals(0, label(41, 45));
        assertEquals(List.of(), ids());
        // but takes what it expects
        assertTrue(stack.found().takes(41, 45, nowUs, 1));
        assertFalse(stack.found().takes(80, 45, nowUs, 1));
        stack.adopt();
        assertEquals(List.of(1), ids());
        assertFalse("it is the stack's", stack.found().takes(41, 46, nowUs, 1));
        assertEquals(1, label(41, 46));
    }

    @Test
    public void resetForgetsWhatWasFound() {
        TrackPlane plane = stack.found().create(nowUs, 100, 0);
        plane.addPast(40, 30, nowUs, 1);
        stack.found().begin(plane, nowUs);
        stack.reset();
        stack.adopt();
        assertEquals(List.of(), ids());
        begin(40, 30, 100, 1);
        assertEquals(List.of(1), ids());
    }

    @Test
    public void eventOnNoContourIsLeftAlone() {
        begin(40, 30, 100, 1);
        assertEquals(0, label(60, 45));
        assertEquals(0, stack.segments().get(0).events());
    }

    @Test
    public void eventGoesToThePlaneThatExplainsMostOfItsPast() {
        // of the second edge, which came the other way, only three columns were seen, if with nine times the events
        begin(40, 30, 100, 1);
        begin(40, 30, -100, 9, 3);
        assertEquals(1, label(40, 45));
        assertEquals(100, output.vxPxPerS[0], 3);
    }

    @Test
    public void eventGoesToThePlaneWhoseEdgeIsNearest() {
        // after 3 ms an event of column 40 is at 39.7 of the first plane, whose edge, seen in five sixteenths, is at 41
        begin(41, 30, 100, 1);
        // and at 40.3 of the second, whose edge, seen in three, is at 40
        begin(40, 30, -100, 1, 3);
        nowUs += 3_000;
        assertEquals(2, label(40, 45));
    }

    @Test
    public void ofPlanesAsNearOneWithMoreAroundGetsTheEvent() {
        // of both planes three sixteenths are near; of the second, where the event is at 39.7, two more were seen at 41
        begin(40, 30, -100, 1, 3);
        TrackPlane plane = stack.found().create(nowUs, 100, 0);
        for (int c = COLUMNS - 1; c >= 0; c--) {
            for (int y = 0; y < ROWS; y++) {
                plane.addPast((c < 3 ? 40 : 41) - c, 30 + y, nowUs - c * 10_000, 1);
            }
        }
        stack.found().begin(plane, nowUs);
        stack.adopt();
        nowUs += 3_000;
        assertEquals(2, label(40, 45));
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
        TrackPlane plane = stack.found().create(nowUs, 100, 0);
        for (int c = COLUMNS - 1; c >= 0; c--) {
            for (int y = 0; y < ROWS; y++) {
                plane.addPast(40 - c, 30 + y, nowUs - c * 10_000, 1);
            }
            for (int[] dot : dots) {
                if (c == 1 || c == 2) {
                    plane.addPast(dot[0] - c, dot[1], nowUs - c * 10_000, 1);
                }
            }
        }
        stack.found().begin(plane, nowUs);
        stack.adopt();
        return dots;
    }

    @Test
    public void whereManyEventsHaveLittleSupportSomethingElseMayBe() {
        // of the dots the fifth is still one of few
        List<Boolean> explained = new ArrayList<>();
        for (int[] dot : beginWithDots()) {
            explained.add(stack.label(dot[0], dot[1], nowUs, 1, output, 0));
            assertEquals("labelled all the same", 1, output.segment[0]);
        }
        assertEquals(List.of(true, true, true, true, true, false, false, false, false), explained);
    }

    @Test
    public void resetForgetsWhereEventsHadLittleSupport() {
        for (int[] dot : beginWithDots()) {
            stack.label(dot[0], dot[1], nowUs, 1, output, 0);
        }
        stack.reset();
        int[] dot = beginWithDots().get(0);
        assertTrue(stack.label(dot[0], dot[1], nowUs, 1, output, 0));
    }

    /**
     * Events that the edge at column 40 is measured from when it enters two more: with the 40th event, the least
     * that is new. Of its past there are the columns of the last 50 ms, 37 to 40.
     */
    private int measured() {
        for (int c = 1; c <= 2; c++) {
            nowUs += 10_000;
            for (int y = 0; y < ROWS; y++) {
                label(40 + c, 30 + y);
            }
        }
        return fit.size();
    }

    @Test
    public void eventThatOnePlaneClaimsMeasuresIt() {
        begin(40, 30, 100, 1);
        assertEquals(4 * ROWS + 40, measured());
    }

    @Test
    public void eventThatTwoPlanesClaimMeasuresNeither() {
        // the same edge once more: what comes from now on lies on both
        begin(40, 30, 100, 1);
        begin(40, 30, 100, 1);
        assertEquals(4 * ROWS, measured());
    }

    @Test
    public void planeThatWasHiddenGetsItsEventsBackWhereItIsRemembered() {
        begin(20, 30, 100, 1);
        assertEquals(1, goOn(20, 30, 15));
        // hidden for 200 ms, in which its contour fades
        for (int i = 0; i < 40; i++) {
            nowUs += 5_000;
            stack.check(nowUs);
        }
        assertEquals(List.of(1), ids());
        assertEquals(1, label(55, 45));
        assertEquals("not beside it", 0, label(70, 45));
    }

    @Test
    public void planeThatGetsNoEventsIsRemoved() {
        begin(40, 30, 100, 1);
        for (int i = 0; i < 40; i++) {
            nowUs += 5_000;
            stack.check(nowUs);
        }
        assertEquals(List.of(), ids());
        assertEquals(1, ended.size());
        assertEquals(Segment.Fate.REMOVED, ended.get(0).fate());
    }

    @Test
    public void planesAreLookedAfterEachFiveMilliseconds() {
        stack.check(nowUs);
        begin(40, 30, 100, 1);
        begin(40, 62, 100, 1);
        stack.check(nowUs + 4_999);
        assertEquals(List.of(1, 2), ids());
        stack.check(nowUs + 5_000);
        assertEquals(List.of(1), ids());
    }

    @Test
    public void planesThatMoveAlikeSideBySideAreOneUnderTheOlderId() {
        begin(40, 10, 100, 1);
        begin(40, 42, 100, 1);
        stack.check(nowUs);
        assertEquals(List.of(1), ids());
        Segment merged = ended.get(0);
        assertEquals(2, merged.id());
        assertEquals(Segment.Fate.MERGED, merged.fate());
        assertEquals(1, merged.mergedInto());
        // it has the contours of both
        nowUs += 10_000;
        assertEquals(1, label(41, 15));
        assertEquals(1, label(41, 65));
    }

    @Test
    public void mergedPlaneRemembersWhereEitherWasSeen() {
        begin(20, 10, 100, 1);
        begin(20, 42, 100, 1);
        stack.check(nowUs);
        assertEquals(1, goOn(20, 10, 7));
        // hidden for 200 ms, in which the contour fades: the lower half was last seen before they merged
        for (int i = 0; i < 40; i++) {
            nowUs += 5_000;
            stack.check(nowUs);
        }
        assertEquals(1, label(47, 57));
    }

    @Test
    public void olderPlaneTakesOverWhereverItStandsInTheStack() {
        // the first ends, and the last takes its place before the second, with the first look at them
        begin(110, 60, 100, 1);
        begin(20, 5, 100, 1);
        begin(20, 37, 100, 1);
        goOnWithTwo(20, 5, 20, 37, 10);
        assertEquals(List.of(2), ids());
        assertEquals(List.of(1, 3), ended.stream().map(Segment::id).toList());
        assertEquals(2, ended.get(1).mergedInto());
    }

    @Test
    public void planesThatMoveApartStayTwo() {
        begin(60, 10, 100, 1);
        begin(60, 42, -100, 1);
        stack.check(nowUs);
        assertEquals(List.of(1, 2), ids());
    }

    @Test
    public void planesThatMoveAlikeApartFromEachOtherAreOneAfterEightPixels() {
        begin(40, 30, 100, 1);
        begin(60, 30, 100, 1);
        goOnWithTwo(40, 30, 60, 30, 6);
        assertEquals(List.of(1, 2), ids());
        goOnWithTwo(46, 30, 66, 30, 4);
        assertEquals(List.of(1), ids());
    }

    @Test
    public void planesApartWhoseSpeedsDifferByATwelfthStayTwo() {
        begin(40, 30, 100, 1);
        begin(60, 30, 108, 1);
        long beganUs = nowUs;
        int first = 1;
        int second = 1;
        while (first <= 12) {
            boolean firstIsNext = first * 108 <= second * 100;
            nowUs = beganUs + (firstIsNext ? first * 10_000 : second * 1_000_000 / 108);
            int column = firstIsNext ? 40 + first++ : 60 + second++;
            for (int y = 0; y < ROWS; y++) {
                label(column, 30 + y);
            }
            stack.check(nowUs);
        }
        assertEquals(List.of(1, 2), ids());
    }

    @Test
    public void planesThatMoveAlikeFarFromEachOtherStayTwo() {
        // boxes 29 px long may lie 0.8 of that apart, and no more
        begin(40, 30, 100, 1);
        begin(68, 30, 100, 1);
        goOnWithTwo(40, 30, 68, 30, 10);
        assertEquals(List.of(1, 2), ids());
    }

    @Test
    public void stackIsFullWithAsManyPlanesAsAreAllowed() {
        stack.setParameters(SofasParameters.defaults().with("maxTrackPlanes", 2).track());
        begin(20, 10, 100, 1);
        assertFalse(stack.found().isFull());
        begin(60, 10, -100, 1);
        assertTrue(stack.found().isFull());
        stack.setParameters(SofasParameters.defaults().with("maxTrackPlanes", 1).track());
        assertEquals(List.of(1), ids());
        assertEquals(2, ended.get(0).id());
        assertTrue(stack.found().isFull());
    }

    @Test
    public void contourIsThatOfTheOneThatIsAskedFor() {
        begin(40, 10, 100, 1);
        begin(80, 50, -100, 1);
        List<Integer> columns = new ArrayList<>();
        stack.contour(2, nowUs, (x, y) -> columns.add(x));
        assertFalse(columns.isEmpty());
        columns.forEach(x -> assertEquals(80, x, 1));
        stack.contour(3, nowUs, (x, y) -> assertEquals("none has this id", 0, x));
    }

    @Test
    public void idsBeginAnewAfterReset() {
        begin(40, 30, 100, 1);
        stack.reset();
        assertEquals(List.of(), ids());
        assertEquals(Segment.Fate.REMOVED, ended.get(0).fate());
        assertEquals(0, label(40, 45));
        begin(40, 30, 100, 1);
        assertEquals(List.of(1), ids());
    }
}
