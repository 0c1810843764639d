package io.github.sofas.flow.track;

import static org.junit.Assert.assertEquals;
import static org.junit.Assert.assertFalse;
import static org.junit.Assert.assertTrue;

import io.github.sofas.event.SensorSize;
import io.github.sofas.flow.Segment;
import io.github.sofas.flow.SofasParameters;
import io.github.sofas.flow.fit.MetricFit;
import io.github.sofas.flow.track.Life.State;
import java.util.Random;
import java.util.ArrayList;
import java.util.List;
import org.junit.Test;

/**
 * What becomes of an upright edge of 30 rows that moves to the right by a column each 10 ms. At 100 px/s its lifetime
 * of 5 px is 50 ms, and it is remembered for 64 px, 640 ms.
 */
public class TrackPlaneTest {
    private static final SensorSize SENSOR = new SensorSize(128, 96);
    private static final int ROWS = 30;
    private static final long COLUMN_US = 10_000;

    private final MetricFit fit = new MetricFit(128, 96, MetricFit.CELL_PX, LiveEvents.CAPACITY, 1900);
    private final List<Long> measuredUs = new ArrayList<>();
    private final TrackPlane plane = new TrackPlane(SENSOR, new Contour.Spare(SENSOR),
        SofasParameters.defaults().track(), (segment, motion) -> measuredUs.add(motion.referenceUs));
    private final Bursts bursts = new Bursts(SENSOR);
    private long nowUs;
    private int column;

    /** Found in three columns, which it took no events in. */
    private void start(int firstColumn) {
        nowUs = 1_000_000;
        column = firstColumn;
        plane.start(nowUs + 3 * COLUMN_US, 100, 0, 0);
        for (int c = 0; c < 3; c++) {
            for (int y = 0; y < ROWS; y++) {
                plane.addPast(column, 30 + y, nowUs, 1, true);
            }
            column++;
            nowUs += COLUMN_US;
        }
        plane.recentre(fit, nowUs);
        plane.number(1);
    }

    private void take(int x, int y, long timeUs, int polarity, Claim claim) {
        plane.support(x, y, timeUs, polarity);
        bursts.reset();
        plane.take(x, y, timeUs, polarity, claim, bursts, fit);
    }

    /** Goes on, and looks after it each 5 ms. */
    private State goOn(int columns) {
        return goOn(columns, Claim.OWN);
    }

    private State goOn(int columns, Claim claim) {
        State state = null;
        for (int c = 0; c < columns; c++) {
            for (int y = 0; y < ROWS; y++) {
                take(column, 30 + y, nowUs, 1, claim);
            }
            column++;
            nowUs += COLUMN_US / 2;
            plane.update(nowUs, 0);
            nowUs += COLUMN_US / 2;
            state = plane.update(nowUs, 0);
        }
        return state;
    }

    @Test
    public void firstMotionIsToldWithTheNumber() {
        start(20);
        // the middle of the time since the first column
        assertEquals(List.of(1_015_000L), measuredUs);
    }

    /** Waits without events, looking each 5 ms, until it is in another state; returns for how long. */
    private long waitedWhile(State state) {
        long fromUs = nowUs;
        while (plane.update(nowUs, 0) == state && nowUs - fromUs < 10_000_000) {
            nowUs += COLUMN_US / 2;
        }
        return nowUs - fromUs;
    }

    @Test
    public void structureThatGetsItsEventsIsTracked() {
        start(20);
        assertEquals(State.TRACKED, goOn(30));
        assertEquals(100, plane.motion().vx, 3);
        // known by its ends only
        assertEquals(0, plane.motion().vy, 5);
        Segment segment = plane.segment(Segment.Fate.ALIVE, 0);
        assertEquals(30 * ROWS, segment.events());
        assertEquals(1, segment.id());
        // at its last events, those of column 52
        assertEquals(52, segment.maxX(), 1);
        assertEquals(30, segment.minY(), 1);
        assertEquals(59, segment.maxY(), 1);
    }

