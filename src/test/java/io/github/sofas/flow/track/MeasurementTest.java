package io.github.sofas.flow.track;

import static org.junit.Assert.assertEquals;
import static org.junit.Assert.assertFalse;
import static org.junit.Assert.assertTrue;

import io.github.sofas.flow.SofasParameters;
import io.github.sofas.flow.fit.MetricFit;
import io.github.sofas.flow.fit.MotionLoss;
import io.github.sofas.flow.fit.VelocityTop;
import io.github.sofas.flow.motion.Motion;
import java.util.ArrayList;
import java.util.List;
import java.util.Random;
import org.junit.Test;

/** What is known of a motion of about 100 px/s to the right, measured once each 10 ms: once a pixel. */
public class MeasurementTest {
    private static final long STEP_US = 10_000;
    private static final double RADIUS_PX = 9;
    private static final SofasParameters.Track P = SofasParameters.defaults().track();

    private final Random random = new Random(11);
    private final MetricFit fit = new MetricFit(256, 128, MetricFit.CELL_PX, LiveEvents.CAPACITY, 1900);
    private final LiveEvents live = new LiveEvents();
    private final Motion motion = new Motion();
    private final Measurement measurement = new Measurement(P);
    private long nowUs = 1_000_000;
    private double edgePx = 30;

    private void start(double vx) {
        measurement.restart();
        motion.set(nowUs, vx, 0);
        motion.centreX = 30;
        motion.centreY = 50;
    }

    /** An upright edge of 30 rows goes on for 10 ms at a speed, and fires once in every column that it enters. */
    private void edge(double pxPerS) {
        for (long timeUs = nowUs; timeUs < nowUs + STEP_US; timeUs += 250) {
            double to = edgePx + pxPerS * 250e-6;
            for (int column = (int) Math.ceil(edgePx); column < to; column++) {
                for (int y = 35; y < 65; y++) {
                    live.add(column, y, timeUs, 1, Claim.OWN, 0);
                }
            }
            edgePx = to;
        }
        nowUs += STEP_US;
    }

    /** Events at chance places, as many as of the edge at 100 px/s. */
    private void noise() {
        for (int i = 0; i < 30; i++) {
            live.add(20 + random.nextInt(40), 30 + random.nextInt(40), nowUs + i * STEP_US / 30, 1, Claim.OWN, 0);
        }
        nowUs += STEP_US;
    }

    /** The same edge stands for 10 ms and fires twice in each row. */
    private void flicker() {
        for (int k = 0; k < 60; k++) {
            live.add((int) edgePx, 35 + k % 30, nowUs + k * STEP_US / 60, 1, Claim.OWN, 0);
        }
        nowUs += STEP_US;
    }

    /** An upright edge that enters columns at 100 px/s - 1000 px/s² t, and leaves them again from 0.1 s on. */
    private static LiveEvents thereAndBack(int polarityBack) {
        LiveEvents events = new LiveEvents();
        for (int leaves = 0; leaves < 2; leaves++) {
            for (int k = 0; k < 5; k++) {
                int column = leaves == 0 ? k : 4 - k;
                // 100 t - 500 t² = column
                double root = Math.sqrt(100 * 100 - 4 * 500 * column);
                long timeUs = Math.round((100 + (leaves == 0 ? -root : root)) / 1000 * 1e6);
                for (int y = 35; y < 65; y++) {
                    events.add(20 + column, y, timeUs, leaves == 0 ? 1 : polarityBack, Claim.OWN, 0);
                }
            }
        }
        return events;
    }

    @Test
    public void eventsOfAnEdgeThatTurnsBackMeetWhateverItsPolarity() {
        motion.set(100_000, 0, 0);
        motion.ax = -1000;
        double same = measurement.metric(motion, thereAndBack(1), 0, fit, 200_000);
        double other = measurement.metric(motion, thereAndBack(-1), 0, fit, 200_000);
        assertEquals("150 events there and 150 back, on one line of 30 rows", same, other, 1e-6 * same);
        assertTrue(same > 0);
    }

    private long lifetimeUs() {
        return (long) (measurement.lifetimePx() / Math.hypot(motion.vx, motion.vy) * 1e6);
    }

    private void measure() {
        live.expire(nowUs - lifetimeUs());
        measurement.measure(motion, live, RADIUS_PX, fit, lifetimeUs(), nowUs);
        motion.moveReference(nowUs);
    }

    private void judge(boolean wasMeasured) {
        measurement.judge(wasMeasured, motion, live, RADIUS_PX, fit, nowUs);
    }

    @Test
    public void nothingIsKnownAtFirst() {
        start(100);
        assertFalse(measurement.isBlurred());
        assertEquals(P.lifetimePx(), measurement.lifetimePx(), 0);
        assertEquals(0, measurement.loss().metric, 0);
    }

