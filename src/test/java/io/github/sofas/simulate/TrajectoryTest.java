package io.github.sofas.simulate;

import static org.junit.Assert.assertEquals;
import static org.junit.Assert.assertTrue;

import java.util.List;
import java.util.Random;
import org.junit.Test;

public class TrajectoryTest {
    private final Pose pose = new Pose();

    @Test
    public void rotationMovesEachPointAtRightAnglesToItsArm() {
        // One turn in 2 pi s: 1 rad/s, from right to down. The point 10 to the right moves down at 10 px/s,
        // the point 5 below moves left at 5 px/s.
        new Trajectory.Rotation(100, 50, 0.3, 1).poseAt(2, pose);
        assertEquals(0, pose.vxAt(100, 50), 1e-12);
        assertEquals(10, pose.vyAt(110, 50), 1e-12);
        assertEquals(-5, pose.vxAt(100, 55), 1e-12);
        assertEquals(0, pose.vyAt(100, 50), 1e-12);
    }

    @Test
    public void rotationTurnsTheShapeFromRightToDown() {
        // After a quarter turn a box that lay along x stands upright.
        new Trajectory.Rotation(0, 0, 0, Math.PI / 2).poseAt(1, pose);
        Shape bar = new Shape.Box(10, 0, 20, 2);
        assertEquals(-1, pose.distanceTo(bar, 0, 10), 1e-9);
        assertEquals(9, pose.distanceTo(bar, 10, 10), 1e-9);
        assertEquals(9, pose.distanceTo(bar, 10, 5), 1e-9);
        assertEquals(10, pose.distanceTo(bar, 0, -10), 1e-9);
    }

    @Test
    public void wayBackHasTheSamePlacesAndSizesAtRatesOfTheOtherSign() {
        // reached after 4 s: after 2 s twice as large as at first, growing by 0.5 1/s; 10 px off at size 1
        Trajectory near = new Trajectory.Approach(100, 50, 10, 0, 0, 1, 4, 3);
        near.poseAt(2, pose);
        assertEquals(2, pose.scale, 1e-12);
        assertEquals(0.5, pose.growthPerS, 1e-12);
        new Trajectory.Backwards(near, 3).poseAt(1, pose);
        assertEquals(2, pose.scale, 1e-12);
        assertEquals(-0.5, pose.growthPerS, 1e-12);
        assertEquals(120, pose.x, 1e-12);
        assertEquals(-10, pose.vxPxPerS, 1e-12);
        assertEquals(-10 - 5, pose.vxAt(130, 50), 1e-12);
    }

    @Test
    public void cameraThatTurnsSeesTheBordersMoveFaster() {
        // 0.5 rad/s in the middle of the time, with a focal length of 200 px: 100 (1 + x²/f²) and 100 x y / f² px/s
        new CameraPath(200, 120, 90, 1, 0, 100, true, 0, 0, 0, 2).poseAt(1, pose);
        for (int x = -120; x <= 120; x += 60) {
            for (int y = -90; y <= 90; y += 45) {
                assertEquals(100 + 100.0 * x * x / 40_000, pose.vxAt(120 + x, 90 + y), 1e-6);
                assertEquals(100.0 * x * y / 40_000, pose.vyAt(120 + x, 90 + y), 1e-6);
            }
        }
        // after 0.2 rad more, the middle of the wall is at tan 0.2 focal lengths from that of the sensor
        new CameraPath(200, 120, 90, 0, 1, 100, true, 0, 0, 0, 2).poseAt(1.4, pose);
        assertEquals(0, pose.alongX(120, 90 + 200 * Math.tan(0.2)), 1e-9);
        assertEquals(0, pose.alongY(120, 90 + 200 * Math.tan(0.2)), 1e-9);
    }

    @Test
    public void wallThatGoesBackMovesMoreSlowlyThere() {
        // half as far back again for each focal length to the right: 1 - x / (2 f) of the speed at x from the middle
        new CameraPath(200, 120, 90, 0, 1, 100, false, 0.5, 0, 0.6, 2).poseAt(1, pose);
        for (int x = -100; x <= 100; x += 100) {
            assertEquals(0, pose.vxAt(120 + x, 30), 1e-6);
            assertEquals(160 * (1 - x / 400.0), pose.vyAt(120 + x, 30), 1e-5);
        }
    }

    @Test
    public void velocityOfAViewIsThatOfTheWallsPoints() {
        for (CameraPath path : List.of(new CameraPath(208, 119.5, 89.5, 0.6, 0.8, 70, true, 0, 0, 0.6, 2.5),
                new CameraPath(208, 119.5, 89.5, 0.6, -0.8, 70, false, 0.4, -0.3, 0.6, 2.5))) {
            path.poseAt(0.4, pose);
            double vx = pose.vxAt(200, 30);
            double vy = pose.vyAt(200, 30);
            double x = pose.alongX(200, 30);
            double y = pose.alongY(200, 30);
            path.poseAt(0.402, pose);
            assertEquals(x, pose.alongX(200 + 0.002 * vx, 30 + 0.002 * vy), 2e-3);
            assertEquals(y, pose.alongY(200 + 0.002 * vx, 30 + 0.002 * vy), 2e-3);
        }
    }

