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
 * Bodies of dots, each of which fires whenever it comes to another pixel, for 100 ms: one of 120 dots, 30 px wide and
 * high, that goes to the right by 100 px/s, and a smaller one 20 px below it. The motion that they are taken to have is
 * that of the larger one.
 */
public class PartingTest {
    private static final SensorSize SENSOR = new SensorSize(128, 96);
    private static final long END_US = 100_000;
    private static final double VX = 100;
    private static final int SMALL_TOP = 60;

    private final MetricFit fit = new MetricFit(128, 96, MetricFit.CELL_PX, TrackPlaneStack.MOST_MEASURED, 1900);
    private final Parting parting = new Parting(SENSOR, new TiledEvents(SENSOR));
    private final List<long[]> events = new ArrayList<>();
    private final LiveEvents live = new LiveEvents();
    private final Motion motion = new Motion();

    private void move(int dots, double left, double top, double side, double vx, double vy) {
        Random random = new Random(dots);
        for (int dot = 0; dot < dots; dot++) {
            double x0 = left + side * random.nextDouble();
            double y0 = top + side * random.nextDouble();
            int column = (int) Math.floor(x0);
            int row = (int) Math.floor(y0);
            for (long t = 0; t < END_US; t += 50) {
                int x = (int) Math.floor(x0 + vx * 1e-6 * t);
                int y = (int) Math.floor(y0 + vy * 1e-6 * t);
                if (x != column || y != row) {
                    events.add(new long[] {t, x, y});
                    column = x;
                    row = y;
                }
            }
        }
    }

    /** Dots of a square of 40 px that turns about its middle, which goes to the right. */
    private void turn(double omega) {
        Random random = new Random(1);
        for (int dot = 0; dot < 150; dot++) {
            double x0 = 40 * (random.nextDouble() - 0.5);
            double y0 = 40 * (random.nextDouble() - 0.5);
            int column = Integer.MIN_VALUE;
            int row = Integer.MIN_VALUE;
            for (long t = 0; t < END_US; t += 50) {
                double angle = omega * 1e-6 * (t - END_US);
                int x = (int) Math.floor(60 + VX * 1e-6 * (t - END_US) + x0 * Math.cos(angle) - y0 * Math.sin(angle));
                int y = (int) Math.floor(48 + x0 * Math.sin(angle) + y0 * Math.cos(angle));
                if (column != Integer.MIN_VALUE && (x != column || y != row)) {
                    events.add(new long[] {t, x, y});
                }
                column = x;
                row = y;
            }
        }
        motion.omega = omega;
        motion.centreX = 60;
        motion.centreY = 48;
    }

    private boolean find(Claim claim) {
        events.sort((a, b) -> Long.compare(a[0], b[0]));
        events.forEach(e -> live.add((int) e[1], (int) e[2], e[0], 1, claim, 0));
        double omega = motion.omega;
        motion.set(END_US, VX, 0);
        motion.omega = omega;
        return parting.findApart(live, motion, 20, fit) || parting.findTwo(live, motion, 20, fit);
    }

    private int ofPart(boolean below) {
        int count = 0;
        for (int k = 0; k < live.size(); k++) {
            int i = live.index(k);
            count += parting.isOfPart(i) && live.y[i] >= SMALL_TOP - 5 == below ? 1 : 0;
        }
        return count;
    }

    @Test
    public void bodyThatLiesApartAndMovesOtherwiseIsFoundWithItsVelocity() {
        move(120, 30, 10, 30, VX, 0);
        int larger = events.size();
        move(40, 40, SMALL_TOP, 10, 120, 20);
        assertTrue(find(Claim.OWN));
        assertEquals(120, parting.motionOfPart().vx, 2);
        assertEquals(20, parting.motionOfPart().vy, 2);
        assertEquals(events.size() - larger, ofPart(true), 5);
        assertEquals(0, ofPart(false));
    }

    @Test
    public void bodyThatMovesAlikeIsNotFound() {
        move(120, 30, 10, 30, VX, 0);
        move(40, 40, SMALL_TOP, 10, VX, 0);
        assertFalse(find(Claim.OWN));
        assertEquals(0, ofPart(true) + ofPart(false));
    }

    @Test
    public void bodyThatDiffersByLessThanHalfAPixelAtTheEndsOfTheWindowIsNotFound() {
        move(120, 30, 10, 30, VX, 0);
        // 0.4 px in the 50 ms from the middle on
        move(40, 40, SMALL_TOP, 10, VX + 8, 0);
        assertFalse(find(Claim.OWN));
    }

    @Test
    public void bodyThatTouchesIsNotFound() {
        move(120, 30, 10, 30, VX, 0);
        move(60, 40, 40, 12, 120, 20);
        assertFalse(find(Claim.OWN));
    }

    @Test
    public void fewerThanSixtyEventsAreNoBody() {
        move(120, 30, 10, 30, VX, 0);
        int larger = events.size();
        move(4, 40, SMALL_TOP, 3, 120, 20);
        assertTrue(events.size() - larger < 60);
        assertFalse(find(Claim.OWN));
    }

    @Test
    public void eventsThatOthersClaimTooShowNothing() {
        move(120, 30, 10, 30, VX, 0);
        move(40, 40, SMALL_TOP, 10, 120, 20);
        assertFalse(find(Claim.SHARED));
    }

    @Test
    public void eventsFarOutsideTheSensorAreOfNoPart() {
        move(120, 30, 10, 30, VX, 0);
        move(40, 40, SMALL_TOP, 10, 120, 20);
        for (long[] event : events) {
            // as if moved by 400 px to the middle of the window
            event[0] += END_US * 80;
        }
        events.add(0, new long[] {0, 40, 40});
        assertFalse(find(Claim.OWN));
        assertEquals(0, ofPart(true) + ofPart(false));
    }

    @Test
    public void bodyThatTurnsIsClearlyOne() {
        turn(3);
        assertFalse(find(Claim.OWN));
        assertTrue(parting.isClearlyOne());
    }

    @Test
    public void eventsOfOneMomentHaveNoParts() {
        move(120, 30, 10, 30, VX, 0);
        move(40, 40, SMALL_TOP, 10, 120, 20);
        events.forEach(event -> event[0] = END_US);
        assertFalse(find(Claim.OWN));
        assertEquals(0, ofPart(true) + ofPart(false));
    }
}
