package io.github.sofas.flow.smooth;

import static org.junit.Assert.assertEquals;

import io.github.sofas.event.SensorSize;
import org.junit.Test;

public class PictureTest {
    private static final SensorSize SENSOR = new SensorSize(64, 48);
    private static final double EXACT = 1e-9;

    /** The outline of a square of 11 x 11 px. */
    private static Picture square(double left, double top) {
        Picture picture = new Picture(SENSOR);
        for (int i = 0; i < 10; i++) {
            picture.add(left + i, top);
            picture.add(left + 10, top + i);
            picture.add(left + 10 - i, top + 10);
            picture.add(left, top + 10 - i);
        }
        return picture;
    }

    @Test
    public void sameContoursAgreeWhereverTheyLie() {
        assertEquals(1, square(10, 10).agreement(square(40.3, 20.8)), EXACT);
        assertEquals("half outside of the sensor", 1, square(10, 10).agreement(square(-4, 10)), 0.35);
    }

    @Test
    public void aPartOfAContourAgreesAsFarAsItReaches() {
        // of the square 11 events are on the upper side; 4 more are within a px of it where it lies a px lower
        Picture side = new Picture(SENSOR);
        for (int i = 0; i <= 10; i++) {
            side.add(10 + i, 10);
        }
        assertEquals(15 / 40.0, side.agreement(square(10, 10)), EXACT);
    }

    @Test
    public void thicknessIsTheSpreadAcross() {
        // 0 to 10 along a line at 45 degrees, and 1 px apart across it: half a px to either side
        Picture line = new Picture(SENSOR);
        double across = Math.sqrt(0.125);
        for (int i = 0; i <= 10; i++) {
            line.add(10 + i + across, 10 + i - across);
            line.add(10 + i - across, 10 + i + across);
        }
        assertEquals(0.5, line.thickness(), 1e-6);
        assertEquals(15, line.middleX(), EXACT);
    }

    @Test
    public void clearedPictureIsAsNew() {
        Picture used = square(10, 10);
        used.clear();
        for (int i = 0; i < 5; i++) {
            used.add(30 + i, 30);
        }
        Picture fresh = new Picture(SENSOR);
        for (int i = 0; i < 5; i++) {
            fresh.add(30 + i, 30);
        }
        assertEquals(5, used.events());
        assertEquals(fresh.agreement(square(20, 20)), used.agreement(square(20, 20)), EXACT);
        assertEquals(square(20, 20).agreement(fresh), square(20, 20).agreement(used), EXACT);
    }
}
