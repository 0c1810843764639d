package io.github.sofas.flow.track;

import static org.junit.Assert.assertEquals;
import static org.junit.Assert.assertFalse;
import static org.junit.Assert.assertTrue;

import java.util.Random;
import org.junit.Test;

/** A contour laid on events. */
public class RegistrationTest {
    private static final double RADIUS = 12;

    /** An upright frame of 20 x 16 px about (50, 40). */
    private static Registration frame() {
        Registration registration = new Registration(128, 96);
        registration.start(50, 40);
        outline(registration::addContour, 0, 0, 0);
        return registration;
    }

    private interface Points {
        void add(double x, double y);
    }

    /** The frame shifted by (dx, dy) and turned by an angle. */
    private static void outline(Points points, double dx, double dy, double angle) {
        for (int i = -10; i <= 10; i++) {
            corner(points, i, -8, dx, dy, angle);
            corner(points, i, 8, dx, dy, angle);
        }
        for (int i = -7; i <= 7; i++) {
            corner(points, -10, i, dx, dy, angle);
            corner(points, 10, i, dx, dy, angle);
        }
    }

    private static void corner(Points points, double x, double y, double dx, double dy, double angle) {
        points.add(50 + dx + Math.cos(angle) * x - Math.sin(angle) * y,
            40 + dy + Math.sin(angle) * x + Math.cos(angle) * y);
    }

    @Test
    public void findsTheShiftToItsEvents() {
        Registration registration = frame();
        outline(registration::addEvent, 2, -1, 0);
        assertTrue(registration.fit(RADIUS));
        // what is up to half a px less falls on the same pixels
        assertEquals(2, registration.shiftX(), 0.5);
        assertEquals(-1, registration.shiftY(), 0.5);
        assertEquals(0, registration.turn(), 0);
        // all 72 events lie on the contour, 4 px near; across it 4 + 2 (3 + 2 + 1) = 16 px over a box of 29 x 25 cells,
        // 72 * 16 / 725 = 1.6 px, is what one at random would be
        assertEquals(72 * (4 - 1.6) / 4, registration.agreement(), 2);
    }

    @Test
    public void findsTheTurnToItsEvents() {
        // the corners, 13 px from the centre, move by 2 px
        Registration registration = frame();
        outline(registration::addEvent, 0, 0, 0.15);
        assertTrue(registration.fit(RADIUS));
        assertEquals(0.15, registration.turn(), 0.05);
        assertEquals(0, registration.shiftX(), 0.5);
        assertEquals(0, registration.shiftY(), 0.5);
    }

    @Test
    public void fewEventsMoveItLittle() {
        // four events 3 px right of the right edge: a px nearer gives 4, and costs the square of the shift: 2 px
        Registration registration = frame();
        for (int i = 0; i < 4; i++) {
            registration.addEvent(63, 38 + i);
        }
        registration.fit(RADIUS);
        assertEquals(2, registration.shiftX(), 0.5);
        assertEquals(0, registration.shiftY(), 0);
    }

    @Test
    public void fewerThanFourEventsShowNothing() {
        Registration registration = frame();
        registration.addEvent(60, 40);
        registration.addEvent(60, 41);
        registration.addEvent(60, 42);
        assertFalse(registration.fit(RADIUS));
        assertEquals(0, registration.agreement(), 0);
    }

    @Test
    public void contourFarFromAllEventsStaysWhereItIs() {
        Registration registration = frame();
        for (int i = 0; i < 50; i++) {
            registration.addEvent(100, 40);
        }
        assertEquals(0, registration.size());
        assertFalse(registration.fit(RADIUS));
        assertEquals(0, registration.shiftX(), 0);
    }

    @Test
    public void noiseAgreesSeldom() {
        // one try in forty may pass two standard deviations, and a few more for having been moved to fit
        Random random = new Random(1);
        int agree = 0;
        for (int n = 0; n < 200; n++) {
            Registration registration = frame();
            for (int i = 0; i < 12; i++) {
                registration.addEvent(36 + random.nextInt(29), 28 + random.nextInt(25));
            }
            agree += registration.fit(RADIUS) ? 1 : 0;
        }
        assertTrue(agree + " of 200", agree < 140);
    }

    @Test
    public void startForgetsContourAndEvents() {
        Registration registration = frame();
        outline(registration::addEvent, 2, -1, 0);
        registration.start(50, 40);
        registration.addContour(20, 20);
        outline(registration::addEvent, 0, 0, 0);
        assertEquals(0, registration.size());
    }
}
