package io.github.sofas.flow.smooth;

import static org.junit.Assert.assertEquals;

import io.github.sofas.event.SensorSize;
import io.github.sofas.flow.motion.Motion;
import java.util.ArrayList;
import java.util.List;
import org.junit.Test;

/**
 * An upright edge of 20 rows that goes to the right by a column each 10 ms, and stands where it is after so many
 * columns, flickering on. Slices of 50 ms.
 */
public class WarpLossTest {
    private static final SensorSize SENSOR = new SensorSize(96, 64);
    private static final long COLUMN_US = 10_000;
    private static final long SLICE_US = 50_000;
    private static final int ROWS = 20;

    private final EventWindow window = new EventWindow();
    private final WarpLoss warpLoss = new WarpLoss(SENSOR, window);
    private final List<Slice> slices = new ArrayList<>();

    private void film(int columns, int moving, int rows) {
        long from = 0;
        for (int c = 0; c < columns; c++) {
            for (int y = 20; y < 20 + rows; y++) {
                window.give(window.add(c * COLUMN_US, 0, 20 + Math.min(c, moving), y, 1), 1, 1);
            }
            if ((c + 1) * COLUMN_US % SLICE_US == 0) {
                long us = (c + 1) * COLUMN_US;
                slices.add(new Slice(window, SENSOR, from, us - SLICE_US, us, 0));
                from = window.end();
            }
        }
    }

    /** Events of each slice that keep their label if the segment moves to the right at a speed. */
    private List<Integer> kept(double vx) {
        SegmentPath path = new SegmentPath(1);
        Motion motion = new Motion();
        motion.set(0, vx, 0);
        path.add(motion);
        List<Integer> kept = new ArrayList<>();
        for (Slice slice : slices) {
            warpLoss.unlabel(path, slices, slice, 4 * SLICE_US);
            slice.relabel();
            int events = 0;
            for (long i = slice.from; i < slice.until; i++) {
                events += window.segment[window.at(i)] == 1 ? 1 : 0;
            }
            kept.add(events);
        }
        return kept;
    }

    private static List<Integer> each(int events, int slices) {
        List<Integer> list = new ArrayList<>();
        for (int k = 0; k < slices; k++) {
            list.add(events);
        }
        return list;
    }

    @Test
    public void eventsThatTheirPathSharpensKeepTheirLabels() {
        film(40, 40, ROWS);
        assertEquals(each(5 * ROWS, 8), kept(100));
    }

    @Test
    public void eventsThatTheirPathBlursLoseThem() {
        // to the left: columns that are 10 ms apart lie two px apart instead of one
        film(40, 40, ROWS);
        assertEquals(each(0, 8), kept(-100));
    }

    @Test
    public void pathThatRunsOnAfterAStopLosesItsEventsFromTheStopOn() {
        // 8 px of travel are 80 ms: of the slice after the stop, half of what is looked at is still
        film(40, 20, ROWS);
        List<Integer> kept = kept(100);
        assertEquals(each(5 * ROWS, 3), kept.subList(0, 3));
        assertEquals(each(0, 3), kept.subList(5, 8));
    }

    @Test
    public void pathThatGoesTooSlowlyToTellKeepsItsEvents() {
        // 2 px/s for 400 ms are less than a px
        film(40, 40, ROWS);
        assertEquals(each(5 * ROWS, 8), kept(-2));
    }

    @Test
    public void fewEventsSayNothing() {
        film(40, 40, 1);
        assertEquals(each(5, 8), kept(-100));
    }
}
