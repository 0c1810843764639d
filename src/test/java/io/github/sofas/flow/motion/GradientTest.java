package io.github.sofas.flow.motion;

import static org.junit.Assert.assertEquals;

import org.junit.Test;

/** What a flow makes of the px beside its centre in a time. */
public class GradientTest {
    private static final double TINY = 1e-12;

    private final Motion motion = new Motion();
    private final Gradient gradient = new Gradient();

    @Test
    public void aQuarterTurnTakesRightToDown() {
        motion.omega = Math.PI;
        gradient.take(motion, 0.5);
        assertEquals(0, gradient.x(1, 0), TINY);
        assertEquals(1, gradient.y(1, 0), TINY);
        assertEquals(-1, gradient.x(0, 1), TINY);
        assertEquals(0, gradient.y(0, 1), TINY);
    }

    @Test
    public void stretchAndGrowthAreExponentials() {
        motion.growth = 0.2;
        motion.deformation.stretch = 0.3;
        gradient.take(motion, 2);
        assertEquals(Math.exp(1), gradient.x(1, 0), TINY);
        assertEquals(Math.exp(-0.2), gradient.y(0, 1), TINY);
        assertEquals(0, gradient.y(1, 0), TINY);
    }

    @Test
    public void rotationAndShearThatCancelSlide() {
        // a wall seen at a slant from the side: below, it moves faster
        motion.omega = -0.25;
        motion.deformation.shear = 0.25;
        gradient.take(motion, 2);
        assertEquals(1, gradient.x(0, 1), TINY);
        assertEquals(1, gradient.y(0, 1), TINY);
        assertEquals(0, gradient.y(1, 0), TINY);
    }

    @Test
    public void isThatOfManyShortSteps() {
        motion.omega = 1.5;
        motion.growth = -0.4;
        motion.deformation.stretch = 0.7;
        motion.deformation.shear = -0.9;
        gradient.takeFirstOrder(motion, 1e-5);
        double x = 3;
        double y = -2;
        for (int i = 0; i < 100_000; i++) {
            double dx = gradient.x(x, y);
            y += gradient.y(x, y);
            x += dx;
        }
        gradient.take(motion, 1);
        assertEquals(x, gradient.x(3, -2), 1e-4);
        assertEquals(y, gradient.y(3, -2), 1e-4);
    }

    @Test
    public void isUndoneByTheSameTimeBack() {
        motion.omega = 0.3;
        motion.growth = 0.1;
        motion.deformation.shear = 0.5;
        gradient.take(motion, 0.7);
        double x = gradient.x(5, 8);
        double y = gradient.y(5, 8);
        gradient.take(motion, -0.7);
        assertEquals(5, gradient.x(x, y), 1e-9);
        assertEquals(8, gradient.y(x, y), 1e-9);
    }
}
