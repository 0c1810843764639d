package io.github.sofas.flow.track;

import static io.github.sofas.flow.track.TrackedEdges.COLUMNS;
import static io.github.sofas.flow.track.TrackedEdges.ROWS;
import static org.junit.Assert.assertEquals;

import java.util.List;
import java.util.Random;
import org.junit.Test;

/** Which of the planes of a stack gets an event, and whether the event measures its motion. */
public class CandidatesTest {
    private final TrackedEdges edges = new TrackedEdges();

    @Test
    public void eventGoesToThePlaneThatExplainsMostOfItsPast() {
        // of the second edge, which came the other way, only three columns were seen, if with nine times the events
        edges.begin(40, 30, 100, 1);
        edges.begin(40, 30, -100, 9, 3);
        assertEquals(1, edges.label(40, 45));
        assertEquals(100, edges.output.vxPxPerS[0], 3);
    }

    @Test
    public void eventGoesToThePlaneWhoseEdgeIsNearest() {
        // after 3 ms an event of column 40 is at 39.7 of the first plane, whose edge, seen in five sixteenths, is at 41
        edges.begin(41, 30, 100, 1);
        // and at 40.3 of the second, whose edge, seen in three, is at 40
        edges.begin(40, 30, -100, 1, 3);
        edges.nowUs += 3_000;
        assertEquals(2, edges.label(40, 45));
    }

    @Test
    public void ofPlanesAsNearOneWithMoreAroundGetsTheEvent() {
        // of both planes three sixteenths are near; of the second, where the event is at 39.7, two more were seen at 41
        edges.begin(40, 30, -100, 1, 3);
        TrackPlane plane = edges.stack.found().create(edges.nowUs, 100, 0);
        for (int c = COLUMNS - 1; c >= 0; c--) {
            for (int y = 0; y < ROWS; y++) {
                plane.addPast((c < 3 ? 40 : 41) - c, 30 + y, edges.nowUs - c * 10_000, 1, true);
            }
        }
        edges.stack.found().begin(plane, edges.nowUs);
        edges.stack.adopt();
        edges.nowUs += 3_000;
        assertEquals(2, edges.label(40, 45));
    }

    /** Planes 1 and 2: of one alone it is not noted where events were. */
    private void beginTwoElsewhere() {
        edges.begin(110, 0, 100, 1);
        edges.begin(90, 60, -100, 1);
    }

    /** The plane of an event at (40, 45), which an edge reached from the right through so many columns. */
    private int planeOfEdgeFromTheRight(int columns) {
        beginTwoElsewhere();
        edges.nowUs -= columns * 10_000;
        for (int c = columns; c >= 1; c--) {
            assertEquals("none expects it yet", 0, edges.label(40 + c, 45));
            edges.nowUs += 10_000;
        }
        // the contour of the first, plane 3, is nearer, as above
        edges.begin(40, 30, 100, 1);
        edges.begin(40, 30, -100, 9, 3);
        return edges.label(40, 45);
    }

    @Test
    public void eventGoesToThePlaneAlongWhoseMotionItsEdgeCame() {
        assertEquals(4, planeOfEdgeFromTheRight(2));
        assertEquals(-100, edges.output.vxPxPerS[0], 3);
    }

    @Test
    public void eventWhoseEdgeCameOnePxFartherStaysWithTheNearestContour() {
        assertEquals(3, planeOfEdgeFromTheRight(1));
    }

    @Test
    public void resetForgetsWhereEdgesCameFrom() {
        beginTwoElsewhere();
        edges.label(42, 45);
        edges.nowUs += 10_000;
        edges.label(41, 45);
        edges.nowUs += 10_000;
        edges.stack.reset();
        assertEquals(3, planeOfEdgeFromTheRight(0));
    }

    /**
     * Events that the edge at column 40 is measured from when it enters two more: with the 40th event, the least
     * that is new. Of its past there are the columns of the last 50 ms, 37 to 40.
     */
    private int measured() {
        for (int c = 1; c <= 2; c++) {
            edges.nowUs += 10_000;
            for (int y = 0; y < ROWS; y++) {
                edges.label(40 + c, 30 + y);
            }
        }
        return edges.fit.size();
    }

    @Test
    public void eventThatOnePlaneClaimsMeasuresIt() {
        edges.begin(40, 30, 100, 1);
        assertEquals(4 * ROWS + 40, measured());
    }

    @Test
    public void eventThatTwoPlanesClaimMeasuresNeither() {
        // the same edge once more: what comes from now on lies on both
        edges.begin(40, 30, 100, 1);
        edges.begin(40, 30, 100, 1);
        assertEquals(4 * ROWS, measured());
    }

    @Test
    public void planeThatWasHiddenGetsItsEventsBackWhereItIsRemembered() {
        edges.begin(20, 30, 100, 1);
        assertEquals(1, edges.goOn(20, 30, 15));
        // hidden for 200 ms, in which its contour fades
        edges.pause();
        assertEquals(List.of(1), edges.ids());
        assertEquals(1, edges.label(55, 45));
        assertEquals("not beside it", 0, edges.label(70, 45));
    }

