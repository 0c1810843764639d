package io.github.sofas.flow.track;

import static org.junit.Assert.assertEquals;
import static org.junit.Assert.assertFalse;
import static org.junit.Assert.assertTrue;

import io.github.sofas.flow.motion.Motion;
import org.junit.Test;

/** A structure that gives 100 events per px of travel, 500 in a lifetime of 5 px; starved below a share of 0.3. */
public class EventDensityTest {
    private static final double LIFETIME_PX = 5;
    private static final double SHARE = 0.3;

    private final EventDensity density = new EventDensity();

    private static LiveEvents live(int events) {
        LiveEvents live = new LiveEvents();
        for (int i = 0; i < events; i++) {
            live.add(i % 50, i / 50, i, 1, Claim.OWN, i);
        }
        return live;
    }

    @Test
    public void structureIsStarvedBelowTheShareOfItsUsualEvents() {
        density.follow(live(500), LIFETIME_PX);
        assertFalse(density.isStarved(live(150), LIFETIME_PX, SHARE));
        assertTrue(density.isStarved(live(149), LIFETIME_PX, SHARE));
    }

    @Test
    public void longerTravelLetsExpectMoreEvents() {
        density.follow(live(500), LIFETIME_PX);
        assertFalse(density.isStarved(live(300), 2 * LIFETIME_PX, SHARE));
        assertTrue(density.isStarved(live(299), 2 * LIFETIME_PX, SHARE));
    }

    @Test
    public void tooFewEventsForAMotionAreTooFewWhateverIsUsual() {
        assertFalse(density.isStarved(live(Measurement.LEAST_EVENTS), LIFETIME_PX, SHARE));
        assertTrue(density.isStarved(live(Measurement.LEAST_EVENTS - 1), LIFETIME_PX, SHARE));
    }

    @Test
    public void moreIsUsualAtOnceAndLessSlowly() {
        density.follow(live(100), LIFETIME_PX);
        density.follow(live(500), LIFETIME_PX);
        density.follow(live(100), LIFETIME_PX);
        assertTrue(density.isStarved(live(149), LIFETIME_PX, SHARE));
        // a thousandth of the way with each look: 0.999^2000 of the 400 events more are left, 54
        for (int i = 0; i < 2000; i++) {
            density.follow(live(100), LIFETIME_PX);
        }
        assertFalse(density.isStarved(live(48), LIFETIME_PX, SHARE));
        assertTrue(density.isStarved(live(45), LIFETIME_PX, SHARE));
    }

    @Test
    public void eventsOfTilesThatAreNotTakenCount() {
        // 32,768 events fill the ring; the next one halves its tiles, and what stays stands for twice as many
        LiveEvents halved = live(LiveEvents.CAPACITY + 1);
        assertEquals(2, halved.thinning());
        density.follow(halved, LIFETIME_PX);
        assertTrue(density.isStarved(live((int) (SHARE * LiveEvents.CAPACITY)), LIFETIME_PX, SHARE));
        assertFalse(density.isStarved(live((int) (SHARE * LiveEvents.CAPACITY) + 2), LIFETIME_PX, SHARE));
    }

    @Test
    public void structureThatBecameAnotherBeginsAnewWithWhatItHas() {
        density.follow(live(500), LIFETIME_PX);
        density.start(live(100), LIFETIME_PX);
        assertFalse(density.isStarved(live(30), LIFETIME_PX, SHARE));
        assertTrue(density.isStarved(live(29), LIFETIME_PX, SHARE));
    }

    /** An event each 10 us, up to 5 ms; 100 are usual a px, which the last ms brings. */
    private boolean isRushed(double vx, double ax) {
        LiveEvents live = new LiveEvents();
        for (int i = 0; i < 500; i++) {
            live.add(i % 50, i / 50, 10L * i, 1, Claim.OWN, i);
        }
        density.follow(live, LIFETIME_PX);
        Motion motion = new Motion();
        motion.set(4_990, vx, 0);
        motion.ax = ax;
        return density.isRushed(live, motion, 0, 4_990);
    }

    @Test
    public void eventsRushWhereTheMotionExplainsLessThanAPartOfTheirTravel() {
        // the newest 100 span 990 us, in which 0.35 px are travelled at 353.5 px/s
        assertTrue(isRushed(353, 0));
        assertFalse(isRushed(354, 0));
    }

    @Test
    public void speedIsThatOfTheTimeOfTheEvents() {
        // at rest now, 495 us ago at 1e6 * 495e-6 = 495 px/s
        assertFalse(isRushed(0, -1e6));
        assertTrue(isRushed(0, -1e5));
    }

    @Test
    public void fewEventsDoNotRush() {
        Motion motion = new Motion();
        density.follow(live(499), LIFETIME_PX);
        assertFalse("99 a px", density.isRushed(live(499), motion, 0, 499));
        density.follow(live(500), LIFETIME_PX);
        assertTrue(density.isRushed(live(500), motion, 0, 500));
        assertFalse("not one px of events", density.isRushed(live(99), motion, 0, 99));
    }
}
