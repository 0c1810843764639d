package io.github.sofas.flow.motion;

import static org.junit.Assert.assertEquals;
import static org.junit.Assert.assertFalse;
import static org.junit.Assert.assertTrue;

import io.github.sofas.flow.motion.PlainMotion.Place;
import org.junit.Test;

/** The motion of the points of a structure, and what stays the same when it is told from elsewhere. */
public class MotionTest {
    /** (30, -10) px/s with its centre at (50, 40), 2 rad/s and 0.5 1/s. */
    private static Motion turningAndGrowing() {
        Motion motion = new Motion();
        motion.set(1_000_000, 30, -10);
        motion.omega = 2;
        motion.growth = 0.5;
        motion.centreX = 50;
        motion.centreY = 40;
        return motion;
    }

    @Test
    public void accelerationCarriesTheVelocityOn() {
        Motion motion = new Motion();
        motion.set(0, 100, -20);
        motion.ax = -50;
        motion.ay = 10;
        assertEquals(90, motion.vxAt(7, 9, 200_000), 1e-4);
        assertEquals(-18, motion.vyAt(7, 9, 200_000), 1e-4);
        motion.moveReference(200_000);
        // 100 * 0.2 - 25 * 0.04, and -20 * 0.2 + 5 * 0.04
        assertEquals(19, motion.centreX, 1e-9);
        assertEquals(-3.8, motion.centreY, 1e-9);
        assertEquals(90, motion.vx, 1e-9);
        assertEquals(-18, motion.vy, 1e-9);
    }

    @Test
    public void accelerationChangesByTheJerkAsTheReferenceMoves() {
        Motion motion = new Motion();
        motion.set(0, 100, 0);
        motion.ax = -50;
        motion.jerkX = 600;
        motion.moveReference(200_000);
        // 100 * 0.2 - 25 * 0.04 + 100 * 0.008; 100 - 50 * 0.2 + 300 * 0.04; -50 + 600 * 0.2
        assertEquals(19.8, motion.centreX, 1e-9);
        assertEquals(102, motion.vx, 1e-9);
        assertEquals(70, motion.ax, 1e-9);
        motion.moveReference(0);
        assertEquals("and back", 0, motion.centreX, 1e-9);
        assertEquals(100, motion.vx, 1e-9);
        motion.hold();
        assertEquals(0, motion.jerkX, 0);
    }

    @Test
    public void rotationChangesAsTheReferenceMoves() {
        Motion motion = new Motion();
        motion.set(0, 0, 0);
        motion.omega = 1;
        motion.alpha = -2;
        motion.alphaChange = 30;
        motion.moveReference(200_000);
        // 1 - 2 * 0.2 + 15 * 0.04; -2 + 30 * 0.2
        assertEquals(1.2, motion.omega, 1e-9);
        assertEquals(4, motion.alpha, 1e-9);
        motion.moveReference(0);
        assertEquals("and back", 1, motion.omega, 1e-9);
        motion.hold();
        assertEquals(0, motion.alphaChange, 0);
    }

    @Test
    public void followsTheReferenceAndThenTheCentreOfAnother() {
        Motion motion = turningAndGrowing();
        motion.ax = 20;
        Motion other = new Motion();
        other.referenceUs = 1_100_000;
        other.centreX = 60;
        other.centreY = 30;
        motion.follow(other);
        assertEquals(1_100_000, motion.referenceUs);
        assertEquals(60, motion.centreX, 0);
        assertEquals(30, motion.centreY, 0);
        // moves to (53.1, 39) and 32 px/s; 6.9 px to the right and 9 above, 2 * 9 of turning and 0.5 * 6.9 of growing
        assertEquals(32 + 18 + 3.45, motion.vx, 1e-9);
        // -10 + 2 * 6.9 - 0.5 * 9
        assertEquals(-0.7, motion.vy, 1e-9);
    }

    @Test
    public void bendsWhereItGainsMoreThanHalfOfItsSpeedInSoManyPx() {
        Motion motion = new Motion();
        motion.set(0, 60, 80);
        // 8 px take 80 ms, in which 625 px/s2 are half of 100 px/s
        motion.ax = 624;
        assertFalse(motion.bendsWithin(8, 7, 9, 0));
        motion.ax = 626;
        assertTrue(motion.bendsWithin(8, 7, 9, 0));
    }

