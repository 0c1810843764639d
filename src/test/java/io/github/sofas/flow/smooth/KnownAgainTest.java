package io.github.sofas.flow.smooth;

import static org.junit.Assert.assertNull;
import static org.junit.Assert.assertSame;

import io.github.sofas.event.SensorSize;
import io.github.sofas.flow.motion.Motion;
import java.util.ArrayList;
import java.util.List;
import org.junit.Test;

/**
 * The upright sides of a square of 20 px that goes to the right at 100 px/s: an event of each pixel each px of travel.
 * Slices of 100 ms. Segment 1 has it at first; segment 2 begins after 250 ms, in the middle of the last slice.
 */
public class KnownAgainTest {
    private static final SensorSize SENSOR = new SensorSize(96, 64);
    private static final long PX_US = 10_000;
    private static final long SLICE_US = 100_000;
    private static final int SIDE = 20;
    private static final int PX = 30;
    private static final int BEGUN_PX = 25;
    private static final int LOST = 1;
    private static final int BEGUN = 2;

    private final EventWindow window = new EventWindow();
    private final List<Slice> slices = new ArrayList<>();
    private final SegmentPath lost = new SegmentPath(LOST);
    private final SegmentPath begun = new SegmentPath(BEGUN);

    /** Films it, with the upper rows of the second segment once that has begun. */
    private void film(int rowsOfBegun) {
        knot(lost, 0);
        knot(begun, BEGUN_PX * PX_US);
        long from = 0;
        for (int px = 0; px < PX; px++) {
            for (int row = 0; row < SIDE; row++) {
                long us = px * PX_US + row * PX_US / SIDE;
                SegmentPath path = px >= BEGUN_PX && row < rowsOfBegun ? begun : lost;
                path.see(us);
                for (int side = 0; side < 2; side++) {
                    window.give(window.add(us, us, 30 + px + side * SIDE, 20 + row, side), path.id(), path.id());
                }
            }
            long untilUs = (px + 1) * PX_US;
            if (untilUs % SLICE_US == 0) {
                slices.add(new Slice(window, SENSOR, from, untilUs - SLICE_US, untilUs, 0));
                from = window.end();
            }
        }
    }

    private static void knot(SegmentPath path, long us) {
        Motion motion = new Motion();
        motion.set(us, 100, 0);
        path.add(motion);
    }

    private SegmentPath knownAgain() {
        return new KnownAgain(SENSOR, window).find(begun, List.of(lost, begun), slices);
    }

    @Test
    public void whatBeginsWhereAnotherEndedIsThatOne() {
        film(SIDE);
        assertSame(lost, knownAgain());
    }

    @Test
    public void whatStillGetsItsEventsIsNotLostWithinASlice() {
        // seven rows are left to it, more than half of the thirteen; a contour of thirteen is like that of all
        film(13);
        assertNull(knownAgain());
    }
}
