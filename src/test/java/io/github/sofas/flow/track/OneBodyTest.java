package io.github.sofas.flow.track;

import static io.github.sofas.flow.track.MovingDots.END_US;
import static io.github.sofas.flow.track.MovingDots.HALF_S;
import static io.github.sofas.flow.track.MovingDots.MIDDLE_X;
import static io.github.sofas.flow.track.MovingDots.MIDDLE_Y;
import static io.github.sofas.flow.track.MovingDots.SIDE;
import static io.github.sofas.flow.track.MovingDots.VX;
import static org.junit.Assert.assertEquals;
import static org.junit.Assert.assertFalse;
import static org.junit.Assert.assertTrue;

import io.github.sofas.flow.fit.MetricFit;
import io.github.sofas.flow.motion.Motion;
import org.junit.Test;

/**
 * Two squares of dots, 24 px wide and high, that touch side by side in the middle of 200 ms; each dot fires whenever it
 * comes to another pixel. Both move to the right, about a middle at 80 px/s.
 */
public class OneBodyTest {
    private final MetricFit fit = new MetricFit(128, 96, MetricFit.CELL_PX, TrackPlaneStack.MOST_MEASURED, 1900);
    private final OneBody body = new OneBody();
    private final LiveEvents left = new LiveEvents();
    private final LiveEvents right = new LiveEvents();
    private final Motion ofLeft = new Motion();
    private final Motion ofRight = new Motion();

    /** Dots of a square that moves by itself, and turns and grows about the middle of both. */
    private static void move(LiveEvents live, double side, double vx, double vy, double omega, double growth) {
        MovingDots dots = new MovingDots();
        dots.move(90, MIDDLE_X + side, vx, vy, omega, growth);
        dots.addTo(live, Claim.OWN);
    }

    /** Asks of both, each with the velocity that its middle has. */
    private double gained(double leftVx, double leftVy, double rightVx, double rightVy) {
        ofLeft.set(END_US / 2, leftVx, leftVy);
        ofLeft.centreX = MIDDLE_X - SIDE / 2;
        ofLeft.centreY = MIDDLE_Y;
        ofRight.set(END_US / 2, rightVx, rightVy);
        ofRight.centreX = MIDDLE_X + SIDE / 2;
        ofRight.centreY = MIDDLE_Y;
        body.take(left, ofLeft, right, ofRight, SIDE);
        return body.sigmasGained(fit);
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
        body.take(left, ofLeft, right, ofRight, SIDE);
        assertEquals(OneBody.NOTHING, body.sigmasGained(fit), 0);
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

    /**
     * Two sides of a square of 48 px that meet in a corner, the upper left or the lower right one; an edge fires where
     * it enters a pixel, whatever comes along it.
     */
    private static void moveCorner(LiveEvents live, Motion its, int sign, double vx, double growth) {
        for (long t = 50; t < END_US; t += 50) {
            double s = t * 1e-6 - HALF_S;
            double middleX = MIDDLE_X + vx * s;
            double now = sign * SIDE * Math.exp(growth * s);
            double before = sign * SIDE * Math.exp(growth * (s - 50e-6));
            int column = (int) Math.floor(middleX + now);
            int row = (int) Math.floor(MIDDLE_Y + now);
            boolean entersColumn = column != (int) Math.floor(middleX - vx * 50e-6 + before);
            boolean entersRow = row != (int) Math.floor(MIDDLE_Y + before);
            for (int along = 0; along < 2 * SIDE; along++) {
                if (entersColumn) {
                    live.add(column, row - sign * along, t, 1, Claim.OWN, 0);
                }
                if (entersRow) {
                    live.add(column - sign * along, row, t, 1, Claim.OWN, 0);
                }
            }
        }
        // the velocity of the tip, taken for that of the middle of both edges, half a side from the tip along each
        its.set(END_US / 2, vx + sign * growth * SIDE, sign * growth * SIDE);
        its.centreX = MIDDLE_X + sign * SIDE / 2;
        its.centreY = MIDDLE_Y + sign * SIDE / 2;
    }

    private boolean growsOrShrinks(double vx, double growth) {
        moveCorner(left, ofLeft, -1, vx, growth);
        moveCorner(right, ofRight, 1, vx, growth);
        body.take(left, ofLeft, right, ofRight, SIDE);
        return body.growsOrShrinks(fit);
    }

    @Test
    public void cornersThatGoApartOrTogetherAreOneBodyThatGrowsOrShrinks() {
        assertTrue(growsOrShrinks(20, 2));
        assertEquals(0, body.motion().omega, 0);
        assertEquals(2, body.motion().growth, 0.1);
        assertEquals(20, body.motion().vxAt((int) MIDDLE_X, (int) MIDDLE_Y, END_US / 2), 2);
        left.clear();
        right.clear();
        assertTrue(growsOrShrinks(20, -2));
        assertEquals(-2, body.motion().growth, 0.1);
    }

    @Test
    public void cornersThatGoOnFasterThanApartAreNotKnownToGrow() {
        // the middles, 34 px from each other, go apart at 68 px/s, which is less than half of 150
        assertFalse(growsOrShrinks(150, 2));
    }

    @Test
    public void cornersThatGoApartAsNothingGrowsAreNotKnownToGrow() {
        assertFalse(growsOrShrinks(20, 3));
    }

    @Test
    public void whatGrowsLittleIsNotTold() {
        // 0.7 px would be 0.41 1/s at 17 px from the middle in 100 ms
        assertFalse(growsOrShrinks(0, 0.2));
    }
}
