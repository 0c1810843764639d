package io.github.sofas.flow.track;

import static org.junit.Assert.assertEquals;
import static org.junit.Assert.assertFalse;
import static org.junit.Assert.assertTrue;

import io.github.sofas.flow.motion.Motion;
import java.util.ArrayList;
import java.util.List;
import org.junit.Test;

/** What is told of a structure's motion, as "number: velocity to the right", and what is another one. */
public class MeasuredMotionTest {
    private final List<String> told = new ArrayList<>();
    private final MeasuredMotion measured =
        new MeasuredMotion((segment, motion) -> told.add(segment + ": " + Math.round(motion.vx)));
    private final Motion motion = new Motion();

    private Motion motion(double vx, double vy) {
        motion.set(0, vx, vy);
        return motion;
    }

    @Test
    public void motionIsToldWhenItIsMeasured() {
        measured.start(90, 0);
        measured.number(7);
        measured.take(motion(100, 0));
        measured.take(motion(110, 0));
        assertEquals(List.of("7: 100", "7: 110"), told);
    }

    @Test
    public void motionOfAStructureWithoutANumberIsToldWithTheNumber() {
        measured.start(90, 0);
        assertEquals(0, measured.id());
        measured.take(motion(100, 0));
        motion(0, 0);
        assertEquals(List.of(), told);
        measured.number(7);
        assertEquals(7, measured.id());
        assertEquals(List.of("7: 100"), told);
    }

    @Test
    public void nextStructureHasNothingToTellBeforeItIsMeasured() {
        measured.start(90, 0);
        measured.take(motion(100, 0));
        measured.start(50, 0);
        measured.number(8);
        assertEquals(List.of(), told);
    }

    @Test
    public void velocityIsAnotherOnceItDiffersByMoreThanAQuarterOfTheMeasuredOne() {
        measured.start(90, 0);
        measured.take(motion(80, -60));
        // a quarter of 100 px/s to either side
        assertFalse(measured.isOther(motion(80 + 25, -60)));
        assertTrue(measured.isOther(motion(80 + 25.1, -60)));
        assertFalse(measured.isOther(motion(80, -60 - 25)));
        assertTrue(measured.isOther(motion(80, -60 + 25.1)));
    }

    @Test
    public void velocityThatItWasFoundWithCountsUntilItIsMeasured() {
        measured.start(40, 0);
        assertFalse(measured.isOther(motion(50, 0)));
        assertTrue(measured.isOther(motion(51, 0)));
    }
}