    /** The plane of an event where plane 1 is remembered, in the box of plane 2, whose edge came by some columns. */
    private int planeOfUncovered(int columns) {
        edges.begin(20, 30, 100, 1);
        edges.goOn(20, 30, 15);
        edges.pause();
        TrackPlane other = edges.begin(100, 60, -100, 1);
        edges.stack.see(other, 30, 20, edges.nowUs, 1, edges.nowUs);
        for (int c = columns; c >= 1; c--) {
            assertEquals("an edge that has just come out", 0, edges.label(55 + c, 45));
            edges.nowUs += 10_000;
        }
        return edges.label(55, 45);
    }

    @Test
    public void whatComesOutFromBehindABodyGoesToThePlaneAlongWhoseMotionItCame() {
        assertEquals("nine of three px on the very pixel, more than six", 2, planeOfUncovered(3));
    }

    @Test
    public void rememberedEventThatAnotherMayHaveIsNobodysUnlessItsEdgeCameAlong() {
        assertEquals(0, planeOfUncovered(0));
    }

    @Test
    public void planeThatWasHiddenGetsItsEventsBackInTheBoxOfAnother() {
        planeOfUncovered(0);
        for (int c = 1; c <= 3; c++) {
            edges.nowUs += 10_000;
            edges.label(55 + c, 45);
        }
        assertEquals(1, edges.output.segment[0]);
    }

    /**
     * The plane of an event at (2, 45) on no contour, in the boxes of plane 1, whose texture has columns 6 to 25, and
     * of plane 2, along whose motion an edge came by some columns.
     *
     * @param times live events of plane 1 are so many times 150
     */
    private int planeOfEntering(double vx, int times, int columns) {
        TrackPlane first = edges.begin(100, 60, vx, times);
        TrackPlane second = edges.begin(100, 0, -100, 1);
        for (int c = columns; c >= 1; c--) {
            assertEquals("in no box", 0, edges.label(2 + c, 45));
            edges.nowUs += 10_000;
        }
        for (int ago = 1; ago >= 0; ago--) {
            for (int x = 6; x < 26; x++) {
                for (int y = 35; y < 56; y++) {
                    edges.stack.see(first, x, y, edges.nowUs - ago * 10_000, 1, edges.nowUs);
                }
            }
        }
        edges.stack.see(first, 0, 20, edges.nowUs, 1, edges.nowUs);
        edges.stack.see(second, 1, 60, edges.nowUs, 1, edges.nowUs);
        return edges.label(2, 45);
    }

    @Test
    public void whatEntersThePictureGoesToTheTextureThatDoesSo() {
        assertEquals(1, planeOfEntering(100, 14, 0));
        edges.stack.reset();
        assertEquals("it leaves there", 0, planeOfEntering(-100, 14, 0));
        edges.stack.reset();
        assertEquals("of 1,950 events", 0, planeOfEntering(100, 13, 0));
    }

    @Test
    public void whatEntersThePictureDoesNotMeasure() {
        planeOfEntering(100, 14, 0);
        LiveEvents live = edges.stack.planeOf(1).live();
        assertEquals(Claim.APPEARING, live.claim(live.index(live.size() - 1)));
    }

    @Test
    public void whatClearlyCameAlongAnotherMotionDoesNotEnter() {
        assertEquals("six px on the very pixel", 2, planeOfEntering(100, 14, 6));
        edges.stack.reset();
        assertEquals("five", 1, planeOfEntering(100, 14, 5));
    }

    /**
     * The plane of an event at (62, 41) on the contour of plane 2, a bar that moves to the left at 100 px/s, and not on
     * that of plane 1, the wall, which has dots there 4 px ahead; an edge came to it by two columns from one side.
     */
    private int planeOfBeforeWall(int fromRow, int rows, int fromColumn) {
        edges.beginWall(fromRow, rows);
        edges.begin(64, 30, -100, 1);
        edges.nowUs -= 10_000;
        for (int column = fromColumn; column != 62; column += Integer.signum(62 - fromColumn)) {
            edges.nowUs += 10_000;
            edges.label(column, 41);
        }
        edges.nowUs += 10_000;
        return edges.label(62, 41);
    }

    @Test
    public void wallHasWhatComesOutFromBehindWhatMovesBeforeIt() {
        assertEquals("it came along the wall's motion", 1, planeOfBeforeWall(0, 12, 60));
        edges.stack.reset();
        assertEquals("along the bar's", 2, planeOfBeforeWall(0, 12, 64));
        edges.stack.reset();
        assertEquals("the wall is three rows of dots", 2, planeOfBeforeWall(32, 3, 60));
    }

    /** The plane of an event where plane 1 is remembered, after 200 ms with so many noise events a ms elsewhere. */
    private int planeOfRemembered(int noisePerMs) {
        edges.begin(20, 30, 100, 1);
        edges.begin(60, 30, 100, 1);
        edges.goOnWithTwo(20, 30, 60, 30, 15);
        Random random = new Random(1);
        for (int ms = 1; ms <= 200; ms++) {
            edges.nowUs += 1_000;
            for (int i = 0; i < noisePerMs; i++) {
                // on every other pixel, so that each is alone, and above the edges, which have the rows from 30 to 59
                assertEquals(0, edges.label(2 * random.nextInt(64), 2 * random.nextInt(12)));
            }
            edges.stack.check(edges.nowUs);
        }
        return edges.label(55, 45);
    }

    @Test
    public void rememberedEventNeedsATraceThatNoiseHasNotInTheDarkOnly() {
        assertEquals(1, planeOfRemembered(0));
        edges.stack.reset();
        // in the mean of the sensor 10 Hz a pixel
        assertEquals(0, planeOfRemembered(128));
    }
}
