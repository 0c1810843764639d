package io.github.sofas.flow.track;

import static io.github.sofas.flow.track.MovingDots.END_US;
import static io.github.sofas.flow.track.MovingDots.MIDDLE_X;
import static io.github.sofas.flow.track.MovingDots.MIDDLE_Y;
import static io.github.sofas.flow.track.MovingDots.SIDE;
import static io.github.sofas.flow.track.MovingDots.VX;
import static org.junit.Assert.assertEquals;
import static org.junit.Assert.assertFalse;
import static org.junit.Assert.assertTrue;

import io.github.sofas.event.SensorSize;
import io.github.sofas.flow.fit.MetricFit;
import io.github.sofas.flow.motion.Motion;
import org.junit.Test;

/**
 * Bodies of dots, each of which fires whenever it comes to another pixel, for 200 ms. Two of them, 24 px wide and high,
 * touch side by side in the middle of that time; what is taken for their motion goes to the right by 80 px/s and turns
 * about the middle of both.
 */
public class TwoBodiesTest {
    private static final SensorSize SENSOR = new SensorSize(128, 96);
    /** Rotation by which two points that lie so far apart as the bodies' middles part by 24 px/s. */
    private static final double OMEGA = 1;

    private final MetricFit fit = new MetricFit(128, 96, MetricFit.CELL_PX, TrackPlaneStack.MOST_MEASURED, 1900);
    private final TwoBodies two = new TwoBodies(new TiledEvents(SENSOR));
    private final MovingDots dots = new MovingDots();
    private final LiveEvents live = new LiveEvents();
    private final Motion motion = new Motion();

    private boolean find(double omega, Claim claim) {
        dots.addTo(live, claim);
        motion.set(END_US / 2, VX, 0);
        motion.centreX = MIDDLE_X;
        motion.centreY = MIDDLE_Y;
        motion.omega = omega;
        return two.find(live, motion, 2 * SIDE, fit);
    }

    private boolean find(double omega) {
        return find(omega, Claim.OWN);
    }

    @Test
    public void bodiesThatTouchAndPartBesideEachOtherAreTwoThatDoNotTurn() {
        dots.move(90, MIDDLE_X - SIDE, -12, 0);
        int larger = dots.size();
        dots.move(60, MIDDLE_X, 12, 0);
        int smaller = dots.size() - larger;
        assertTrue(find(OMEGA));
        assertEquals(VX, two.larger().vx, 2);
        assertEquals(-12, two.larger().vy, 2);
        assertEquals(VX, two.smaller().vx, 2);
        assertEquals(12, two.smaller().vy, 2);
        assertEquals(0, two.larger().omega, 0);
        int found = 0;
        int right = 0;
        for (int k = 0; k < live.size(); k++) {
            int i = live.index(k);
            if (two.isOfSmaller(i)) {
                found++;
                right += MovingDots.isRight(live, i) ? 1 : 0;
            }
        }
        // tiles of 8 px may hold some of both
        assertEquals(smaller, found, 0.1 * smaller);
        assertEquals(found, right, 0.05 * found);
    }

    @Test
    public void bodyThatTurnsIsOne() {
        dots.move(150, MIDDLE_X - SIDE / 2, 0, 2);
        assertFalse(find(2));
        assertTrue(two.turns());
        assertTrue(two.isClearlyOne());
    }

    @Test
    public void partsOfABodyThatTurnsAreNotTwo() {
        dots.move(90, MIDDLE_X - SIDE, 0, OMEGA);
        dots.move(60, MIDDLE_X, 0, OMEGA);
        assertFalse(find(OMEGA));
        assertTrue(two.isClearlyOne());
    }

    @Test
    public void whatIsNotTakenToTurnIsNotAsked() {
        dots.move(90, MIDDLE_X - SIDE, -12, 0);
        dots.move(60, MIDDLE_X, 12, 0);
        assertFalse(find(0));
        assertFalse(two.turns());
        assertFalse(two.isClearlyOne());
    }

    @Test
    public void fewerThanSixtyEventsAreNoBody() {
        dots.move(90, MIDDLE_X - SIDE, -12, 0);
        int larger = dots.size();
        dots.move(3, MIDDLE_X, 12, 0);
        assertTrue(dots.size() - larger < 60);
        assertFalse(find(OMEGA));
    }

    @Test
    public void eventsThatOthersClaimTooShowNothing() {
        dots.move(90, MIDDLE_X - SIDE, -12, 0);
        dots.move(60, MIDDLE_X, 12, 0);
        assertFalse(find(OMEGA, Claim.SHARED));
    }

    @Test
    public void moreEventsThanAreMeasuredAtOnceAreNotAsked() {
        dots.move(1000, MIDDLE_X - SIDE, -12, 0);
        dots.move(600, MIDDLE_X, 12, 0);
        assertTrue(dots.size() > Measurement.MOST_EVENTS);
        assertFalse(find(OMEGA));
        assertFalse(two.isClearlyOne());
    }
}
