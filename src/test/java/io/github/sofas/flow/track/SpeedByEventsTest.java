package io.github.sofas.flow.track;

import static org.junit.Assert.assertEquals;
import static org.junit.Assert.assertFalse;
import static org.junit.Assert.assertTrue;

import io.github.sofas.flow.SofasParameters;
import io.github.sofas.flow.fit.MetricFit;
import io.github.sofas.flow.motion.Motion;
import org.junit.Test;

/**
 * A window of 0.1 s. A motion that slows down from 90 to 50 px/s has travelled 7 px in it, 2.32 px in the last 40 ms;
 * one that speeds up from 10 to 50 px/s 3 px and 1.68 px. An acceleration of 400 px/s² shifts the ends by 0.5 px.
 */
public class SpeedByEventsTest {
    private static final long NOW_US = 100_000;
    private static final double PX = 1e-6;

    private final SpeedByEvents byEvents = new SpeedByEvents();
    private final Motion motion = new Motion();
    private final Measurement measurement = new Measurement(SofasParameters.defaults().track());
    private final MetricFit fit = new MetricFit(100, 100, MetricFit.CELL_PX, 4096, 1000);
    private boolean inView = true;

    private boolean correct(LiveEvents live) {
        return byEvents.correct(motion, live, 0, inView, measurement, fit, NOW_US);
    }

    /** So many events, one each so many µs at first, of which the newest 50 begin some time before now. */
    private static LiveEvents live(int events, long newestUs) {
        LiveEvents live = new LiveEvents();
        int first = events - 50;
        for (int i = 0; i < first; i++) {
            live.add(i % 50, i / 50, i * (NOW_US - newestUs) / first, 1, Claim.OWN, i);
        }
        for (int i = 0; i < 50; i++) {
            live.add(i, 20, NOW_US - newestUs + i * newestUs / 50, 1, Claim.OWN, i);
        }
        return live;
    }

    private void moves(double ax) {
        motion.set(NOW_US, 50, 0);
        motion.ax = ax;
    }

    /** Velocity in the middle of the window. */
    private double midVx() {
        Motion mid = new Motion();
        mid.copyFrom(motion);
        mid.moveReference(NOW_US / 2);
        return mid.vx;
    }

    @Test
    public void whatSlowsDownIsAsSlowNowAsItsEventsTellAndWasAsFastAsBeforeInTheMiddleOfTheWindow() {
        moves(-400);
        // 700 events on 7 px: 50 on half a px, which took 40 ms instead of what the motion has travelled in them
        double share = 0.5 / 2.32;
        assertTrue(correct(live(700, 40_000)));
        assertEquals(50 * share, motion.vx, PX);
        assertEquals(-400 + (share - 1) * 50 / 0.05, motion.ax, PX);
        assertEquals(70, midVx(), PX);
    }

    @Test
    public void motionThatItsEventsConfirmStays() {
        moves(-400);
        // 50, and 54 px/s 10 ms ago: 0.52 px
        assertFalse(correct(live(700, 10_000)));
        assertEquals(50, motion.vx, 0);
        assertEquals(-400, motion.ax, 0);
    }

    @Test
    public void whatSpeedsUpIsMadeSlowerOnlyByFewerEventsThanWhatSlowsDown() {
        // 300 events on 3 px; within 18 ms 0.835 px, of which half a px is 0.6
        moves(400);
        assertFalse(correct(live(300, 18_000)));
        assertTrue(correct(live(300, 40_000)));
        assertEquals(50 * 0.5 / 1.68, motion.vx, PX);
        assertEquals(30, midVx(), PX);
        // half a px of the 0.77 px within 14.5 ms are 0.65
        moves(-400);
        assertTrue(correct(live(700, 14_500)));
    }

    /** An upright edge, 60 rows, that enters a column at each of some times. */
    private static LiveEvents edge(double... enteredS) {
        LiveEvents live = new LiveEvents();
        for (int column = 0; column < enteredS.length; column++) {
            for (int row = 0; row < 60; row++) {
                live.add(20 + column, row, Math.round(enteredS[column] * 1e6), 1, Claim.OWN, 0);
            }
        }
        return live;
    }

    @Test
    public void whatIsNotKnownToSlowDownIsSlowerWhereItsEventsMeetMoreOftenSo() {
        // 100 t - 500 t² px, which stands at 0.1 s: 5 px within the window, 50 px/s in its middle
        moves(0);
        assertTrue(correct(edge(0, 0.01056, 0.02254, 0.03675, 0.05528)));
        // 300 events on 5 px, 30 of them on half a px, which took 44.7 instead of 10 ms
        assertEquals(50 * 0.5 / (50 * 0.04472), motion.vx, PX);
        assertEquals(50, midVx(), PX);
        moves(0);
        inView = false;
        assertFalse("it may be hidden", correct(edge(0, 0.01056, 0.02254, 0.03675, 0.05528)));
    }

    @Test
    public void whatIsHiddenIsAsFastAsBefore() {
        // 50 px/s, hidden from 60 ms on
        moves(0);
        assertFalse(correct(edge(0, 0.02, 0.04, 0.06)));
        motion.set(NOW_US, 0, 0);
        assertFalse("at rest", correct(live(700, 40_000)));
    }

    @Test
    public void eventsThatComeSomewhatUnevenlySlowDownWhatSlowsDownOnly() {
        // half a px of 0.68, 0.67 and 0.65 px within 13 ms; 199 px/s² shift the ends by less than a quarter px
        moves(-400);
        assertTrue(correct(live(700, 13_000)));
        moves(-199);
        assertFalse(correct(live(600, 13_000)));
        moves(0);
        assertFalse(correct(live(500, 13_000)));
    }

    @Test
    public void fewEventsTellNothing() {
        moves(-400);
        // 19 on half a px
        assertFalse(correct(live(279, 40_000)));
        assertFalse(correct(new LiveEvents()));
        assertTrue(correct(live(280, 60_000)));
    }
}
