package io.github.sofas.flow.track;

import static org.junit.Assert.assertFalse;
import static org.junit.Assert.assertTrue;

import org.junit.Before;
import org.junit.Test;

/** Motions of 50 px/s whose events span 100 ms: 5 px of travel, more than the 2 px below which none is judged. */
public class PredictionTest {
    private static final double SPEED = 50;
    private static final long WINDOW_US = 100_000;

    private final Prediction prediction = new Prediction();
    private long nowUs = 1_000_000;

    @Before
    public void start() {
        prediction.restart();
    }

    private void judge(double along, double atRest, double speed, long afterUs) {
        judge(along, atRest, 100, speed, afterUs);
    }

    private void judge(double along, double atRest, int events, double speed, long afterUs) {
        nowUs += afterUs;
        prediction.judge(along, atRest, events, speed, WINDOW_US, nowUs);
    }

    @Test
    public void believesAMotionThatIsNew() {
        assertTrue(prediction.holds());
        assertFalse(prediction.isRefuted());
    }

    @Test
    public void holdsWhileEventsMeetByATenthMoreThanAtRest() {
        judge(441, 400, SPEED, 10_000);
        assertTrue(prediction.holds());
        judge(439, 400, SPEED, 10_000);
        assertFalse(prediction.holds());
    }

    @Test
    public void holdsWhileEventsMeetMoreThanByChance() {
        // at rest less than by chance, as those of noise from a small part of the sensor
        judge(20, -50, 400, SPEED, 10_000);
        assertTrue("a tenth of 400, less a standard deviation, sqrt(400)", prediction.holds());
        judge(19, -50, 400, SPEED, 10_000);
        assertFalse(prediction.holds());
        judge(19, -50, 400, 1, 10_000);
        assertFalse("at any speed", prediction.holds());
        judge(0, -50, 100, SPEED, 10_000);
        assertTrue("so few events tell nothing", prediction.holds());
    }

    @Test
    public void doesNotJudgeWhatHardlyTravels() {
        judge(100, 200, 20, 10_000);
        assertTrue("2 px in 100 ms", prediction.holds());
        judge(100, 200, 20.1, 10_000);
        assertFalse(prediction.holds());
    }

    @Test
    public void isRefutedAfterFivePixelsAgainstTheEvents() {
        judge(100, 200, SPEED, 0);
        judge(100, 200, SPEED, 100_000);
        assertFalse("5 px, not more", prediction.isRefuted());
        judge(100, 200, SPEED, 1_000);
        assertTrue(prediction.isRefuted());
    }

    @Test
    public void isNotRefutedByEventsThatTellNothing() {
        // within a standard deviation, sqrt(100) = 10, of rest: what is hidden looks like this
        judge(90, 100, SPEED, 0);
        judge(90, 100, SPEED, 1_000_000);
        assertFalse(prediction.holds());
        assertFalse(prediction.isRefuted());
    }

    @Test
    public void forgetsWhatWasAgainstItWhenItHoldsAgain() {
        judge(100, 200, SPEED, 0);
        judge(100, 200, SPEED, 90_000);
        judge(400, 200, SPEED, 10_000);
        judge(100, 200, SPEED, 50_000);
        assertFalse(prediction.isRefuted());
    }

    @Test
    public void isSureForHalfAWindowOnceEventsMeetHalfAsOftenAgainAsAtRest() {
        judge(601, 400, SPEED, 10_000);
        assertTrue(prediction.isSure(nowUs + WINDOW_US / 2 - 1));
        assertFalse(prediction.isSure(nowUs + WINDOW_US / 2));
        judge(600, 400, SPEED, 10_000);
        assertFalse("no more than half as often again", prediction.isSure(nowUs));
    }

    @Test
    public void isSureOfNothingAtTheStart() {
        judge(601, 400, SPEED, 10_000);
        prediction.restart();
        assertFalse(prediction.isSure(nowUs));
    }
}