    @Test
    public void pointHasTheCentresVelocityAndItsShareOfRotationAndGrowth() {
        // 20 px right of the centre: 2 rad/s push down by 40 px/s, growth of 0.5 to the right by 10
        Motion motion = turningAndGrowing();
        assertEquals(30 + 10, motion.vxAt(70, 40, 1_000_000), 1e-4);
        assertEquals(-10 + 40, motion.vyAt(70, 40, 1_000_000), 1e-4);
        // 10 px below it: 20 px/s to the left, 5 down
        assertEquals(30 - 20, motion.vxAt(50, 50, 1_000_000), 1e-4);
        assertEquals(-10 + 5, motion.vyAt(50, 50, 1_000_000), 1e-4);
    }

    @Test
    public void pointIsSeenFromWhereTheCentreIsByThen() {
        // after 0.1 s the centre is at (53, 39)
        Motion motion = turningAndGrowing();
        assertEquals(30, motion.vxAt(53, 39, 1_100_000), 1e-4);
        assertEquals(-10, motion.vyAt(53, 39, 1_100_000), 1e-4);
        // and turns by 2 + 0.1 * 5 rad/s: 10 px right of it 25 px/s down
        motion.alpha = 5;
        assertEquals(-10 + 25, motion.vyAt(63, 39, 1_100_000), 1e-4);
        // and grows by 0.5 + 0.1 * 2 1/s: 10 px right of it 7 px/s to the right
        motion.growthChange = 2;
        assertEquals(30 + 7, motion.vxAt(63, 39, 1_100_000), 1e-4);
    }

    @Test
    public void movedReferenceLeavesTheMotionAsItIs() {
        Motion motion = turningAndGrowing();
        motion.alpha = 5;
        motion.growthChange = 0.2;
        Motion moved = new Motion();
        moved.copyFrom(motion);
        moved.moveReference(1_200_000);
        assertEquals(3, moved.omega, 1e-9);
        assertEquals(0.54, moved.growth, 1e-9);
        for (long timeUs = 900_000; timeUs <= 1_300_000; timeUs += 100_000) {
            assertEquals(motion.vxAt(70, 25, timeUs), moved.vxAt(70, 25, timeUs), 1e-4);
            assertEquals(motion.vyAt(70, 25, timeUs), moved.vyAt(70, 25, timeUs), 1e-4);
        }
    }

    @Test
    public void movedCentreTakesTheVelocityThatThePointThereHas() {
        // to (60, 50): 10 px right gives (5, 20) px/s, 10 px down (-20, 5)
        Motion motion = turningAndGrowing();
        motion.moveCentre(60, 50);
        assertEquals(30 + 5 - 20, motion.vx, 1e-9);
        assertEquals(-10 + 20 + 5, motion.vy, 1e-9);
        assertEquals(60, motion.centreX, 0);
        assertEquals(50, motion.centreY, 0);
    }

    @Test
    public void movedCentreIsSpedUpAsTheRotationAndTheGrowthAreThere() {
        // 10 px right of it 5 rad/s² push down by 50 px/s² and 2 1/s² to the right by 20; 10 px below it, left and down
        Motion motion = turningAndGrowing();
        motion.ax = 7;
        motion.ay = -3;
        motion.alpha = 5;
        motion.growthChange = 2;
        motion.moveCentre(60, 50);
        assertEquals(7 + 20 - 50, motion.ax, 1e-9);
        assertEquals(-3 + 50 + 20, motion.ay, 1e-9);
    }

    private static void assertEveryPointMovesAlike(Motion motion, Motion moved) {
        for (int x = 0; x < 100; x += 33) {
            for (int y = 0; y < 100; y += 33) {
                assertEquals(motion.vxAt(x, y, 1_000_000), moved.vxAt(x, y, 1_000_000), 1e-4);
                assertEquals(motion.vyAt(x, y, 1_000_000), moved.vyAt(x, y, 1_000_000), 1e-4);
            }
        }
    }

    @Test
    public void movedCentreLeavesTheVelocityOfEveryPointAsItIs() {
        Motion motion = turningAndGrowing();
        Motion moved = turningAndGrowing();
        moved.moveCentre(-13, 71);
        assertEveryPointMovesAlike(motion, moved);
    }

    @Test
    public void movedCentreLeavesTheVelocityOfEveryPointOfAPlaneAsItIs() {
        Motion motion = turningAndGrowing();
        motion.deformation.stretch = 0.2;
        motion.deformation.shear = -0.3;
        motion.deformation.perspectiveX = 0.004;
        motion.deformation.perspectiveY = -0.003;
        Motion moved = new Motion();
        moved.copyFrom(motion);
        moved.moveCentre(-13, 71);
        assertEveryPointMovesAlike(motion, moved);
    }

