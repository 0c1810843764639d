package io.github.sofas.flow;

import static org.junit.Assert.assertEquals;
import static org.junit.Assert.assertTrue;

import io.github.sofas.event.SensorSize;
import java.util.function.DoubleUnaryOperator;
import org.junit.Test;

/**
 * A disc that goes right at 60 px/s. Where it slows down, it does from 1 s on, by 200 px/s²: it stands at 1.3 s.
 */
public class TurningBackTest {
    private static final double PX_PER_S = 60;
    private static final double PX_PER_S2 = 200;
    private static final double STANDS_S = 1.3;
    private static final double STANDS_PX = 40 + PX_PER_S + PX_PER_S * 0.3 / 2;
    private static final double STEP_S = 1e-4;

    /** Of the events from 1.2 s on, those that have its segment of before, and how far off their velocities are. */
    private static final class Followed implements DiscFilm.Labels {
        private final DoubleUnaryOperator vx;
        private int id;
        private int events;
        private int labelled;
        private double off;

        Followed(DoubleUnaryOperator vx) {
            this.vx = vx;
        }

        @Override
        public void take(double timeS, int segment, double itsVx, double itsVy) {
            if (timeS < 1) {
                id = segment;
            } else if (timeS > 1.2) {
                events++;
                labelled += segment == id ? 1 : 0;
                off += Math.hypot(itsVx - vx.applyAsDouble(timeS), itsVy);
            }
        }

        private double share() {
            assertTrue("followed before", id > 0);
            return (double) labelled / events;
        }

        private double offPxPerS() {
            return off / events;
        }
    }

    private static double untilItStandsX(double timeS) {
        double slowedS = Math.max(0, timeS - 1);
        return 40 + PX_PER_S * timeS - PX_PER_S2 / 2 * slowedS * slowedS;
    }

    private static double untilItStandsVx(double timeS) {
        return PX_PER_S - PX_PER_S2 * Math.max(0, timeS - 1);
    }

    @Test
    public void whatTurnsBackIsFollowedByItsSegmentWithItsVelocity() {
        Followed followed = new Followed(TurningBackTest::untilItStandsVx);
        DiscFilm.show(TurningBackTest::untilItStandsX, 1.6, STEP_S, followed);
        assertEquals("events of its segment", 1, followed.share(), 0.05);
        assertEquals("px/s off", 0, followed.offPxPerS(), 10);
    }

    /** It stands until 1.7 s, and sets off by the same acceleration, to the right or to the left. */
    private static Followed showStanding(int direction) {
        Followed followed = new Followed(timeS -> timeS < STANDS_S ? untilItStandsVx(timeS)
            : direction * PX_PER_S2 * Math.max(0, timeS - 1.7));
        DiscFilm.show(timeS -> {
            double setOffS = Math.max(0, timeS - 1.7);
            return timeS < STANDS_S ? untilItStandsX(timeS) : STANDS_PX + direction * PX_PER_S2 / 2 * setOffS * setOffS;
        }, 2, STEP_S, followed);
        return followed;
    }

    @Test
    public void whatStandsAndGoesOnIsFollowedByItsSegment() {
        Followed followed = showStanding(1);
        assertEquals("events of its segment", 1, followed.share(), 0.05);
        assertEquals("px/s off", 0, followed.offPxPerS(), 10);
    }

    @Test
    public void whatStandsAndGoesBackIsFollowedByItsSegment() {
        Followed followed = showStanding(-1);
        assertEquals("events of its segment", 1, followed.share(), 0.05);
        assertEquals("px/s off", 0, followed.offPxPerS(), 10);
    }

    /**
     * How often a disc that stops at once, at one of several moments, and sets off at once after a pause is followed.
     * One moment shows little: where its edges stop within their px tells how its first events come.
     */
    private static int followedOfStopping(SensorSize sensor, int moments, double pauseS, int direction) {
        int followed = 0;
        for (int i = 0; i < moments; i++) {
            double stopsS = 1.2 + 0.0131 * i;
            double setsOffS = stopsS + pauseS;
            Followed its = new Followed(timeS -> timeS < stopsS ? PX_PER_S
                : timeS > setsOffS ? direction * PX_PER_S : 0);
            DiscFilm.show(sensor, timeS -> 40 + PX_PER_S * (Math.min(timeS, stopsS)
                + direction * Math.max(0, timeS - setsOffS)), setsOffS + 0.3, STEP_S, its);
            followed += its.share() > 0.9 ? 1 : 0;
        }
        return followed;
    }

    @Test
    public void whatStopsWithinAPixelAndGoesOnIsFollowedByItsSegment() {
        int followed = followedOfStopping(DiscFilm.SENSOR, 24, 0.4, 1);
        assertTrue("followed in " + followed, followed >= 22);
    }

    @Test
    public void whatTheBorderCutsOffAndStopsAndGoesBackIsFollowedByItsSegment() {
        int followed = followedOfStopping(DiscFilm.NARROW, 12, 0.2, -1);
        assertTrue("followed in " + followed, followed >= 11);
    }

    @Test
    public void whatIsSeenInFramesDoesNotStandBetweenThem() {
        Followed followed = new Followed(timeS -> PX_PER_S);
        // two px from one to the next
        DiscFilm.show(timeS -> 40 + PX_PER_S * timeS, 2, 2 / PX_PER_S, followed);
        assertEquals("events of its segment", 1, followed.share(), 0);
        assertEquals("px/s off", 0, followed.offPxPerS(), 1);
    }
}