    @Test
    public void objectSeenFromTheFrontAfterAWallIsOne() {
        new CameraPath(200, 120, 90, 1, 0, 100, true, 0, 0, 0, 2).poseAt(1, pose);
        new Trajectory.Straight(10, 20, 0, 30, 40, 0).poseAt(0, pose);
        assertEquals(30, pose.vxAt(100, 100), 1e-12);
        assertEquals(90, pose.alongX(100, 100), 1e-12);
    }

    @Test
    public void pendulumHasThePapersPeakSpeedAtTheLowestPoint() {
        // sqrt(2 * 9.82 * 0.72 * (1 - cos 23 deg)) = 1.0602 m/s; 200 px/m makes 212.0 px/s.
        Pendulum pendulum = new Pendulum(120, 90, 200, 0);
        pendulum.poseAt(pendulum.periodS() / 4, pose);
        assertEquals(1.0602, Pendulum.peakSpeedMPerS(), 5e-4);
        assertEquals(200 * Pendulum.peakSpeedMPerS(), pose.vxPxPerS, 1e-6);
        assertEquals(0, pose.vyPxPerS, 1e-6);
        assertEquals(120, pose.x, 1e-6);
        assertEquals(90, pose.y, 1e-6);
    }

    @Test
    public void pendulumRestsAtItsGreatestAngle() {
        // L sin 23 deg = 0.72 * 0.39073 = 0.28133 m, 56.27 px left of the lowest point.
        new Pendulum(120, 90, 200, 0).poseAt(0, pose);
        assertEquals(120 - 56.265, pose.x, 1e-3);
        assertEquals(0, pose.vxPxPerS, 1e-6);
    }

    @Test
    public void pendulumsPeriodExceedsTheSmallAngleOneByOnePercent() {
        // 2 pi sqrt(0.72 / 9.82) = 1.70133 s; the series 1 + a^2/16 + 11 a^4/3072 with a = 0.40143 gives 1.01016.
        assertEquals(1.70133 * 1.01016, new Pendulum(0, 0, 200, 0).periodS(), 1e-4);
    }

    @Test
    public void panTurnsRoundInItsMiddle() {
        Trajectory pan = new Trajectory.ThereAndBack(10, 20, 50, 0, 4, 0);
        pan.poseAt(0, pose);
        assertEquals(50, pose.vxPxPerS, 1e-9);
        pan.poseAt(2, pose);
        assertEquals(0, pose.vxPxPerS, 1e-9);
        assertEquals(10 + 50 * 4 / Math.PI, pose.x, 1e-9);
        pan.poseAt(4, pose);
        assertEquals(-50, pose.vxPxPerS, 1e-9);
        assertEquals(10, pose.x, 1e-9);
    }

    @Test
    public void whatIsFixedToABodyGoesAndTurnsWithIt() {
        // a quarter turn after 1 s puts what was 10 px to the right 10 px below, moving left at 10 pi/2 px/s
        Trajectory body = new Trajectory.Rotation(100, 50, 0, Math.PI / 2);
        Trajectory fixed = new Trajectory.Fixed(body, 10, 0, Math.PI / 2);
        fixed.poseAt(1, pose);
        assertEquals(100, pose.x, 1e-9);
        assertEquals(60, pose.y, 1e-9);
        assertEquals(-5 * Math.PI, pose.vxPxPerS, 1e-9);
        assertEquals(0, pose.vyPxPerS, 1e-9);
        assertEquals("half a turn in all", -1, pose.cos, 1e-9);
        assertEquals(Math.PI / 2 * 13, fixed.maxSpeedPxPerS(3), 1e-9);
    }

    @Test
    public void velocityIsTheDerivativeOfPlaceOnEveryTrajectory() {
        List<Trajectory> trajectories = List.of(
                new Trajectory.Straight(5, 6, 1, 58, -20, 0.5),
                new Trajectory.Rotation(5, 6, 0.5, -3),
                new Trajectory.Fixed(new Trajectory.Sway(5, 6, 58, -20, 0.5, 0.2, 0.6, 1.5), 40, -30, 0.5),
                new Trajectory.ThereAndBack(5, 6, 58, -20, 4, 0),
                new Pendulum(120, 90, 373, 0.6),
                new Wander(60, 60, 1, 120, 90, 90, 60, 58, 4, new Random(3)));
        double gap = 1e-6;
        for (Trajectory trajectory : trajectories) {
            for (double time = 0.0123; time < 4; time += 0.3) {
                Pose before = new Pose();
                Pose after = new Pose();
                trajectory.poseAt(time - gap, before);
                trajectory.poseAt(time + gap, after);
                trajectory.poseAt(time, pose);
                assertEquals((after.x - before.x) / (2 * gap), pose.vxPxPerS, 1e-3);
                assertEquals((after.y - before.y) / (2 * gap), pose.vyPxPerS, 1e-3);
                double turned = Math.atan2(before.cos * after.sin - before.sin * after.cos,
                        before.cos * after.cos + before.sin * after.sin);
                assertEquals(turned / (2 * gap), pose.turnRadPerS, 1e-3);
                double speed = Math.hypot(pose.vxAt(pose.x, pose.y + 10), pose.vyAt(pose.x, pose.y + 10));
                assertTrue(speed <= trajectory.maxSpeedPxPerS(10) + 1e-9);
            }
        }
    }

