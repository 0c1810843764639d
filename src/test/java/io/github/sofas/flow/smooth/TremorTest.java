package io.github.sofas.flow.smooth;

import static org.junit.Assert.assertEquals;

import io.github.sofas.event.SensorSize;
import io.github.sofas.flow.motion.Motion;
import java.util.ArrayList;
import java.util.List;
import java.util.function.DoubleUnaryOperator;
import org.junit.Test;

/**
 * A picture that moves by 25 px/s in the mean, with 4,000 events per px, for nine slices of 50 ms. Its path knows the
 * mean only.
 */
public class TremorTest {
    private static final SensorSize SENSOR = new SensorSize(96, 64);
    private static final double PX_PER_S = 25;
    private static final double EVENTS_PER_PX = 4000;
    private static final int NONE = Integer.MAX_VALUE;
    private static final int SLICES = 9;
    private static final long SLICE_US = 50_000;
    private static final long BLOCK_US = SLICE_US / 32;
    private static final long STEP_US = 10;

    private final EventWindow window = new EventWindow();
    private final Tremor tremor = new Tremor(window, new Labels(), BLOCK_US, 2 * SLICES * 32);
    private final SegmentPath path = new SegmentPath(1);
    private final List<Slice> slices = new ArrayList<>();

    /**
     * Looks at the slice in the middle.
     *
     * @param pace multiple of the mean speed at a time in seconds
     * @param perPx events per px
     * @param other which event of how many has another label
     */
    private void look(DoubleUnaryOperator pace, double perPx, int other) {
        Motion motion = new Motion();
        motion.set(0, PX_PER_S, 0);
        path.add(motion);
        long from = 0;
        double due = 0;
        int n = 0;
        for (long us = 0; us < SLICES * SLICE_US; us += STEP_US) {
            due += pace.applyAsDouble(us * 1e-6) * PX_PER_S * perPx * STEP_US * 1e-6;
            for (; due >= 1; due--) {
                int segment = n % other == other - 1 ? 2 : 1;
                window.give(window.add(us, us, n % 90, n % 60, 1), segment, segment);
                n++;
            }
            if ((us + STEP_US) % SLICE_US == 0) {
                slices.add(new Slice(window, SENSOR, from, us + STEP_US - SLICE_US, us + STEP_US, 0));
                from = window.end();
            }
        }
        tremor.look(path, slices, slices.get(SLICES / 2));
    }

    private void assertFactors(DoubleUnaryOperator expected, double within) {
        long fromUs = slices.get(SLICES / 2).fromUs;
        for (long us = fromUs; us < fromUs + SLICE_US; us += BLOCK_US) {
            assertEquals(us + " µs", expected.applyAsDouble((us + BLOCK_US / 2) * 1e-6), tremor.factor(1, us), within);
        }
    }

    /** Faster and slower by so much ten times per second. */
    private static DoubleUnaryOperator trembling(double by) {
        return timeS -> 1 + by * Math.sin(20 * Math.PI * timeS);
    }

    @Test
    public void speedTremblesAsTheEventsPerTimeDo() {
        look(trembling(0.2), EVENTS_PER_PX, NONE);
        // the mean over 20 ms of 100 trembles by 0.93 of that
        assertFactors(trembling(0.186), 0.015);
        assertEquals("another label", 1, tremor.factor(2, 4 * SLICE_US), 0);
    }

    @Test
    public void steadyPictureDoesNotTremble() {
        look(timeS -> 1, EVENTS_PER_PX, NONE);
        assertFactors(timeS -> 1, 0);
    }

    @Test
    public void whatVariesByChanceOnlyIsNoTremor() {
        // of 2,000 events in 20 ms, a fiftieth more or less is chance
        look(trembling(0.02), EVENTS_PER_PX, NONE);
        assertFactors(timeS -> 1, 0.01);
    }

    @Test
    public void fewEventsShowNoTremor() {
        look(trembling(0.2), EVENTS_PER_PX / 50, NONE);
        assertFactors(timeS -> 1, 0);
    }

    @Test
    public void nothingTremblesBesideOthers() {
        // a sixth of the rest; a quarter
        look(trembling(0.2), EVENTS_PER_PX, 7);
        assertFactors(trembling(0.186), 0.025);
        window.forget(window.end());
        slices.clear();
        look(trembling(0.2), EVENTS_PER_PX, 5);
        assertFactors(timeS -> 1, 0);
    }

    @Test
    public void endOfTheEventsIsNoTremor() {
        // 85 and 10 ms after the slice
        look(timeS -> timeS < 0.335 ? 1 : 0, EVENTS_PER_PX, NONE);
        assertFactors(timeS -> 1, 0);
        window.forget(window.end());
        slices.clear();
        look(timeS -> timeS < 0.26 ? 1 : 0, EVENTS_PER_PX, NONE);
        assertFactors(timeS -> 1, 0);
    }

    @Test
    public void framesAreNoTremor() {
        // a source that sees 30 pictures per second
        look(timeS -> timeS * 30 % 1 < 0.03 ? 33 : 0, EVENTS_PER_PX, NONE);
        assertFactors(timeS -> 1, 0);
    }
}
