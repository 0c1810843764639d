package io.github.sofas.flow.motion;

import static org.junit.Assert.assertEquals;

import io.github.sofas.flow.motion.PlainMotion.Place;
import org.junit.Test;

public class SteppedProjectionTest {
    private static final double STEP_PX = 1.0 / 16;
    /** What is left out of sine, cosine and exponential at 40 px from the centre, in px. */
    private static final double ROUNDED_PX = 1e-3;

    /** Everything at once: within 0.2 s it turns by up to 0.5 rad and grows by a tenth. */
    private static Motion motion() {
        Motion motion = new Motion();
        motion.set(1_000_000, 120, -40);
        motion.ax = 300;
        motion.ay = 100;
        motion.omega = 1.5;
        motion.alpha = -8;
        motion.growth = 0.5;
        motion.growthChange = 1.5;
        motion.centreX = 80;
        motion.centreY = 60;
        return motion;
    }

    @Test
    public void pointOfATurningBodyIsProjectedAlongItsCircle() {
        // centre (50, 40), 5 rad/s, 0.1 s after the reference: what was at (70, 40) is turned by 0.5 rad, to
        // (50 + 20 * 0.87758, 40 + 20 * 0.47943) = (67.55, 49.59); (68, 50) comes from (50, 40) plus
        // (0.87758 * 18 + 0.47943 * 10, 0.87758 * 10 - 0.47943 * 18)
        Motion motion = new Motion();
        motion.set(0, 0, 0);
        motion.omega = 5;
        motion.centreX = 50;
        motion.centreY = 40;
        SteppedProjection stepped = new SteppedProjection();
        stepped.begin(motion, 100_000, 20, STEP_PX);
        stepped.goTo(100_000);
        assertEquals(70.591, stepped.x(68, 50), ROUNDED_PX);
        assertEquals(40.146, stepped.y(68, 50), ROUNDED_PX);
        // by a change of the rotation of 100 rad/s² from rest, too
        motion.omega = 0;
        motion.alpha = 100;
        stepped.begin(motion, 100_000, 20, STEP_PX);
        stepped.goTo(100_000);
        assertEquals(70.591, stepped.x(68, 50), ROUNDED_PX);
        assertEquals(40.146, stepped.y(68, 50), ROUNDED_PX);
    }

    @Test
    public void pointOfAGrowingBodyIsProjectedTowardsItsCentre() {
        // exp(-0.2) = 0.81873 after 0.1 s at 2 1/s, exp(0.2) = 1.22140 as long before
        Motion motion = new Motion();
        motion.set(0, 0, 0);
        motion.growth = 2;
        motion.centreX = 50;
        motion.centreY = 40;
        SteppedProjection stepped = new SteppedProjection();
        stepped.begin(motion, 100_000, 20, STEP_PX);
        stepped.goTo(100_000);
        assertEquals(50 + 20 * 0.81873, stepped.x(70, 30), ROUNDED_PX);
        assertEquals(40 - 10 * 0.81873, stepped.y(70, 30), ROUNDED_PX);
        stepped.goTo(-100_000);
        assertEquals(50 + 20 * 1.22140, stepped.x(70, 30), ROUNDED_PX);
    }

    @Test
    public void eventsFallWithinHalfAStepOfWhereTheMotionPutsThem() {
        Motion motion = motion();
        SteppedProjection stepped = new SteppedProjection();
        stepped.begin(motion, 200_000, 40, STEP_PX);
        double farthest = 0;
        for (long timeUs = 800_000; timeUs <= 1_000_000; timeUs += 37) {
            // places that stay within 40 px of the centre, which moves by less than 24 px
            int x = 80 - (int) (timeUs / 37 % 15);
            int y = 60 + (int) (timeUs / 37 % 13);
            Place plain = PlainMotion.project(motion, x, y, timeUs);
            stepped.advance(timeUs);
            farthest = Math.max(farthest, plain.distance(stepped.x(x, y), stepped.y(x, y)));
        }
        assertEquals(0, farthest, STEP_PX / 2 + ROUNDED_PX);
    }

    @Test
    public void timeIsReachedExactlyWhereItIsAskedFor() {
        Motion motion = motion();
        SteppedProjection stepped = new SteppedProjection();
        stepped.begin(motion, 200_000, 40, STEP_PX);
        for (long timeUs = 800_000; timeUs <= 1_200_000; timeUs += 9_973) {
            Place plain = PlainMotion.project(motion, 90, 45, timeUs);
            stepped.goTo(timeUs);
            assertEquals(0, plain.distance(stepped.x(90, 45), stepped.y(90, 45)), ROUNDED_PX);
        }
    }

    @Test
    public void eventBeforeTheLastOneBeginsAStepOfItsOwn() {
        Motion motion = motion();
        SteppedProjection stepped = new SteppedProjection();
        stepped.begin(motion, 200_000, 40, STEP_PX);
        stepped.advance(1_000_000);
        stepped.advance(900_000);
        Place plain = PlainMotion.project(motion, 70, 65, 900_000);
        assertEquals(0, plain.distance(stepped.x(70, 65), stepped.y(70, 65)), STEP_PX / 2 + ROUNDED_PX);
    }

    @Test
    public void projectionIsTheSimilarityThatItShows() {
        SteppedProjection stepped = new SteppedProjection();
        stepped.begin(motion(), 200_000, 40, STEP_PX);
        stepped.goTo(900_000);
        assertEquals(stepped.cos() * 70 + stepped.sin() * 30 + stepped.shiftX(), stepped.x(70, 30), 1e-9);
        assertEquals(stepped.cos() * 30 - stepped.sin() * 70 + stepped.shiftY(), stepped.y(70, 30), 1e-9);
        // 0.1 s before, smaller by exp(-0.05 + 0.75 * 0.01), so scaled up by as much
        assertEquals(Math.exp(0.0425), Math.hypot(stepped.cos(), stepped.sin()), 1e-4);
    }

    @Test
    public void whatStandsStillIsProjectedInOneStep() {
        Motion motion = new Motion();
        motion.set(1_000_000, 0, 0);
        SteppedProjection stepped = new SteppedProjection();
        stepped.begin(motion, 500_000, 100, STEP_PX);
        stepped.advance(500_000);
        assertEquals(17, stepped.x(17, 31), 0);
        stepped.advance(1_000_000);
        assertEquals(31, stepped.y(17, 31), 0);
    }

    @Test
    public void wayBackLeadsToTheEvent() {
        SteppedProjection stepped = new SteppedProjection();
        stepped.begin(motion(), 200_000, 40, STEP_PX);
        stepped.advance(860_000);
        double x = stepped.x(70, 50);
        double y = stepped.y(70, 50);
        assertEquals(70, stepped.backX(x, y), 1e-9);
        assertEquals(50, stepped.backY(x, y), 1e-9);
    }
}