    @Test
    public void speedOfWhatIsDeformedIsThatOfFourPointsOfIt() {
        Motion motion = turningAndGrowing();
        motion.deformation.stretch = 1.2;
        motion.deformation.shear = -0.7;
        double squares = 0;
        for (int[] r : new int[][] {{4, 0}, {-4, 0}, {0, 4}, {0, -4}}) {
            squares += Math.pow(motion.vxAt(50 + r[0], 40 + r[1], 1_000_000), 2)
                + Math.pow(motion.vyAt(50 + r[0], 40 + r[1], 1_000_000), 2);
        }
        assertEquals(Math.sqrt(squares / 4), motion.speed(4), 1e-4);
    }

    @Test
    public void speedIsTheRootOfTheMeanSquareOverTheStructure() {
        // 30² + 10² of the centre, (2² + 0.5²) 4² of points 4 px from it
        assertEquals(Math.sqrt(1000 + 4.25 * 16), turningAndGrowing().speed(4), 1e-9);
        // the same by the velocities of four such points
        double squares = 0;
        for (int[] r : new int[][] {{4, 0}, {-4, 0}, {0, 4}, {0, -4}}) {
            double vx = turningAndGrowing().vxAt(50 + r[0], 40 + r[1], 1_000_000);
            double vy = turningAndGrowing().vyAt(50 + r[0], 40 + r[1], 1_000_000);
            squares += vx * vx + vy * vy;
        }
        assertEquals(Math.sqrt(squares / 4), turningAndGrowing().speed(4), 1e-4);
    }

    @Test
    public void speedFromAnotherMotionIsThatOfTheirDifferenceOverTheStructure() {
        Motion motion = turningAndGrowing();
        Motion other = new Motion();
        other.set(1_000_000, 12, 7);
        other.omega = -1;
        other.growth = 0.2;
        other.centreX = 60;
        other.centreY = 25;
        // by the velocities of four points 4 px from the centre of the first
        double squares = 0;
        for (int[] r : new int[][] {{4, 0}, {-4, 0}, {0, 4}, {0, -4}}) {
            double vx = motion.vxAt(50 + r[0], 40 + r[1], 1_000_000) - other.vxAt(50 + r[0], 40 + r[1], 1_000_000);
            double vy = motion.vyAt(50 + r[0], 40 + r[1], 1_000_000) - other.vyAt(50 + r[0], 40 + r[1], 1_000_000);
            squares += vx * vx + vy * vy;
        }
        assertEquals(Math.sqrt(squares / 4), motion.speedFrom(other, 4), 1e-4);
        // the same motion told of another centre
        other.copyFrom(motion);
        other.moveCentre(-13, 71);
        assertEquals(0, motion.speedFrom(other, 4), 1e-9);
    }

    @Test
    public void newVelocityEndsEveryChangeAndLeavesTheCentre() {
        Motion motion = turningAndGrowing();
        motion.ax = 1;
        motion.ay = 2;
        motion.alpha = 3;
        motion.set(5, 1, 2);
        assertEquals(5, motion.referenceUs);
        assertEquals(1, motion.vxAt(90, 90, 1_000_005), 0);
        assertEquals(2, motion.vyAt(90, 90, 1_000_005), 0);
        assertEquals(50, motion.centreX, 0);
    }

    @Test
    public void noPointIsFasterThanTheMostThatItsSpeedMayBe() {
        Motion motion = turningAndGrowing();
        motion.ax = 200;
        motion.alpha = -3;
        motion.growthChange = 2;
        for (long fromUs : new long[] {900_000, 1_000_000, 1_150_000}) {
            Place before = PlainMotion.at(motion, 80, 60, fromUs);
            double most = motion.mostSpeed(before.x(), before.y(), fromUs, fromUs + 20_000);
            for (long timeUs = fromUs + 1_000; timeUs <= fromUs + 20_000; timeUs += 1_000) {
                Place now = PlainMotion.at(motion, 80, 60, timeUs);
                double speed = now.distance(before.x(), before.y()) / 1e-3;
                assertTrue(speed + " of " + most, speed <= most);
                before = now;
            }
        }
        // 30 px/s and -10 px/s, and nothing else
        motion.set(1_000_000, 30, -10);
        assertEquals(Math.sqrt(1000), motion.mostSpeed(80, 60, 900_000, 1_200_000), 1e-9);
    }
}