    @Test
    public void edgeIsSharpAndItsVelocityIsFound() {
        start(90);
        for (int i = 0; i < 20; i++) {
            edge(100);
            measure();
            assertTrue(measurement.isSharp());
            assertFalse(measurement.isBlurred());
        }
        assertEquals(100, motion.vx, 2);
        assertEquals(0, motion.vy, 2);
        // known across it, and not along it
        assertTrue(measurement.loss().xx > 20 * measurement.loss().yy);
    }

    @Test
    public void noiseIsBlurredAfterFivePixelsOfTravel() {
        start(100);
        for (int i = 0; i < 5; i++) {
            noise();
        }
        measure();
        assertFalse(measurement.isSharp());
        double travelledPx = 0;
        // it finds velocities of its own, along which the travel is counted
        for (int i = 0; i < 20; i++) {
            if (Math.abs(travelledPx - 5) > 0.5) {
                assertEquals(travelledPx + " px", travelledPx > 5, measurement.isBlurred());
            }
            noise();
            travelledPx += measurement.lifetimePx() * STEP_US / lifetimeUs();
            measure();
            assertFalse(measurement.isSharp());
        }
        assertTrue(measurement.isBlurred());
    }

    @Test
    public void whatIsSharpAgainIsBlurredNoMore() {
        start(100);
        for (int i = 0; i < 12; i++) {
            noise();
            measure();
        }
        assertTrue(measurement.isBlurred());
        live.clear();
        motion.set(nowUs, 100, 0);
        for (int i = 0; i < 5; i++) {
            edge(100);
        }
        measure();
        assertTrue(measurement.isSharp());
        assertFalse(measurement.isBlurred());
        measurement.restart();
        assertTrue(measurement.isSharp());
    }

    @Test
    public void motionThatIsHeldPredictsWhatGoesOnButNotWhatStands() {
        start(100);
        for (int i = 0; i < 10; i++) {
            edge(100);
            measure();
            judge(true);
            assertTrue(measurement.isPredictive());
        }
        edge(100);
        judge(false);
        assertTrue(measurement.isPredictive());
        live.clear();
        motion.moveReference(nowUs);
        for (int i = 0; i < 5; i++) {
            flicker();
        }
        judge(false);
        assertFalse(measurement.isPredictive());
        measurement.restart();
        assertTrue(measurement.isPredictive());
    }

    @Test
    public void lifetimeOfASteadyMotionGrowsToItsMost() {
        start(100);
        double before = measurement.lifetimePx();
        for (int i = 0; i < 60; i++) {
            edge(100);
            measure();
            assertTrue(measurement.lifetimePx() >= before);
            before = measurement.lifetimePx();
        }
        assertEquals(P.maxLifetimePx(), measurement.lifetimePx(), 0);
    }

    @Test
    public void lifetimeShrinksWhenTheMotionChanges() {
        start(100);
        for (int i = 0; i < 60; i++) {
            edge(100);
            measure();
        }
        // half as fast again from one moment to the next
        for (int i = 0; i < 8; i++) {
            edge(150);
            measure();
        }
        assertTrue(measurement.lifetimePx() < P.maxLifetimePx());
        assertTrue(measurement.lifetimePx() >= P.lifetimePx());
    }

    @Test
    public void lifetimeStaysWithinNewBounds() {
        start(100);
        measurement.setParameters(SofasParameters.defaults().with("lifetimePx", 8).track());
        assertEquals(8, measurement.lifetimePx(), 0);
        measurement.setParameters(SofasParameters.defaults().with("lifetimePx", 2).with("maxLifetimePx", 3).track());
        assertEquals(3, measurement.lifetimePx(), 0);
    }

    @Test
    public void eighthOfTheEventsMustBeNewAndATwelfthOfMany() {
        start(100);
        assertEquals("at least", 40, measurement.newsNeeded(100));
        assertEquals(50, measurement.newsNeeded(400));
        assertEquals(250, measurement.newsNeeded(2_000));
        // before anything is known of how often they meet all are needed, and so an eighth of them
        assertEquals(1_500, measurement.newsNeeded(12_000));
        // ten events a cell and more meet often: 4,096 of them are enough, of which a quarter must be new, or a twelfth
        // of all
        for (int i = 0; i < 12_000; i++) {
            live.add(30 + i / 2_400, 40 + i % 20, nowUs + i, 1, Claim.OWN, 0);
        }
        nowUs += 12_000;
        motion.set(nowUs, 400, 0);
        measure();
        assertEquals(1_024, measurement.newsNeeded(12_000));
        assertEquals(1_250, measurement.newsNeeded(15_000));
        // half of fewer, and 2,000 at least
        assertEquals(750, measurement.newsNeeded(6_000));
        assertEquals(500, measurement.newsNeeded(3_000));
    }