    @Test
    public void wandererStaysInItsBoxAndReverses() {
        Wander wander = new Wander(60, 60, 1, 120, 90, 90, 60, 58, 60, new Random(3));
        int reversals = 0;
        double lastAlong = 1;
        for (double time = 0; time < 60; time += 0.01) {
            wander.poseAt(time, pose);
            // The box and a little more: it needs some px to turn.
            assertTrue(Math.abs(pose.x - 120) < 115 && Math.abs(pose.y - 90) < 85);
            double along = pose.vxPxPerS * pose.cos + pose.vyPxPerS * pose.sin;
            reversals += along * lastAlong < 0 ? 1 : 0;
            lastAlong = along;
        }
        assertTrue("reversals " + reversals, reversals >= 5);
    }

    @Test
    public void paceIsOneThenBendsToItsLast() {
        Trajectory.Pace back = new Trajectory.Pace(-1, 1, 0.5);
        assertEquals(1, back.rate(0.9), 0);
        assertEquals("half way through the bend", 0, back.rate(1.25), 1e-12);
        assertEquals(-1, back.rate(1.5), 1e-12);
        // 1 s forward, the bend cancels itself, 1 s back.
        assertEquals(1, back.travelledS(1.5), 1e-12);
        assertEquals(0, back.travelledS(2.5), 1e-12);
        Trajectory.Pace stop = new Trajectory.Pace(0, 1, 0.5);
        assertEquals("half of the bend's time", 1.25, stop.travelledS(9), 1e-12);
    }

    @Test
    public void approachingDoublesInSizeWhenHalfTheTimeToContactIsOver() {
        Trajectory approach = new Trajectory.Approach(120, 90, 10, 0, 0, 0.5, 4, 3);
        approach.poseAt(0, pose);
        assertEquals(0.25, pose.growthPerS, 1e-12);
        assertEquals(120 + 0.5 * 10, pose.x, 1e-12);
        approach.poseAt(2, pose);
        assertEquals(1, pose.scale, 1e-12);
        assertEquals(0.5, pose.growthPerS, 1e-12);
        // The point 30 px to the right of the line of sight leaves it by half its distance a second.
        assertEquals(15, pose.vxAt(150, 90), 1e-12);
        assertEquals(2, approach.maxScale(), 1e-12);
    }

    @Test
    public void ratesAreDerivativesOfPlaceAngleAndSize() {
        List<Trajectory> trajectories = List.of(new Trajectory.Sway(10, 20, 30, -40, 0.9, 0.35, 0.6, 1.3),
                new Trajectory.Approach(120, 90, 10, -7, 0.4, 0.45, 3.9, 2.8),
                new Trajectory.Journey(50, 60, 1.1, 70, -20, new Trajectory.Pace(-1, 0.8, 0.6), 0.3, 1.7),
                new Trajectory.Journey(50, 60, 1.1, 70, -20, new Trajectory.Pace(0, 0.8, 0.6), 0.3, -1.7));
        double h = 1e-5;
        Pose later = new Pose();
        for (Trajectory trajectory : trajectories) {
            for (double t = 0.05; t < 2.5; t += 0.07) {
                trajectory.poseAt(t - h, pose);
                trajectory.poseAt(t + h, later);
                double vx = (later.x - pose.x) / (2 * h);
                double vy = (later.y - pose.y) / (2 * h);
                double turn = Math.asin(later.sin * pose.cos - later.cos * pose.sin) / (2 * h);
                double growth = Math.log(later.scale / pose.scale) / (2 * h);
                trajectory.poseAt(t, pose);
                assertEquals(vx, pose.vxPxPerS, 1e-4);
                assertEquals(vy, pose.vyPxPerS, 1e-4);
                assertEquals(turn, pose.turnRadPerS, 1e-6);
                assertEquals(growth, pose.growthPerS, 1e-6);
                double speed = Math.hypot(pose.vxAt(pose.x, pose.y + 10), pose.vyAt(pose.x, pose.y + 10));
                assertTrue(speed <= trajectory.maxSpeedPxPerS(10) + 1e-9);
            }
        }
    }
}
