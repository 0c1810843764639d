package io.github.sofas.flow.smooth;

import static org.junit.Assert.assertEquals;
import static org.junit.Assert.assertFalse;
import static org.junit.Assert.assertTrue;

import io.github.sofas.event.SensorSize;
import io.github.sofas.flow.motion.Motion;
import java.util.ArrayList;
import java.util.List;
import org.junit.Test;

public class SegmentPathTest {
    private static final double EXACT = 1e-9;

    private final SegmentPath path = new SegmentPath(1);
    private final Motion at = new Motion();

    /** To the right, with this column of the centre. */
    static Motion motion(long us, double vx, double centreX) {
        Motion motion = new Motion();
        motion.set(us, vx, 0);
        motion.centreX = centreX;
        return motion;
    }

    @Test
    public void motionChangesEvenlyBetweenTwoKnots() {
        // 100 to 200 px/s within 1 s: after a quarter of it 125 px/s, and (100 + 125) / 2 * 0.25 px farther
        path.add(motion(0, 100, 10));
        path.add(motion(1_000_000, 200, 160));
        path.at(250_000, at);
        assertEquals(125, at.vx, EXACT);
        assertEquals(10 + 28.125, at.centreX, EXACT);
        assertEquals(250_000, at.referenceUs);
        assertEquals("the change is in the velocity already", 0, at.ax, EXACT);
    }

    @Test
    public void deformationChangesEvenly() {
        Motion first = motion(0, 100, 0);
        first.deformation.stretch = 0.1;
        Motion second = motion(1_000_000, 100, 100);
        second.deformation.stretch = 0.3;
        second.deformation.perspectiveY = 0.004;
        path.add(first);
        path.add(second);
        path.at(750_000, at);
        assertEquals(0.25, at.deformation.stretch, EXACT);
        assertEquals(0.003, at.deformation.perspectiveY, EXACT);
        path.at(2_000_000, at);
        assertEquals(0.3, at.deformation.stretch, EXACT);
    }

    @Test
    public void turnAndGrowthChangeEvenlyAboutWhateverCentresTheyAreGiven() {
        // the second knot tells of the same turning, of 2 and 4 rad/s, about a centre 30 px to the right
        Motion first = motion(0, 0, 0);
        first.omega = 2;
        first.growth = 1;
        Motion second = motion(1_000_000, 0, 0);
        second.omega = 4;
        second.growth = 3;
        second.moveCentre(30, 0);
        path.add(first);
        path.add(second);
        path.at(500_000, at);
        assertEquals(0, at.vx, EXACT);
        assertEquals(0, at.vy, EXACT);
        assertEquals(3, at.omega, EXACT);
        assertEquals(2, at.growth, EXACT);
    }

    /** One knot at 1 s and 50 px, with 100 px/s² more from then on, of a segment that has events until a time. */
    private void addAccelerated(double vx, long newestUs) {
        Motion only = motion(1_000_000, vx, 50);
        only.ax = 100;
        path.add(only);
        path.see(newestUs);
    }

    @Test
    public void segmentMovesSteadilyBeforeTheFirstKnot() {
        addAccelerated(100, 1_000_000);
        path.at(900_000, at);
        assertEquals(100, at.vx, EXACT);
        assertEquals(40, at.centreX, EXACT);
    }

    @Test
    public void motionChangesOnAfterTheLastKnotByAQuarterOfItsSpeedAtMost() {
        // 100 px/s² from 100 px/s on: after 0.1 s 110 px/s and 0.5 px more than steadily, after 0.25 s a quarter more
        addAccelerated(100, 9_000_000);
        path.at(1_100_000, at);
        assertEquals(110, at.vx, EXACT);
        assertEquals(60.5, at.centreX, EXACT);
        assertEquals("the change is in the velocity already", 0, at.ax, EXACT);
        path.at(2_000_000, at);
        assertEquals(125, at.vx, EXACT);
        assertEquals(50 + 25 + 3.125 + 0.75 * 125, at.centreX, EXACT);
    }

    @Test
    public void motionChangesNoMoreAfterTheNewestEvent() {
        // 100 px/s² until 1.1 s: 110 px/s from then on
        addAccelerated(100, 1_100_000);
        path.at(1_200_000, at);
        assertEquals(110, at.vx, EXACT);
        assertEquals(60.5 + 11, at.centreX, EXACT);
    }

