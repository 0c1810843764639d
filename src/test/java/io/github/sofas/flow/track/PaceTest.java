package io.github.sofas.flow.track;

import static org.junit.Assert.assertEquals;

import io.github.sofas.flow.motion.Motion;
import java.util.function.DoubleUnaryOperator;
import org.junit.Test;

/**
 * A structure whose speed rises from 30 to 70 px/s in 0.4 s, and falls again. It is measured over 0.16 s, so that its
 * motion is known 80 ms late.
 */
public class PaceTest {
    private static final double WINDOW_S = 0.16;
    private static final double STEP_S = 0.01;
    private static final double UNTIL_S = 2.75;

    private final Pace pace = new Pace();

    private static double speed(double s) {
        double part = s / 0.8 - Math.floor(s / 0.8);
        return 30 + 80 * Math.min(part, 1 - part);
    }

    /** Shows it with so many events per s, and measured as given, at each time; returns the pace at the end. */
    private double shown(DoubleUnaryOperator eventsPerS, DoubleUnaryOperator measured) {
        LiveEvents live = new LiveEvents();
        Motion motion = new Motion();
        Motion mid = new Motion();
        pace.start();
        double due = 0;
        for (int step = 0; step * STEP_S < UNTIL_S; step++) {
            double fromS = step * STEP_S;
            double rate = eventsPerS.applyAsDouble(fromS + STEP_S / 2);
            for (due += rate * STEP_S; due >= 1; due--) {
                double afterS = STEP_S - (due - 1) / rate;
                live.add(0, 0, Math.round((fromS + afterS) * 1e6), 1, Claim.OWN, 0);
            }
            long nowUs = Math.round((fromS + STEP_S) * 1e6);
            live.expire(nowUs - Math.round(WINDOW_S * 1e6));
            double pxPerS = measured.applyAsDouble(fromS + STEP_S - WINDOW_S / 2);
            mid.set(nowUs - Math.round(WINDOW_S / 2 * 1e6), pxPerS, 0);
            pace.learn(mid, 0, nowUs);
            motion.set(nowUs, pxPerS, 0);
            pace.look(motion, live, 0, Math.round(WINDOW_S * 1e6), nowUs);
        }
        return pace.factor();
    }

    @Test
    public void velocitiesFollowTheRateOfTheEventsOnceMeasurementsHaveConfirmedIt() {
        // rising, it is 65 px/s at the end, and was 57 px/s 80 ms before; the newest 100 events, 100 per px, are those
        // of the last 15.5 ms, with 64.2 px/s on average
        assertEquals(64.2 / 57, shown(s -> 100 * speed(s), PaceTest::speed), 0.02);
    }

    @Test
    public void eventsThatComeFasterAreNotBelievedWhereMeasurementsShowASteadySpeed() {
        assertEquals(1, shown(s -> 100 * speed(s), s -> 50), 0);
    }

    @Test
    public void fewEventsShowNoPace() {
        assertEquals(1, shown(s -> 10 * speed(s), PaceTest::speed), 0);
    }
}
