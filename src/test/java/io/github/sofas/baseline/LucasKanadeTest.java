package io.github.sofas.baseline;

import static org.junit.Assert.assertArrayEquals;
import static org.junit.Assert.assertEquals;
import static org.junit.Assert.assertThrows;
import static org.junit.Assert.assertTrue;

import io.github.sofas.baseline.LucasKanade.Derivative;
import io.github.sofas.event.EventBatch;
import io.github.sofas.event.SensorSize;
import io.github.sofas.flow.FlowOutput;
import java.util.Random;
import org.junit.Test;

public class LucasKanadeTest {
    private static final SensorSize SENSOR = new SensorSize(11, 11);
    private static final int MIDDLE = 5;
    private static final double EXACT = 1e-4;

    private final EventBatch batch = new EventBatch(2_000);
    private final FlowOutput output = new FlowOutput(2_000);
    private long timeUs;

    /** So many ON events at a pixel, a microsecond apart. */
    private void fire(int x, int y, int count) {
        for (int k = 0; k < count; k++) {
            batch.add(timeUs++, x, y, 1);
        }
    }

    private void assertLast(Derivative derivative, double vx, double vy) {
        new LucasKanade(SENSOR, derivative).process(batch, output);
        int last = batch.size() - 1;
        assertEquals(vx, output.vxPxPerS[last], EXACT);
        assertEquals(vy, output.vyPxPerS[last], EXACT);
        assertEquals(vx == 0 && vy == 0 ? 0 : 1, output.segment[last]);
    }

    @Test
    public void backwardDifferencesPullALoneEventToTheLeftAndUp() {
        // nx is 1 at the event and -1 to its right: xx = 2, xn = 1, the same in y.
        // xy: nx and ny are both 1 at the event, nowhere else together: xy = 1; determinant 4 - 1 = 3.
        // vx = (xy yn - yy xn) / 3 * 20 / s = (1 - 2) / 3 * 20 = -20 / 3.
        fire(MIDDLE, MIDDLE, 1);
        assertLast(Derivative.BACKWARD_DIFFERENCE, -20.0 / 3, -20.0 / 3);
    }

    @Test
    public void centralDifferencesGiveALoneEventNoFlow() {
        // nx and n are never both other than 0 at one pixel.
        fire(MIDDLE, MIDDLE, 1);
        assertLast(Derivative.CENTRAL_DIFFERENCE, 0, 0);
    }

    @Test
    public void centralDifferencesSolveForBothComponentsWhereThereIsACorner() {
        // One event each at columns 5, 8 and 9 of row 5; column 9 is outside the window but within a difference.
        // nx: +1 at 4, -1 at 6, +1 at 7, +1 at 8: xx = 4, xn = 1 (at 8). ny: +-1 above and below 5 and 8: yy = 4.
        // xy = 0. vx = -(4 * 1) / 16 * 40 / s = -10.
        fire(8, MIDDLE, 1);
        fire(9, MIDDLE, 1);
        fire(MIDDLE, MIDDLE, 1);
        assertLast(Derivative.CENTRAL_DIFFERENCE, -10, 0);
    }

    @Test
    public void centralDifferencesGiveAStraightEdgeItsNormalFlow() {
        // Counts 1, 2, 3 from column 4 to 6 in every row: n rises by 1 a pixel and by 2 in 50 ms, 40 / s.
        for (int y = 0; y < SENSOR.height(); y++) {
            fire(4, y, 1);
            fire(6, y, 3);
            fire(5, y, y == MIDDLE ? 1 : 2);
        }
        fire(MIDDLE, MIDDLE, 1);
        assertLast(Derivative.CENTRAL_DIFFERENCE, -40, 0);
    }

    @Test
    public void savitzkyGolayFitsTheSlopeOfARamp() {
        // Counts 1 to 7 down the window: slope 1 a pixel; 4 at the middle: -4 * 20 / 3 = -26.67.
        for (int x = 0; x < SENSOR.width(); x++) {
            for (int dy = -3; dy <= 3; dy++) {
                fire(x, MIDDLE + dy, 4 + dy - (x == MIDDLE && dy == 0 ? 1 : 0));
            }
        }
        fire(MIDDLE, MIDDLE, 1);
        assertLast(Derivative.SAVITZKY_GOLAY, 0, -80.0 / 3);
    }