    @Test
    public void whatStoppedStaysWhereItIs() {
        addAccelerated(0, 9_000_000);
        path.at(2_000_000, at);
        assertEquals(0, at.vx, EXACT);
        assertEquals(50, at.centreX, EXACT);
    }

    @Test
    public void bendIsTheMeanChangeAroundATime() {
        // 100 px/s until 1 s, then 100 px/s² more: from 0.8 to 1.2 s it changes by 20 px/s in 0.4 s
        path.add(motion(0, 100, 0));
        path.add(motion(1_000_000, 100, 100));
        path.add(motion(2_000_000, 200, 250));
        path.bending(1_000_000, 200_000, at);
        assertEquals(100, at.vx, EXACT);
        assertEquals(50, at.ax, EXACT);
    }

    /** Within half a second, 50 px to the right of what stands and turns by 2 rad/s. */
    private boolean isOneWithWhatTurns(double vy) {
        SegmentPath piece = new SegmentPath(2);
        for (long us = 0; us <= 500_000; us += 500_000) {
            Motion turning = motion(us, 0, 0);
            turning.omega = 2;
            path.add(turning);
            Motion moving = motion(us, 0, 50);
            moving.vy = vy;
            moving.centreY = vy * us * 1e-6;
            piece.add(moving);
        }
        boolean isOne = path.movedAsOneWith(piece);
        assertEquals("whichever is asked", isOne, piece.movedAsOneWith(path));
        return isOne;
    }

    @Test
    public void pieceThatGoesWhereTheBodyTurnsIsOneWithItThoughItDoesNotShowThatItTurns() {
        // 2 rad/s move the place of the piece down by 100 px/s
        assertTrue(isOneWithWhatTurns(100));
        assertTrue("a little late", isOneWithWhatTurns(60));
    }

    @Test
    public void whatGoesAgainstTheTurningOfAnotherIsNotOneWithIt() {
        // 37 px apart in the time, of which half of the turning excuses 27, a distance of 53 px in the mean; and 3 more
        assertFalse(isOneWithWhatTurns(-75));
    }

    @Test
    public void piecesThatDoNotTurnAreOneWhereTheirVelocitiesAgreeToASeventh() {
        SegmentPath slower = new SegmentPath(2);
        SegmentPath slow = new SegmentPath(3);
        for (long us = 0; us <= 1_000_000; us += 1_000_000) {
            path.add(motion(us, 100, us * 100e-6));
            slower.add(motion(us, 84, us * 84e-6));
            slow.add(motion(us, 80, us * 80e-6));
        }
        // 16 and 20 px apart: 3 and 15 of 100 px may be
        assertTrue(path.movedAsOneWith(slower));
        assertFalse(path.movedAsOneWith(slow));
    }

    @Test
    public void whatWasNotKnownAtTheSameTimeMayBeOne() {
        path.add(motion(0, 100, 0));
        SegmentPath later = new SegmentPath(2);
        later.add(motion(1_000_000, -100, 0));
        assertTrue(path.movedAsOneWith(later));
    }

    @Test
    public void laterMeasurementOfAnEarlierTimeTakesThePlaceOfOlderOnes() {
        path.add(motion(0, 100, 0));
        path.add(motion(500_000, 900, 0));
        path.add(motion(400_000, 200, 0));
        path.at(450_000, at);
        assertEquals(200, at.vx, EXACT);
    }

    /** A slice from 0.25 to 0.75 s with two events of a segment, 40 px apart: a radius of about 10 px. */
    private static Slice slice() {
        EventWindow window = new EventWindow();
        window.give(window.add(300_000, 0, 20, 10, 1), 1, 1);
        window.give(window.add(400_000, 0, 60, 10, 1), 1, 1);
        return new Slice(window, new SensorSize(96, 64), 0, 250_000, 750_000, 0);
    }

