package io.github.sofas.flow.track;

import static org.junit.Assert.assertEquals;

import io.github.sofas.flow.SofasParameters;
import io.github.sofas.flow.fit.MetricFit;
import io.github.sofas.flow.motion.Motion;
import java.util.Random;
import org.junit.Test;

/** Over how much travel planes are measured after a second; of edges {@link MeasurementTest} shows it. */
public class MeasuredTravelTest {
    private static final SofasParameters.Track P = SofasParameters.defaults().track();
    private static final double MIDDLE_X = 128;
    private static final double MIDDLE_Y = 64;
    private static final double HALF_WIDTH = 100;
    private static final double HALF_HEIGHT = 50;
    /** Root of the mean square distance of such a box from its middle. */
    private static final double RADIUS_PX = 65;

    private final Random random = new Random(11);

    /**
     * Travel in px that a plane of dots at chance places is measured over. It moves along a diagonal and grows from its
     * middle; each dot fires where it comes to another pixel.
     */
    private double travelPx(double pxPerS, double growth) {
        double along = pxPerS * Math.sqrt(0.5);
        MetricFit fit = new MetricFit(256, 128, MetricFit.CELL_PX, LiveEvents.CAPACITY, 1900);
        LiveEvents live = new LiveEvents();
        Measurement measurement = new Measurement(P);
        measurement.restart();
        Motion motion = new Motion();
        motion.set(0, along, along);
        motion.growth = growth;
        motion.centreX = MIDDLE_X;
        motion.centreY = MIDDLE_Y;
        double[] x = random.doubles(600, -HALF_WIDTH, HALF_WIDTH).toArray();
        double[] y = random.doubles(600, -HALF_HEIGHT, HALF_HEIGHT).toArray();
        for (long nowUs = 0; nowUs < 1_000_000; nowUs += 1_000) {
            for (int i = 0; i < x.length; i++) {
                int column = (int) (MIDDLE_X + x[i]);
                int row = (int) (MIDDLE_Y + y[i]);
                x[i] += (along + growth * x[i]) * 1e-3;
                y[i] += (along + growth * y[i]) * 1e-3;
                if (Math.abs(x[i]) >= HALF_WIDTH || Math.abs(y[i]) >= HALF_HEIGHT) {
                    // another comes in its place
                    x[i] = random.nextDouble(-HALF_WIDTH, HALF_WIDTH);
                    y[i] = random.nextDouble(-HALF_HEIGHT, HALF_HEIGHT);
                } else if ((int) (MIDDLE_X + x[i]) != column || (int) (MIDDLE_Y + y[i]) != row) {
                    int polarity = i % 2 == 0 ? 1 : -1;
                    live.add((int) (MIDDLE_X + x[i]), (int) (MIDDLE_Y + y[i]), nowUs, polarity, Claim.OWN, 0);
                }
            }
            if (nowUs >= 100_000 && nowUs % 20_000 == 0) {
                long lifetimeUs = (long) (measurement.lifetimePx() / motion.speed(RADIUS_PX) * 1e6);
                live.expire(nowUs - lifetimeUs);
                measurement.measure(motion, live, RADIUS_PX, fit, lifetimeUs, nowUs);
                motion.moveReference(nowUs);
            }
        }
        return measurement.lifetimePx();
    }

    @Test
    public void slowPlaneIsMeasuredOverAFifthOfASecondButNoLessThanOfEightPixels() {
        assertEquals(0.2 * 60, travelPx(60, 0), 0.5);
        assertEquals(1.6 * P.lifetimePx(), travelPx(30, 0), 0.5);
        assertEquals(P.maxLifetimePx(), travelPx(120, 0), 0);
    }

    @Test
    public void growthIsNotCountedForTheEightPixels() {
        // 20 px/s by growth and 15 by the velocity, of which 8 px take as long as 13.3 px of both, about as measured
        assertEquals(8 * Math.hypot(20, 15) / 15, travelPx(15, 20 / RADIUS_PX), 2);
    }
}
