package io.github.sofas.flow;

import static org.junit.Assert.assertEquals;

import io.github.sofas.event.SensorSize;
import org.junit.Test;

/** A disc that goes right at 50 px/s, and becomes 35 % faster and slower, as what a hand moves does. */
public class SwayingSpeedTest {
    private static final double PX_PER_S = 50;
    private static final double SWAY = 0.35;

    /** How far velocities from 1.5 s on are off, as a share of the speed, which sways so many times per second. */
    private static double off(double timesPerS) {
        double perS = timesPerS * 2 * Math.PI;
        double[] off = new double[1];
        double[] sum = new double[1];
        DiscFilm.show(new SensorSize(350, 64), timeS -> 40 + PX_PER_S * (timeS - SWAY / perS * Math.cos(perS * timeS)),
            5, 1e-4, (timeS, segment, vx, vy) -> {
                if (timeS > 1.5 && segment != 0) {
                    double speed = PX_PER_S * (1 + SWAY * Math.sin(perS * timeS));
                    off[0] += Math.hypot(vx - speed, vy);
                    sum[0] += speed;
                }
            });
        return off[0] / sum[0];
    }

    @Test
    public void velocitiesFollowASpeedThatSwaysWithinTheWindow() {
        assertEquals(0, off(1.5), 0.075);
        assertEquals(0, off(3), 0.14);
    }
}
