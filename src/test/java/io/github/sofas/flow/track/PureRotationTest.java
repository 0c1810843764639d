package io.github.sofas.flow.track;

import static org.junit.Assert.assertEquals;
import static org.junit.Assert.assertFalse;
import static org.junit.Assert.assertTrue;

import io.github.sofas.flow.fit.MetricFit;
import io.github.sofas.flow.motion.Motion;
import java.util.ArrayList;
import java.util.List;
import java.util.Random;
import org.junit.Test;

/**
 * A square of 150 dots that turns by 2 rad/s: each fires whenever it comes to another pixel, until 200 ms. Its motion
 * is known to slow down until 100 ms, and then to go back by 400 px/s²: by 2 px until 200 ms, by 0.72 px until 160 ms.
 */
public class PureRotationTest {
    private static final int DOTS = 150;
    private static final double SIDE_PX = 24;
    private static final double RADIUS_PX = 10;
    private static final double X = 64;
    private static final double Y = 48;
    private static final double RAD_PER_S = 2;
    private static final double BACK_PX_PER_S2 = 400;
    private static final long STOPS_US = 100_000;
    private static final long NOW_US = 200_000;

    private final MetricFit fit = new MetricFit(128, 96, MetricFit.CELL_PX, LiveEvents.CAPACITY, 1000);
    private final PureRotation rotation = new PureRotation();
    private final Motion motion = new Motion();

    public PureRotationTest() {
        motion.set(STOPS_US, 0, 0);
        motion.ax = BACK_PX_PER_S2;
        motion.omega = RAD_PER_S;
        motion.centreX = X;
        motion.centreY = Y;
    }

    /** Events of dots that turn by so much and that, from the stop on, accelerate to the right by so much. */
    private static LiveEvents dots(double radPerS, double pxPerS2, long untilUs) {
        Random random = new Random(5);
        List<long[]> events = new ArrayList<>();
        for (int dot = 0; dot < DOTS; dot++) {
            double x0 = SIDE_PX * (random.nextDouble() - 0.5);
            double y0 = SIDE_PX * (random.nextDouble() - 0.5);
            int column = Integer.MIN_VALUE;
            int row = 0;
            for (long t = 0; t < untilUs; t += 100) {
                double s = (t - STOPS_US) * 1e-6;
                double cos = Math.cos(radPerS * s);
                double sin = Math.sin(radPerS * s);
                int x = (int) Math.floor(X + pxPerS2 * s * s / 2 + cos * x0 - sin * y0);
                int y = (int) Math.floor(Y + sin * x0 + cos * y0);
                if (column != Integer.MIN_VALUE && (x != column || y != row)) {
                    events.add(new long[] {t, x, y});
                }
                column = x;
                row = y;
            }
        }
        events.sort((a, b) -> Long.compare(a[0], b[0]));
        LiveEvents live = new LiveEvents();
        events.forEach(e -> live.add((int) e[1], (int) e[2], e[0], 1, Claim.OWN, 0));
        return live;
    }

    /** A light of 15 x 10 px that flickers twice after the stop, and an event of before. */
    private static LiveEvents flashes() {
        LiveEvents live = new LiveEvents();
        live.add((int) X, (int) Y, STOPS_US - 50_000, 1, Claim.OWN, 0);
        for (int flash = 0; flash < 2; flash++) {
            for (int dot = 0; dot < DOTS; dot++) {
                long us = STOPS_US + 100 + 80_000 * flash + 100 * dot;
                live.add((int) X + dot % 15, (int) Y + dot / 15, us, 1, Claim.OWN, 0);
            }
        }
        return live;
    }

    private long sinceUs(LiveEvents live, long nowUs) {
        return rotation.sinceUs(motion, live, RADIUS_PX, fit, nowUs);
    }

    @Test
    public void whatWasToTurnBackTurnsInPlaceWhereItsEventsMeetThere() {
        assertEquals(STOPS_US, sinceUs(dots(RAD_PER_S, 0, NOW_US), NOW_US));
    }

    @Test
    public void whatGoesBackAsItWasToDoesNotTurnInPlace() {
        assertEquals(Rest.NEVER, sinceUs(dots(RAD_PER_S, BACK_PX_PER_S2, NOW_US), NOW_US));
    }

    @Test
    public void itIsNotKnownBeforeTheWayBackWouldShow() {
        LiveEvents live = dots(RAD_PER_S, 0, 170_000);
        assertEquals(Rest.NEVER, sinceUs(live, 160_000));
        // 0.98 px
        assertEquals(STOPS_US, sinceUs(live, 170_000));
    }

    @Test
    public void whatIsNotKnownToTurnStandsWhereItsEventsMeetMoreOftenThereByAStandardDeviation() {
        motion.omega = 0;
        // two events of each of 150 pixels, 15 x 10, meet where they are
        assertEquals(STOPS_US, sinceUs(flashes(), NOW_US));
        assertEquals(Rest.NEVER, sinceUs(dots(0, BACK_PX_PER_S2, NOW_US), NOW_US));
    }

    @Test
    public void whatDoesNotTurnDoesNotShowThatItTurns() {
        motion.omega = 0;
        assertFalse(rotation.showsSince(STOPS_US, motion, dots(0, 0, NOW_US), RADIUS_PX, fit));
    }

    @Test
    public void whatStopsShowsThatItTurnsByEventsThatMeetAlongItsRotationAndNotAtRest() {
        assertTrue(rotation.showsSince(STOPS_US, motion, dots(RAD_PER_S, 0, NOW_US), RADIUS_PX, fit));
        assertFalse(rotation.showsSince(STOPS_US, motion, flashes(), RADIUS_PX, fit));
    }

    @Test
    public void fewEventsShowNothing() {
        LiveEvents live = new LiveEvents();
        LiveEvents all = dots(RAD_PER_S, 0, NOW_US);
        for (int k = 0; k < 11; k++) {
            int i = all.index(all.size() - 11 + k);
            live.add(all.x[i], all.y[i], all.timeUs[i], 1, Claim.OWN, 0);
        }
        assertFalse(rotation.showsSince(STOPS_US, motion, live, RADIUS_PX, fit));
    }
}
