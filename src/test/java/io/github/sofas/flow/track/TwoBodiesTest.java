package io.github.sofas.flow.track;

import static org.junit.Assert.assertEquals;
import static org.junit.Assert.assertFalse;
import static org.junit.Assert.assertTrue;

import io.github.sofas.event.SensorSize;
import io.github.sofas.flow.fit.MetricFit;
import io.github.sofas.flow.motion.Motion;
import java.util.ArrayList;
import java.util.List;
import java.util.Random;
import org.junit.Test;

/**
 * Bodies of dots, each of which fires whenever it comes to another pixel, for 200 ms. Two of them, 24 px wide and high,
 * touch side by side in the middle of that time; what is taken for their motion goes to the right by 80 px/s and turns
 * about the middle of both.
 */
public class TwoBodiesTest {
    private static final SensorSize SENSOR = new SensorSize(128, 96);
    private static final long END_US = 200_000;
    private static final double HALF_S = END_US * 0.5e-6;
    private static final double VX = 80;
    private static final double MIDDLE_X = 56;
    private static final double MIDDLE_Y = 44;
    private static final double SIDE = 24;
    /** Rotation by which two points that lie so far apart as the bodies' middles part by 24 px/s. */
    private static final double OMEGA = 1;

    private final MetricFit fit = new MetricFit(128, 96, MetricFit.CELL_PX, TrackPlaneStack.MOST_MEASURED, 1900);
    private final TwoBodies two = new TwoBodies(new TiledEvents(SENSOR));
    private final List<long[]> events = new ArrayList<>();
    private final LiveEvents live = new LiveEvents();
    private final Motion motion = new Motion();

    /** Dots of a square, by its left side in the middle of the time, that move and turn about the middle of both. */
    private void move(int dots, double left, double vy, double omega) {
        Random random = new Random(dots);
        for (int dot = 0; dot < dots; dot++) {
            double x0 = left + SIDE * random.nextDouble() - MIDDLE_X;
            double y0 = SIDE * (random.nextDouble() - 0.5);
            int column = Integer.MIN_VALUE;
            int row = 0;
            for (long t = 0; t < END_US; t += 50) {
                double s = t * 1e-6 - HALF_S;
                double cos = Math.cos(omega * s);
                double sin = Math.sin(omega * s);
                int x = (int) Math.floor(MIDDLE_X + VX * s + cos * x0 - sin * y0);
                int y = (int) Math.floor(MIDDLE_Y + vy * s + sin * x0 + cos * y0);
                if (column != Integer.MIN_VALUE && (x != column || y != row)) {
                    events.add(new long[] {t, x, y});
                }
                column = x;
                row = y;
            }
        }
    }

    private boolean find(double omega, Claim claim) {
        events.sort((a, b) -> Long.compare(a[0], b[0]));
        events.forEach(e -> live.add((int) e[1], (int) e[2], e[0], 1, claim, 0));
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
        move(90, MIDDLE_X - SIDE, -12, 0);
        int larger = events.size();
        move(60, MIDDLE_X, 12, 0);
        int smaller = events.size() - larger;
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
                double s = live.timeUs[i] * 1e-6 - HALF_S;
                right += live.x[i] >= MIDDLE_X + VX * s - 1 ? 1 : 0;
            }
        }
        // tiles of 8 px may hold some of both
        assertEquals(smaller, found, 0.1 * smaller);
        assertEquals(found, right, 0.05 * found);
    }

    @Test
    public void bodyThatTurnsIsOne() {
        move(150, MIDDLE_X - SIDE / 2, 0, 2);
        assertFalse(find(2));
        assertTrue(two.turns());
        assertTrue(two.isClearlyOne());
    }

    @Test
    public void partsOfABodyThatTurnsAreNotTwo() {
        move(90, MIDDLE_X - SIDE, 0, OMEGA);
        move(60, MIDDLE_X, 0, OMEGA);
        assertFalse(find(OMEGA));
        assertTrue(two.isClearlyOne());
    }

    @Test
    public void whatIsNotTakenToTurnIsNotAsked() {
        move(90, MIDDLE_X - SIDE, -12, 0);
        move(60, MIDDLE_X, 12, 0);
        assertFalse(find(0));
        assertFalse(two.turns());
        assertFalse(two.isClearlyOne());
    }

    @Test
    public void fewerThanSixtyEventsAreNoBody() {
        move(90, MIDDLE_X - SIDE, -12, 0);
        int larger = events.size();
        move(3, MIDDLE_X, 12, 0);
        assertTrue(events.size() - larger < 60);
        assertFalse(find(OMEGA));
    }

    @Test
    public void eventsThatOthersClaimTooShowNothing() {
        move(90, MIDDLE_X - SIDE, -12, 0);
        move(60, MIDDLE_X, 12, 0);
        assertFalse(find(OMEGA, Claim.SHARED));
    }

    @Test
    public void moreEventsThanAreMeasuredAtOnceAreNotAsked() {
        move(1000, MIDDLE_X - SIDE, -12, 0);
        move(600, MIDDLE_X, 12, 0);
        assertTrue(events.size() > Measurement.MOST_EVENTS);
        assertFalse(find(OMEGA));
        assertFalse(two.isClearlyOne());
    }
}
