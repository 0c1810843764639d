package io.github.sofas.flow.track;

import static org.junit.Assert.assertEquals;
import static org.junit.Assert.assertFalse;
import static org.junit.Assert.assertTrue;

import io.github.sofas.event.SensorSize;
import io.github.sofas.flow.motion.Motion;
import org.junit.Test;

/** Contour and memory of one structure, at (60, 40), together. */
public class OutlineTest {
    private static final SensorSize SENSOR = new SensorSize(128, 96);
    /** A sixteenth has 10 ms. */
    private static final long LIFETIME_US = 160_000;
    /** Events of noise of a pixel per µs of which 2 lie on nine cells after 40 ms, a quarter of the lifetime. */
    private static final double MUCH_NOISE = 2.0 / (9 * 40_000);

    private final Outline outline = new Outline(SENSOR, new Contour.Spare(SENSOR), 64);
    private final Motion motion = new Motion();

    private void start(double vx) {
        motion.set(0, vx, 0);
        motion.centreX = 60;
        motion.centreY = 40;
        outline.start(motion, 0);
        outline.remember(motion);
    }

    /** A block of 3 x 3 events of time 0, of which a memory remembers all. */
    private void takeBlock(Claim claim) {
        for (int y = 39; y < 42; y++) {
            for (int x = 59; x < 62; x++) {
                outline.contour().support(x, y, 0, 1);
                outline.take(x, y, 0, 1, claim, LIFETIME_US);
            }
        }
    }

    private boolean isOnContour() {
        return outline.contour().support(60, 40, 0, 1) > 0;
    }

    private boolean isRemembered() {
        return outline.memory().remembered(60, 40, 0) > 0;
    }

    @Test
    public void eventIsOnTheContourAndRemembered() {
        start(0);
        takeBlock(Claim.OWN);
        assertTrue(isOnContour());
        assertTrue(isRemembered());
    }

    @Test
    public void whatIsRememberedOnlyIsNotRememberedForLonger() {
        start(0);
        takeBlock(Claim.REMEMBERED);
        assertTrue(isOnContour());
        assertFalse(isRemembered());
    }

    /** Whether events are on the contour yet after some time in noise of a rate. */
    private boolean isOnContourAfter(long us, double noise) {
        start(0);
        takeBlock(Claim.OWN);
        outline.pass(us, noise, false, LIFETIME_US);
        return isOnContour();
    }

    @Test
    public void contourHoldsEventsForTheLifetimeOrUntilNoiseWouldFillIt() {
        assertTrue(isOnContourAfter(159_000, 0));
        assertFalse(isOnContourAfter(160_000, 0));
        assertTrue(isOnContourAfter(39_000, MUCH_NOISE));
        assertFalse("two events of noise on the nine cells", isOnContourAfter(41_000, MUCH_NOISE));
    }

    @Test
    public void contourHoldsEventsForAnEighthOfTheLifetimeAtLeast() {
        assertTrue(isOnContourAfter(19_000, 100 * MUCH_NOISE));
        assertFalse(isOnContourAfter(20_000, 100 * MUCH_NOISE));
    }

    @Test
    public void placeHasBeenInSightForAShareOfTheTimeThatEventsAreHeld() {
        start(100);
        // column 3 came in 3.5 px, 35 ms, ago; column 19 before all events that are held
        assertEquals(35.0 / 160, outline.shareInSight(3, 40, 0, LIFETIME_US), 1e-6);
        assertEquals(1, outline.shareInSight(19, 40, 0, LIFETIME_US), 0);
        outline.pass(0, MUCH_NOISE, false, LIFETIME_US);
        assertEquals(35.0 / 40, outline.shareInSight(3, 40, 0, LIFETIME_US), 1e-3);
    }

    @Test
    public void placesAreRememberedForSoManyPxOfTravelAndTwoSecondsAtMost() {
        start(100);
        assertEquals(640_000, outline.memoryUs(motion));
        outline.setMemoryPx(32);
        assertEquals(320_000, outline.memoryUs(motion));
        start(10);
        assertEquals(2_000_000, outline.memoryUs(motion));
        start(0);
        assertEquals(2_000_000, outline.memoryUs(motion));
    }
}
