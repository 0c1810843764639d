package io.github.sofas.flow.track;

import static org.junit.Assert.assertEquals;
import static org.junit.Assert.assertFalse;
import static org.junit.Assert.assertTrue;

import io.github.sofas.flow.motion.Motion;
import io.github.sofas.flow.motion.PlainMotion;
import io.github.sofas.flow.motion.PlainMotion.Place;
import org.junit.Test;

/** Coordinates that go with a structure: a place of it keeps its coordinates. */
public class FrameTest {
    private static final double RADIUS_PX = 20;
    /** What sine, cosine and exponential of a step leave out at 20 px. */
    private static final double ROUNDED_PX = 1e-3;

    private final Frame frame = new Frame();

    private static Motion motion(double vx, double vy, double omega, double growth) {
        Motion motion = new Motion();
        motion.set(1_000_000, vx, vy);
        motion.omega = omega;
        motion.growth = growth;
        motion.centreX = 60;
        motion.centreY = 40;
        return motion;
    }

    /** The same motion with a later reference. */
    private static Motion later(Motion motion, long timeUs) {
        Motion moved = new Motion();
        moved.copyFrom(motion);
        moved.moveReference(timeUs);
        return moved;
    }

    /** Follows a motion in steps of 20 ms for 0.2 s. */
    private void followed(Motion motion) {
        frame.anchor(motion, RADIUS_PX);
        for (long timeUs = 1_020_000; timeUs <= 1_200_000; timeUs += 20_000) {
            frame.follow(later(motion, timeUs), RADIUS_PX);
        }
    }

    /** Where a place of the structure is after 0.2 s must have the coordinates that it had at first. */
    private void assertKeepsItsPlaces(Motion motion, double tolerance) {
        followed(motion);
        for (double[] place : new double[][] {{60, 40}, {80, 40}, {55, 20}, {45.5, 53.25}}) {
            Place now = PlainMotion.at(motion, place[0], place[1], 1_200_000);
            assertEquals(place[0], frame.fromReferenceX(now.x(), now.y()), tolerance);
            assertEquals(place[1], frame.fromReferenceY(now.x(), now.y()), tolerance);
            assertEquals(now.x(), frame.toReferenceX(place[0], place[1]), tolerance);
            assertEquals(now.y(), frame.toReferenceY(place[0], place[1]), tolerance);
        }
    }

    @Test
    public void anchoredFrameIsTheSensor() {
        Motion motion = motion(100, -50, 2, 0.5);
        frame.anchor(motion, RADIUS_PX);
        assertEquals(13, frame.fromReferenceX(13, 29), 0);
        assertEquals(29, frame.fromReferenceY(13, 29), 0);
        assertEquals(0, frame.departurePx(13, 29), 0);
        assertTrue(frame.isOnlyShifted());
    }

    @Test
    public void placesKeepTheirCoordinatesWhileTheStructureTravels() {
        // to the rounding of the sums, not of any step
        assertKeepsItsPlaces(motion(120, -70, 0, 0), 1e-9);
        assertTrue(frame.isOnlyShifted());
        // 24 px to the right, 14 up
        assertEquals(Math.hypot(24, 14), frame.departurePx(50, 50), 1e-9);
        assertEquals(-24, frame.shiftX(), 1e-9);
        assertEquals(14, frame.shiftY(), 1e-9);
    }

    @Test
    public void placesKeepTheirCoordinatesWhileTheStructureTurns() {
        assertKeepsItsPlaces(motion(0, 0, 4, 0), ROUNDED_PX);
        assertFalse(frame.isOnlyShifted());
        // by 0.8 rad: the centre stays, 20 px from it the chord is 40 sin(0.4)
        assertEquals(0, frame.departurePx(60, 40), ROUNDED_PX);
        assertEquals(40 * Math.sin(0.4), frame.departurePx(80, 40), ROUNDED_PX);
    }

    @Test
    public void placesKeepTheirCoordinatesWhileTheStructureGrows() {
        assertKeepsItsPlaces(motion(0, 0, 0, 1.5), ROUNDED_PX);
        assertFalse(frame.isOnlyShifted());
        // what is 20 px from the centre now was there at 20 exp(-0.3)
        assertEquals(20 - 20 * Math.exp(-0.3), frame.departurePx(80, 40), ROUNDED_PX);
    }

    @Test
    public void placesKeepTheirCoordinatesUnderAllOfThese() {
        Motion motion = motion(120, -70, 4, -1);
        motion.ax = 200;
        motion.ay = 90;
        motion.alpha = -6;
        assertKeepsItsPlaces(motion, ROUNDED_PX);
    }

    @Test
    public void eventsHaveTheCoordinatesOfTheirPlaces() {
        Motion motion = motion(120, -70, 2, 0.5);
        followed(motion);
        for (long timeUs = 1_200_000; timeUs < 1_240_000; timeUs += 977) {
            Place place = PlainMotion.project(motion, 95, 22, timeUs);
            frame.advance(timeUs);
            // half a step of a sixteenth of a pixel, in coordinates that are smaller than the sensor by now
            assertEquals(place.x(), frame.x(95, 22), 1.0 / 32 + ROUNDED_PX);
            assertEquals(place.y(), frame.y(95, 22), 1.0 / 32 + ROUNDED_PX);
            assertEquals(95, frame.sensorX(frame.x(95, 22), frame.y(95, 22)), ROUNDED_PX);
            assertEquals(22, frame.sensorY(frame.x(95, 22), frame.y(95, 22)), ROUNDED_PX);
        }
    }

    @Test
    public void eventsGoWhereTheFrameIsShifted() {
        frame.anchor(motion(0, 0, 0, 0), RADIUS_PX);
        frame.advance(1_000_000);
        frame.shift(-3, 2);
        frame.advance(1_000_000);
        assertEquals(10, frame.x(13, 29), 0);
        assertEquals(31, frame.y(13, 29), 0);
    }

    @Test
    public void betterKnownMotionLeavesPlacesWhereTheyAre() {
        // 0.1 s along (100, 0), then along (0, 80): (60, 40) goes to (70, 40), and from there to (70, 48)
        frame.anchor(motion(100, 0, 0, 0), RADIUS_PX);
        Motion other = motion(0, 80, 0, 0);
        other.referenceUs = 1_100_000;
        frame.follow(other, RADIUS_PX);
        assertEquals(60, frame.fromReferenceX(70, 40), 1e-9);
        frame.follow(later(other, 1_200_000), RADIUS_PX);
        assertEquals(60, frame.fromReferenceX(70, 48), 1e-9);
        assertEquals(40, frame.fromReferenceY(70, 48), 1e-9);
    }

    @Test
    public void frameAnchoredAgainIsTheSensorAtTheReference() {
        Motion motion = motion(120, -70, 4, 1);
        followed(motion);
        frame.anchorAgain();
        assertTrue(frame.isOnlyShifted());
        assertEquals(0, frame.departurePx(33, 44), 0);
        assertEquals(1_200_000, frame.motion().referenceUs);
        // and goes on along the motion
        frame.follow(later(motion, 1_240_000), RADIUS_PX);
        Place at = PlainMotion.at(later(motion, 1_200_000), 70, 30, 1_240_000);
        assertEquals(70, frame.fromReferenceX(at.x(), at.y()), ROUNDED_PX);
        assertEquals(30, frame.fromReferenceY(at.x(), at.y()), ROUNDED_PX);
    }

    @Test
    public void shiftByWholePixelsMovesTheCoordinates() {
        followed(motion(120, -70, 0, 0));
        frame.shift(24, -14);
        assertEquals(0, frame.departurePx(50, 50), 1e-9);
    }
}
