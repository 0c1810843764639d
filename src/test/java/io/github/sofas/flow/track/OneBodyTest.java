package io.github.sofas.flow.track;

import static org.junit.Assert.assertEquals;
import static org.junit.Assert.assertTrue;

import io.github.sofas.flow.fit.MetricFit;
import io.github.sofas.flow.motion.Motion;
import java.util.Random;
import org.junit.Test;

/**
 * Two squares of dots, 24 px wide and high, that touch side by side in the middle of 200 ms; each dot fires whenever it
 * comes to another pixel. Both move to the right, about a middle at 80 px/s.
 */
public class OneBodyTest {
    private static final long END_US = 200_000;
    private static final double HALF_S = END_US * 0.5e-6;
    private static final double VX = 80;
    private static final double MIDDLE_X = 56;
    private static final double MIDDLE_Y = 44;
    private static final double SIDE = 24;

    private final MetricFit fit = new MetricFit(128, 96, MetricFit.CELL_PX, TrackPlaneStack.MOST_MEASURED, 1900);
    private final OneBody body = new OneBody();
    private final LiveEvents left = new LiveEvents();
    private final LiveEvents right = new LiveEvents();
    private final Motion ofLeft = new Motion();
    private final Motion ofRight = new Motion();

    /** Dots of a square that moves by itself, and turns and grows about the middle of both. */
    private static void move(LiveEvents live, double side, double vx, double vy, double omega, double growth) {
        Random random = new Random(1);
        int dots = 90;
        double[][] places = new double[dots][];
        int[] column = new int[dots];
        int[] row = new int[dots];
        for (int dot = 0; dot < dots; dot++) {
            places[dot] = new double[] {side + SIDE * random.nextDouble(), SIDE * (random.nextDouble() - 0.5)};
        }
        for (long t = 0; t < END_US; t += 50) {
            double s = t * 1e-6 - HALF_S;
            double scale = Math.exp(growth * s);
            double cos = scale * Math.cos(omega * s);
            double sin = scale * Math.sin(omega * s);
            for (int dot = 0; dot < dots; dot++) {
                int x = (int) Math.floor(MIDDLE_X + vx * s + cos * places[dot][0] - sin * places[dot][1]);
                int y = (int) Math.floor(MIDDLE_Y + vy * s + sin * places[dot][0] + cos * places[dot][1]);
                if (t > 0 && (x != column[dot] || y != row[dot])) {
                    live.add(x, y, t, 1, Claim.OWN, 0);
                }
                column[dot] = x;
                row[dot] = y;
            }
        }
    }

    /** Asks of both, each with the velocity that its middle has. */
    private double gained(double leftVx, double leftVy, double rightVx, double rightVy) {
        ofLeft.set(END_US / 2, leftVx, leftVy);
        ofLeft.centreX = MIDDLE_X - SIDE / 2;
        ofLeft.centreY = MIDDLE_Y;
        ofRight.set(END_US / 2, rightVx, rightVy);
        ofRight.centreX = MIDDLE_X + SIDE / 2;
        ofRight.centreY = MIDDLE_Y;
        return body.sigmasGained(left, ofLeft, right, ofRight, SIDE, fit);
    }

    private double gainedTurning(double omega, double growth) {
        move(left, -SIDE, VX, 0, omega, growth);
        move(right, 0, VX, 0, omega, growth);
        double vx = growth * SIDE / 2;
        double vy = omega * SIDE / 2;
        return gained(VX - vx, -vy, VX + vx, vy);
    }

    @Test
    public void partsOfWhatTurnsAreOneBody() {
        assertTrue(gainedTurning(1, 0) > 4);
        assertEquals(1, body.motion().omega, 0.05);
        assertEquals(0, body.motion().growth, 0.05);
        assertEquals(VX, body.motion().vxAt((int) MIDDLE_X, (int) MIDDLE_Y, END_US / 2), 1);
    }

    @Test
    public void partsOfWhatGrowsAreOneBody() {
        assertTrue(gainedTurning(0, 1) > 4);
        assertEquals(0, body.motion().omega, 0.05);
        assertEquals(1, body.motion().growth, 0.05);
        assertEquals(VX, body.motion().vxAt((int) MIDDLE_X, (int) MIDDLE_Y, END_US / 2), 1);
    }

    @Test
    public void bodiesThatPassBesideEachOtherAreTwo() {
        move(left, -SIDE, VX, -12, 0, 0);
        move(right, 0, VX, 12, 0, 0);
        assertTrue(gained(VX, -12, VX, 12) < -4);
    }

    @Test
    public void bodiesOfWhichOneFollowsTheOtherMoreSlowlyAreTwo() {
        move(left, -SIDE, VX - 12, 0, 0, 0);
        move(right, 0, VX + 12, 0, 0, 0);
        assertTrue(gained(VX - 12, 0, VX + 12, 0) < -4);
    }

    @Test
    public void whatTurnsAndGrowsLittleIsNotTold() {
        // 0.6 px at 12 px from the middle in 100 ms
        assertEquals(OneBody.NOTHING, gainedTurning(0.5, 0), 0);
    }

    @Test
    public void fewEventsAreNotTold() {
        gainedTurning(1, 0);
        right.keepNewest(49);
        assertEquals(OneBody.NOTHING, gained(VX, -12, VX, 12), 0);
    }

    @Test
    public void partsWhoseMiddlesAllButCoincideAreNotTold() {
        gainedTurning(1, 0);
        ofLeft.centreX = MIDDLE_X;
        ofRight.centreX = MIDDLE_X + 0.1;
        // 120 rad/s
        assertEquals(OneBody.NOTHING, body.sigmasGained(left, ofLeft, right, ofRight, SIDE, fit), 0);
    }

    @Test
    public void eventsThatOthersClaimTooTellNothing() {
        move(left, -SIDE, VX, 0, 1, 0);
        for (int k = 0; k < left.size(); k++) {
            int i = left.index(k);
            right.add(left.x[i], left.y[i], left.timeUs[i], 1, Claim.SHARED, 0);
        }
        left.keepNewest(60);
        assertEquals(OneBody.NOTHING, gained(VX, -12, VX, 12), 0);
    }
}