    @Test
    public void eventsOnTheContourOfAnotherAreNotMeasured() {
        start(100);
        for (int i = 0; i < 5; i++) {
            edge(100);
        }
        for (int i = 0; i < 500; i++) {
            live.add(20, 30, nowUs - 1, 1, i % 2 == 0 ? Claim.SHARED : Claim.REMEMBERED, 0);
        }
        measure();
        assertEquals(150, fit.size());
    }

    @Test
    public void handfulOfEventsHasNoMotion() {
        start(100);
        for (int i = 0; i < Measurement.LEAST_EVENTS - 1; i++) {
            live.add(30, 40 + i, nowUs - 20_000 + i, 1, Claim.OWN, 0);
        }
        measure();
        assertEquals(100, motion.vx, 0);
        assertEquals(0, measurement.loss().metric, 0);
    }

    @Test
    public void halfOfTheEventsIsMeasuredWhereTheyMeetOften() {
        measureTwice(1_800);
        assertEquals(live.size(), fit.size());
        measureTwice(2_400);
        assertEquals(2_000, fit.size());
        measureTwice(6_000);
        assertEquals(live.size() / 2, fit.size());
        measureTwice(12_000);
        assertEquals(4_096, fit.size());
    }

    /** Measures a short upright edge that fires so often; what is measured the second time stays loaded. */
    private void measureTwice(int events) {
        start(400);
        live.clear();
        for (int i = 0; i < events; i++) {
            live.add(30 + i / (events / 5), 40 + i % 20, nowUs + i, 1, Claim.OWN, 0);
        }
        nowUs += events;
        measure();
        assertEquals("all, as nothing is known yet", events, fit.size());
        measure();
    }

    @Test
    public void weaklyKnownDirectionTakesAPartOfTheStep() {
        // one row of the edge fires much more often than the others: what is known of the velocity along it
        start(100);
        for (int column = 30; column < 35; column++) {
            edge(100);
            for (int i = 0; i < 12; i++) {
                live.add(column, 50, nowUs - 1, 1, Claim.OWN, 0);
            }
        }
        measure();
        motion.vx = 90;
        motion.vy = 10;
        measure();
        // the same fit again, of the events as they were projected, and what it knows
        VelocityTop top = fit.fit(0, 0, MetricFit.FLAT_SIGMAS);
        assertFalse(top.isFlat());
        MotionLoss loss = measurement.loss();
        double half = (nowUs - live.oldestUs()) * 0.5e-6;
        double stiffness = 0.002 * loss.metric * half * half;
        // (L + S)^-1 L step, the step of the fit
        double movedX = motion.vx - 90;
        double movedY = motion.vy - 10;
        assertEquals(loss.xx * top.stepX() + loss.xy * top.stepY(),
            (loss.xx + stiffness) * movedX + loss.xy * movedY, 1e-9 * loss.xx);
        assertEquals(loss.xy * top.stepX() + loss.yy * top.stepY(),
            loss.xy * movedX + (loss.yy + stiffness) * movedY, 1e-9 * loss.xx);
        assertTrue(movedY / top.stepY() < movedX / top.stepX());
    }

    /** Events of another's contour, a third of all. */
    private void cross() {
        for (int i = 0; i < live.size() / 2; i++) {
            live.add(20, 30, nowUs - 1, 1, Claim.SHARED, 0);
        }
    }

    @Test
    public void changeOfTheMotionIsHeldWhileAnotherCrosses() {
        start(100);
        for (int i = 0; i < 5; i++) {
            edge(100);
        }
        for (int i = 0; i < 4; i++) {
            measure();
        }
        motion.ax = 50;
        cross();
        measure();
        assertEquals(0.8 * 50, motion.ax, 1e-9);
    }

    @Test
    public void everyFourthMeasurementAsksAllNineProjections() {
        start(100);
        for (int i = 0; i < 5; i++) {
            edge(100);
        }
        // while another crosses nothing but the velocity is measured
        cross();
        List<Long> metrics = new ArrayList<>();
        for (int i = 0; i < 9; i++) {
            long before = fit.votes();
            measure();
            metrics.add((fit.votes() - before) / (2L * fit.size()));
        }
        assertEquals(List.of(9L, 9L, 9L, 5L, 9L, 5L, 5L, 5L, 9L), metrics);
    }

    @Test
    public void steadyMotionIsMeasuredBySlopes() {
        start(100);
        List<Long> looks = new ArrayList<>();
        for (int i = 0; i < 60; i++) {
            edge(100);
            long before = fit.votes();
            measure();
            looks.add((fit.votes() - before) / (2L * fit.size()));
        }
        // one for the slopes, and along the edge two more; nine and more before its lifetime has grown by half
        assertTrue(looks.toString(), looks.subList(0, 4).stream().allMatch(n -> n >= 9));
        assertTrue(looks.toString(), looks.subList(40, 60).contains(3L));
    }
}
