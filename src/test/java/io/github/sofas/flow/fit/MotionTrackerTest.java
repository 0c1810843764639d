package io.github.sofas.flow.fit;

import static org.junit.Assert.assertEquals;
import static org.junit.Assert.assertFalse;
import static org.junit.Assert.assertNotEquals;
import static org.junit.Assert.assertTrue;

import io.github.sofas.flow.motion.Motion;
import java.util.Random;
import java.util.function.DoubleUnaryOperator;
import org.junit.Before;
import org.junit.Test;

/** A structure of 80 px around (120, 90), measured every 10 ms over windows of 0.1 s. */
public class MotionTrackerTest {
    private static final double HALF_S = 0.05;
    private static final double RADIUS_PX = 80;
    private static final double TINY = 1e-9;

    private final MotionTracker tracker = new MotionTracker();
    private final Motion motion = new Motion();
    private final MotionLoss loss = new MotionLoss();
    private final Random random = new Random(7);
    /** The last measured velocity and acceleration to the right. */
    private double measuredVx;
    private double measuredAx;

    @Before
    public void isSharp() {
        loses(100);
    }

    /** So much metric for each px that the ends of the window shift by; its noise is 1. */
    private void loses(double perPx) {
        loss.xx = perPx * HALF_S * HALF_S;
        loss.yy = loss.xx;
        loss.turn = loss.xx * RADIUS_PX * RADIUS_PX;
    }

    /** Measures velocity and acceleration to the right of a time, but for so much noise, and tracks them. */
    private void measure(double middleS, double vx, double ax, double noise) {
        begin(middleS);
        motion.vx = vx + noise * random.nextGaussian();
        motion.ax = ax + 50 * noise * random.nextGaussian();
        measuredVx = motion.vx;
        measuredAx = motion.ax;
        tracker.track(motion, motion.ax, motion.ay, motion.alpha, loss, HALF_S, RADIUS_PX);
    }

    private void begin(double middleS) {
        motion.moveReference(Math.round(middleS * 1e6));
        motion.moveCentre(120, 90);
        tracker.takeBack(motion);
    }

    private Motion after(double s) {
        Motion later = new Motion();
        later.copyFrom(motion);
        later.moveReference(motion.referenceUs + Math.round(s * 1e6));
        return later;
    }

    /** Share of a velocity that swings by which a window sees it swing: it sees a tenth of the jerk, too. */
    private static double seen(double radPerS) {
        return 1 - 0.1 * Math.pow(radPerS * HALF_S, 2);
    }

    private double off(DoubleUnaryOperator v, DoubleUnaryOperator a, double noise) {
        return off(v, a, noise, v);
    }

    /**
     * Root of the mean square by which the velocity at the end of the window is off, of the last second of two.
     *
     * @param v measured velocity, and a its acceleration
     */
    private double off(DoubleUnaryOperator v, DoubleUnaryOperator a, double noise, DoubleUnaryOperator truth) {
        motion.set(0, v.applyAsDouble(0), motion.vy);
        double sum = 0;
        for (int i = 0; i < 200; i++) {
            double middle = 0.01 * i;
            measure(middle, v.applyAsDouble(middle), a.applyAsDouble(middle), noise);
            double off = after(HALF_S).vx - truth.applyAsDouble(middle + HALF_S);
            sum += i < 100 ? 0 : off * off / 100;
        }
        return Math.sqrt(sum);
    }

    @Test
    public void whatSwingsIsFollowedToTheEndOfTheWindow() {
        // by 80 px/s once a second: 3,200 px/s³ at most, of which the acceleration alone leaves 0.6 * 0.05² / sqrt(2)
        double w = 2 * Math.PI;
        double off = off(s -> 100 + 80 * seen(w) * Math.sin(w * s), s -> 80 * w * Math.cos(w * s), 0,
            s -> 100 + 80 * Math.sin(w * s));
        assertTrue("off by " + off + " instead of 3.3", off < 2);
    }

    @Test
    public void whatMovesSteadilyIsKnownBetterThanByOneMeasurement() {
        double off = off(s -> 100, s -> 0, 0.3);
        // 0.3 px/s, and 15 px/s² until the end of the window
        assertTrue("off by " + off, off < 0.3);
        assertEquals(0, motion.ax, 4);
    }