    @Test
    public void structureThatHadFewEventsEndsAsSoonAsItGetsTooFew() {
        // 180 events, less than the 200 that it must have had to be waited for
        start(20);
        assertEquals(State.TRACKED, goOn(6));
        waitedWhile(State.TRACKED);
        assertEquals(State.ENDED, plane.update(nowUs, 0));
    }

    @Test
    public void structureThatHadManyIsWaitedForUntilItIsForgotten() {
        start(20);
        assertEquals(State.TRACKED, goOn(7));
        // starved when less than 0.3 of the usual events are left of a lifetime
        long trackedUs = waitedWhile(State.TRACKED);
        assertTrue(trackedUs > 0 && trackedUs <= plane.lifetimeUs());
        assertEquals(State.WAITED_FOR, plane.update(nowUs, 0));
        assertEquals(64 / plane.motion().speed(ROWS / Math.sqrt(12)) * 1e6, waitedWhile(State.WAITED_FOR), 20_000);
        assertEquals(State.ENDED, plane.update(nowUs, 0));
    }

    @Test
    public void hiddenStructureIsTrackedAgainWhenItComesBack() {
        start(20);
        goOn(12);
        waitedWhile(State.TRACKED);
        // hidden for 200 ms in all, in which it goes on by 20 px
        while (nowUs < 1_350_000) {
            nowUs += COLUMN_US;
            assertEquals(State.WAITED_FOR, plane.update(nowUs, 0));
        }
        column = 20 + 35;
        assertTrue(plane.memory().remembered(column, 45, nowUs) > 0);
        assertEquals(State.TRACKED, goOn(6, Claim.REMEMBERED));
        assertEquals(18 * ROWS, plane.segment(Segment.Fate.ALIVE, 0).events());
    }

    @Test
    public void starvedStructureIsWaitedForAnewEachTime() {
        start(20);
        goOn(10);
        long first = waitedWhile(State.TRACKED);
        nowUs += 400_000;
        assertEquals(State.WAITED_FOR, plane.update(nowUs, 0));
        column += (int) ((first + 400_000) / COLUMN_US);
        assertEquals(State.TRACKED, goOn(6));
        waitedWhile(State.TRACKED);
        // 400 ms of the first time are not counted
        nowUs += 400_000;
        assertEquals(State.WAITED_FOR, plane.update(nowUs, 0));
    }

    @Test
    public void structureThatHasLeftTheSensorIsNotWaitedFor() {
        // the last column that it entered is the sensor's last one but one: it leaves within 20 ms
        start(107);
        assertEquals(State.TRACKED, goOn(17));
        long endUs = nowUs + waitedWhile(State.TRACKED);
        assertEquals(State.ENDED, plane.update(endUs, 0));
    }

    @Test
    public void structureThatNoLongerIsSharpEnds() {
        // as many events as ever, at chance places of 20 columns
        Random random = new Random(5);
        start(20);
        State state = goOn(10);
        for (int i = 0; i < 30 && state != State.ENDED; i++) {
            for (int k = 0; k < ROWS; k++) {
                take(25 + random.nextInt(20), 30 + random.nextInt(ROWS), nowUs + k * 300, 1, Claim.OWN);
            }
            nowUs += COLUMN_US;
            state = plane.update(nowUs, 0);
        }
        assertEquals(State.ENDED, state);
    }

    @Test
    public void planeBeginsAnewWithTheNextStructure() {
        start(20);
        goOn(10);
        waitedWhile(State.TRACKED);
        plane.clear();
        start(20);
        assertEquals(State.TRACKED, goOn(1));
        assertEquals(ROWS, plane.segment(Segment.Fate.ALIVE, 0).events());
        assertEquals(0, plane.memory().remembered(33, 45, nowUs + 1));
    }

    /** Goes on with some of its rows only. */
    private State goOnWith(int rows, int columns) {
        State state = null;
        for (int c = 0; c < columns; c++) {
            for (int y = 0; y < rows; y++) {
                take(column, 30 + y, nowUs, 1, Claim.OWN);
            }
            column++;
            nowUs += COLUMN_US;
            state = plane.update(nowUs, 0);
        }
        return state;
    }

