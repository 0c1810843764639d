package io.github.sofas.flow.track;

import static org.junit.Assert.assertEquals;
import static org.junit.Assert.assertFalse;
import static org.junit.Assert.assertTrue;

import io.github.sofas.flow.motion.Motion;
import org.junit.Test;

/** A structure followed by its place. */
public class PlaceTrackTest {
    private static final double EVENTS_A_PX = 72;

    private final Contour contour = new Contour(128, 96, 0.15);
    private final Motion motion = new Motion();
    private final LiveEvents live = new LiveEvents();
    private final StrayEvents strays = new StrayEvents();
    private final Registration registration = new Registration(128, 96);
    private final PlaceTrack place = new PlaceTrack();

    /** An upright frame of 20 x 16 px whose centre is at (x, 40), at a time. */
    private static void frame(double x, long timeUs, LiveEvents events) {
        int left = (int) Math.rint(x) - 10;
        for (int i = 0; i <= 20; i++) {
            events.add(left + i, 32, timeUs, 1, false, false);
            events.add(left + i, 48, timeUs, -1, false, false);
        }
        for (int i = 1; i < 16; i++) {
            events.add(left, 32 + i, timeUs, 1, false, false);
            events.add(left + 20, 32 + i, timeUs, -1, false, false);
        }
    }

    /** The frame at (50, 40) at 0 s, moving right at a speed. */
    private void start(double speed) {
        LiveEvents seen = new LiveEvents();
        frame(50, 0, seen);
        frame(50, 0, seen);
        motion.set(0, speed, 0);
        contour.project(seen, motion);
        motion.moveCentre(contour.centreX(), contour.centreY());
        assertTrue(place.start(contour, 0, 50, 5, 0));
    }

    private void follow(long nowUs) {
        place.follow(motion, live, strays, registration, EVENTS_A_PX, nowUs);
    }

    @Test
    public void staysWithWhatTurnsRound() {
        // thought to go on at 50 px/s, but comes back at 50 px/s from the start: 2.5 px in 50 ms
        start(50);
        for (int i = 1; i <= 10; i++) {
            frame(50 - 0.25 * i, i * 5_000, live);
            follow(i * 5_000);
        }
        assertEquals(50 - 2.5, motion.centreX, 0.7);
        assertEquals(40, motion.centreY, 0.5);
        assertEquals(-50, motion.vx, 25);
    }

    @Test
    public void countsStraysAsItsOwn() {
        start(0);
        for (int i = 0; i <= 20; i++) {
            strays.add(42 + i, 32, 4_000);
            strays.add(42 + i, 48, 4_000);
        }
        for (int i = 1; i < 16; i++) {
            strays.add(42, 32 + i, 4_000);
            strays.add(62, 32 + i, 4_000);
        }
        assertTrue(place.isDue(contour, live, strays, 5_000));
        follow(5_000);
        // shifts within a quarter px fall on the same pixels, and the filter trusts where it was by a tenth
        assertEquals(52, motion.centreX, 0.5);
    }

    @Test
    public void slowsDownWithoutEvents() {
        // it loses its speed v over 2 px, dv/dt = -v² / 2 px: after 0.2 s 50 / (1 + 50 * 0.2 / 2) = 8 px/s are left,
        // and it has gone 2 ln 6 = 3.6 px instead of 10
        start(50);
        for (int i = 1; i <= 10; i++) {
            follow(i * 20_000);
        }
        assertEquals(8, motion.vx, 2);
        assertEquals(53.6, motion.centreX, 1);
    }

    @Test
    public void isDueAfterTwelveEventsOrTwentyMilliseconds() {
        start(0);
        for (int i = 0; i < 11; i++) {
            live.add(40, 35 + i, 1_000, 1, false, false);
        }
        strays.add(90, 90, 1_000);
        assertFalse(place.isDue(contour, live, strays, 5_000));
        strays.add(40, 46, 1_000);
        assertTrue(place.isDue(contour, live, strays, 5_000));
        strays.clear();
        assertFalse(place.isDue(contour, live, strays, 19_999));
        assertTrue(place.isDue(contour, live, strays, 20_000));
    }

    @Test
    public void velocityShowsAfterFourPx() {
        start(50);
        for (int i = 1; i <= 12; i++) {
            frame(50 + 0.5 * i, i * 10_000, live);
            follow(i * 10_000);
            long since = place.movesSince(motion);
            // first followed at 10 ms; 4 px later is 80 ms later
            assertEquals("after " + i, i >= 9, since < Long.MAX_VALUE);
            if (i == 9) {
                assertEquals(10_000, since);
                return;
            }
        }
    }

    @Test
    public void drawnContourTakesEventsOfEitherPolarity() {
        start(0);
        place.draw(contour, motion);
        assertTrue(contour.support(40, 40, 0, 1) >= contour.threshold());
        assertTrue(contour.support(40, 40, 0, -1) >= contour.threshold());
        assertFalse(contour.support(45, 40, 0, 1) >= contour.threshold());
        assertEquals(40, contour.left());
        assertEquals(60, contour.right());
    }
}