    @Test
    public void savitzkyGolayNeedsAGradient() {
        // One event at the middle and one beside it: slope 1 / 196, and 49 / 196² is below 1.
        fire(6, MIDDLE, 1);
        fire(MIDDLE, MIDDLE, 1);
        assertLast(Derivative.SAVITZKY_GOLAY, 0, 0);
    }

    @Test
    public void forgetsEventsOlderThanTheMaximumAge() {
        fire(8, MIDDLE, 1);
        fire(9, MIDDLE, 1);
        // Exactly 50 ms after the second, so that only the first is too old and nx n is 0 everywhere.
        timeUs = LucasKanade.MAX_AGE_US + 1;
        fire(MIDDLE, MIDDLE, 1);
        assertLast(Derivative.CENTRAL_DIFFERENCE, 0, 0);
    }

    @Test
    public void keepsEventsOfExactlyTheMaximumAge() {
        fire(8, MIDDLE, 1);
        timeUs = 0;
        fire(9, MIDDLE, 1);
        timeUs = LucasKanade.MAX_AGE_US;
        fire(MIDDLE, MIDDLE, 1);
        assertLast(Derivative.CENTRAL_DIFFERENCE, -10, 0);
    }

    @Test
    public void countsPolaritiesApart() {
        batch.add(timeUs++, 8, MIDDLE, -1);
        batch.add(timeUs++, 9, MIDDLE, -1);
        fire(MIDDLE, MIDDLE, 1);
        assertLast(Derivative.CENTRAL_DIFFERENCE, 0, 0);
    }

    @Test
    public void givesNoFlowWhereTheWindowLeavesTheSensor() {
        fire(3, MIDDLE, 1);
        assertLast(Derivative.BACKWARD_DIFFERENCE, 0, 0);
    }

    @Test
    public void batchesAndResetsMakeNoDifference() {
        Random random = new Random(1);
        for (int i = 0; i < 2_000; i++) {
            timeUs += random.nextInt(200);
            batch.add(timeUs, random.nextInt(24), random.nextInt(24), random.nextInt(2) * 2 - 1);
        }
        LucasKanade method = new LucasKanade(new SensorSize(24, 24), Derivative.CENTRAL_DIFFERENCE);
        method.process(batch, output);
        method.reset();
        EventBatch one = new EventBatch(1);
        FlowOutput single = new FlowOutput(1);
        int withFlow = 0;
        for (int i = 0; i < batch.size(); i++) {
            one.clear();
            one.add(batch.timeUs[i], batch.x[i], batch.y[i], batch.polarity[i]);
            method.process(one, single);
            assertArrayEquals(new float[] {output.vxPxPerS[i], output.vyPxPerS[i], output.segment[i]},
                    new float[] {single.vxPxPerS[0], single.vyPxPerS[0], single.segment[0]}, 0);
            withFlow += single.segment[0];
        }
        assertTrue(withFlow > 0);
    }

    @Test
    public void refusesAnOutputThatIsTooSmall() {
        fire(MIDDLE, MIDDLE, 2);
        IllegalArgumentException e = assertThrows(IllegalArgumentException.class,
                () -> new LucasKanade(SENSOR).process(batch, new FlowOutput(1)));
        assertEquals("output must hold the batch's 2 events but holds 1", e.getMessage());
    }

    @Test
    public void givesNoFlowToEventsOutsideTheSensor() {
        EventBatch outside = new EventBatch(2);
        outside.add(0, -1, 5, 1);
        outside.add(1, 5, 11, -1);
        output.segment[1] = 7;
        new LucasKanade(SENSOR).process(outside, output);
        assertEquals(0, output.segment[0]);
        assertEquals(0, output.segment[1]);
    }
}