    @Test
    public void structureThatGetsLessThanAThirdOfItsEventsIsStarved() {
        // 15 rows of 30 are more than the share of 0.3, 7 are less: enough live events to measure, 40 and more
        start(20);
        goOn(10);
        assertEquals(State.TRACKED, goOnWith(15, 16));
        start(20);
        goOn(10);
        assertEquals(State.WAITED_FOR, goOnWith(7, 16));
    }

    @Test
    public void motionOfAStarvedStructureIsHeld() {
        start(20);
        goOn(10);
        assertEquals(State.WAITED_FOR, goOnWith(7, 16));
        long votes = fit.votes();
        plane.recentre(fit, nowUs);
        // looked at along the motion and at rest, each on two grids at most: no fit, which takes five looks
        assertTrue(fit.votes() - votes <= 4 * fit.size());
        // and measured again as soon as it gets its events
        goOn(16);
        assertTrue(fit.votes() > votes);
    }

    @Test
    public void fewEventsAreMeasuredWhenTheyWouldWaitLong() {
        start(20);
        goOn(10);
        plane.recentre(fit, nowUs);
        take(column, 45, nowUs, 1, Claim.OWN);
        long votes = fit.votes();
        long lateUs = Math.max(20_000, plane.lifetimeUs() / 4);
        plane.measureIfLate(fit, nowUs + lateUs);
        assertEquals(votes, fit.votes());
        plane.measureIfLate(fit, nowUs + lateUs + 1);
        assertTrue(fit.votes() > votes);
        // nothing new since
        votes = fit.votes();
        plane.measureIfLate(fit, nowUs + 60_000);
        assertEquals(votes, fit.votes());
    }

    @Test
    public void burstLastsForHalfAPixelOfTravelAndOneAndAHalfMillisecondsAtMost() {
        plane.start(nowUs, 400, 300, 0);
        assertEquals(1_000, plane.burstUs());
        plane.start(nowUs, 250, 0, 0);
        assertEquals(1_500, plane.burstUs());
        plane.start(nowUs, 10, 0, 0);
        assertEquals(1_500, plane.burstUs());
    }

    @Test
    public void onlyTheFirstEventOfABurstIsMeasured() {
        start(20);
        goOn(10);
        for (int y = 0; y < ROWS; y++) {
            bursts.begins(column, 30 + y, nowUs, 1, 0);
        }
        plane.recentre(fit, nowUs);
        long votes = fit.votes();
        for (int times = 0; times < 200; times++) {
            plane.support(column, 30 + times % ROWS, nowUs, 1);
            plane.take(column, 30 + times % ROWS, nowUs, 1, Claim.OWN, bursts, fit);
        }
        assertEquals(votes, fit.votes());
        for (int times = 0; times < 200; times++) {
            take(column, 30 + times % ROWS, nowUs, 1, Claim.OWN);
        }
        assertTrue(fit.votes() > votes);
    }

    @Test
    public void contourIsDrawnAnewWhereTheMotionWasCorrected() {
        // found at 60 px/s, which leaves the three columns 0.8 px apart in its frame
        nowUs = 1_000_000;
        plane.start(nowUs + 2 * COLUMN_US, 60, 0, 0);
        for (int c = 0; c < 6; c++) {
            for (int y = 0; y < ROWS; y++) {
                plane.addPast(20 + c, 30 + y, nowUs, 1, true);
            }
            nowUs += COLUMN_US;
        }
        plane.recentre(fit, nowUs);
        assertEquals(100, plane.motion().vx, 10);
        // all within a cell of the next column, each in another sixteenth of the lifetime
        assertEquals(2 * 6, plane.support(26, 45, nowUs, 1));
        assertEquals(0, plane.support(23, 45, nowUs, 1));
    }

    @Test
    public void placeWhereAStructureIsOnlyRememberedIsNotRememberedAnew() {
        start(20);
        goOn(5);
        // beside its end: taken as a remembered one, it may be noise
        for (int i = 0; i < 16; i++) {
            take(column - 2 + i % 4, 69 + i / 4, nowUs, 1, Claim.REMEMBERED);
        }
        assertEquals(0, plane.memory().remembered(column, 71, nowUs));
        for (int i = 0; i < 16; i++) {
            take(column - 2 + i % 4, 69 + i / 4, nowUs, 1, Claim.OWN);
        }
        assertTrue(plane.memory().remembered(column, 71, nowUs) > 0);
    }

