package io.github.sofas.flow.smooth;

import static org.junit.Assert.assertEquals;

import io.github.sofas.event.SensorSize;
import io.github.sofas.flow.motion.Motion;
import java.util.ArrayList;
import java.util.List;
import org.junit.Test;

/**
 * The outline of a square of 20 px that goes to the right at 100 px/s for 150 ms and then back: an event of each pixel
 * of its upright sides each px of travel, ON and OFF at the front and at the back. Slices of 50 ms.
 */
public class PathAlignmentTest {
    private static final SensorSize SENSOR = new SensorSize(96, 64);
    private static final long PX_US = 10_000;
    private static final long SLICE_US = 50_000;
    private static final int SIDE = 20;
    /** Time of the turn in px of travel. */
    private static final int TURN = 15;

    private final EventWindow window = new EventWindow();
    private final PathAlignment alignment = new PathAlignment(SENSOR, window);
    private final List<Slice> slices = new ArrayList<>();
    private final SegmentPath path = new SegmentPath(1);

    private void film(boolean turnsBack) {
        path.see(0);
        long from = 0;
        for (int px = 0; px < 2 * TURN; px++) {
            int column = 30 + (turnsBack && px > TURN ? 2 * TURN - px : px);
            for (int y = 20; y < 20 + SIDE; y++) {
                long us = px * PX_US + (y - 20) * PX_US / SIDE;
                boolean isBack = turnsBack && px > TURN;
                window.give(window.add(us, us, column, y, isBack ? 1 : 0), 1, 1);
                window.give(window.add(us, us, column + SIDE, y, isBack ? 0 : 1), 1, 1);
            }
            if ((px + 1) * PX_US % SLICE_US == 0) {
                long us = (px + 1) * PX_US;
                slices.add(new Slice(window, SENSOR, from, us - SLICE_US, us, 0));
                from = window.end();
            }
        }
    }

    private void knot(long us, double vx) {
        knot(us, vx, 0);
    }

    private void knot(long us, double vx, double stretch) {
        Motion motion = new Motion();
        motion.set(us, vx, 0);
        motion.deformation.stretch = stretch;
        path.add(motion);
    }

    private double vx(long us) {
        Motion motion = new Motion();
        path.at(us, motion);
        return motion.vx;
    }

    private void bendAll() {
        for (Slice slice : slices) {
            alignment.bend(path, slices, slice, SLICE_US);
        }
    }

    @Test
    public void pathThatIsRightStaysAsItIs() {
        film(false);
        knot(0, 100);
        knot(300_000, 100);
        bendAll();
        for (long us = 0; us < 300_000; us += 10_000) {
            assertEquals(100, vx(us), 0);
        }
    }

    @Test
    public void pathThatTurnsBackLateIsBentToTurnInTime() {
        film(true);
        knot(0, 100);
        // as measured with a lag: it turns at 160 ms, not in the middle of the column that it turns in
        knot(130_000, 100);
        knot(190_000, -100);
        knot(300_000, -100);
        assertEquals(17, vx(155_000), 1);
        bendAll();
        assertEquals(0, vx(155_000), 8);
        assertEquals(100, vx(100_000), 4);
        assertEquals(-100, vx(220_000), 4);
    }

    @Test
    public void pathOfWhatIsDeformedStaysAsItIs() {
        film(true);
        knot(0, 100, 0.1);
        knot(130_000, 100, 0.1);
        knot(190_000, -100, 0.1);
        knot(300_000, -100, 0.1);
        double before = vx(155_000);
        bendAll();
        assertEquals(before, vx(155_000), 0);
    }

    @Test
    public void handfulOfEventsBendsNothing() {
        path.see(0);
        for (int k = 0; k < 50; k++) {
            window.give(window.add(k * 1000, 0, 20 + k % 7, 20, 1), 1, 1);
        }
        slices.add(new Slice(window, SENSOR, 0, 0, SLICE_US, 0));
        knot(0, 100);
        bendAll();
        assertEquals(100, vx(25_000), 0);
    }
}