    @Test
    public void whatIsSoftIsCorrectedLess() {
        // measured 0.15 px off at the ends of the window, once as if only 0.03 were noise, and once as it is
        double off = off(s -> 100, s -> 0, 3);
        tracker.stop();
        loses(0.5 / 0.15);
        double soft = off(s -> 100, s -> 0, 3);
        assertTrue(soft + " and " + off, soft < 0.7 * off);
    }

    @Test
    public void swingingAlongAnAxisWithoutTravelIsThatOfThePixels() {
        // to and fro by 1 px/s twice a second, at 3 px/s, 0.3 px in a window, and at 50
        double w = 4 * Math.PI;
        off(s -> 3 + Math.sin(w * s), s -> w * Math.cos(w * s), 0);
        double locked = Math.abs(motion.ax);
        off(s -> 50 + Math.sin(w * s), s -> w * Math.cos(w * s), 0);
        assertTrue(locked + " and " + Math.abs(motion.ax), locked < 0.5 * Math.abs(motion.ax));
    }

    @Test
    public void rotationIsFollowedAsVelocityIs() {
        double w = 2 * Math.PI;
        motion.set(0, 40, 0);
        double sum = 0;
        for (int i = 0; i < 200; i++) {
            double middle = 0.01 * i;
            begin(middle);
            motion.omega = seen(w) * Math.sin(w * middle);
            motion.alpha = w * Math.cos(w * middle);
            tracker.track(motion, 0, 0, motion.alpha, loss, HALF_S, RADIUS_PX);
            double off = after(HALF_S).omega - Math.sin(w * (middle + HALF_S));
            sum += i < 100 ? 0 : off * off / 100;
        }
        // the change of the rotation alone leaves 0.6 * 0.05² * 4 pi² / sqrt(2)
        assertTrue("off by " + Math.sqrt(sum) + " instead of 0.042", Math.sqrt(sum) < 0.028);
    }

    @Test
    public void overALongWindowTheVelocityGoesOnAsItIs() {
        // gains 20 px/s in a second, measured over windows of 0.6 s, at whose end a third of that acceleration is left
        motion.set(0, 50, 0);
        for (int i = 0; i < 40; i++) {
            double middle = 0.06 * i;
            begin(middle);
            motion.vx = 50 + 20 * middle;
            motion.ax = 20;
            tracker.track(motion, 20, 0, 0, loss, 0.3, RADIUS_PX);
        }
        assertEquals(20 * Math.exp(-1), motion.ax, 1);
    }

    @Test
    public void measuringGoesOnFromWhatWasMeasured() {
        motion.set(0, 100, 0);
        for (int i = 0; i < 50; i++) {
            measure(0.01 * i, 100, 0, 0.3);
        }
        assertNotEquals(measuredVx, motion.vx, 0.01);
        begin(0.5);
        assertEquals(measuredVx + 0.01 * measuredAx, motion.vx, TINY);
        assertEquals(measuredAx, motion.ax, TINY);
    }

    @Test
    public void whatCameFromElsewhereIsMeasuredAsItIs() {
        motion.set(0, 100, 0);
        for (int i = 0; i < 50; i++) {
            measure(0.01 * i, 100, 0, 0.3);
        }
        motion.set(500_000, 102, 3);
        tracker.replace();
        begin(0.5);
        assertEquals(102, motion.vx, 0);
        assertEquals(3, motion.vy, 0);
    }

    @Test
    public void anotherMotionIsBegunAnew() {
        off(s -> 100, s -> 0, 0.3);
        // by 1 px at the end of the window
        measure(2, 120, 10, 0);
        assertEquals(120, motion.vx, 0);
        assertEquals(10, motion.ax, 0);
    }

    @Test
    public void whatCouldNotBeMeasuredIsBegunAnew() {
        off(s -> 100, s -> 0, 0.3);
        begin(2);
        motion.vx = 101;
        begin(2.01);
        assertEquals("kept", 101 + 0.01 * motion.ax, motion.vx, TINY);
        tracker.track(motion, motion.ax, 0, 0, loss, HALF_S, RADIUS_PX);
        assertEquals(101 + 0.01 * motion.ax, motion.vx, TINY);
    }

    @Test
    public void whatIsStoppedStaysAsItIs() {
        off(s -> 100, s -> 0, 0.3);
        assertTrue(tracker.isTracking());
        tracker.stop();
        assertFalse(tracker.isTracking());
        double vx = motion.vx;
        begin(1.99);
        assertEquals(vx, motion.vx, 0);
    }
}
