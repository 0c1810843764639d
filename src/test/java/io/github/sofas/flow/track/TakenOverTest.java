package io.github.sofas.flow.track;

import static io.github.sofas.flow.track.MovingDots.END_US;
import static io.github.sofas.flow.track.MovingDots.MIDDLE_X;
import static io.github.sofas.flow.track.MovingDots.MIDDLE_Y;
import static io.github.sofas.flow.track.MovingDots.SIDE;
import static io.github.sofas.flow.track.MovingDots.VX;
import static org.junit.Assert.assertEquals;
import static org.junit.Assert.assertFalse;
import static org.junit.Assert.assertTrue;

import io.github.sofas.event.SensorSize;
import io.github.sofas.flow.motion.Motion;
import org.junit.Test;

/** Squares of {@link MovingDots} that are taken for one structure, which goes to the right. */
public class TakenOverTest {
    /** By what two squares part in 200 ms is 5 px. */
    private static final double VY = 12;
    private static final int LEFT = 7;
    private static final int RIGHT = 3;

    private final TakenOver taken = new TakenOver(new TiledEvents(new SensorSize(128, 96)));
    private final MovingDots dots = new MovingDots();
    private final LiveEvents live = new LiveEvents();

    private static Motion motion(double vx, double vy, double omega) {
        Motion motion = new Motion();
        motion.set(END_US / 2, vx, vy);
        motion.centreX = MIDDLE_X;
        motion.centreY = MIDDLE_Y;
        motion.omega = omega;
        return motion;
    }

    private boolean begin(Claim claim) {
        dots.addTo(live, claim);
        return taken.begin(live, motion(VX, 0, 0), 2 * SIDE);
    }

    @Test
    public void eachTileOfTwoBodiesGoesToTheOneThatMovesAsItDoes() {
        dots.move(90, MIDDLE_X - SIDE, -VY, 0);
        dots.move(60, MIDDLE_X, VY, 0);
        assertTrue(begin(Claim.OWN));
        taken.offer(motion(VX, VY, 0), RIGHT);
        taken.offer(motion(VX, -VY, 0), LEFT);
        assertTrue(taken.isExplained());
        assertEquals(live.size(), taken.size());
        assertEquals("that of more dots", LEFT, taken.heir());
        int right = 0;
        for (int k = 0; k < taken.size(); k++) {
            right += taken.owner(k) == (MovingDots.isRight(live, taken.index(k)) ? RIGHT : LEFT) ? 1 : 0;
        }
        // tiles of 8 px may hold some of both
        assertEquals(taken.size(), right, 0.05 * taken.size());
    }

    @Test
    public void whatDoesNotShowThatItTurnsIsAPartOfWhatTurns() {
        dots.move(90, MIDDLE_X, 0, 1);
        dots.addTo(live, Claim.OWN);
        // the middle of the square is 12 px beside that about which it turns
        assertTrue(taken.begin(live, motion(VX, SIDE / 2, 0), SIDE));
        taken.offer(motion(VX, 0, 1), LEFT);
        assertTrue(taken.isExplained());
        assertEquals(LEFT, taken.owner(0));
    }

    @Test
    public void bodyIsNoneOfThoseThatMoveOtherwise() {
        dots.move(90, MIDDLE_X, 0, 0);
        assertTrue(begin(Claim.OWN));
        taken.offer(motion(VX, VY, 0), RIGHT);
        taken.offer(motion(VX, -VY, 0), LEFT);
        assertFalse(taken.isExplained());
    }

    @Test
    public void whatMovesAsItDoesIsNotAsked() {
        dots.move(90, MIDDLE_X, 0, 0);
        assertTrue(begin(Claim.OWN));
        // 0.4 px at the ends of 200 ms
        taken.offer(motion(VX, 4, 0), RIGHT);
        assertFalse(taken.isExplained());
    }

    @Test
    public void whatMovesFarOtherwiseIsNotAsked() {
        // 7 px at the ends of 200 ms
        dots.move(90, MIDDLE_X, 70, 0);
        assertTrue(begin(Claim.OWN));
        taken.offer(motion(VX, 70, 0), RIGHT);
        assertFalse(taken.isExplained());
    }

    @Test
    public void fewEventsOfItsOwnTellNothing() {
        dots.move(90, MIDDLE_X, VY, 0);
        assertTrue(begin(Claim.SHARED));
        taken.offer(motion(VX, VY, 0), RIGHT);
        assertFalse(taken.isExplained());
    }

    @Test
    public void nobodyTakesOverWhatIsAlone() {
        dots.move(90, MIDDLE_X, 0, 0);
        assertTrue(begin(Claim.OWN));
        assertFalse(taken.isExplained());
    }
}
