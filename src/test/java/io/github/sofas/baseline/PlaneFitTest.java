package io.github.sofas.baseline;

import static org.junit.Assert.assertEquals;
import static org.junit.Assert.assertFalse;
import static org.junit.Assert.assertTrue;

import org.junit.Test;

public class PlaneFitTest {
    private final PlaneFit fit = new PlaneFit(52);

    private void addPlane(double gx, double gy, double at0) {
        for (int y = -3; y <= 3; y++) {
            for (int x = -3; x <= 3; x++) {
                fit.add(x, y, gx * x + gy * y + at0);
            }
        }
    }

    private void assertPlane(double gx, double gy, double at0) {
        double[] plane = fit.plane();
        assertEquals(gx, -plane[0] / plane[2], 1e-12);
        assertEquals(gy, -plane[1] / plane[2], 1e-12);
        assertEquals(at0, -plane[3] / plane[2], 1e-12);
        assertEquals(1, Math.hypot(Math.hypot(plane[0], plane[1]), Math.hypot(plane[2], plane[3])), 1e-12);
    }

    @Test
    public void findsAPlaneExactly() {
        addPlane(0.016, -0.012, 0.3);
        fit.fit();
        assertPlane(0.016, -0.012, 0.3);
    }

    @Test
    public void findsAFlatPlaneAndASteepOne() {
        addPlane(0, 0, 0);
        fit.fit();
        assertPlane(0, 0, 0);
        fit.clear();
        addPlane(5, 0.25, -2);
        fit.fit();
        assertPlane(5, 0.25, -2);
    }

    @Test
    public void aSecondFitToTheSamePointsDoesNotMove() {
        addPlane(0.016, -0.012, 0.3);
        fit.fit();
        assertEquals(0, fit.fit(), 1e-14);
    }

    @Test
    public void dropsOnlyPointsFartherThanTheDistance() {
        addPlane(0, 0, 0);
        fit.fit();
        assertFalse(fit.dropFartherThan(1e-9));
        fit.add(0, 0, 0.1);
        fit.add(0, 0, -0.1);
        fit.add(0, 0, 0.05);
        assertTrue(fit.dropFartherThan(0.06));
        assertEquals(50, fit.size());
    }
}