    /** Changes its speed for 22 px, from 100 px/s, then goes on at the one it has, with two rows only. */
    private void changeSpeedAndThin(double accelerationPxPerS2) {
        start(20);
        goOn(10);
        double speed = 100;
        for (int c = 0; c < 55; c++) {
            for (int y = 0; y < ROWS; y += c < 22 ? 1 : 20) {
                take(column, 30 + y, nowUs, 1, Claim.OWN);
            }
            column++;
            long stepUs = Math.round(1e6 / speed);
            speed += c < 22 ? accelerationPxPerS2 * stepUs * 1e-6 : 0;
            nowUs += stepUs;
            plane.update(nowUs, 0);
        }
    }

    @Test
    public void tellsNothingOnceItGetsFewEventsAtAVelocityThatWasNotMeasured() {
        // 100 to 46 px/s: what changes by as much is waited for at other speeds
        changeSpeedAndThin(-180);
        assertEquals(State.WAITED_FOR, plane.update(nowUs, 0));
        assertFalse(plane.isPredictive());
    }

    @Test
    public void tellsOnWhatGetsFewEventsAtItsSteadyVelocity() {
        changeSpeedAndThin(0);
        assertEquals(State.WAITED_FOR, plane.update(nowUs, 0));
        assertTrue(plane.isPredictive());
    }

    @Test
    public void contourThatGaveUpAPartHasTheNewestEvents() {
        // two textures, apart, of which the second is faster by 60 px/s
        double[] at = new Random(3).doubles(400, 0, 20).toArray();
        plane.start(0, 100, 0, 0);
        for (long t = -100_000; t <= 0; t += 100) {
            for (int dot = 0; dot < 200; dot++) {
                double vx = (dot % 4 == 0 ? 160 : 100) * 1e-6;
                int x = (int) Math.floor(60 + at[dot] + vx * t);
                if (x != (int) Math.floor(60 + at[dot] + vx * (t - 100))) {
                    plane.addPast(x, (int) at[dot + 200] + (dot % 4 == 0 ? 60 : 10), t, 1, true);
                }
            }
        }
        plane.recentre(fit, 0);
        // what comes into sight then is not measured yet
        int measurements = measuredUs.size();
        for (int y = 20; y < 35; y++) {
            take(100, y, 20_000, 1, Claim.OWN);
        }
        assertEquals(measurements, measuredUs.size());
        Parting parting = new Parting(SENSOR, new TiledEvents(SENSOR));
        assertTrue(plane.beginsToPart(40_000));
        assertTrue(plane.findPart(parting, fit));
        TrackPlane part = new TrackPlane(SENSOR, new Contour.Spare(SENSOR), SofasParameters.defaults().track(),
            (segment, motion) -> { });
        plane.giveUp(parting, part, fit, 40_000);
        assertTrue(plane.support(102, 27, 40_000, 1) > 0);
        assertEquals("those of the part", 0, plane.support(70, 70, 40_000, 1));
    }

    @Test
    public void velocityOfAStraightEdgeIsNotKnownAlongIt() {
        // upright, 100 px/s to the right
        plane.start(1_000_000, 100, 0, 0);
        for (int i = 0; i < 240; i++) {
            plane.addPast(20 + i / 30, 30 + i % 30, 1_000_000 + i / 30 * 10_000, 1, true);
        }
        plane.recentre(fit, 1_080_000);
        assertFalse(plane.isVelocityKnown());
        // a right angle, as fast downwards
        plane.start(1_000_000, 100, 100, 0);
        for (int i = 0; i < 240; i++) {
            int step = i / 30;
            plane.addPast(20 + step + i % 30, 30 + step, 1_000_000 + step * 10_000, 1, true);
            plane.addPast(20 + step, 31 + step + i % 30, 1_000_000 + step * 10_000, 1, true);
        }
        plane.recentre(fit, 1_080_000);
        assertTrue(plane.isVelocityKnown());
    }
}
