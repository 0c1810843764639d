package io.github.sofas.flow.smooth;

import static org.junit.Assert.assertEquals;

import io.github.sofas.flow.motion.Motion;
import org.junit.Test;

/** Steps of 4 ms, from 0 s to 400 ms, each with the way from its middle. */
public class PathProjectionTest {
    private static final int STEPS = 100;
    private static final double PER_US = 1.0 / 4000;
    private static final long REFERENCE_US = 200_000;

    private final SegmentPath path = new SegmentPath(1);
    private final PathProjection projection = new PathProjection();

    private static Motion motion(long us, double vx) {
        Motion motion = new Motion();
        motion.set(us, vx, 0);
        return motion;
    }

    private void begin() {
        projection.begin(path, REFERENCE_US, 0, PER_US, STEPS);
    }

    private double x(int step, int x, int y) {
        projection.goTo(step);
        return projection.x(x, y);
    }

    private double y(int step, int x, int y) {
        projection.goTo(step);
        return projection.y(x, y);
    }

    @Test
    public void stepsHaveTheTimesOfTheirMiddles() {
        path.add(motion(0, 100));
        begin();
        assertEquals(0, projection.step(0));
        assertEquals(0, projection.step(3_999));
        assertEquals(1, projection.step(4_000));
        assertEquals(STEPS - 1, projection.step(10_000_000));
        // step 0 is at 2 ms, 198 ms before the reference: 19.8 px; step 99 at 398 ms
        assertEquals(30 + 19.8, x(0, 30, 7), 1e-9);
        assertEquals(7, y(0, 30, 7), 1e-9);
        assertEquals(30 - 19.8, x(99, 30, 7), 1e-9);
    }

    @Test
    public void eventsOfAStepAreThoseBeforeTheNextOne() {
        path.add(motion(0, 100));
        projection.begin(path, REFERENCE_US, 0, 3.0 / 10_007, STEPS);
        for (int step = 0; step < STEPS - 1; step++) {
            long untilUs = projection.untilUs(step);
            assertEquals(step, projection.step(untilUs - 1));
            assertEquals(step + 1, projection.step(untilUs));
        }
        assertEquals(STEPS - 1, projection.step(projection.untilUs(STEPS - 1)));
    }

    @Test
    public void wayIsThatOfThePathHoweverItBends() {
        // 0 px/s until 100 ms, then evenly to 100 px/s at 200 ms, then evenly to 0 at 300 ms
        path.add(motion(0, 0));
        path.add(motion(100_000, 0));
        path.add(motion(200_000, 100));
        path.add(motion(300_000, 0));
        begin();
        // 5 px on either side, all of them within 100 ms; one acceleration has as much on both sides of what is as far
        assertEquals(5, x(0, 0, 0), 0.01);
        assertEquals(-5, x(99, 0, 0), 0.01);
    }

    @Test
    public void turningAndGrowingGoOnAboutTheCentre() {
        Motion turning = motion(REFERENCE_US, 0);
        turning.centreX = 50;
        turning.centreY = 40;
        turning.omega = Math.PI / 2 / 0.198;
        turning.growth = Math.log(2) / 0.198;
        path.add(turning);
        begin();
        // within 198 ms a quarter turn, which takes right to down, and twice the size
        assertEquals(50, x(0, 60, 40), 1e-6);
        assertEquals(60, y(0, 60, 40), 1e-6);
        // backwards down to right, and half of it
        assertEquals(55, x(99, 50, 50), 1e-6);
        assertEquals(40, y(99, 50, 50), 1e-6);
    }

    @Test
    public void whatIsTakenToTheReferenceCanBeTakenBack() {
        Motion turning = motion(REFERENCE_US, 80);
        turning.omega = 2;
        turning.growth = 0.5;
        path.add(turning);
        begin();
        double x = x(17, 33, 44);
        double y = y(17, 33, 44);
        assertEquals(33, projection.backX(x, y), 1e-9);
        assertEquals(44, projection.backY(x, y), 1e-9);
    }
}