    @Test
    public void whatTurnsIsMeasuredAnewEveryFourPxOfTravel() {
        // at 4 rad/s and 10 px it travels 40 px/s: 4 px in 100 ms, and 8 px in 200 ms
        for (int k = 0; k < 10; k++) {
            Motion knot = motion(100_000L * k + 20_000, 0, 40);
            knot.omega = 4;
            path.add(knot);
            Motion between = motion(100_000L * k + 60_000, 0, 40);
            between.omega = 3;
            path.add(between);
        }
        List<Long> measuredUs = new ArrayList<>();
        path.refine(slice(), 1_000_000, (us, sideUs, least) -> {
            measuredUs.add(us);
            assertEquals(200_000, sideUs, 70_000);
            Motion measured = motion(us, 0, 40);
            measured.omega = 4.5;
            return measured;
        });
        assertEquals(260_000, measuredUs.get(0).longValue());
        assertTrue(measuredUs.size() + " in 500 ms", measuredUs.size() >= 4 && measuredUs.size() <= 5);
        path.at(500_000, at);
        assertEquals(4.5, at.omega, EXACT);
        path.at(820_000, at);
        assertEquals("outside of the slice", 4, at.omega, EXACT);
    }

    @Test
    public void whatTurnsBackIsMeasuredAnewByItsGreatestSpeedIfThatHasManyEvents() {
        // it slows down from 80 to 10 px/s in 0.35 s and speeds up again: at 10 px/s 8 px would take 800 ms, in which
        // it was and will be as fast as 80 px/s, at which they take 100 ms
        for (long timeUs = 100_000; timeUs <= 900_000; timeUs += 50_000) {
            path.add(turningBack(timeUs));
        }
        List<Long> few = new ArrayList<>();
        path.refine(slice(), 1_000_000, (us, sideUs, least) -> {
            if (least > 1) {
                assertEquals(100_000, sideUs, 10_000);
                return null;
            }
            few.add(us);
            assertTrue(sideUs + " at " + us, us != 500_000 || sideUs > 600_000);
            return null;
        });
        assertTrue(few.contains(500_000L));
        List<Long> many = new ArrayList<>();
        path.refine(slice(), 1_000_000, (us, sideUs, least) -> {
            many.add(us);
            assertTrue("enough events", least > 1);
            return turningBack(us);
        });
        assertTrue(many.size() + " in 500 ms, about one each 4 px at 80 px/s", many.size() >= 7);
    }

    private static Motion turningBack(long timeUs) {
        Motion motion = motion(timeUs, Math.min(80, 10 + Math.abs(timeUs - 500_000) * 200e-6), 40);
        motion.omega = 0.3;
        return motion;
    }

    @Test
    public void whatOnlyMovesOrCannotBeMeasuredStaysAsItIs() {
        path.add(motion(300_000, 100, 0));
        path.refine(slice(), 1_000_000, (us, sideUs, least) -> {
            throw new AssertionError("it does not turn");
        });
        Motion turning = motion(400_000, 100, 0);
        turning.omega = 5;
        path.add(turning);
        path.refine(slice(), 1_000_000, (us, sideUs, least) -> null);
        path.at(400_000, at);
        assertEquals(5, at.omega, EXACT);
    }

    @Test
    public void knotsAreForgottenThatNoLaterTimeNeeds() {
        assertFalse(path.isMeasured());
        path.add(motion(0, 100, 0));
        path.add(motion(1_000_000, 200, 0));
        path.add(motion(2_000_000, 300, 0));
        path.forget(1_500_000);
        path.at(1_500_000, at);
        assertEquals(250, at.vx, EXACT);
        path.at(500_000, at);
        assertEquals("of before its first knot", 200, at.vx, EXACT);
        path.forget(9_000_000);
        assertTrue(path.isMeasured());
    }

    @Test
    public void knotsThatAreKnownBetterTakeThePlaceOfThoseOfTheirTime() {
        for (int k = 0; k <= 4; k++) {
            path.add(motion(100_000 * k, 100, 10 * k));
        }
        path.replace(100_000, 300_000, List.of(motion(150_000, 50, 15), motion(250_000, 60, 20)));
        path.at(0, at);
        assertEquals(100, at.vx, EXACT);
        path.at(150_000, at);
        assertEquals(50, at.vx, EXACT);
        path.at(200_000, at);
        assertEquals("between the two", 55, at.vx, EXACT);
        path.at(300_000, at);
        assertEquals("that of the time after", 100, at.vx, EXACT);
    }
}
