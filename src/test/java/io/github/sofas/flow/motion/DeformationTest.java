package io.github.sofas.flow.motion;

import static org.junit.Assert.assertEquals;
import static org.junit.Assert.assertFalse;
import static org.junit.Assert.assertTrue;

import org.junit.Test;

/** What the flow of a plane adds to a velocity, rotation and growth. */
public class DeformationTest {
    private static final double TINY = 1e-12;

    private static Deformation deformation(double stretch, double shear, double perspectiveX, double perspectiveY) {
        Deformation deformation = new Deformation();
        deformation.stretch = stretch;
        deformation.shear = shear;
        deformation.perspectiveX = perspectiveX;
        deformation.perspectiveY = perspectiveY;
        return deformation;
    }

    @Test
    public void stretchDrawsApartAlongOneAxisAndTogetherAlongTheOther() {
        Deformation stretch = deformation(0.5, 0, 0, 0);
        assertEquals(5, stretch.vx(10, 4), TINY);
        assertEquals(-2, stretch.vy(10, 4), TINY);
    }

    @Test
    public void shearDoesTheSameAlongTheDiagonals() {
        Deformation shear = deformation(0, 0.5, 0, 0);
        // (3, 3) is drawn apart, (3, -3) together
        assertEquals(1.5, shear.vx(3, 3), TINY);
        assertEquals(1.5, shear.vy(3, 3), TINY);
        assertEquals(-1.5, shear.vx(3, -3), TINY);
        assertEquals(1.5, shear.vy(3, -3), TINY);
    }

    @Test
    public void perspectiveIsThatOfACameraThatTurns() {
        // 0.4 rad/s about the vertical axis with a focal length of 200 px: 80 (1 + x²/f²) px/s and 80 x y / f²
        Deformation perspective = deformation(0, 0, 80.0 / 40_000, 0);
        for (int x = -120; x <= 120; x += 60) {
            for (int y = -90; y <= 90; y += 45) {
                assertEquals(80.0 * x * x / 40_000, perspective.vx(x, y), TINY);
                assertEquals(80.0 * x * y / 40_000, perspective.vy(x, y), TINY);
            }
        }
    }

    @Test
    public void isAsManyTimesAnotherAsTheWeightSays() {
        Deformation sum = deformation(1, 2, 3, 4);
        sum.multiply(0.5);
        sum.add(deformation(2, 4, 6, 8), 0.25);
        assertEquals(1, sum.stretch, TINY);
        assertEquals(2, sum.shear, TINY);
        assertEquals(3, sum.perspectiveX, TINY);
        assertEquals(4, sum.perspectiveY, TINY);
        assertFalse(sum.isNone());
        sum.clear();
        assertTrue(sum.isNone());
    }

    @Test
    public void noPointIsFasterThanItSays() {
        Deformation all = deformation(0.3, -0.4, 0.002, 0.001);
        // 0.5 1/s at 20 px, and the square of 20 times 0.002236
        assertEquals(10 + 400 * Math.sqrt(5e-6), all.mostSpeed(20), TINY);
        for (double angle = 0; angle < 6.3; angle += 0.1) {
            double x = 20 * Math.cos(angle);
            double y = 20 * Math.sin(angle);
            assertTrue(Math.hypot(all.vx(x, y), all.vy(x, y)) <= all.mostSpeed(20));
        }
    }
}
