package io.github.sofas.flow.smooth;

import static org.junit.Assert.assertEquals;
import static org.junit.Assert.assertFalse;
import static org.junit.Assert.assertTrue;

import io.github.sofas.event.EventBatch;
import io.github.sofas.event.SensorSize;
import io.github.sofas.flow.FlowOutput;
import io.github.sofas.flow.SofasParameters;
import io.github.sofas.flow.motion.Motion;
import java.util.Map;
import java.util.TreeMap;
import org.junit.Test;

/** Labels of the upper and the lower end of an upright edge that moves to the right at 100 px/s; slices of 50 ms. */
public class SmootherTest {
    private static final SensorSize SENSOR = new SensorSize(128, 64);
    private static final int UPPER = 1;
    private static final int LOWER = 2;
    /** What the lower end is known again in, and another body. */
    private static final int AGAIN = 3;
    private static final int OTHER = 4;

    private final Smoother smoother = new Smoother(SENSOR, SofasParameters.defaults().track(), 200_000);
    private final EventBatch batch = new EventBatch(40);
    private final FlowOutput causal = new FlowOutput(40);

    /** Whether the lower half of the edge goes along. */
    private boolean lowerMoves = true;

    private void measured(int segment, long us, double vx, int y) {
        Motion motion = new Motion();
        motion.set(us, vx, 0);
        motion.centreX = 10 + us * vx * 1e-6;
        motion.centreY = y;
        smoother.add(segment, motion);
    }

    /** Columns that the edge enters, one in 10 ms, with the causal labels of its ends. */
    private void film(int from, int until, int upper, int lower) {
        for (int column = from; column < until; column++) {
            batch.clear();
            for (int y = 10; y < 50; y++) {
                batch.add(column * 10_000L, 10 + (y < 30 || lowerMoves ? column : 0), y, 1);
                causal.segment[y - 10] = y < 30 ? upper : lower;
            }
            smoother.endSlices(column * 10_000L);
            for (int i = 0; i < batch.size(); i++) {
                smoother.add(batch, causal, i);
            }
        }
    }

    /** Columns in which the upper and the lower half has each label, as upper * 10 + lower. */
    private Map<Integer, Integer> given() {
        smoother.finish();
        Map<Integer, Integer> columns = new TreeMap<>();
        while (smoother.take(batch, causal)) {
            assertEquals(40, batch.size());
            columns.merge(causal.segment[0] * 10 + causal.segment[39], 1, Integer::sum);
        }
        return columns;
    }

    @Test
    public void piecesThatMergeWithinTheLookAheadAreOneFromTheStart() {
        measured(UPPER, 0, 100, 20);
        measured(LOWER, 0, 100, 40);
        film(0, 10, UPPER, LOWER);
        assertFalse("nothing was given", smoother.merge(LOWER, UPPER));
        film(10, 20, UPPER, UPPER);
        assertEquals(Map.of(11, 20), given());
    }

    @Test
    public void labelsThatWereGivenStayAndTheRestIsJoined() {
        measured(UPPER, 0, 100, 20);
        measured(LOWER, 0, 100, 40);
        film(0, 51, UPPER, LOWER);
        // at 500 ms the slices up to 250 ms were labelled for good, of 25 columns, and the one after it with them
        assertTrue("its label ends", smoother.merge(LOWER, UPPER));
        film(51, 60, UPPER, UPPER);
        assertEquals(Map.of(12, 30, 11, 30), given());
    }

    @Test
    public void labelThatWasGivenGoesOnWhereTheOtherIsNew() {
        measured(LOWER, 0, 100, 40);
        film(0, 46, 0, LOWER);
        measured(UPPER, 460_000, 100, 20);
        film(46, 50, UPPER, LOWER);
        assertFalse("its label goes on", smoother.merge(LOWER, UPPER));
        film(50, 60, UPPER, UPPER);
        assertEquals(LOWER, smoother.label(UPPER));
        assertTrue(given().keySet().stream().allMatch(labels -> labels == LOWER || labels == 10 * LOWER + LOWER));
    }

    @Test
    public void whatMovedApartIsNotOneFromTheStart() {
        measured(UPPER, 0, 100, 20);
        measured(UPPER, 90_000, 100, 20);
        measured(LOWER, 0, 0, 40);
        measured(LOWER, 90_000, 0, 40);
        lowerMoves = false;
        film(0, 10, UPPER, LOWER);
        assertTrue("9 px apart", smoother.merge(LOWER, UPPER));
        film(10, 20, UPPER, UPPER);
        assertEquals(Map.of(12, 10, 11, 10), given());
    }

    @Test
    public void pieceAndWhatItWasKnownAgainInDoNotMakeOneOfTwoBodies() {
        measured(UPPER, 0, 100, 20);
        measured(LOWER, 0, 100, 40);
        film(0, 10, UPPER, LOWER);
        measured(AGAIN, 100_000, 100, 40);
        measured(OTHER, 100_000, 100, 40);
        film(10, 20, UPPER, AGAIN);
        assertTrue("it has its path now", smoother.isLeft(LOWER));
        assertTrue(smoother.end(AGAIN));
        assertFalse("nothing was given", smoother.merge(AGAIN, UPPER));
        assertTrue("it was all of it again", smoother.end(LOWER));
        assertFalse(smoother.merge(LOWER, OTHER));
        assertEquals(UPPER, smoother.label(LOWER));
        assertEquals(OTHER, smoother.label(OTHER));
    }
}
